// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "collisions.h"

#include "listed_particles.h"

#include <algorithm>

namespace ellipsoid::post {

/// Velocity of the second particle's point of contact relative to the first one's.
Vector3 Collisions::relative_velocity(const Motion& first, const Motion& second,
                                      const Touching& contact) {
  return second.velocity + cross(second.spin, contact.lever_2) - first.velocity -
         cross(first.spin, contact.lever_1);
}

/// A contact that was not there in the frame before.
Collisions::Touching Collisions::begun(const ParticleSet& set, const TouchingPair& pair,
                                       double time) const {
  const Particle &p = set.particles[pair.i], &q = set.particles[pair.j];
  const PeriodicCell cell(set.box);
  Touching fresh;
  fresh.collision.id_1 = p.id;
  fresh.collision.id_2 = q.id;
  fresh.collision.begin = time;
  fresh.normal = pair.normal;
  fresh.lever_1 = cell.nearest(pair.point - p.centre);
  fresh.lever_2 = cell.nearest(pair.point - q.centre);
  const auto first = motions_.find(p.id), second = motions_.find(q.id);
  fresh.is_whole = has_frame_ && first != motions_.end() && second != motions_.end();
  if (fresh.is_whole) {
    const Vector3 v = relative_velocity(first->second, second->second, fresh);
    fresh.collision.normal_speed = -dot(v, fresh.normal);
    fresh.collision.tangential_speed = norm(v - dot(v, fresh.normal) * fresh.normal);
  }
  return fresh;
}

/// Collisions of the pairs that have parted, as far as their beginning was seen as well.
std::vector<Collision> Collisions::ended(const std::map<std::int64_t, Motion>& motions,
                                         double time) const {
  std::vector<Collision> ended;
  for (const auto& [ids, was] : touching_) {
    const auto first = motions.find(ids.first), second = motions.find(ids.second);
    if (!was.is_whole || first == motions.end() || second == motions.end())
      continue;
    ended.push_back(was.collision);
    ended.back().end = time;
    ended.back().departure_speed =
        dot(relative_velocity(first->second, second->second, was), was.normal);
  }
  return ended;
}

std::vector<Collision> Collisions::advance(const ParticleSet& set,
                                           const std::vector<TouchingPair>& pairs, double time) {
  if (!set.has_velocities || !set.has_spins)
    throw InputError("collisions need the columns vx vy vz and omegax omegay omegaz");
  const double between = 0.5 * (time_ + time);
  std::map<std::int64_t, Motion> motions;
  for (const Particle& p : set.particles)
    motions[p.id] = {p.velocity, p.angular_velocity};
  std::map<Pair, Touching> touching;
  for (const TouchingPair& pair : pairs) {
    const Pair ids{set.particles[pair.i].id, set.particles[pair.j].id};
    if (const auto known = touching_.find(ids); known != touching_.end()) {
      touching[ids] = known->second;
      touching_.erase(known);
    } else if (touching.count(ids) == 0) {
      const Touching& fresh = touching[ids] = begun(set, pair, between);
      from_the_start_ += fresh.is_whole ? 0 : 1;
    }
    Collision& c = touching[ids].collision;
    c.largest_overlap = std::max(c.largest_overlap, pair.overlap);
  }
  std::vector<Collision> over = ended(motions, between);
  touching_ = std::move(touching);
  motions_ = std::move(motions);
  time_ = time;
  has_frame_ = true;
  return over;
}

std::vector<TouchingPair> touching_pairs(const ParticleSet& set) {
  const ContactNetwork network = find_contacts(set, 0.0);
  std::vector<TouchingPair> pairs;
  for (const PairContact& pair : network.pairs) {
    const Contact& contact = network.contacts[pair.first];
    pairs.push_back({pair.i, pair.j, contact.point, contact.normal, pair.largest_overlap});
  }
  return pairs;
}

std::vector<TouchingPair> listed_pairs(const Frame& list, const ContactColumns& columns,
                                       const ParticleSet& set) {
  const ListedParticles particles(list, set);
  const PeriodicCell cell(set.box);
  const ListedVectors points(list, columns.points, "point of contact");
  const ListedVectors normals(list, columns.normals, "normal");
  const std::vector<double>* const overlaps =
      columns.overlap.empty() ? nullptr : &list.required(columns.overlap, "the overlap");
  std::map<std::pair<std::size_t, std::size_t>, TouchingPair> pairs;
  for (std::size_t row = 0; row < list.rows; ++row) {
    std::size_t i = particles.at(columns.ids.at(0), row), j = particles.at(columns.ids.at(1), row);
    if (i > j)
      std::swap(i, j);
    const Vector3 way = cell.nearest(set.particles[j].centre - set.particles[i].centre);
    Vector3 normal = normals.at(row).value_or(way);
    if (!(norm(normal) > 0.0))
      normal = way;
    normal = normalized(dot(normal, way) < 0.0 ? -normal : normal);
    const Vector3 point = points.at(row).value_or(set.particles[i].centre + 0.5 * way);
    TouchingPair& pair =
        pairs.try_emplace({i, j}, TouchingPair{i, j, point, normal, 0.0}).first->second;
    pair.overlap = std::max(pair.overlap, overlaps ? (*overlaps)[row] : 0.0);
  }
  std::vector<TouchingPair> result;
  for (const auto& entry : pairs)
    result.push_back(entry.second);
  return result;
}

} // namespace ellipsoid::post
