// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Contacts between two bodies made of spheres: chains on straight axes, or any sets.
//
// Conventions (those of ellipsoid_contact.h):
//  - the normal n points from body i to body j;
//  - the overlap h = R_k + R_l - |c_l - c_k| is positive when spheres penetrate;
//  - the contact point lies in the middle of the overlap, relative to the centre of i;
//  - a pair of spheres touches when |c_l - c_k|^2 < (R_k + R_l)^2: nothing else is a contact.
//
// The search of two chains. Let the outer chain be the one with fewer spheres.
//  (1) Only those of its spheres count whose centre lies within R_max,i + R_max,j of the other
//      axis' line and within reach of the other chain along both axes: an interval, found in O(1).
//  (2) Seen from an outer sphere k at axial coordinate t and distance p from the inner axis, inner
//      sphere l overlaps by f(l) = R_k + R_l - sqrt((x_l - t)^2 + p^2). Radii are a concave
//      function of the abscissa (checked once per chain) and the root is convex, so f is concave
//      along the inner axis: its maximum is reached by walking uphill, and the touching spheres are
//      its neighbours without gaps. The walk starts where the previous k ended.
//  (3) The maximum changes by at most (1 + steepest radius) per length along the outer axis, so a
//      gap of g allows to skip all k within g / (1 + steepest radius).
// Where one of the bodies is no chain, their trees are walked together (sphere_tree.h).
// All bounds are widened by `search_rounding`, so no contact can be lost to rounding; the pairs
// left are tested exactly.
#pragma once

#include "math/vector3.h"
#include "multisphere/multisphere_body.h"

#include <cmath>
#include <vector>

namespace ellipsoid {

/// Widening of the search bounds, relative to the extent of the pair: they are sums of a few
/// products, good to about 1e-15, and chains are concave to `concavity_rounding`.
constexpr double search_rounding = 1e-11;

/// Up to so many pairs of spheres are all tested: quicker than any search (3 by 3).
constexpr int direct_search_limit = 9;

/// An axis direction is used to bound an interval only if it changes the bounded quantity by more
/// than this per unit length: keeps the quotient's rounding far below `search_interval_rounding`.
constexpr double search_smallest_slope = 1e-4;
constexpr double search_interval_rounding = 1e-7; ///< search_rounding / slope, with a margin

struct SphereContact {
  int sphere_i = 0, sphere_j = 0;
  Vector3 normal; ///< unit, from i to j
  Vector3 point;  ///< middle of the overlap, relative to the centre of i (length)
  double overlap = 0.0;
  double reduced_radius = 0.0;           ///< R_k R_l / (R_k + R_l) (length)
  double radius_i = 0.0, radius_j = 0.0; ///< of the two spheres (length)
};

struct ContactCount {
  int contacts = 0;
  int tested = 0; ///< distances between spheres computed: potential contacts (figure 18)
};

/// One sphere of a body in space.
struct PlacedSphere {
  int number;
  Vector3 centre; ///< from the body's centre (length)
  double radius;  ///< (length)
};

inline PlacedSphere placed(const SphereCentres& spheres, int k) {
  return {k, spheres.at(k), spheres.radius(k)};
}

/// Tests one pair of spheres.
/// @param[in] centre_distance x_j - x_i (length)
/// @param[in] axis_i of body i
/// @return whether they touch; `contact` is complete then, untouched otherwise
inline bool touch(const Vector3& axis_i, const Vector3& centre_distance, const PlacedSphere& k,
                  const PlacedSphere& l, SphereContact& contact) {
  // This order of operations changes only its sign when i and j are swapped.
  const Vector3 distance = centre_distance + (l.centre - k.centre);
  const double sum = k.radius + l.radius, squared = dot(distance, distance);
  if (!(squared < sum * sum))
    return false;
  const double length = std::sqrt(squared), overlap = sum - length;
  // coinciding centres have no normal of their own
  const Vector3 normal = length > 0.0 ? (1.0 / length) * distance : normal_across(axis_i);
  contact.sphere_i = k.number;
  contact.sphere_j = l.number;
  contact.normal = normal;
  contact.overlap = overlap;
  contact.point = k.centre + (k.radius - 0.5 * overlap) * normal;
  contact.reduced_radius = k.radius * l.radius / sum;
  contact.radius_i = k.radius;
  contact.radius_j = l.radius;
  return true;
}

namespace multisphere_search {

/// Closed interval; empty when low > high.
struct Interval {
  double low, high;
  void clip(double from, double to) {
    if (from > low)
      low = from;
    if (to < high)
      high = to;
  }
};

/// Outer body seen from the inner one's centre and axis.
struct OuterLine {
  double offset = 0.0, slope = 0.0; ///< axial coordinate t(x) = offset + slope x
  /// Squared distance from the axis p(x)^2 = squared + 2 linear x + quadratic x^2.
  double squared = 0.0, linear = 0.0, quadratic = 0.0;
  double extent = 0.0;        ///< of the pair: scale of rounding (length)
  Interval centres{0.0, 0.0}; ///< abscissae of outer spheres that may touch (length)
};

/// @param[in] outer_position outer centre - inner centre (length)
/// @param[in] gap spheres count that are closer than this (length)
OuterLine outer_line(const MultispherePose& outer, const MultispherePose& inner,
                     const Vector3& outer_position, double gap);

/// Inner sphere near axial coordinate t: where the first walk starts.
inline int inner_start(const MultispherePose& inner, double t) {
  const int l = inner.body->first_at_or_after(t / inner.scale);
  return l < inner.body->count() ? l : l - 1;
}

/// The inner chain seen from one outer sphere.
class InnerView {
 public:
  InnerView(const MultispherePose& inner, double radius, double t, double p2, int& tested)
      : chain_(*inner.body), scale_(inner.scale), radius_(radius), t_(t), p2_(p2), tested_(tested) {
  }

  double overlap(int l) const {
    ++tested_;
    const double u = scale_ * chain_.abscissa(l) - t_;
    return radius_ + scale_ * chain_.radius(l) - std::sqrt(u * u + p2_);
  }

  /// Walks from sphere `l` to the one with the largest overlap, which is returned.
  double climb(int& l) const {
    double best = overlap(l);
    if (!climb(l, +1, best))
      climb(l, -1, best);
    return best;
  }

 private:
  bool climb(int& l, int step, double& best) const {
    const int start = l;
    while (l + step >= 0 && l + step < chain_.count()) {
      const double next = overlap(l + step);
      if (!(next > best))
        break;
      best = next;
      l += step;
    }
    return l != start;
  }

  const MultisphereBody& chain_;
  double scale_, radius_, t_, p2_;
  int& tested_;
};

/// Calls visit(outer sphere, inner sphere, overlap) for every pair that may be closer than `gap`;
/// the overlap is negative between spheres apart, and good to search_rounding.
/// @param[out] tested is increased by the number of distances computed
template <class Visit>
void for_each_candidate(const MultispherePose& outer, const MultispherePose& inner,
                        const Vector3& outer_position, double gap, int& tested,
                        const Visit& visit) {
  const OuterLine line = outer_line(outer, inner, outer_position, gap);
  if (line.centres.low > line.centres.high)
    return;
  const MultisphereBody& chain = *outer.body;
  const double margin = search_rounding * line.extent, least = -gap - margin;
  const double length_per_gap = 1.0 / (1.0 + chain.steepest_radius());
  int k = chain.first_at_or_after(line.centres.low / outer.scale);
  int nearest = -1;
  while (k < chain.count()) {
    const double x = outer.scale * chain.abscissa(k);
    if (x > line.centres.high)
      return;
    const double t = line.offset + line.slope * x;
    const double p2 = line.squared + x * (2.0 * line.linear + x * line.quadratic);
    if (nearest < 0)
      nearest = inner_start(inner, t);
    const InnerView view(inner, outer.scale * chain.radius(k), t, std::fmax(0.0, p2), tested);
    const double overlap = view.climb(nearest);
    ++k;
    if (overlap > least) {
      visit(k - 1, nearest, overlap);
      double next;
      for (int l = nearest - 1; l >= 0 && (next = view.overlap(l)) > least; --l)
        visit(k - 1, l, next);
      for (int l = nearest + 1; l < inner.body->count() && (next = view.overlap(l)) > least; ++l)
        visit(k - 1, l, next);
      continue;
    }
    const double skipped = x - length_per_gap * (overlap + gap) - margin;
    while (k < chain.count() && outer.scale * chain.abscissa(k) < skipped)
      ++k;
  }
}

/// Body j seen from body i.
RelativePose relative_pose(const MultispherePose& i, const MultispherePose& j,
                           const Vector3& centre_distance);

/// Of bodies that are no chains both.
template <class Visit>
int for_each_near_pair_of_trees(const MultispherePose& i, const MultispherePose& j,
                                const Vector3& centre_distance, double gap, const Visit& visit) {
  const double extent = i.scale * i.body->reach() + j.scale * j.body->reach() + gap;
  const double within = (gap + search_rounding * extent) / i.scale;
  return for_each_pair_within(i.body->tree(), j.body->tree(), relative_pose(i, j, centre_distance),
                              within, [&](int k, int l, double g) { visit(k, l, -i.scale * g); });
}

} // namespace multisphere_search

/// Calls visit(sphere of i, sphere of j, overlap) for every pair of spheres closer than `gap`, and
/// maybe for some more; the overlap is negative between spheres apart, and good to search_rounding.
/// @param[in] centre_distance x_j - x_i (length)
/// @param[in] gap >= 0 (length)
/// @return how many distances between spheres were computed
template <class Visit>
int for_each_near_pair(const MultispherePose& i, const MultispherePose& j,
                       const Vector3& centre_distance, double gap, const Visit& visit) {
  int tested = 0;
  if (i.body->count() * j.body->count() <= direct_search_limit) {
    const SphereCentres of_i(i), of_j(j);
    for (int k = 0; k < i.body->count(); ++k)
      for (int l = 0; l < j.body->count(); ++l)
        visit(k, l,
              of_i.radius(k) + of_j.radius(l) - norm(centre_distance + (of_j.at(l) - of_i.at(k))));
    return i.body->count() * j.body->count();
  }
  if (!i.body->is_chain() || !j.body->is_chain())
    return multisphere_search::for_each_near_pair_of_trees(i, j, centre_distance, gap, visit);
  if (i.body->count() <= j.body->count())
    multisphere_search::for_each_candidate(i, j, -centre_distance, gap, tested, visit);
  else
    multisphere_search::for_each_candidate(
        j, i, centre_distance, gap, tested,
        [&](int l, int k, double overlap) { visit(k, l, overlap); });
  return tested;
}

/// Calls on_contact(const SphereContact&) for every touching pair of spheres. No allocation.
/// @param[in] centre_distance x_j - x_i (length)
template <class OnContact>
ContactCount for_each_contact(const MultispherePose& i, const MultispherePose& j,
                              const Vector3& centre_distance, OnContact&& on_contact) {
  ContactCount count;
  SphereContact contact;
  const SphereCentres of_i(i), of_j(j);
  count.tested = for_each_near_pair(i, j, centre_distance, 0.0, [&](int k, int l, double) {
    if (!touch(i.axis, centre_distance, placed(of_i, k), placed(of_j, l), contact))
      return;
    ++count.contacts;
    on_contact(static_cast<const SphereContact&>(contact));
  });
  return count;
}

/// Lower bound of the distance between the two bodies. Of chains that of their capsules (axis
/// segments with the largest radius), of others that of their bounding spheres. Positive: proof
/// that no spheres touch (length). Negative values are good to 1e-7 of the bodies' lengths where
/// nearly parallel axes meet.
double smallest_gap(const MultispherePose& i, const MultispherePose& j,
                    const Vector3& centre_distance);

/// Distance between the nearest two spheres of the bodies, or `limit` where none are nearer
/// (length); good to search_rounding.
/// @param[out] tested is increased by the number of distances computed
double nearest_gap(const MultispherePose& i, const MultispherePose& j,
                   const Vector3& centre_distance, double limit, int& tested);

/// What becomes of several simultaneous contacts of one pair of particles (or particle and wall).
enum class MulticontactRule {
  sum,    ///< eq. (25): forces of all contacts add up
  average ///< the sum, divided by the number of contacts of this pair at this moment
};

/// Factor for the force (normal and tangential, elastic and viscous, hence also the torque) of
/// every sphere contact of a pair with `contacts` touching pairs of spheres: 1 for `sum`,
/// 1/contacts for `average`, so that parallel springs act like one of their mean stiffness. The
/// contact law is evaluated for each contact unscaled, with its own overlap, history and friction
/// limit; only its result is scaled. Contacts of a particle with different partners, or with
/// different walls, are not averaged with each other. `average` stands for the correction of
/// multiple contacts that Markauskas et al. 2010 mention below eq. 25 (Kruggel-Emden et al. 2008,
/// Powder Technology 188, 153-165); what is averaged is what is written here.
/// @param[in] contacts >= 1
inline double multicontact_weight(MulticontactRule rule, int contacts) {
  return rule == MulticontactRule::average ? 1.0 / contacts : 1.0;
}

} // namespace ellipsoid
