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
  explicit DisjointSets(std::size_t count) : m_parent(count) {
    std::iota(m_parent.begin(), m_parent.end(), std::size_t{0});
  }
  std::size_t root(std::size_t i) {
    while (m_parent[i] != i)
      i = m_parent[i] = m_parent[m_parent[i]];
    return i;
  }
  bool are_joined(std::size_t i, std::size_t j) {
    return m_parent[i] == m_parent[j] || root(i) == root(j);
  }
  void join(std::size_t i, std::size_t j) {
    const std::size_t p = root(i), q = root(j);
    m_parent[std::max(p, q)] = std::min(p, q);
  }

 private:
  std::vector<std::size_t> m_parent;
};

} // namespace ellipsoid::post
