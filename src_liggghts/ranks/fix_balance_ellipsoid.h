// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// fix balance/ellipsoid: shifts the planes between sub-domains so that all ranks have as much to do
// (doc/fix_balance_ellipsoid.md).
#ifdef FIX_CLASS
// clang-format off
FixStyle(balance/ellipsoid,FixBalanceEllipsoid)
// clang-format on
#else
#ifndef LMP_FIX_BALANCE_ELLIPSOID_H
#define LMP_FIX_BALANCE_ELLIPSOID_H

#include "fix.h"
#include "host_variants.h"
#include "sub_domains.h"

namespace LAMMPS_NS {

/// Global scalar: imbalance, largest over mean of the ranks, after the last check. Global vector:
/// imbalance before and after it, number of shifts so far, most particles of a rank.
class FixBalanceEllipsoid : public Fix {
 public:
  FixBalanceEllipsoid(class LAMMPS* lmp, int narg, char** arg);

  int setmask() override;
  void init() override;
  void setup(int) override { note_box_change(false); }
  void end_of_step() override { note_box_change(false); }
  void write_restart(FILE* file) override;
  void restart(ELLIPSOID_RESTART_PARAMETERS) override;
  double compute_scalar() override { return after_; }
  double compute_vector(int n) override;

  /// To be called when neighbour lists are about to be built and all other fixes are ready for it.
  void balance();
  /// The planes in what write_restart() wrote.
  static ellipsoid_host::Planes planes_of(const char* state);

 private:
  bigint every_ = 0;       // steps between two checks
  double threshold_ = 1.1; // of the imbalance
  bool by_time_ = false;   // by measured times instead of numbers of particles
  ellipsoid_host::BalanceSettings settings_;

  double before_ = 1.0, after_ = 1.0; // imbalance at the last check
  bigint shifts_ = 0;                 // so far
  double time_at_check_ = 0.0;        // of this rank since the run began, at the last check (s)
  bool was_measured_ = false;
  bool is_for_insertion_ = false; // planes are even until the host's fixes have inserted

  void parse(int narg, char** arg);
  void note_box_change(bool planes_too);
  bigint next_insertion() const;
  bool is_due() const;
  double work_since_check();
  void check();
  void shift(const ellipsoid_host::Planes& planes);
};

} // namespace LAMMPS_NS

#endif
#endif
