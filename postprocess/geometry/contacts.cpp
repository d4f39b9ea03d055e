// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "contacts.h"

#include "cell_grid.h"
#include "contact_batch.h"
#include "disjoint_sets.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ellipsoid::post {
namespace {

/// Bodies of one particle for the search: its ellipsoid, or its spheres.
struct SearchBodies {
  std::vector<EllipsoidShape> smooth; ///< by particle; unused for multi-sphere particles
  std::vector<Vector3> centres;       ///< of the bounding balls
  std::vector<double> radii;
};

double bounding_radius(const ParticleSet& set, const Particle& p) {
  if (p.is_smooth())
    return p.largest_axis();
  double radius = 0.0;
  for (std::size_t k = p.first_sphere; k < p.first_sphere + p.sphere_count; ++k)
    radius = std::max(radius, norm(set.spheres[k].centre - p.centre) + set.spheres[k].radius);
  return radius;
}

SearchBodies search_bodies(const ParticleSet& set, double gap) {
  SearchBodies bodies;
  bodies.smooth.reserve(set.particles.size());
  bodies.centres.reserve(set.particles.size());
  bodies.radii.reserve(set.particles.size());
  const Vector3 half_gap{0.5 * gap, 0.5 * gap, 0.5 * gap};
  for (const Particle& p : set.particles) {
    bodies.smooth.push_back(make_shape(p.semiaxes + half_gap, p.orientation));
    bodies.centres.push_back(p.centre);
    bodies.radii.push_back(bounding_radius(set, p) + 0.5 * gap);
  }
  return bodies;
}

/// What one look at two ellipsoids tells, before any search.
struct FirstLook {
  bool are_apart = false; ///< proved by `normal`
  bool touch = false;     ///< proved by a point inside both
  // the rest is not set where they are apart
  Vector3 normal;           ///< unit, from i to j: near the contact's
  double next_lambda = 0.5; ///< nearer to the maximum of the function
};

/// The function of Perram and Wertheim (1985, J. Comput. Phys. 58, 409) at one lambda: with
/// y = ((1 - lambda) A_i + lambda A_j)^-1 d the point x_i + (1 - lambda) A_i y lies at the levels
/// (1 - lambda)^2 s_i(y)^2 and lambda^2 s_j(y)^2 of the bodies (1: surface), and y is the normal
/// of a plane that separates them when s_i(y) + s_j(y) < y.d.
FirstLook first_look(const EllipsoidShape& i, const EllipsoidShape& j, const Vector3& d,
                     double lambda) {
  // far above the rounding of the most slender bodies that are read (aspect ratio 1e4)
  constexpr double well_inside = 1.0 - 1.0e-6;
  const SymmetricMatrix3 g = (1.0 - lambda) * i.a_matrix + lambda * j.a_matrix;
  const SymmetricMatrix3 adjugate{g.yy * g.zz - g.yz * g.yz, g.xx * g.zz - g.xz * g.xz,
                                  g.xx * g.yy - g.xy * g.xy, g.xz * g.yz - g.xy * g.zz,
                                  g.xy * g.yz - g.xz * g.yy, g.xy * g.xz - g.yz * g.xx};
  const Vector3 y = adjugate * d; // times the determinant
  const double s_i = support(i, y), s_j = support(j, y);
  FirstLook look;
  look.are_apart = s_i + s_j < dot(y, d);
  if (look.are_apart)
    return look;
  const double determinant = g.xx * adjugate.xx + g.xy * adjugate.xy + g.xz * adjugate.xz;
  look.touch = std::max((1.0 - lambda) * s_i, lambda * s_j) < well_inside * determinant;
  look.next_lambda = s_i + s_j > 0.0 ? s_i / (s_i + s_j) : lambda;
  const double length = norm(y);
  look.normal = length > 0.0 ? (1.0 / length) * y : Vector3{1.0, 0.0, 0.0};
  return look;
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
  constexpr int most_looks = 4; // the next step is the search itself
  FirstLook look;
  for (int k = 0; k < most_looks; ++k) {
    look = first_look(i, j, distance, look.next_lambda);
    if (look.are_apart || look.touch)
      return look.touch;
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

/// Whether two particles touch, as find_contacts() would have it.
bool particles_touch(const ParticleSet& set, const SearchBodies& bodies, double gap, std::size_t i,
                     std::size_t j) {
  const Particle &p = set.particles[i], &q = set.particles[j];
  if (p.is_smooth() && q.is_smooth())
    return ellipsoids_touch(bodies.smooth[i], bodies.smooth[j], q.centre - p.centre);
  if (p.is_smooth() || q.is_smooth()) {
    const std::size_t smooth = p.is_smooth() ? i : j;
    return any_sphere(set, p.is_smooth() ? q : p, [&](const Sphere& s) {
      return ellipsoids_touch(bodies.smooth[smooth], enlarged_ball(s, gap),
                              s.centre - bodies.centres[smooth]);
    });
  }
  return any_sphere(set, p, [&](const Sphere& s) {
    return any_sphere(set, q, [&](const Sphere& t) { return spheres_touch(s, t, gap); });
  });
}

/// Adds the contacts of pairs of particles to the network, in the order in which the pairs come.
/// Pairs of ellipsoids wait until there are enough of them to be searched together.
class PairFinder {
 public:
  PairFinder(const ParticleSet& set, const SearchBodies& bodies, double gap,
             ContactNetwork& network)
      : m_set(set), m_bodies(bodies), m_gap(gap), m_network(network) {}

  void find(std::size_t i, std::size_t j) {
    const Particle &p = m_set.particles[i], &q = m_set.particles[j];
    if (p.is_smooth() && q.is_smooth()) {
      ellipsoids(i, j);
      return;
    }
    search_waiting();
    const std::size_t first = m_network.contacts.size();
    if (p.is_smooth())
      ellipsoid_and_spheres(i, q, 1.0);
    else if (q.is_smooth())
      ellipsoid_and_spheres(j, p, -1.0);
    else
      spheres(p, q);
    add_pair(i, j, first);
  }

  /// To be called after the last pair.
  void search_waiting() {
    m_batch.solve();
    for (int k = 0; k < m_batch.size(); ++k) {
      const auto [i, j] = m_waiting[static_cast<std::size_t>(k)];
      const std::size_t first = m_network.contacts.size();
      add_contact(settled(m_batch.geometry(k), m_bodies.smooth[i], m_bodies.smooth[j],
                          m_bodies.centres[j] - m_bodies.centres[i]),
                  m_bodies.centres[i], 1.0);
      add_pair(i, j, first);
    }
    m_batch.clear();
  }

 private:
  /// Deep overlaps are searched anew from the best normal there is.
  static ContactGeometry settled(const ContactGeometry& found, const EllipsoidShape& i,
                                 const EllipsoidShape& j, const Vector3& distance) {
    const bool is_certain =
        found.status == ContactStatus::separated ||
        (found.status == ContactStatus::touching &&
         found.overlap <= i.smallest_curvature_radius + j.smallest_curvature_radius);
    return is_certain ? found : find_contact(i, j, distance);
  }

  void add_pair(std::size_t i, std::size_t j, std::size_t first) {
    const std::size_t count = m_network.contacts.size() - first;
    if (count > 0)
      m_network.pairs.push_back({i, j, first, count, largest_overlap(first)});
  }

  double largest_overlap(std::size_t first) const {
    double largest = m_network.contacts[first].overlap;
    for (std::size_t k = first + 1; k < m_network.contacts.size(); ++k)
      largest = std::max(largest, m_network.contacts[k].overlap);
    return largest;
  }

  void ellipsoids(std::size_t i, std::size_t j) {
    const Vector3 distance = m_bodies.centres[j] - m_bodies.centres[i];
    const FirstLook look = first_look(m_bodies.smooth[i], m_bodies.smooth[j], distance, 0.5);
    if (look.are_apart)
      return;
    m_waiting[static_cast<std::size_t>(m_batch.size())] = {i, j};
    m_batch.add(m_bodies.smooth[i], m_bodies.smooth[j], distance, look.normal);
    if (m_batch.full())
      search_waiting();
  }

  void add_contact(const ContactGeometry& found, const Vector3& centre_i, double sign) {
    if (found.status == ContactStatus::not_converged)
      ++m_network.not_converged;
    if (found.status == ContactStatus::separated || found.overlap < 0.0)
      return;
    m_network.contacts.push_back(
        {centre_i + found.point, sign * found.normal, found.overlap - m_gap});
  }

  /// @param[in] sign 1 when the ellipsoid is the pair's first particle, else -1
  void ellipsoid_and_spheres(std::size_t smooth, const Particle& chain, double sign) {
    for (std::size_t k = chain.first_sphere; k < chain.first_sphere + chain.sphere_count; ++k) {
      const Sphere& s = m_set.spheres[k];
      const Vector3 distance = s.centre - m_bodies.centres[smooth];
      const EllipsoidShape ball = enlarged_ball(s, m_gap);
      if (!first_look(m_bodies.smooth[smooth], ball, distance, 0.5).are_apart)
        add_contact(find_contact(m_bodies.smooth[smooth], ball, distance), m_bodies.centres[smooth],
                    sign);
    }
  }

  void spheres(const Particle& p, const Particle& q) {
    for (std::size_t k = p.first_sphere; k < p.first_sphere + p.sphere_count; ++k)
      for (std::size_t l = q.first_sphere; l < q.first_sphere + q.sphere_count; ++l)
        sphere_pair(m_set.spheres[k], m_set.spheres[l]);
  }

  void sphere_pair(const Sphere& s, const Sphere& t) {
    if (!spheres_touch(s, t, m_gap))
      return;
    const Vector3 d = t.centre - s.centre;
    const double distance = norm(d);
    const Vector3 normal = distance > 0.0 ? (1.0 / distance) * d : Vector3{1.0, 0.0, 0.0};
    const double overlap = s.radius + t.radius - distance;
    m_network.contacts.push_back({s.centre + (s.radius - 0.5 * overlap) * normal, normal, overlap});
  }

  const ParticleSet& m_set;
  const SearchBodies& m_bodies;
  double m_gap;
  ContactNetwork& m_network;
  ContactBatch m_batch;
  std::array<std::pair<std::size_t, std::size_t>, ContactBatch::capacity> m_waiting;
};

} // namespace

ContactNetwork find_contacts(const ParticleSet& set, double gap) {
  const SearchBodies bodies = search_bodies(set, gap);
  CellGrid grid(bodies.centres, bodies.radii);
  ContactNetwork network;
  PairFinder finder(set, bodies, gap, network);
  std::vector<std::size_t> partners;
  for (std::size_t i = 0; i < set.particles.size(); ++i) {
    partners.clear();
    grid.for_later_neighbours(i, [&](std::size_t j) { partners.push_back(j); });
    std::sort(partners.begin(), partners.end());
    for (const std::size_t j : partners)
      finder.find(i, j);
  }
  finder.search_waiting();
  return network;
}

std::vector<std::size_t> touching_clusters(const ParticleSet& set, double gap) {
  const SearchBodies bodies = search_bodies(set, gap);
  CellGrid grid(bodies.centres, bodies.radii);
  const std::size_t count = set.particles.size();
  DisjointSets clusters(count);
  for (std::size_t i = 0; i < count; ++i)
    grid.for_later_neighbours(i, [&](std::size_t j) {
      if (clusters.root(i) != clusters.root(j) && particles_touch(set, bodies, gap, i, j))
        clusters.join(i, j);
    });
  std::vector<std::size_t> roots(count);
  for (std::size_t i = 0; i < count; ++i)
    roots[i] = clusters.root(i);
  return roots;
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
