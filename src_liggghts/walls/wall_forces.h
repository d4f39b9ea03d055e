// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Forces of contacts with a wall, of many at once, by the kernel's batch of contact laws.
#pragma once

#include "batched_law.h"
#include "law/law_batch.h"
#include "particle_arrays.h"
#include "wall/wall_contact.h"

#include <string>

namespace ellipsoid_host {

/// A contact whose force is computed together with others.
struct ContactWithWall {
  int particle = 0;
  int wall_type = 0;         ///< atom type of the wall: its material
  double* history = nullptr; ///< values of the models; null: they remember nothing
  double weight = 1.0;       ///< of the force in the sum
  ellipsoid::WallContact geometry;
  ellipsoid::Vector3 velocity; ///< of the wall at the contact (length/time)
  int mesh = -1, triangle = 0; ///< number of the mesh (-1: a primitive wall), and its triangle
};

class WallForces {
 public:
  /// What the models are, see BatchedModels.
  LIGGGHTS::ContactModels::BatchedModels& models() { return models_; }
  const LIGGGHTS::ContactModels::BatchedModels& models() const { return models_; }

  void begin_step(const LAMMPS_NS::Atom& atom) {
    particles_ = ParticleArrays(atom);
    models_.begin_step(batch_);
  }
  void add(const ContactWithWall& contact);
  /// Whether there is no room for another contact before solve_and_clear().
  bool is_full() const { return batch_.full(); }
  /// @tparam Act act(contact, action), in the order in which the contacts came
  /// @param[in] is_time_step springs grow, otherwise forces are those of the moment
  template <class Act> void solve_and_clear(double time_step, bool is_time_step, const Act& act) {
    solve(time_step, is_time_step);
    for (int k = 0; k < batch_.size(); ++k)
      act(contacts_[k], batch_.action(k));
    batch_.clear();
  }

 private:
  LIGGGHTS::ContactModels::BatchedModels models_;
  ParticleArrays particles_;
  ellipsoid::ContactLawBatch batch_;
  ContactWithWall contacts_[ellipsoid::ContactLawBatch::capacity];

  void solve(double time_step, bool is_time_step);
};

} // namespace ellipsoid_host
