// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Forces and torques of contacts: of many at once by the kernel's batch of contact laws where it
// has the chosen one (batched_law.h), otherwise one after the other by the host's contact models.
#pragma once

#include "batched_law.h"
#include "contact_reports.h"
#include "host_models.h"
#include "law/law_batch.h"
#include "near_pair.h"
#include "particle_arrays.h"

#include <string>

namespace ellipsoid_host {

class ModelSettings;

class PairForces : private LAMMPS_NS::Pointers {
 public:
  PairForces(LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::PairGranEllipsoid& pair,
             LIGGGHTS::ContactModels::HostModels& models)
      : Pointers(lmp), pair_(pair), models_(models), reports_(lmp, pair) {}

  void read_settings(const ModelSettings& settings);
  /// Why contacts do not run in batches; empty: they do.
  const std::string& obstacle() const { return laws_.obstacle(); }
  /// After the models have registered their properties.
  void connect(PropertyRegistry& registry);

  /// @param[in] for_list see ContactReports
  void begin_step(bool for_list);
  void end_step();

  /// A contact; its force is computed together with others, in the order in which they came, at
  /// apply_added() at the latest.
  void add(const Contact& contact, const ellipsoid::ContactFrame& frame) {
    added_[batch_.size()] = contact;
    batch_.add(frame);
    if (batch_.full())
      apply_added();
  }
  void apply_added() {
    apply(added_, false);
    batch_.clear();
  }
  /// The contacts that a search has found, after all that were added before.
  /// @param[in] contacts one for each pair of the search
  /// @param[in] are_flagged the flags of all of them say already that there is a contact
  void apply_found(const ellipsoid::ContactBatch& search, const Contact* contacts,
                   bool are_flagged);
  /// Tells the models that a contact is over.
  void close(int i, int j, int* flag, double* history);

 private:
  LAMMPS_NS::PairGranEllipsoid& pair_;
  LIGGGHTS::ContactModels::HostModels& models_;
  ContactReports reports_;
  ParticleArrays particles_;
  bool newton_ = false;
  bool computes_forces_ = false, is_time_step_ = false;
  int frozen_group_ = 0;
  const double* rigid_masses_ = nullptr; // of the bodies that particles belong to

  ellipsoid::ContactLawBatch batch_;
  Contact added_[ellipsoid::ContactLawBatch::capacity];
  LIGGGHTS::ContactModels::BatchedModels laws_;

  LIGGGHTS::ContactModels::SurfacesIntersectData common_data() const;
  double mass(int i) const;
  ellipsoid::PairMasses masses(int i, int j) const;
  ellipsoid::Vector3 centre_distance(int i, int j) const;
  bool owns(int j) const { return newton_ || j < particles_.owned; }

  void apply(const Contact* contacts, bool are_flagged);
  void apply_in_batch(const Contact* contacts, bool are_flagged);
  void gather(const Contact* contacts, bool are_flagged);
  template <bool in_plane> void add_action(const Contact& contact, int k);
  void report_action(const Contact& contact, int k);
  void apply_by_models(const Contact* contacts);
  LIGGGHTS::ContactModels::SurfacesIntersectData record(const Contact& contact, int k) const;
  void add_force(int i, const LIGGGHTS::ContactModels::ForceData& force);
};

} // namespace ellipsoid_host
