// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The pairs of the neighbour lists: those that are dealt with in every step (active), and those
// whose next check is deferred until their particles may touch (deferred_checks.h).
#ifndef NEIGHBOUR_PAIRS_H_
#define NEIGHBOUR_PAIRS_H_

#include "near_pair.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "separation/deferred_checks.h"

#include <cstddef>
#include <vector>

namespace LIGGGHTS {

class NeighbourPairs {
 public:
  /// @param[in] lists of the pair style, @param[in] histories as many lists of flags and histories
  /// @param[in] history_values of a pair
  void begin_step(const LAMMPS_NS::NeighList* lists, const LAMMPS_NS::NeighList* histories,
                  int history_values) {
    lists_ = lists;
    histories_ = histories;
    history_values_ = history_values;
  }

  /// The lists are new: no pair is active, none deferred.
  /// @param[in] particles number of owned particles and ghosts
  void restart(std::size_t particles);
  std::size_t size() const { return checks_.size(); }

  /// Calls visit(index, i, j) for all pairs.
  template <class Visit> void for_each(const Visit& visit) const {
    std::uint32_t index = 0;
    for_each_in_lists([&](int i, int j) { visit(index++, i, j); });
  }

  NearPair pair(std::uint32_t index, int i, int j) const {
    const std::size_t k = index - checks_.first_index(i);
    return {index,
            i,
            j,
            false,
            &histories_->firstneigh[i][k],
            &histories_->firstdouble[i][static_cast<std::size_t>(history_values_) * k]};
  }

  void activate(const NearPair& pair) { active_.push_back(pair); }

  /// Calls step(pair) for all active pairs, in the order in which they became so. Those for which
  /// it returns false are not active any more.
  /// @param[in] prefetch prefetch(pair): asks the processor for what step() will read; called some
  ///            pairs ahead, for pairs that touched
  template <class Prefetch, class Step>
  void for_each_active(const Prefetch& prefetch, const Step& step) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < active_.size(); ++k) {
      NearPair& pair = active_[k];
      if (k + pairs_ahead < active_.size() && active_[k + pairs_ahead].touched)
        prefetch(active_[k + pairs_ahead]);
      if (!step(pair))
        continue;
      if (kept != k)
        active_[kept] = pair;
      ++kept;
    }
    active_.resize(kept);
  }
  /// The histories of pairs lie apart in memory: asked for in time, they are there when needed.
  static void prefetch_history(const NearPair& pair) {
    __builtin_prefetch(pair.history, 1);
    __builtin_prefetch(pair.history + doubles_per_cache_line, 1);
  }

  /// The check of a pair that is apart is deferred.
  /// @param[in] gap between the particles (length), @param[in] approach see MotionClocks (length)
  void defer(std::uint32_t index, int i, double gap, double approach,
             ellipsoid::MotionClocks& clocks) {
    checks_.defer(index, i, gap, approach, clocks);
  }

  /// Calls on_due(index, i, j) for the pairs whose check is due, which it activates or defers, and
  /// after_block() now and then, where pairs may be deferred that became due before.
  template <class OnDue, class AfterBlock>
  void end_due_deferrals(const ellipsoid::MotionClocks& clocks, const OnDue& on_due,
                         const AfterBlock& after_block) {
    checks_.end_due(
        clocks,
        [&on_due](std::size_t index, int i, int j) {
          on_due(static_cast<std::uint32_t>(index), i, j);
        },
        after_block);
  }

 private:
  static constexpr std::size_t pairs_ahead = 16;
  static constexpr std::ptrdiff_t doubles_per_cache_line = 8;

  const LAMMPS_NS::NeighList* lists_ = nullptr;
  const LAMMPS_NS::NeighList* histories_ = nullptr;
  int history_values_ = 0;
  std::vector<NearPair> active_;
  ellipsoid::DeferredChecks checks_;

  template <class Visit> void for_each_in_lists(const Visit& visit) const {
    for (int k = 0; k < lists_->inum; ++k) {
      const int i = lists_->ilist[k];
      for (int l = 0; l < lists_->numneigh[i]; ++l)
        visit(i, lists_->firstneigh[i][l] & NEIGHMASK);
    }
  }
};

} // namespace LIGGGHTS

#endif
