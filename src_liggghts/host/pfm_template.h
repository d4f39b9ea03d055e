// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The template of particles of LIGGGHTS-PFM with the interface of later hosts.
#pragma once

#include "fix_template_sphere.h"
#include "particleToInsert.h"

namespace ellipsoid_host {

class HostTemplate : public LAMMPS_NS::FixTemplateSphere {
 public:
  /// Of the bounding spheres (length).
  virtual double min_rad() = 0;
  virtual double max_rad() = 0;
  virtual double max_r_bound() = 0;
  virtual void init_ptilist(int count, bool, LAMMPS_NS::FixPropertyAtom*) = 0;
  virtual void randomize_ptilist(int count, int group, int order) = 0;

  // --- not called by this host
  virtual void randomize_single() = 0;
  virtual void direct_set_ptlist(int, const void*, int, int) = 0;
  virtual unsigned int generate_hash() = 0;

 protected:
  HostTemplate(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
      : FixTemplateSphere(lmp, narg, arg), random_insertion(random) {}

  LAMMPS_NS::RanPark* random_insertion;
  LAMMPS_NS::ParticleToInsert* pti = nullptr;
  int seed_orig = 0;
  template <class Value> void add_hash_value(Value, unsigned int&, unsigned int&) {}

 private:
  // as this host calls them
  double min_rad() const override { return const_cast<HostTemplate*>(this)->min_rad(); }
  double max_rad() const override { return const_cast<HostTemplate*>(this)->max_rad(); }
  double max_r_bound() const override { return const_cast<HostTemplate*>(this)->max_r_bound(); }
  void init_ptilist(int count) override { init_ptilist(count, false, nullptr); }
  void randomize_ptilist(int count, int group) override {
    for (int k = 0; k < count; ++k) {
      LAMMPS_NS::ParticleToInsert& particle = *pti_list[k];
      particle.fix_properties.clear(); // those of the last insertion
      particle.fix_property_values.clear();
      particle.property_index = particle.property_iindex = -1;
    }
    randomize_ptilist(count, group, 0);
  }
};

} // namespace ellipsoid_host
