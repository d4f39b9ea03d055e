// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Base class of a granular pair style, the same for every host.
#pragma once

#include "fix_contact_history.h"
#include "force.h"
#include "host_contact.h"
#include "host_variants.h"
#include "pair_gran.h"

#include <cstdint>
#include <cstdio>

#ifdef ELLIPSOID_HOST_PFM
#include "pfm_pair.h"
#else

namespace ellipsoid_host {

class HostPairStyle : public LAMMPS_NS::PairGran {
 public:
  explicit HostPairStyle(LAMMPS_NS::LAMMPS* lmp) : PairGran(lmp) {}

  /// For commands that list the contacts of a step, like compute pair/gran/local: begin, add each
  /// contact, end.
  void begin_list() {
#ifdef ELLIPSOID_HOST_INL
    updateRequestedCallbacks();
    callBeginPass();
#endif
  }
  void add_to_list(LIGGGHTS::ContactModels::SurfacesIntersectData& contact,
                   LIGGGHTS::ContactModels::ForceData force_i,
                   const LIGGGHTS::ContactModels::ForceData& force_j) {
#ifdef ELLIPSOID_HOST_INL
    call_post_force_callback(contact, force_i, force_j);
#else
    static_cast<void>(force_j);
    cpl_add_pair(contact, force_i);
#endif
  }
  void end_list() {
#ifdef ELLIPSOID_HOST_INL
    callEndPass();
#else
    cpl_pair_finalize();
#endif
  }

 protected:
  /// The contact forces of a time step; `for_list` if its contacts are to be listed.
  virtual void add_forces(int eflag, int vflag, bool for_list) = 0;
  /// Reads what write_restart_settings() wrote.
  virtual void read_settings_again(std::FILE* file) = 0;

 private:
#ifdef ELLIPSOID_HOST_INL
  bool has_listeners_ = false; // since the pair style was made

  void compute_force(int eflag, int vflag) override { add_forces(eflag, vflag, has_listeners_); }
  void read_restart_settings(std::FILE* file, const Version&) override {
    read_settings_again(file);
  }
  void register_post_force_callback(LIGGGHTS::ILoopCallbackCallable* listener) override {
    has_listeners_ = true;
    PairGran::register_post_force_callback(listener);
  }
#else
  void compute_force(int eflag, int vflag, int addflag) override {
    add_forces(eflag, vflag, cpl() && addflag);
  }
  void read_restart_settings(std::FILE* file, const int, const int) override {
    read_settings_again(file);
  }
#endif
};

} // namespace ellipsoid_host

#endif

namespace ellipsoid_host {

/// Is there a pair_style gran/ellipsoid with this surface?
inline bool has_surface(LAMMPS_NS::Force& force, const char* name) {
  auto* pair = dynamic_cast<HostPairStyle*>(force.pair_match("gran/ellipsoid", 1));
  return pair && pair->contact_match("surface", name);
}

} // namespace ellipsoid_host
