// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "neighbour_pairs.h"

#include <algorithm>

using namespace ellipsoid_host;

namespace {

/// The margin of a particle is half the skin, as for centres in the host's lists, but at least what
/// its surface moves in so many steps: else one body that spins fast would have the pairs of all
/// chosen anew too often.
constexpr double steps_in_margin = 20.0;

} // namespace

/// In new lists the host has flagged the pairs whose ids are among the partners it has kept.
bool NeighbourPairs::recall_rows(LAMMPS_NS::FixContactHistory& kept, const int* tags) {
  if (!are_kept_)
    return false;
  active_.clear();
  rows_.clear(history_values_);
  for_each_in_lists([&](const Candidate& pair) {
    double& number = histories_->firstdouble[pair.i][pair.entry];
    number = 0.0;
    if (!is_flagged(pair))
      return;
    const int row = rows_.allocate(), id = tags[pair.j];
    number = row;
    for (int partner = 0; partner < kept.n_partner(pair.i); ++partner)
      if (kept.partner(pair.i, partner) == id) {
        kept.contacthistory(pair.i, partner, rows_.at(row));
        break;
      }
  });
  return true;
}

void NeighbourPairs::begin_choice(double skin, ellipsoid::MotionClocks& clocks) {
  for (std::size_t particle = 0; particle < clocks.size(); ++particle)
    clocks.set_margin(particle, std::max(0.5 * skin, steps_in_margin * clocks.way(particle)));
  for (NearPair& pair : active_)
    if (!*pair.flag)
      end_history(pair);
  active_.clear();
  entries_.clear();
  ends_.assign(clocks.size(), 0);
}

void NeighbourPairs::end_choice(std::size_t particles) {
  std::uint32_t end = 0; // particles without near pairs end where the one before does
  for (int k = 0; k < lists_->inum; ++k) {
    std::uint32_t& own = ends_[static_cast<std::size_t>(lists_->ilist[k])];
    own = end = std::max(end, own);
  }
  checks_.restart(particles, [this](const auto& visit) {
    for_each([&visit](std::uint32_t, int i, int j) { visit(i, j); });
  });
}
