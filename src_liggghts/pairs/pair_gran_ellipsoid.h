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

#include "batch_notice.h"
#include "contact_counts.h"
#include "ellipsoid_contact_caller.h"
#include "host_pair.h"
#include "more_history.h"
#include "near_candidates.h"

#include <memory>
#include <string>

namespace ellipsoid_host {
class PairForces;
class SurfaceContacts;
} // namespace ellipsoid_host

namespace LIGGGHTS {
namespace ContactModels {
class HostModels;
}
} // namespace LIGGGHTS

namespace LAMMPS_NS {

class PairGranEllipsoid : public ellipsoid_host::HostPairStyle,
                          public LIGGGHTS::ContactModels::EllipsoidContactCaller {
 public:
  explicit PairGranEllipsoid(class LAMMPS* lmp);
  ~PairGranEllipsoid() override;

  void settings(int narg, char** arg) override;
  void init_style() override;
  void init_granular() override;
  void write_restart_settings(FILE* file) override;
  double stressStrainExponent() override;
  bool contact_match(const std::string type, const std::string model) override;
  int64_t hashcode() override;
  /// Besides what the host's pair styles give: "contacts", their number on this rank (double).
  void* extract(const char* what, int& dimension) override;

  /// The arguments of the command, models and settings, with a space between two.
  const std::string& arguments() const { return arguments_; }

  /// What the contact search did in the last time step, on this rank.
  const ellipsoid_host::ContactCounts& counts() const { return counts_; }
  /// Gives the history registered so far `times` slots in all.
  void repeat_history(int times);
  /// Of a pair that touches.
  /// @param[in] in_list histories of its first particle in the host's lists, @param[in] entry there
  double* history(double* in_list, int entry) const;
  /// The host's fix is about to keep the histories.
  void keep_histories();
  /// Where new lists take their candidates from: see near_candidates.h.
  ellipsoid_host::NearCandidates& near_candidates() { return near_candidates_; }
  /// Before new lists are made, on all ranks, when ghosts are known.
  void ghosts_are_new();
  /// To be asked for each particle of a list from 0 on; null: the host's bins serve.
  ellipsoid_host::NearCandidates* candidates_of(int i);
  FixContactHistory* contact_history() const { return fix_history; }
  /// Where a value of the history of a contact begins.
  int history_offset(const std::string& name) const;
  /// Whether value k of a pair's history, or of more_history(), is the negative seen from j.
  bool changes_sign(int k) const {
    return history_arg[static_cast<std::size_t>(k) % history_arg.size()].newtonflag == "1";
  }
  ellipsoid_host::MoreHistory& more_history() { return more_history_; }

 protected:
  void add_forces(int eflag, int vflag, bool for_list) override;
  void read_settings_again(FILE* file) override;

 private:
  std::unique_ptr<ellipsoid_host::SurfaceContacts> contacts_;
  std::unique_ptr<LIGGGHTS::ContactModels::HostModels> models_;
  std::unique_ptr<ellipsoid_host::PairForces> forces_;
  ellipsoid_host::MoreHistory more_history_;
  class FixContactHistoryEllipsoid* history_keeper_ = nullptr;
  ellipsoid_host::ContactCounts counts_;
  ellipsoid_host::NearCandidates near_candidates_;
  std::string arguments_; // empty: of an older restart file, which does not have them
  bool warned_ = false;
  LIGGGHTS::ContactModels::BatchNotice batch_notice_;
  int pages_[2] = {0, 0}; // neigh_modify page and one when a run was last set up

  void create(int64_t variant);
  /// Stops with one line where there is a complaint.
  void refuse(const std::string& complaint);
  void read_settings(int narg, char** arg);
  void check_pages();
  void shorten_lists();
  void warn_of_searches();
  void keep_arguments();
  void keep_history();
  class Fix* own_fix(const char* id, const char* style);
  void save_contact_history();
};

} // namespace LAMMPS_NS

#endif
#endif
