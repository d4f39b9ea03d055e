// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The ellipsoids of owned and ghost particles as the contact search takes them: A = R diag R^T,
// made once per particle and time step, and only of particles that are asked for.
#ifndef ELLIPSOID_SHAPES_H_
#define ELLIPSOID_SHAPES_H_

#include "ellipsoid_contact.h"
#include "ellipsoid_host.h"
#include "particle_arrays.h"

#include <cstddef>
#include <vector>

namespace LIGGGHTS {

class EllipsoidShapes {
 public:
  /// Particles have moved: all shapes are made anew when they are asked for. References to shapes
  /// are good until the next call.
  void begin_step(const LAMMPS_NS::Atom& atom) {
    particles_ = ParticleArrays(atom);
    const auto count = static_cast<std::size_t>(atom.nlocal + atom.nghost);
    if (shapes_.size() != count)
      shapes_.resize(count);
    fresh_.assign(count, 0);
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

  __attribute__((noinline, flatten)) void make(int i) {
    const auto index = static_cast<std::size_t>(i);
    fresh_[index] = 1;
    shapes_[index] = ellipsoid::make_shape(ellipsoid_host::vector(particles_.shape[i]),
                                           ellipsoid_host::quaternion(particles_.quaternion[i]));
  }
};

} // namespace LIGGGHTS

#endif
