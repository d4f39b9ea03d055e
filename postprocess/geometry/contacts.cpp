// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "contacts.h"

#include "cell_grid.h"
#include "ellipsoid_contact.h"

#include <algorithm>
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
  const Vector3 half_gap{0.5 * gap, 0.5 * gap, 0.5 * gap};
  for (const Particle& p : set.particles) {
    bodies.smooth.push_back(make_shape(p.semiaxes + half_gap, p.orientation));
    bodies.centres.push_back(p.centre);
    bodies.radii.push_back(bounding_radius(set, p) + 0.5 * gap);
  }
  return bodies;
}

/// Adds the contacts of one pair of particles to the network.
class PairFinder {
 public:
  PairFinder(const ParticleSet& set, const SearchBodies& bodies, double gap,
             ContactNetwork& network)
      : m_set(set), m_bodies(bodies), m_gap(gap), m_network(network) {}

  void find(std::size_t i, std::size_t j) {
    const Particle &p = m_set.particles[i], &q = m_set.particles[j];
    const std::size_t first = m_network.contacts.size();
    if (p.is_smooth() && q.is_smooth())
      ellipsoids(m_bodies.smooth[i], p.centre, m_bodies.smooth[j], q.centre);
    else if (p.is_smooth())
      ellipsoid_and_spheres(i, q, 1.0);
    else if (q.is_smooth())
      ellipsoid_and_spheres(j, p, -1.0);
    else
      spheres(p, q);
    const std::size_t count = m_network.contacts.size() - first;
    if (count > 0)
      m_network.pairs.push_back({i, j, first, count, largest_overlap(first)});
  }

 private:
  double largest_overlap(std::size_t first) const {
    double largest = m_network.contacts[first].overlap;
    for (std::size_t k = first + 1; k < m_network.contacts.size(); ++k)
      largest = std::max(largest, m_network.contacts[k].overlap);
    return largest;
  }

  void ellipsoids(const EllipsoidShape& i, const Vector3& centre_i, const EllipsoidShape& j,
                  const Vector3& centre_j, double sign = 1.0) {
    const Vector3 distance = centre_j - centre_i;
    if (overlap_along(i, j, distance, distance) < 0.0)
      return; // the plane across the centres' connection separates them
    const ContactGeometry found = find_contact(i, j, distance);
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
      const double radius = s.radius + 0.5 * m_gap;
      ellipsoids(m_bodies.smooth[smooth], m_bodies.centres[smooth],
                 make_shape({radius, radius, radius}, {}), s.centre, sign);
    }
  }

  void spheres(const Particle& p, const Particle& q) {
    for (std::size_t k = p.first_sphere; k < p.first_sphere + p.sphere_count; ++k)
      for (std::size_t l = q.first_sphere; l < q.first_sphere + q.sphere_count; ++l)
        sphere_pair(m_set.spheres[k], m_set.spheres[l]);
  }

  void sphere_pair(const Sphere& s, const Sphere& t) {
    const Vector3 d = t.centre - s.centre;
    const double reach = s.radius + t.radius + m_gap;
    const double squared = dot(d, d);
    if (squared > reach * reach)
      return;
    const double distance = std::sqrt(squared);
    const Vector3 normal = distance > 0.0 ? (1.0 / distance) * d : Vector3{1.0, 0.0, 0.0};
    const double overlap = s.radius + t.radius - distance;
    m_network.contacts.push_back({s.centre + (s.radius - 0.5 * overlap) * normal, normal, overlap});
  }

  const ParticleSet& m_set;
  const SearchBodies& m_bodies;
  double m_gap;
  ContactNetwork& m_network;
};

} // namespace

ContactNetwork find_contacts(const ParticleSet& set, double gap) {
  const SearchBodies bodies = search_bodies(set, gap);
  const CellGrid grid(bodies.centres, bodies.radii);
  ContactNetwork network;
  PairFinder finder(set, bodies, gap, network);
  std::vector<std::size_t> partners;
  for (std::size_t i = 0; i < set.particles.size(); ++i) {
    partners.clear();
    grid.for_neighbours(i, [&](std::size_t j) {
      if (j > i)
        partners.push_back(j);
    });
    std::sort(partners.begin(), partners.end());
    for (const std::size_t j : partners)
      finder.find(i, j);
  }
  return network;
}

std::vector<double> wall_overlaps(const ParticleSet& set, std::size_t particle,
                                  const PlaneWall& wall, double gap) {
  const Particle& p = set.particles[particle];
  std::vector<double> overlaps;
  if (p.is_smooth()) {
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
