// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "disc_union.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ellipsoid::post {
namespace {

constexpr double pi = 3.141592653589793238462643;

/// Angles from -pi to pi.
using Arcs = std::vector<std::pair<double, double>>;

void add_arc(double begin, double end, Arcs& arcs) {
  if (begin < -pi) {
    arcs.emplace_back(begin + 2.0 * pi, pi);
    begin = -pi;
  }
  if (end > pi) {
    arcs.emplace_back(-pi, end - 2.0 * pi);
    end = pi;
  }
  arcs.emplace_back(begin, end);
}

/// What other discs cover of a disc's edge. Of equal discs the first one keeps its edge.
Arcs covered_arcs(const std::vector<Disc>& discs, std::size_t k) {
  Arcs arcs;
  const Disc& own = discs[k];
  for (std::size_t l = 0; l < discs.size(); ++l) {
    const double dx = discs[l].x - own.x, dy = discs[l].y - own.y, apart = std::hypot(dx, dy);
    const double r = own.radius, s = discs[l].radius;
    if (l == k || apart >= r + s || r >= apart + s) {
      if (l < k && apart == 0.0 && r == s)
        arcs.emplace_back(-pi, pi);
      continue;
    }
    if (s >= apart + r) {
      arcs.emplace_back(-pi, pi);
      continue;
    }
    const double cosine = (apart * apart + (r - s) * (r + s)) / (2.0 * apart * r);
    const double half = std::acos(std::clamp(cosine, -1.0, 1.0)), middle = std::atan2(dy, dx);
    add_arc(middle - half, middle + half, arcs);
  }
  std::sort(arcs.begin(), arcs.end());
  return arcs;
}

/// By Green's theorem.
void add_free_arc(const Disc& disc, double from, double to, DiscUnion& sums) {
  const double r = disc.radius;
  sums.perimeter += r * (to - from);
  sums.area += 0.5 * r *
               (r * (to - from) + disc.x * (std::sin(to) - std::sin(from)) -
                disc.y * (std::cos(to) - std::cos(from)));
}

} // namespace

DiscUnion measure_discs(const std::vector<Disc>& discs) {
  DiscUnion sums;
  for (std::size_t k = 0; k < discs.size(); ++k) {
    double reached = -pi;
    for (const auto& [begin, end] : covered_arcs(discs, k)) {
      if (begin > reached)
        add_free_arc(discs[k], reached, begin, sums);
      reached = std::max(reached, end);
    }
    if (reached < pi)
      add_free_arc(discs[k], reached, pi, sums);
  }
  return sums;
}

} // namespace ellipsoid::post
