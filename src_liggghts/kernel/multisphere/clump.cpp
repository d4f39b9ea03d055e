// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "multisphere/clump.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

namespace ellipsoid {
namespace {

/// Volumes, moments and their products are finite and not 0 within these, in any unit.
constexpr double smallest_length = 1e-30, largest_length = 1e30;

/// Spheres of a file that shall touch do so to its digits: relative to the larger radius.
constexpr double touching_tolerance = 1e-9;

[[noreturn]] void refuse(const std::string& what) { throw std::invalid_argument("clump: " + what); }

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

double gap_between(const SphereSet& set, std::size_t k, std::size_t l) {
  return norm(set.centres[l] - set.centres[k]) - (set.radii[k] + set.radii[l]);
}

/// For each sphere the first one that is equal to it: itself, where none is before it.
std::vector<std::size_t> first_equal_spheres(const SphereSet& set) {
  const auto numbers = [&](std::size_t k) {
    const Vector3& c = set.centres[k];
    return std::make_tuple(c.x, c.y, c.z, set.radii[k]);
  };
  std::vector<std::size_t> order(set.centres.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<std::size_t> first = order;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t k, std::size_t l) { return numbers(k) < numbers(l); });
  for (std::size_t n = 1; n < order.size(); ++n)
    if (numbers(order[n - 1]) == numbers(order[n]))
      first[order[n]] = first[order[n - 1]];
  return first;
}

/// Each contact of two equal spheres would count twice: a body of twice the stiffness.
void refuse_equal_spheres(const SphereSet& set) {
  const std::vector<std::size_t> first = first_equal_spheres(set);
  for (std::size_t k = 0; k < first.size(); ++k)
    if (first[k] != k)
      refuse("spheres " + std::to_string(first[k] + 1) + " and " + std::to_string(k + 1) +
             " are equal, and each contact would count twice; leave one out");
}

bool are_connected(const SphereSet& set, std::size_t k, std::size_t l) {
  return gap_between(set, k, l) <= touching_tolerance * std::max(set.radii[k], set.radii[l]);
}

} // namespace

int leave_out_equal_spheres(SphereSet& set) {
  const std::vector<std::size_t> first = first_equal_spheres(set);
  std::size_t kept = 0;
  for (std::size_t k = 0; k < first.size(); ++k) {
    if (first[k] != k)
      continue;
    set.centres[kept] = set.centres[k];
    set.radii[kept++] = set.radii[k];
  }
  set.centres.resize(kept);
  set.radii.resize(kept);
  return static_cast<int>(first.size() - kept);
}

void check_values(const SphereSet& set) {
  if (set.centres.empty() || set.centres.size() > static_cast<std::size_t>(largest_set_count))
    refuse(std::to_string(set.centres.size()) + " spheres; allowed are 1 to " +
           std::to_string(largest_set_count) + ": use a coarser set");
  if (set.radii.size() != set.centres.size())
    refuse(std::to_string(set.radii.size()) + " radii for " + std::to_string(set.centres.size()) +
           " centres; give each sphere one radius");
  for (std::size_t k = 0; k < set.centres.size(); ++k) {
    const Vector3& c = set.centres[k];
    const std::string which = "sphere " + std::to_string(k + 1) + " has ";
    if (!std::isfinite(c.x) || !std::isfinite(c.y) || !std::isfinite(c.z))
      refuse(which + "the centre " + number(c.x) + " " + number(c.y) + " " + number(c.z) +
             "; finite values are needed: correct it");
    if (!std::isfinite(set.radii[k]) || !(set.radii[k] > 0.0))
      refuse(which + "the radius " + number(set.radii[k]) +
             "; a finite value > 0 is needed: correct it or leave the sphere out");
    if (set.radii[k] < smallest_length || set.radii[k] > largest_length || norm(c) > largest_length)
      refuse(which + "the centre " + number(c.x) + " " + number(c.y) + " " + number(c.z) +
             " and the radius " + number(set.radii[k]) + "; radii from " + number(smallest_length) +
             " to " + number(largest_length) +
             " and no larger distances are allowed: choose "
             "another unit");
  }
}

void check_spheres(const SphereSet& set) {
  check_values(set);
  refuse_equal_spheres(set);
}

/// From each part's first sphere to all that can be reached.
std::vector<int> connected_parts(const SphereSet& set) {
  std::vector<int> parts(set.centres.size(), -1);
  std::vector<std::size_t> left(set.centres.size()), reached;
  std::iota(left.begin(), left.end(), std::size_t{0});
  for (int part = 0; !left.empty(); ++part) {
    reached = {left.front()};
    parts[left.front()] = part;
    left.erase(left.begin());
    while (!reached.empty()) {
      const std::size_t from = reached.back();
      reached.pop_back();
      const auto apart = std::stable_partition(
          left.begin(), left.end(), [&](std::size_t l) { return !are_connected(set, from, l); });
      for (auto l = apart; l != left.end(); ++l)
        parts[*l] = part;
      reached.insert(reached.end(), apart, left.end());
      left.erase(apart, left.end());
    }
  }
  return parts;
}

int connected_count(const SphereSet& set, int from, int step) {
  std::vector<std::size_t> root; // of each sphere; roots are their own
  const auto root_of = [&root](std::size_t k) {
    while (root[k] != k)
      k = root[k] = root[root[k]];
    return k;
  };
  int parts = 0, next = from;
  for (std::size_t k = 0; k < set.centres.size(); ++k) {
    root.push_back(k);
    ++parts;
    for (std::size_t l = 0; l < k; ++l)
      if (root_of(l) != root_of(k) && are_connected(set, k, l)) {
        root[root_of(l)] = root_of(k);
        --parts;
      }
    if (static_cast<int>(k) + 1 < next)
      continue;
    if (parts == 1)
      return next;
    next += step;
  }
  return 0;
}

void check_connected(const SphereSet& set) {
  const std::vector<int> parts = connected_parts(set);
  const int count = 1 + *std::max_element(parts.begin(), parts.end());
  if (count == 1)
    return;
  const auto apart =
      static_cast<std::size_t>(std::find(parts.begin(), parts.end(), 1) - parts.begin());
  double gap = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < parts.size(); ++k)
    if (parts[k] == 0)
      gap = std::min(gap, gap_between(set, k, apart));
  refuse("the spheres are " + std::to_string(count) + " bodies apart, sphere " +
         std::to_string(apart + 1) + " is " + number(gap) +
         " from that of sphere 1; a clump is one body: let its spheres overlap or touch");
}

} // namespace ellipsoid
