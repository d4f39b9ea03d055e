// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace ellipsoid::post {

/// Sets that are joined one pair at a time; the root of a set is its smallest member.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i)
      i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  bool are_joined(std::size_t i, std::size_t j) {
    return parent_[i] == parent_[j] || root(i) == root(j);
  }
  void join(std::size_t i, std::size_t j) {
    const std::size_t p = root(i), q = root(j);
    parent_[std::max(p, q)] = std::min(p, q);
  }

 private:
  std::vector<std::size_t> parent_;
};

} // namespace ellipsoid::post
