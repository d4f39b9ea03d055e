// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Which pairs of spheres of two neighbouring chains have to be tested in a time step.
//
// A search (multisphere_contact.h) finds all pairs of spheres closer than a gap. Until both bodies
// together have travelled that far, no other pair of spheres can touch, and a pair of chains without
// such spheres needs no look at all. "Travelled" is the sum over all steps of travel(), which no
// point of the body exceeds: the proof is exact, and what touches does not depend on when the last
// search was.
#pragma once

#include "multisphere_contact.h"

#include <cstddef>
#include <vector>

namespace ellipsoid {

/// How far any point of a body has moved at most (length).
/// @param[in] displacement of its centre (length)
inline double travel(const ChainPose& before, const ChainPose& after, const Vector3& displacement) {
  const SphereChain& chain = *after.chain;
  const double grown = std::fabs(after.scale - before.scale);
  return norm(displacement) + after.scale * chain.half_length() * norm(after.axis - before.axis) +
         grown * (chain.half_length() + chain.largest_radius());
}

class ContactWatch {
 public:
  /// One pair of spheres to test.
  struct SpherePair {
    double centre_i, centre_j, radius_i, radius_j; ///< in lengths of the chains
    short sphere_i, sphere_j;
    short slot; ///< of its history; -1: none (the caller's)
  };

  /// Travels are sums of many terms, and gaps good to search_rounding: a gap is used up to this share.
  static constexpr double usable_share = 1.0 - 1e-6;
  /// Where no spheres have to be tested a search looks so many times farther: the pair of chains rests
  /// until the nearest of them could touch.
  static constexpr double second_reach = 4.0;

  /// Forgets everything; `pairs` pairs of chains, all of them due.
  void restart(std::size_t pairs);

  /// Whether a pair of chains must be searched again.
  /// @param[in] travelled by both bodies since restart() (length)
  bool is_due(std::size_t pair, double travelled) const {
    return !(travelled < watched_[pair].until);
  }
  /// Travelled distance at which the pair is due (length).
  double until(std::size_t pair) const { return watched_[pair].until; }
  /// Whether no spheres have to be tested until the pair is due.
  bool is_empty(std::size_t pair) const { return watched_[pair].count == 0; }

  /// Searches the pair; all its spheres to test are without slot then, in ascending order.
  /// @param[in] centre_distance x_j - x_i (length)
  /// @param[in] gap > 0: spheres closer than this are to be tested (length)
  /// @return how many distances between spheres were computed
  int search(std::size_t pair, double travelled, const ChainPose& i, const ChainPose& j,
             const Vector3& centre_distance, double gap);

  /// Spheres to test, ordered by sphere_i, then sphere_j.
  SpherePair* begin(std::size_t pair) { return &spheres_[watched_[pair].first]; }
  SpherePair* end(std::size_t pair) { return begin(pair) + watched_[pair].count; }

  /// Calls on_touch(SpherePair&, const SphereContact&) for all spheres to test that touch.
  template <class OnTouch>
  void for_each_touching(std::size_t pair, const ChainPose& i, const ChainPose& j,
                         const Vector3& centre_distance, const OnTouch& on_touch) {
    const Vector3 axis_i = i.scale * i.axis, axis_j = j.scale * j.axis;
    for (SpherePair *s = begin(pair), *last = end(pair); s != last; ++s) {
      const Vector3 distance = centre_distance + (s->centre_j * axis_j - s->centre_i * axis_i);
      const double sum = (1.0 + search_rounding) * (i.scale * s->radius_i + j.scale * s->radius_j);
      if (dot(distance, distance) < sum * sum &&
          touch(i, j, centre_distance, s->sphere_i, s->sphere_j, contact_))
        on_touch(*s, static_cast<const SphereContact&>(contact_));
    }
  }

 private:
  struct Watched {
    double until = 0.0; ///< travelled distance at which it is due (length)
    unsigned first = 0; ///< of its places in spheres_
    int count = 0, room = 0;
  };
  std::vector<Watched> watched_;
  std::vector<SpherePair> spheres_;
  std::vector<SpherePair> found_;
  SphereContact contact_; // here, not to be cleared for every pair

  int find(const ChainPose& i, const ChainPose& j, const Vector3& centre_distance, double gap);
  void keep_found(std::size_t pair);
};

} // namespace ellipsoid
