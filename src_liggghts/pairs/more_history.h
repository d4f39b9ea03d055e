// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace ellipsoid_host {

/// Contact histories of pairs beyond the room that the host's lists give each pair: few pairs have
/// any. They last as long as the lists (fix_contacthistory_ellipsoid.h keeps them from one to the
/// next).
class MoreHistory {
 public:
  using Values = std::vector<double>;

  /// Of a pair, by its index in the lists; empty for most.
  const Values& of(std::uint32_t pair) const {
    static const Values none;
    const auto found = of_pairs_.find(pair);
    return found == of_pairs_.end() ? none : found->second;
  }
  std::size_t size(std::uint32_t pair) const { return of_pairs_.empty() ? 0 : of(pair).size(); }
  double* at(std::uint32_t pair, std::size_t offset) { return &of_pairs_.at(pair)[offset]; }
  /// Adds so many values, which are 0.
  void grow(std::uint32_t pair, int values) {
    Values& mine = of_pairs_[pair];
    mine.resize(mine.size() + static_cast<std::size_t>(values), 0.0);
  }
  void set(std::uint32_t pair, const double* begin, const double* end) {
    of_pairs_[pair].assign(begin, end);
  }
  void clear() { of_pairs_.clear(); }

 private:
  std::unordered_map<std::uint32_t, Values> of_pairs_;
};

} // namespace ellipsoid_host
