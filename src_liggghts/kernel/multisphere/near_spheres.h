// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Which pairs of spheres of two neighbouring bodies have to be tested in a time step.
//
// A search (multisphere_contact.h) finds all pairs of spheres closer than a gap. Until both bodies
// may have come closer by that much (motion_clocks.h), no other pair of spheres can touch, and a
// pair of chains without such spheres needs no test at all. The proof is exact, and what touches
// does not depend on when the last search was.
#pragma once

#include "multisphere/multisphere_contact.h"
#include "separation/motion_clocks.h"
#include "vectorised/prefetch.h"

#include <cstddef>
#include <vector>

namespace ellipsoid {

class NearSpheres {
 public:
  /// One pair of spheres to test.
  struct SpherePair {
    double centre_i, centre_j; ///< of chains: abscissae, in lengths of the template
    double radius_i, radius_j; ///< in lengths of the template
    short sphere_i, sphere_j;
    short slot; ///< of its history; -1: none (the caller's)
  };

  /// Gaps are good to search_rounding: a gap is used up to this share.
  static constexpr double usable_share = 1.0 - 1e-6;
  /// Where no spheres have to be tested a search goes so many times farther: the pair of chains
  /// is left alone until the nearest of them could touch.
  static constexpr double second_reach = 4.0;

  /// Forgets everything; `pairs` pairs of chains, all of them due.
  void restart(std::size_t pairs);

  /// Whether a pair of chains must be searched again.
  /// @param[in] time_i, time_j of the clocks of its bodies
  bool is_due(std::size_t pair, double time_i, double time_j) const {
    const OfPair& of_pair = of_pairs_[pair];
    return !(time_i < of_pair.until.i && time_j < of_pair.until.j);
  }
  /// Until then the pair is not due.
  void set_deadlines(std::size_t pair, const MotionClocks::Deadlines& until) {
    of_pairs_[pair].until = until;
  }
  /// Whether the last search found no spheres to test.
  bool is_empty(std::size_t pair) const { return of_pairs_[pair].count == 0; }

  /// Asks the processor for what is remembered of a pair; then for its spheres.
  void prefetch_pair(std::size_t pair) const { prefetch(&of_pairs_[pair]); }
  void prefetch_spheres(std::size_t pair) const {
    const SpherePair* spheres = &spheres_[of_pairs_[pair].first];
    prefetch_to_write(spheres);
    prefetch_to_write(spheres + 2);
  }

  struct Search {
    double gap; ///< until the bodies are closer by so much no other spheres touch (length)
    int tested; ///< distances between spheres that were computed
  };
  /// Searches the pair, which is due then until set_deadlines(); all its spheres to test are
  /// without slot, in ascending order.
  /// @param[in] centre_distance x_j - x_i (length)
  /// @param[in] gap > 0: spheres closer than this are to be tested (length)
  Search search(std::size_t pair, const MultispherePose& i, const MultispherePose& j,
                const Vector3& centre_distance, double gap);

  /// Spheres to test, ordered by sphere_i, then sphere_j.
  SpherePair* begin(std::size_t pair) { return &spheres_[of_pairs_[pair].first]; }
  SpherePair* end(std::size_t pair) { return begin(pair) + of_pairs_[pair].count; }

  struct Touching {
    SpherePair* spheres;
    SphereContact contact;
  };
  /// Finds all spheres to test that touch, in their order.
  /// @param[out] touching has room for all from begin() to end()
  /// @return how many touch
  int find_touching(std::size_t pair, const MultispherePose& i, const MultispherePose& j,
                    const Vector3& centre_distance, Touching* touching) {
    int count = 0;
    const bool are_chains = i.body->is_chain() && j.body->is_chain();
    const SphereCentres of_i(i), of_j(j);
    for (SpherePair *s = begin(pair), *last = end(pair); s != last; ++s) {
      touching[count].spheres = s;
      const int k = s->sphere_i, l = s->sphere_j;
      const Vector3 centre_k = are_chains ? (i.scale * s->centre_i) * i.axis : of_i.at(k);
      const Vector3 centre_l = are_chains ? (j.scale * s->centre_j) * j.axis : of_j.at(l);
      count += touch(i.axis, centre_distance, {k, centre_k, i.scale * s->radius_i},
                     {l, centre_l, j.scale * s->radius_j}, touching[count].contact);
    }
    return count;
  }

 private:
  struct OfPair {
    MotionClocks::Deadlines until{0.0, 0.0};
    unsigned first = 0; ///< of its entries in spheres_
    int count = 0, room = 0;
  };
  std::vector<OfPair> of_pairs_;
  std::vector<SpherePair> spheres_;
  std::vector<SpherePair> found_;

  int find(const MultispherePose& i, const MultispherePose& j, const Vector3& centre_distance,
           double gap);
  void keep_found(std::size_t pair);
};

} // namespace ellipsoid
