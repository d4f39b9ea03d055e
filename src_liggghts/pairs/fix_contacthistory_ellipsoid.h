// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// fix contacthistory/ellipsoid: made by pair_style gran/ellipsoid. While neighbour lists are made
// anew it keeps the contact histories that the host would lose or mix up: those of contacts beyond
// the room that the host gives a pair, and, in short periodic boxes, those of the several images
// of a partner, which the host does not tell apart. It also asks for new lists in time where these
// hold only the pairs that are near by true shape (near_candidates.h). (The host calls fixes whose
// style begins with `contacthistory` before particles come and go.)
#ifdef FIX_CLASS
// clang-format off
FixStyle(contacthistory/ellipsoid,FixContactHistoryEllipsoid)
// clang-format on
#else
#ifndef LMP_FIX_CONTACTHISTORY_ELLIPSOID_H
#define LMP_FIX_CONTACTHISTORY_ELLIPSOID_H

#include "fix.h"
#include "new_numbers.h"
#include "rows_of_particles.h"

#include <cstdint>
#include <vector>

namespace LAMMPS_NS {

class FixContactHistoryEllipsoid : public Fix, public ellipsoid_host::KnowsNumbers {
 public:
  FixContactHistoryEllipsoid(class LAMMPS* lmp, int narg, char** arg);
  ~FixContactHistoryEllipsoid() override;
  int setmask() override;

  /// Histories have been changed by contacts, and are to be saved before lists are made anew.
  void histories_changed() { are_changed_ = true; }
  /// Gives the pairs of new lists what was saved; does nothing if they have it.
  void give_back();
  /// The pairs have got what the host's fix keeps, which does not tell images from each other.
  void give_back_again() { are_to_be_given_ = true; }

  /// Has lists that are outdated made anew in this step.
  void post_integrate() override;
  void pre_exchange() override;
  void setup_pre_exchange() override { pre_exchange(); }
  /// Has the pair style prepare what the making of lists asks for.
  void pre_neighbor() override;
  void setup_pre_neighbor() override { pre_neighbor(); }

  void renumber(const ellipsoid_host::NewNumbers& numbers) override;

  double memory_usage() override;
  void copy_arrays(int from, int to, int) override;
  void set_arrays(int i) override;
  int pack_exchange(int i, double* buffer) override;
  int unpack_exchange(int i, double* buffer) override;
  int pack_restart(int i, double* buffer) override;
  void unpack_restart(int i, int set) override;
  int size_restart(int i) override;
  int maxsize_restart() override;

 private:
  /// Of one particle, its contacts one after the other: see save_contact().
  using Saved = ellipsoid_host::RowsOfParticles::Row;

  ellipsoid_host::RowsOfParticles saved_;
  bool are_changed_ = false, are_to_be_given_ = false;

  void save();
  void save_contact(int i, int j, const double* row, const std::vector<double>& more, double sign);
  const double* find(int i, int j) const;
  void give_back_pair(std::uint32_t index, int i, int j, int* flag, double* row);
  void reserve_exchange();
  class PairGranEllipsoid& pair() const;
};

} // namespace LAMMPS_NS

#endif
#endif
