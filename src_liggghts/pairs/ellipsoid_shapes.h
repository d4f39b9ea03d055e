// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The ellipsoids of owned and ghost particles as the contact search takes them,
// A = R diag(a^2, b^2, c^2) R^T, made once per particle and time step: all of them together, or,
// where most particles touch nothing, only those that are asked for.
#pragma once

#include "ellipsoid/ellipsoid_contact.h"
#include "ellipsoid/shape_batch.h"
#include "ellipsoid_host.h"
#include "particle_arrays.h"

#include <cstddef>
#include <vector>

namespace ellipsoid_host {

class EllipsoidShapes {
 public:
  /// Particles have moved: all shapes are made anew. References to shapes are good until the next
  /// call.
  /// @param[in] new_lists other particles may be neighbours than before
  void begin_step(const LAMMPS_NS::Atom& atom, bool new_lists) {
    particles_ = ParticleArrays(atom);
    const auto count = static_cast<std::size_t>(atom.nlocal + atom.nghost);
    if (shapes_.size() != count)
      shapes_.resize(count);
    const bool made_all = makes_all_ && fresh_.size() == count;
    makes_all_ = !new_lists && (makes_all_ || 2 * asked_for_ > count);
    asked_for_ = 0;
    if (!(made_all && makes_all_)) // else all are marked already
      fresh_.assign(count, makes_all_ ? 1 : 0);
    if (makes_all_)
      make_all();
  }

  const ellipsoid::EllipsoidShape& operator[](int i) {
    const auto index = static_cast<std::size_t>(i);
    if (!fresh_[index])
      make(i);
    return shapes_[index];
  }

  /// Where the shape of particle i is or will be.
  const ellipsoid::EllipsoidShape* address(int i) const {
    return &shapes_[static_cast<std::size_t>(i)];
  }

 private:
  ParticleArrays particles_;
  std::vector<ellipsoid::EllipsoidShape> shapes_;
  std::vector<char> fresh_;
  std::size_t asked_for_ = 0; // shapes that were made one by one in this step
  bool makes_all_ = false;

  void make_all() {
    ellipsoid::make_shapes({particles_.shape[0], particles_.quaternion[0], shapes_.data()},
                           static_cast<int>(shapes_.size()));
  }

  __attribute__((noinline, flatten)) void make(int i) {
    const auto index = static_cast<std::size_t>(i);
    fresh_[index] = 1;
    ++asked_for_;
    shapes_[index] =
        ellipsoid::make_shape(vector(particles_.shape[i]), quaternion(particles_.quaternion[i]));
  }
};

} // namespace ellipsoid_host
