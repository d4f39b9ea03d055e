// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Base class of a granular pair style with LIGGGHTS-PFM: what later hosts have besides is off.
#pragma once

#include "error.h"
#include "force.h"
#include "host_contact.h"
#include "pair_gran.h"

#include <cstdio>
#include <string>

namespace ellipsoid_host {

class HostPairStyle : public LAMMPS_NS::PairGran {
 public:
  explicit HostPairStyle(LAMMPS_NS::LAMMPS* lmp) : PairGran(lmp) {}

  virtual bool contact_match(const std::string type, const std::string model) = 0;

  /// For compute pair/gran/local: add each contact of a step.
  void begin_list() {}
  void add_to_list(LIGGGHTS::ContactModels::SurfacesIntersectData& contact,
                   LIGGGHTS::ContactModels::ForceData force_i,
                   const LIGGGHTS::ContactModels::ForceData&) {
    cpl_add_pair(contact, force_i);
  }
  void end_list() {}

  // --- of later hosts
  double relax(int) const { return 1.0; }
  bool store_sum_normal_force() const { return false; }
  double* get_sum_normal_force_ptr(int) { return nullptr; }
  bool storeContactForcesStress() const { return false; }
  LAMMPS_NS::FixContactPropertyAtom* fix_contact_forces_stress() { return nullptr; }
  /// Steps between two that store forces of contacts.
  int storeContactForcesEvery() const { return 1; }
  LAMMPS_NS::FixContactHistory* get_fix_history() const { return fix_history; }

 protected:
  static constexpr bool store_multicontact_data_ = false;

  /// The contact forces of a time step; `for_list` if its contacts are to be listed.
  virtual void add_forces(int eflag, int vflag, bool for_list) = 0;
  /// Reads what write_restart_settings() wrote.
  virtual void read_settings_again(std::FILE* file) = 0;

 private:
  void compute_force(int eflag, int vflag, int addflag) override {
    add_forces(eflag, vflag, cpl() && addflag);
  }
  void compute_single_pair_force(LCM::CollisionData&, LCM::ForceData&, LCM::ForceData&) override {
    error->all(FLERR, "fix break/particle does not work with pair_style gran/ellipsoid; remove it");
  }
  void read_restart_settings(std::FILE* file) override { read_settings_again(file); }
};

} // namespace ellipsoid_host
