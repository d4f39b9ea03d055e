// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Contacts between two chains of spheres on straight axes.
//
// Conventions (those of ellipsoid_contact.h):
//  - the normal n points from body i to body j;
//  - the overlap h = R_k + R_l - |c_l - c_k| is positive when spheres penetrate;
//  - the contact point lies in the middle of the overlap, relative to the centre of i;
//  - a pair of spheres touches when |c_l - c_k|^2 < (R_k + R_l)^2: nothing else is a contact.
//
// The search. Let the outer chain be the one with fewer spheres.
//  (1) Only those of its spheres count whose centre lies within R_max,i + R_max,j of the other
//      axis' line and within reach of the other chain along both axes: an interval, found in O(1).
//  (2) Seen from an outer sphere k at axial coordinate t and distance p from the inner axis, inner
//      sphere l overlaps by f(l) = R_k + R_l - sqrt((x_l - t)^2 + p^2). Radii are a concave
//      function of the abscissa (checked once per chain) and the root is convex, so f is concave
//      along the inner axis: its maximum is reached by walking uphill, and the touching spheres are
//      its neighbours without gaps. The walk starts where the previous k ended.
//  (3) The maximum changes by at most (1 + steepest radius) per length along the outer axis, so a
//      gap of g allows to skip all k within g / (1 + steepest radius).
// All bounds are widened by `search_rounding`, so no contact can be lost to rounding; the pairs
// left are tested exactly.
#pragma once

#include "math/vector3.h"
#include "multisphere/multisphere_template.h"

#include <cmath>
#include <vector>

namespace ellipsoid {

/// Widening of the search bounds, relative to the extent of the pair: they are sums of a few
/// products, good to about 1e-15, and chains are concave to `concavity_rounding`.
constexpr double search_rounding = 1e-11;
constexpr double concavity_rounding = 1e-14; ///< relative to the largest radius

/// Up to so many pairs of spheres are all tested: quicker than any search (3 by 3).
constexpr int direct_search_limit = 9;

/// An axis direction is used to bound an interval only if it changes the bounded quantity by more
/// than this per unit length: keeps the quotient's rounding far below `search_interval_rounding`.
constexpr double search_smallest_slope = 1e-4;
constexpr double search_interval_rounding = 1e-7; ///< search_rounding / slope, with a margin

/// A chain prepared for the search. Built once per template, shared by all its particles.
class SphereChain {
 public:
  /// @throws std::invalid_argument centres not ascending, radii not positive or not a concave
  ///         function of the centres (every chain of make_multisphere() is)
  explicit SphereChain(const MultisphereTemplate& geometry);

  int count() const { return static_cast<int>(centres_.size()); }
  double centre(int k) const { return centres_[static_cast<std::size_t>(k)]; }
  double radius(int k) const { return radii_[static_cast<std::size_t>(k)]; }
  double half_length() const { return half_length_; } ///< largest |centre| (length)
  double largest_radius() const { return largest_radius_; }
  double steepest_radius() const { return steepest_radius_; } ///< largest |dR/dx| of neighbours

  /// Smallest index whose centre is >= x; count() if there is none.
  int first_at_or_after(double x) const;

 private:
  std::vector<double> centres_, radii_;
  double half_length_ = 0.0, largest_radius_ = 0.0, steepest_radius_ = 0.0;
};

/// One body: a chain, the direction of its axis, and its size relative to the chain's.
struct ChainPose {
  const SphereChain* chain = nullptr;
  Vector3 axis{1.0, 0.0, 0.0}; ///< unit: the body's x axis in space
  double scale = 1.0;          ///< particle's length / chain's length
};

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

/// One sphere of a chain, in lengths of the chain.
struct ChainSphere {
  int number;
  double centre, radius;
};

inline ChainSphere sphere(const SphereChain& chain, int k) {
  return {k, chain.centre(k), chain.radius(k)};
}

/// From the centre of sphere k of i to that of sphere l of j (length).
inline Vector3 sphere_distance(const ChainPose& i, const ChainPose& j,
                               const Vector3& centre_distance, double centre_k, double centre_l) {
  // This order of operations changes only its sign when i and j are swapped.
  return centre_distance + ((j.scale * centre_l) * j.axis - (i.scale * centre_k) * i.axis);
}

/// Coinciding centres have no normal of their own: any direction across the axis of i will do.
Vector3 normal_across(const Vector3& axis);

/// Tests one pair of spheres.
/// @param[in] centre_distance x_j - x_i (length)
/// @return whether they touch; `contact` is complete then, untouched otherwise
inline bool touch(const ChainPose& i, const ChainPose& j, const Vector3& centre_distance,
                  const ChainSphere& k, const ChainSphere& l, SphereContact& contact) {
  const Vector3 distance = sphere_distance(i, j, centre_distance, k.centre, l.centre);
  const double radius_k = i.scale * k.radius, radius_l = j.scale * l.radius;
  const double sum = radius_k + radius_l, squared = dot(distance, distance);
  if (!(squared < sum * sum))
    return false;
  const double length = std::sqrt(squared), overlap = sum - length;
  const Vector3 normal = length > 0.0 ? (1.0 / length) * distance : normal_across(i.axis);
  contact.sphere_i = k.number;
  contact.sphere_j = l.number;
  contact.normal = normal;
  contact.overlap = overlap;
  contact.point = (i.scale * k.centre) * i.axis + (radius_k - 0.5 * overlap) * normal;
  contact.reduced_radius = radius_k * radius_l / sum;
  contact.radius_i = radius_k;
  contact.radius_j = radius_l;
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
OuterLine outer_line(const ChainPose& outer, const ChainPose& inner, const Vector3& outer_position,
                     double gap);

/// Inner sphere near axial coordinate t: where the first walk starts.
inline int inner_start(const ChainPose& inner, double t) {
  const int l = inner.chain->first_at_or_after(t / inner.scale);
  return l < inner.chain->count() ? l : l - 1;
}

/// The inner chain seen from one outer sphere.
class InnerView {
 public:
  InnerView(const ChainPose& inner, double radius, double t, double p2, int& tested)
      : chain_(*inner.chain), scale_(inner.scale), radius_(radius), t_(t), p2_(p2),
        tested_(tested) {}

  double overlap(int l) const {
    ++tested_;
    const double u = scale_ * chain_.centre(l) - t_;
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

  const SphereChain& chain_;
  double scale_, radius_, t_, p2_;
  int& tested_;
};

/// Calls visit(outer sphere, inner sphere, overlap) for every pair that may be closer than `gap`;
/// the overlap is negative between spheres apart, and good to search_rounding.
/// @param[out] tested is increased by the number of distances computed
template <class Visit>
void for_each_candidate(const ChainPose& outer, const ChainPose& inner,
                        const Vector3& outer_position, double gap, int& tested,
                        const Visit& visit) {
  const OuterLine line = outer_line(outer, inner, outer_position, gap);
  if (line.centres.low > line.centres.high)
    return;
  const SphereChain& chain = *outer.chain;
  const double margin = search_rounding * line.extent, least = -gap - margin;
  const double length_per_gap = 1.0 / (1.0 + chain.steepest_radius());
  int k = chain.first_at_or_after(line.centres.low / outer.scale);
  int nearest = -1;
  while (k < chain.count()) {
    const double x = outer.scale * chain.centre(k);
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
      for (int l = nearest + 1; l < inner.chain->count() && (next = view.overlap(l)) > least; ++l)
        visit(k - 1, l, next);
      continue;
    }
    const double skipped = x - length_per_gap * (overlap + gap) - margin;
    while (k < chain.count() && outer.scale * chain.centre(k) < skipped)
      ++k;
  }
}

} // namespace multisphere_search

/// Calls visit(sphere of i, sphere of j, overlap) for every pair of spheres closer than `gap`, and
/// maybe for some more; the overlap is negative between spheres apart, and good to search_rounding.
/// @param[in] centre_distance x_j - x_i (length)
/// @param[in] gap >= 0 (length)
/// @return how many distances between spheres were computed
template <class Visit>
int for_each_near_pair(const ChainPose& i, const ChainPose& j, const Vector3& centre_distance,
                       double gap, const Visit& visit) {
  int tested = 0;
  if (i.chain->count() * j.chain->count() <= direct_search_limit) {
    for (int k = 0; k < i.chain->count(); ++k)
      for (int l = 0; l < j.chain->count(); ++l) {
        const Vector3 distance =
            sphere_distance(i, j, centre_distance, i.chain->centre(k), j.chain->centre(l));
        visit(k, l, i.scale * i.chain->radius(k) + j.scale * j.chain->radius(l) - norm(distance));
      }
    return i.chain->count() * j.chain->count();
  }
  if (i.chain->count() <= j.chain->count())
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
ContactCount for_each_contact(const ChainPose& i, const ChainPose& j,
                              const Vector3& centre_distance, OnContact&& on_contact) {
  ContactCount count;
  SphereContact contact;
  count.tested = for_each_near_pair(i, j, centre_distance, 0.0, [&](int k, int l, double) {
    if (!touch(i, j, centre_distance, sphere(*i.chain, k), sphere(*j.chain, l), contact))
      return;
    ++count.contacts;
    on_contact(static_cast<const SphereContact&>(contact));
  });
  return count;
}

/// The same, into a vector that is cleared first (it allocates only while its capacity grows).
ContactCount find_contacts(const ChainPose& i, const ChainPose& j, const Vector3& centre_distance,
                           std::vector<SphereContact>& contacts);

/// Lower bound of the distance between the two bodies: that of their capsules (axis segments with
/// the largest radius). Positive: proof that no spheres touch (length). Negative values are good to
/// 1e-7 of the bodies' lengths where nearly parallel axes meet.
double smallest_gap(const ChainPose& i, const ChainPose& j, const Vector3& centre_distance);

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
