// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "balance/plane_planning.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace ellipsoid {

namespace {

/// How near the heaviest part comes to the lightest possible, in average weights of a part.
constexpr double tolerance = 1e-3;
/// What sums in another order may differ by.
constexpr double rounding = 1e-12;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Weight below each plane, column by column.
std::vector<std::vector<double>> sums_below(const SlabWeights& weights) {
  std::vector<std::vector<double>> columns;
  for (int column = 0; column < weights.columns(); ++column) {
    std::vector<double> below(at(weights.slabs()) + 1, 0.0);
    for (int slab = 0; slab < weights.slabs(); ++slab)
      below[at(slab) + 1] = below[at(slab)] + weights.of(column, slab);
    columns.push_back(std::move(below));
  }
  return columns;
}

class Planner {
 public:
  Planner(const SlabWeights& weights, int parts, int least_slabs)
      : slabs_(weights.slabs()), parts_(parts), least_(least_slabs), below_(sums_below(weights)),
        total_below_(at(slabs_) + 1, 0.0) {
    for (const std::vector<double>& below : below_)
      for (std::size_t plane = 0; plane < below.size(); ++plane)
        total_below_[plane] += below[plane];
  }

  /// The best planes.
  std::vector<int> plan() {
    double low = 0.0, high = 0.0;
    for (const std::vector<double>& below : below_)
      high = std::max(high, below.back());
    low = high / parts_;
    const double mean = total_below_.back() / parts_ / static_cast<double>(below_.size());
    if (can_keep(low))
      high = low;
    while (high - low > tolerance * mean) {
      const double middle = 0.5 * (low + high);
      (can_keep(middle) ? high : low) = middle;
    }
    can_keep(high);
    return planes_near_even_shares();
  }

 private:
  int slabs_, parts_, least_;
  std::vector<std::vector<double>> below_; ///< by column and plane
  std::vector<double> total_below_;        ///< of all columns
  std::vector<int> reach_;                 ///< highest upper plane of a part, by its lower plane
  /// Whether the rest can be cut from a plane on, by the number of parts below and the plane.
  std::vector<std::vector<std::uint8_t>> goes_on_;

  /// How far up a part can reach from each plane before a column has more than the limit.
  void find_reach(double limit) {
    reach_.assign(at(slabs_) + 1, slabs_);
    for (const std::vector<double>& below : below_) {
      int upper = 0;
      for (int lower = 0; lower <= slabs_; ++lower) {
        upper = std::max(upper, lower);
        while (upper < slabs_ && below[at(upper) + 1] - below[at(lower)] <= limit)
          ++upper;
        reach_[at(lower)] = std::min(reach_[at(lower)], upper);
      }
    }
  }

  /// Can parts of the least thickness keep the limit? Leaves reach_ and goes_on_ behind.
  bool can_keep(double limit) {
    find_reach(limit * (1.0 + rounding));
    goes_on_.assign(at(parts_) + 1, std::vector<std::uint8_t>(at(slabs_) + 1, 0));
    goes_on_[at(parts_)][at(slabs_)] = 1;
    std::vector<int> good_below(at(slabs_) + 2, 0); // number of good planes below each
    for (int part = parts_ - 1; part >= 0; --part) {
      const std::vector<std::uint8_t>& next = goes_on_[at(part) + 1];
      for (int plane = 0; plane <= slabs_; ++plane)
        good_below[at(plane) + 1] = good_below[at(plane)] + next[at(plane)];
      for (int plane = part * least_; plane + least_ <= slabs_; ++plane)
        goes_on_[at(part)][at(plane)] =
            reach_[at(plane)] >= plane + least_ &&
            good_below[at(reach_[at(plane)]) + 1] > good_below[at(plane + least_)];
    }
    return goes_on_[0][0] != 0;
  }

  /// Where the share `part / parts` of the weight of all columns is nearest.
  int even_plane(int part) const {
    const double all = total_below_.back(), wanted = std::min(all, all * part / parts_); // rounding
    const auto above = std::lower_bound(total_below_.begin(), total_below_.end(), wanted);
    const int plane = static_cast<int>(above - total_below_.begin());
    if (plane > 0 && wanted - total_below_[at(plane) - 1] < total_below_[at(plane)] - wanted)
      return plane - 1;
    return plane;
  }

  /// After can_keep(): of the planes that keep the limit, from the lowest on those nearest to even
  /// shares.
  std::vector<int> planes_near_even_shares() const {
    std::vector<int> planes{0};
    for (int part = 1; part <= parts_; ++part) {
      const int lowest = planes.back() + least_, highest = reach_[at(planes.back())];
      const int even = std::clamp(even_plane(part), lowest, highest);
      int chosen = even;
      for (int away = 0; away <= slabs_; ++away) {
        if (is_good(part, chosen = even - away, lowest, highest) ||
            is_good(part, chosen = even + away, lowest, highest))
          break;
      }
      planes.push_back(chosen);
    }
    return planes;
  }
  bool is_good(int part, int plane, int lowest, int highest) const {
    return plane >= lowest && plane <= highest && goes_on_[at(part)][at(plane)] != 0;
  }
};

} // namespace

std::vector<int> plan_planes(const SlabWeights& weights, int parts, int least_slabs) {
  return Planner(weights, parts, least_slabs).plan();
}

double heaviest_part(const SlabWeights& weights, const std::vector<int>& planes) {
  double heaviest = 0.0;
  for (int column = 0; column < weights.columns(); ++column)
    for (std::size_t part = 0; part + 1 < planes.size(); ++part) {
      double sum = 0.0;
      for (int slab = planes[part]; slab < planes[part + 1]; ++slab)
        sum += weights.of(column, slab);
      heaviest = std::max(heaviest, sum);
    }
  return heaviest;
}

std::vector<double> planes_of_next_stage(const std::vector<double>& present,
                                         const std::vector<double>& wanted) {
  std::vector<double> next = wanted;
  for (std::size_t k = 1; k + 1 < present.size(); ++k)
    next[k] = std::clamp(wanted[k], present[k - 1], present[k + 1]);
  return next;
}

} // namespace ellipsoid
