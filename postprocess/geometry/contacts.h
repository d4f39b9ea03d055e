// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Contacts recomputed from positions with the engine's own kernel.
#pragma once

#include "particles.h"

#include <utility>
#include <vector>

namespace ellipsoid::post {

/// One touching pair of bodies: two ellipsoids, or a sub-sphere with a sub-sphere or ellipsoid.
struct Contact {
  Vector3 point;        ///< in space (length)
  Vector3 normal;       ///< unit, from i to j
  double overlap = 0.0; ///< h >= -gap (length)
};

/// One touching pair of particles (i < j, indices of the set) with all its contacts. In a box that
/// repeats a pair may come several times, by different images; a particle is no partner of its own
/// images.
struct PairContact {
  std::size_t i = 0, j = 0;
  std::size_t first = 0, count = 0; ///< its run in ContactNetwork::contacts
  double largest_overlap = 0.0;     ///< (length)
};

struct ContactNetwork {
  std::vector<PairContact> pairs;
  std::vector<Contact> contacts;
  std::size_t not_converged = 0; ///< contacts whose search hit its iteration limit
  bool reaches_itself = false;   ///< the box is so short that particles come near their own images
};

/// The pairs of particles that come near each other, found once for several searches.
class NearPairs {
 public:
  using Pair = std::pair<std::size_t, std::size_t>; ///< indices of the set, the smaller one first

  NearPairs() = default;
  /// Those whose bounding balls, enlarged by gap / 2 each, overlap, in ascending order; with all
  /// images in a box that repeats.
  NearPairs(const ParticleSet& set, double gap);
  double gap() const { return gap_; }
  const std::vector<Pair>& pairs() const { return pairs_; }
  /// From the second particle of a pair to its image that is near the first one (length).
  Vector3 shift(std::size_t pair) const { return shifts_.empty() ? Vector3{} : shifts_[pair]; }
  bool reaches_itself() const { return reaches_itself_; }

 private:
  void find_in_cell(const ParticleSet& set, const std::vector<double>& radii);

  double gap_ = 0.0; ///< (length)
  std::vector<Pair> pairs_;
  std::vector<Vector3> shifts_; ///< by pair; empty: none is shifted
  bool reaches_itself_ = false;
};

/// All contacts between particles. Two bodies touch when the kernel's overlap is h >= 0; with a
/// gap > 0 all semi-axes and radii are first enlarged by gap / 2 (the overlap is then that of
/// the enlarged bodies minus gap).
ContactNetwork find_contacts(const ParticleSet& set, double gap);
/// @param[in] near of the same set; useful when its gap is not smaller
ContactNetwork find_contacts(const ParticleSet& set, double gap, const NearPairs& near);

/// The cluster of every particle, by the smallest index in it: particles belong together when they
/// touch as in find_contacts(), or are connected by particles that do. Faster than the contacts.
/// The gap is that of the near pairs.
/// @param[in] touching pairs that are known to touch, if any
std::vector<std::size_t> touching_clusters(const ParticleSet& set, const NearPairs& near,
                                           const std::vector<PairContact>& touching = {});

/// A plane wall: bodies are on the side into which `inward` points.
struct PlaneWall {
  Vector3 point, inward; ///< inward: unit
};

/// Radius of the ball about a particle's centre that holds it (length).
double bounding_radius(const ParticleSet& set, const Particle& p);

/// Contacts of one particle with a wall: overlaps (length) of the bodies that touch it, after
/// the same enlargement by gap.
std::vector<double> wall_overlaps(const ParticleSet& set, std::size_t particle,
                                  const PlaneWall& wall, double gap);

} // namespace ellipsoid::post
