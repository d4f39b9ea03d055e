// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "collisions.h"

#include <algorithm>

namespace ellipsoid::post {

/// Of the second particle's point of contact as seen from the first one's.
Vector3 Collisions::relative_velocity(const Motion& first, const Motion& second,
                                      const Touching& contact) {
  return second.velocity + cross(second.spin, contact.lever_2) - first.velocity -
         cross(first.spin, contact.lever_1);
}

std::vector<Collision> Collisions::take(const ParticleSet& set, double time) {
  const PeriodicCell cell(set.box);
  if (!set.has_velocities || !set.has_spins)
    throw InputError("collisions need the columns vx vy vz and omegax omegay omegaz");
  const double between = 0.5 * (m_time + time);
  std::map<std::int64_t, Motion> motions;
  for (const Particle& p : set.particles)
    motions[p.id] = {p.velocity, p.angular_velocity};
  const ContactNetwork network = find_contacts(set, 0.0);
  std::map<Pair, Touching> touching;
  for (const PairContact& pair : network.pairs) {
    const Particle &p = set.particles[pair.i], &q = set.particles[pair.j];
    const Pair ids{p.id, q.id};
    if (const auto known = m_touching.find(ids); known != m_touching.end()) {
      touching[ids] = known->second;
      m_touching.erase(known);
    } else if (touching.count(ids) == 0) {
      const Contact& contact = network.contacts[pair.first];
      Touching& fresh = touching[ids];
      fresh.collision.id_1 = p.id;
      fresh.collision.id_2 = q.id;
      fresh.collision.begin = between;
      fresh.normal = contact.normal;
      fresh.lever_1 = contact.point - p.centre;
      fresh.lever_2 = cell.nearest(contact.point - q.centre);
      const auto first = m_motions.find(p.id), second = m_motions.find(q.id);
      fresh.is_whole = m_has_frame && first != m_motions.end() && second != m_motions.end();
      m_from_the_start += fresh.is_whole ? 0 : 1;
      if (fresh.is_whole) {
        const Vector3 v = relative_velocity(first->second, second->second, fresh);
        fresh.collision.normal_speed = -dot(v, fresh.normal);
        fresh.collision.tangential_speed = norm(v - dot(v, fresh.normal) * fresh.normal);
      }
    }
    Collision& c = touching[ids].collision;
    c.largest_overlap = std::max(c.largest_overlap, pair.largest_overlap);
  }
  std::vector<Collision> ended;
  for (auto& [ids, was] : m_touching) {
    const auto first = motions.find(ids.first), second = motions.find(ids.second);
    if (!was.is_whole || first == motions.end() || second == motions.end())
      continue;
    was.collision.end = between;
    was.collision.departure_speed =
        dot(relative_velocity(first->second, second->second, was), was.normal);
    ended.push_back(was.collision);
  }
  m_touching = std::move(touching);
  m_motions = std::move(motions);
  m_time = time;
  m_has_frame = true;
  return ended;
}

} // namespace ellipsoid::post
