// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The near pairs of the neighbour lists: those that are dealt with in every step (active), and
// those whose next check is deferred until their particles may touch (deferred_checks.h). The
// host's lists hold pairs whose bounding spheres are near; most pairs of long or flat particles are
// far apart all the same. These are left out until a particle has moved by more than its margin
// (motion_clocks.h), rotation included; then the near pairs are chosen anew from the same lists.
#pragma once

#include "fix_contact_history.h"
#include "history_rows.h"
#include "near_pair.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "separation/deferred_checks.h"
#include "vectorised/prefetch.h"

#include <cstddef>
#include <vector>

namespace ellipsoid_host {

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

  /// The lists are new: pairs that touched before get back what the host's fix has kept, if it has
  /// the histories as they were.
  /// @param[in] tags ids of the particles
  /// @return whether it has
  bool recall_rows(LAMMPS_NS::FixContactHistory& kept, const int* tags);
  /// @param[in] all the host's fix has what the histories are at present
  void histories_are_kept(bool all) { are_kept_ = all; }
  const HistoryRows& rows() const { return rows_; }
  /// The pair, which has no history, gets one: numbers that are 0.
  void begin_history(NearPair& pair) {
    const int row = rows_.allocate();
    row_number(pair) = row;
    pair.history = rows_.at(row);
  }
  /// Does nothing where the pair has none.
  void end_history(NearPair& pair) {
    if (!pair.history)
      return;
    double& row = row_number(pair);
    rows_.free(static_cast<int>(row));
    row = 0.0;
    pair.history = nullptr;
  }

  /// A pair of the lists: the host's numbering.
  struct Candidate {
    int i, j;
    std::uint32_t entry; ///< of j in the list of i
  };

  /// Chooses the near pairs: no pair is active then, none deferred. All particles get new margins,
  /// those that turn fast larger ones.
  /// @param[in] skin of the neighbour lists (length)
  /// @param[in] choose choose(candidates, count, keep): sets keep[k] to false where pair k is
  ///            proved to be farther apart than both margins; count is up to candidates_together
  template <class Choose>
  void restart(double skin, ellipsoid::MotionClocks& clocks, const Choose& choose) {
    begin_choice(skin, clocks);
    Candidate candidates[candidates_together];
    int count = 0;
    for_each_in_lists([&](const Candidate& candidate) {
      candidates[count++] = candidate;
      if (count == candidates_together) {
        keep_near(candidates, count, choose);
        count = 0;
      }
    });
    keep_near(candidates, count, choose);
    end_choice(clocks.size());
  }
  static constexpr int candidates_together = 64;

  /// Number of near pairs.
  std::size_t size() const { return checks_.size(); }

  /// Calls visit(index, i, j) for all near pairs.
  template <class Visit> void for_each(const Visit& visit) const {
    std::uint32_t index = 0;
    for (int k = 0; k < lists_->inum; ++k) {
      const int i = lists_->ilist[k];
      for (const std::uint32_t end = ends_[static_cast<std::size_t>(i)]; index < end; ++index)
        visit(index, i, partner(i, entries_[index]));
    }
  }

  /// Whether the contact models have a contact, or had one when the lists were made.
  bool is_flagged(const Candidate& candidate) const {
    return histories_->firstneigh[candidate.i][candidate.entry] != 0;
  }
  /// Null: the pair has none.
  double* history(const Candidate& candidate) const {
    const int row = static_cast<int>(histories_->firstdouble[candidate.i][candidate.entry]);
    return row == 0 ? nullptr : rows_.at(row);
  }

  NearPair pair(std::uint32_t index, int i, int j) const {
    const Candidate own{i, j, entries_[index]};
    return {index, i, j, false, &histories_->firstneigh[i][own.entry], history(own)};
  }

  void activate(const NearPair& pair) { active_.push_back(pair); }

  /// Calls step(pair) for all active pairs, in the order in which they became so. Those for which
  /// it returns false are not active any more.
  /// @param[in] prefetch prefetch(pair): asks the processor for what step() will read; called some
  ///            pairs ahead, for pairs that touched, where there are so many that caches are small
  /// @param[in] prefetch_more the same for what stands where that points to, half as far ahead
  template <class Prefetch, class PrefetchMore, class Step>
  void for_each_active(const Prefetch& prefetch, const PrefetchMore& prefetch_more,
                       const Step& step) {
    const std::size_t count = active_.size();
    const std::size_t ahead = count > pairs_in_cache ? pairs_ahead : 2 * count;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < count; ++k) {
      NearPair& pair = active_[k];
      if (k + ahead < count && active_[k + ahead].touched)
        prefetch(active_[k + ahead]);
      if (k + ahead / 2 < count && active_[k + ahead / 2].touched)
        prefetch_more(active_[k + ahead / 2]);
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
    ellipsoid::prefetch_to_write(pair.history);
    ellipsoid::prefetch_to_write(pair.history + doubles_per_cache_line);
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
  static constexpr std::size_t pairs_in_cache = 4000; ///< their data need not be asked for
  static constexpr std::ptrdiff_t doubles_per_cache_line = 8;

  const LAMMPS_NS::NeighList* lists_ = nullptr;
  const LAMMPS_NS::NeighList* histories_ = nullptr;
  int history_values_ = 0;
  HistoryRows rows_; ///< of pairs that touch; the host's lists hold the number of the row
  bool are_kept_ = true;
  std::vector<std::uint32_t> entries_; ///< of the near pairs in the host's lists
  std::vector<std::uint32_t> ends_;    ///< by i: index after its last near pair
  std::vector<NearPair> active_;
  ellipsoid::DeferredChecks checks_;

  double& row_number(const NearPair& pair) const {
    return histories_->firstdouble[pair.i][pair.flag - histories_->firstneigh[pair.i]];
  }
  int partner(int i, std::uint32_t entry) const { return lists_->firstneigh[i][entry] & NEIGHMASK; }

  template <class Visit> void for_each_in_lists(const Visit& visit) const {
    for (int k = 0; k < lists_->inum; ++k) {
      const int i = lists_->ilist[k];
      const auto count = static_cast<std::uint32_t>(lists_->numneigh[i]);
      for (std::uint32_t entry = 0; entry < count; ++entry)
        visit(Candidate{i, partner(i, entry), entry});
    }
  }

  void begin_choice(double skin, ellipsoid::MotionClocks& clocks);
  void end_choice(std::size_t particles);

  template <class Choose>
  void keep_near(const Candidate* candidates, int count, const Choose& choose) {
    bool keep[candidates_together];
    choose(candidates, count, keep);
    for (int k = 0; k < count; ++k)
      if (keep[k]) {
        entries_.push_back(candidates[k].entry);
        ends_[static_cast<std::size_t>(candidates[k].i)] =
            static_cast<std::uint32_t>(entries_.size());
      }
  }
};

} // namespace ellipsoid_host
