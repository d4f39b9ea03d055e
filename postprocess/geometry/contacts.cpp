// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "contacts.h"

#include "disjoint_sets.h"
#include "ellipsoid/contact_batch.h"
#include "quick_test.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ellipsoid::post {

namespace {

/// Bodies of one particle for the search: its ellipsoid, or its spheres.
struct SearchBodies {
  std::vector<EllipsoidShape> smooth; ///< by particle; unused for multi-sphere particles
  std::vector<Vector3> centres;
  std::vector<char> is_smooth;
  std::vector<double> inner_radii; ///< of balls inside the ellipsoids

  /// From the first particle's centre to that of the second one's image.
  Vector3 distance(const NearPairs::Pair& pair, const Vector3& shift) const {
    return centres[pair.second] + shift - centres[pair.first];
  }
  /// Whether the centres alone tell that two ellipsoids touch.
  bool surely_touch(const NearPairs::Pair& pair, const Vector3& shift) const {
    const Vector3 d = distance(pair, shift);
    const double reach = inner_radii[pair.first] + inner_radii[pair.second];
    return dot(d, d) < reach * reach;
  }
  bool are_smooth(const NearPairs::Pair& pair) const {
    return is_smooth[pair.first] && is_smooth[pair.second];
  }
  void add_to(QuickTestBatch& tests, const NearPairs::Pair& pair, const Vector3& shift) const {
    tests.add(smooth[pair.first], smooth[pair.second], distance(pair, shift));
  }
};

SearchBodies search_bodies(const ParticleSet& set, double gap) {
  constexpr double well_inside = 1.0 - 1.0e-6; // far above rounding
  SearchBodies bodies;
  bodies.smooth.reserve(set.particles.size());
  bodies.centres.reserve(set.particles.size());
  const Vector3 half_gap{0.5 * gap, 0.5 * gap, 0.5 * gap};
  for (const Particle& p : set.particles) {
    bodies.smooth.push_back(make_shape(p.semiaxes + half_gap, p.orientation));
    bodies.centres.push_back(p.centre);
    bodies.is_smooth.push_back(static_cast<char>(p.is_smooth()));
    bodies.inner_radii.push_back(p.is_smooth() ? well_inside * p.smallest_axis() : 0.0);
  }
  return bodies;
}

EllipsoidShape enlarged_ball(const Sphere& sphere, double gap) {
  const double radius = sphere.radius + 0.5 * gap;
  return make_shape({radius, radius, radius}, {});
}

bool spheres_touch(const Sphere& s, const Sphere& t, double gap) {
  const Vector3 d = t.centre - s.centre;
  const double reach = s.radius + t.radius + gap;
  return dot(d, d) <= reach * reach;
}

bool ellipsoids_touch(const EllipsoidShape& i, const EllipsoidShape& j, const Vector3& distance) {
  constexpr int most_tests = 4; // the next step is the search itself
  QuickTest result;
  for (int k = 0; k < most_tests; ++k) {
    result = quick_test(i.a_matrix, j.a_matrix, distance, result.next_lambda);
    if (result.are_apart || result.touch)
      return !result.are_apart;
  }
  const ContactGeometry found = find_contact(i, j, distance);
  return found.status != ContactStatus::separated && found.overlap >= 0.0;
}

/// Runs visit(sphere) over the spheres of a particle until it returns true; whether it did.
template <class Visitor>
bool any_sphere(const ParticleSet& set, const Particle& p, const Visitor& visit) {
  const auto first = set.spheres.begin() + static_cast<std::ptrdiff_t>(p.first_sphere);
  return std::any_of(first, first + static_cast<std::ptrdiff_t>(p.sphere_count), visit);
}

Sphere moved(const Sphere& sphere, const Vector3& shift) {
  return {sphere.centre + shift, sphere.radius};
}

/// Whether two particles touch, as find_contacts() would have it.
/// @param[in] shift of the second one
bool particles_touch(const ParticleSet& set, const SearchBodies& bodies, double gap,
                     const NearPairs::Pair& pair, const Vector3& shift) {
  const auto [i, j] = pair;
  const Particle &p = set.particles[i], &q = set.particles[j];
  if (p.is_smooth() && q.is_smooth())
    return ellipsoids_touch(bodies.smooth[i], bodies.smooth[j], bodies.distance(pair, shift));
  if (p.is_smooth() || q.is_smooth()) {
    const std::size_t smooth = p.is_smooth() ? i : j;
    const Vector3 of_spheres = p.is_smooth() ? shift : -shift;
    return any_sphere(set, p.is_smooth() ? q : p, [&](const Sphere& s) {
      return ellipsoids_touch(bodies.smooth[smooth], enlarged_ball(s, gap),
                              s.centre + of_spheres - bodies.centres[smooth]);
    });
  }
  return any_sphere(set, p, [&](const Sphere& s) {
    return any_sphere(set, q,
                      [&](const Sphere& t) { return spheres_touch(s, moved(t, shift), gap); });
  });
}

/// Adds the contacts of pairs of particles to the network, in the order in which the pairs come.
/// Pairs of ellipsoids wait until there are enough of them to be searched together.
class PairFinder {
 public:
  PairFinder(const ParticleSet& set, const SearchBodies& bodies, double gap,
             ContactNetwork& network)
      : set_(set), bodies_(bodies), gap_(gap), network_(network) {}

  /// @param[in] shift of the second particle
  void find(const NearPairs::Pair& pair, const Vector3& shift) {
    if (bodies_.are_smooth(pair)) {
      tested_[static_cast<std::size_t>(tests_.size())] = pair;
      bodies_.add_to(tests_, pair, shift);
      if (tests_.full())
        test_waiting();
      return;
    }
    search_waiting();
    const auto [i, j] = pair;
    const Particle &p = set_.particles[i], &q = set_.particles[j];
    const std::size_t first = network_.contacts.size();
    if (p.is_smooth())
      ellipsoid_and_spheres(i, {}, q, shift, 1.0);
    else if (q.is_smooth())
      ellipsoid_and_spheres(j, shift, p, {}, -1.0);
    else
      spheres(p, q, shift);
    add_pair(i, j, first);
  }

  /// To be called after the last pair.
  void search_waiting() {
    test_waiting();
    search_touching();
  }

 private:
  void add_pair(std::size_t i, std::size_t j, std::size_t first) {
    const std::size_t count = network_.contacts.size() - first;
    if (count > 0)
      network_.pairs.push_back({i, j, first, count, largest_overlap(first)});
  }

  double largest_overlap(std::size_t first) const {
    double largest = network_.contacts[first].overlap;
    for (std::size_t k = first + 1; k < network_.contacts.size(); ++k)
      largest = std::max(largest, network_.contacts[k].overlap);
    return largest;
  }

  /// Takes the pairs that are not apart to the search.
  void test_waiting() {
    tests_.solve();
    for (int k = 0; k < tests_.size(); ++k) {
      if (tests_.are_apart(k))
        continue;
      const auto [i, j] = tested_[static_cast<std::size_t>(k)];
      waiting_[static_cast<std::size_t>(batch_.size())] = {{i, j}, tests_.distance(k)};
      batch_.add(bodies_.smooth[i], bodies_.smooth[j], tests_.distance(k), tests_.normal(k));
      if (batch_.full())
        search_touching();
    }
    tests_.clear();
  }

  void search_touching() {
    batch_.solve();
    for (int k = 0; k < batch_.size(); ++k) {
      const auto& [pair, distance] = waiting_[static_cast<std::size_t>(k)];
      const auto [i, j] = pair;
      const std::size_t first = network_.contacts.size();
      const ContactGeometry found = batch_.geometry(k);
      const EllipsoidShape &shape_i = bodies_.smooth[i], &shape_j = bodies_.smooth[j];
      if (is_settled(found, shape_i, shape_j))
        add_contact(found, bodies_.centres[i], 1.0);
      else
        add_contact(find_contact(shape_i, shape_j, distance), bodies_.centres[i], 1.0);
      add_pair(i, j, first);
    }
    batch_.clear();
  }

  void add_contact(const ContactGeometry& found, const Vector3& centre_i, double sign) {
    if (!has_converged(found.status))
      ++network_.not_converged;
    if (found.status == ContactStatus::separated || found.overlap < 0.0)
      return;
    // number by number: a contact that is copied right after its numbers were stored one by one
    // keeps the processor waiting
    Contact& contact = network_.contacts.emplace_back();
    contact.point = centre_i + found.point;
    contact.normal = sign * found.normal;
    contact.overlap = found.overlap - gap_;
  }

  /// @param[in] shift_smooth, shift_chain of the images
  /// @param[in] sign 1 when the ellipsoid is the pair's first particle, else -1
  void ellipsoid_and_spheres(std::size_t smooth, const Vector3& shift_smooth, const Particle& chain,
                             const Vector3& shift_chain, double sign) {
    const Vector3 centre = bodies_.centres[smooth] + shift_smooth;
    for (std::size_t k = chain.first_sphere; k < chain.first_sphere + chain.sphere_count; ++k) {
      const Sphere& s = set_.spheres[k];
      const Vector3 distance = s.centre + shift_chain - centre;
      const EllipsoidShape ball = enlarged_ball(s, gap_);
      if (!quick_test(bodies_.smooth[smooth].a_matrix, ball.a_matrix, distance, 0.5).are_apart)
        add_contact(find_contact(bodies_.smooth[smooth], ball, distance), centre, sign);
    }
  }

  /// @param[in] shift of the second particle
  void spheres(const Particle& p, const Particle& q, const Vector3& shift) {
    for (std::size_t k = p.first_sphere; k < p.first_sphere + p.sphere_count; ++k)
      for (std::size_t l = q.first_sphere; l < q.first_sphere + q.sphere_count; ++l)
        sphere_pair(set_.spheres[k], moved(set_.spheres[l], shift));
  }

  void sphere_pair(const Sphere& s, const Sphere& t) {
    if (!spheres_touch(s, t, gap_))
      return;
    const Vector3 d = t.centre - s.centre;
    const double distance = norm(d);
    const Vector3 normal = distance > 0.0 ? (1.0 / distance) * d : Vector3{1.0, 0.0, 0.0};
    const double overlap = s.radius + t.radius - distance;
    network_.contacts.push_back({s.centre + (s.radius - 0.5 * overlap) * normal, normal, overlap});
  }

  const ParticleSet& set_;
  const SearchBodies& bodies_;
  double gap_;
  ContactNetwork& network_;
  QuickTestBatch tests_;
  std::array<NearPairs::Pair, QuickTestBatch::capacity> tested_;
  ContactBatch batch_;
  struct Waiting {
    NearPairs::Pair pair;
    Vector3 distance; ///< of the centres
  };
  std::array<Waiting, ContactBatch::capacity> waiting_;
};

} // namespace

ContactNetwork find_contacts(const ParticleSet& set, double gap) {
  return find_contacts(set, gap, NearPairs(set, gap));
}

ContactNetwork find_contacts(const ParticleSet& set, double gap, const NearPairs& near) {
  if (gap > near.gap())
    return find_contacts(set, gap);
  const SearchBodies bodies = search_bodies(set, gap);
  ContactNetwork network;
  network.reaches_itself = near.reaches_itself();
  network.pairs.reserve(near.pairs().size());
  network.contacts.reserve(near.pairs().size());
  PairFinder finder(set, bodies, gap, network);
  for (std::size_t k = 0; k < near.pairs().size(); ++k)
    finder.find(near.pairs()[k], near.shift(k));
  finder.search_waiting();
  return network;
}

namespace {

/// Joins particles that touch. Pairs of ellipsoids wait for their quick tests until there are
/// enough of them.
class ClusterFinder {
 public:
  ClusterFinder(const ParticleSet& set, double gap)
      : set_(set), bodies_(search_bodies(set, gap)), gap_(gap), clusters_(set.particles.size()) {}

  /// @param[in] shift of the second particle
  void find(const NearPairs::Pair& pair, const Vector3& shift) {
    if (are_joined(pair))
      return;
    if (!bodies_.are_smooth(pair)) {
      search(pair, shift);
      return;
    }
    if (bodies_.surely_touch(pair, shift)) {
      join(pair);
      return;
    }
    waiting_[static_cast<std::size_t>(tests_.size())] = {pair, shift};
    bodies_.add_to(tests_, pair, shift);
    if (tests_.full())
      test_waiting();
  }

  /// A pair that touches.
  void join(const NearPairs::Pair& pair) { clusters_.join(pair.first, pair.second); }

  /// To be called after the last pair. Clusters by the smallest index in them.
  std::vector<std::size_t> clusters() {
    test_waiting();
    std::vector<std::size_t> roots(set_.particles.size());
    for (std::size_t i = 0; i < roots.size(); ++i)
      roots[i] = clusters_.root(i);
    return roots;
  }

 private:
  bool are_joined(const NearPairs::Pair& pair) {
    return clusters_.are_joined(pair.first, pair.second);
  }
  void search(const NearPairs::Pair& pair, const Vector3& shift) {
    if (particles_touch(set_, bodies_, gap_, pair, shift))
      join(pair);
  }
  void test_waiting() {
    tests_.solve();
    for (int k = 0; k < tests_.size(); ++k) {
      const auto& [pair, shift] = waiting_[static_cast<std::size_t>(k)];
      if (tests_.are_apart(k))
        continue;
      if (tests_.touch(k))
        join(pair);
      else if (!are_joined(pair))
        search(pair, shift);
    }
    tests_.clear();
  }

  const ParticleSet& set_;
  SearchBodies bodies_;
  double gap_;
  DisjointSets clusters_;
  QuickTestBatch tests_;
  struct Waiting {
    NearPairs::Pair pair;
    Vector3 shift;
  };
  std::array<Waiting, QuickTestBatch::capacity> waiting_;
};

} // namespace

std::vector<std::size_t> touching_clusters(const ParticleSet& set, const NearPairs& near,
                                           const std::vector<PairContact>& touching) {
  ClusterFinder finder(set, near.gap());
  for (const PairContact& pair : touching)
    finder.join({pair.i, pair.j});
  for (std::size_t k = 0; k < near.pairs().size(); ++k)
    finder.find(near.pairs()[k], near.shift(k));
  return finder.clusters();
}

std::vector<double> wall_overlaps(const ParticleSet& set, std::size_t particle,
                                  const PlaneWall& wall, double gap) {
  const Particle& p = set.particles[particle];
  std::vector<double> overlaps;
  if (p.is_smooth()) {
    constexpr double and_rounding = 1.0 + 1.0e-12;
    if (dot(p.centre - wall.point, wall.inward) > and_rounding * (p.largest_axis() + 0.5 * gap))
      return overlaps;
    const Vector3 half_gap{0.5 * gap, 0.5 * gap, 0.5 * gap};
    const ContactGeometry found = find_plane_contact(
        make_shape(p.semiaxes + half_gap, p.orientation), wall.point - p.centre, -wall.inward);
    if (found.overlap >= 0.0)
      overlaps.push_back(found.overlap - 0.5 * gap);
    return overlaps;
  }
  for (std::size_t k = p.first_sphere; k < p.first_sphere + p.sphere_count; ++k) {
    const Sphere& s = set.spheres[k];
    const double overlap = s.radius - dot(s.centre - wall.point, wall.inward);
    if (overlap >= -0.5 * gap)
      overlaps.push_back(overlap);
  }
  return overlaps;
}

} // namespace ellipsoid::post
