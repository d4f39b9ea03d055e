// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// pair_style gran/ellipsoid: contacts between ellipsoids, by any of the host's contact models.
#ifdef PAIR_CLASS
// clang-format off
PairStyle(gran/ellipsoid,PairGranEllipsoid)
// clang-format on
#else
#ifndef LMP_PAIR_GRAN_ELLIPSOID_H
#define LMP_PAIR_GRAN_ELLIPSOID_H

#include "ellipsoid_contact_caller.h"
#include "granular_pair_style.h"
#include "pair_gran.h"
#include "update.h"

namespace LAMMPS_NS {

/// What the contact search did in the last time step, on this rank.
struct ContactCounts {
  enum Item {
    touching_pairs,
    contacts,
    near_pairs,
    tested,
    newton_steps,
    not_converged,
    item_count
  };
  double values[item_count] = {};
};

class PairGranEllipsoid : public PairGran, public LIGGGHTS::ContactModels::EllipsoidContactCaller {
 public:
  explicit PairGranEllipsoid(class LAMMPS* lmp);
  ~PairGranEllipsoid();

  void settings(int narg, char** arg) override;
  void init_style() override;
  void init_granular() override { impl_->init_granular(); }
  void write_restart_settings(FILE* file) override { impl_->write_restart_settings(file); }
  void read_restart_settings(FILE* file, const int major, const int minor) override;
  double stressStrainExponent() override { return impl_->stressStrainExponent(); }
  bool contact_match(const std::string type, const std::string model) override {
    return impl_->contact_match(type, model);
  }
  int64_t hashcode() override { return impl_->hashcode(); }

  /// Owned pairs count once, pairs with a ghost half on each rank.
  void publish(const ContactCounts& counts);
  const ContactCounts& counts() const { return counts_; }
  /// Gives the history registered so far `times` slots in all.
  void repeat_history(int times);

 protected:
  void compute_force(int eflag, int vflag, int addflag) override {
    if (computeflag_)
      begin_records(update->ntimestep);
    impl_->compute_force(this, eflag, vflag, addflag);
  }

 private:
  LIGGGHTS::PairStyles::IGranularPairStyle* impl_ = nullptr;
  ContactCounts counts_;
  bool warned_ = false;

  void create(int64_t variant);
  void check_pages();
};

} // namespace LAMMPS_NS

#endif
#endif
