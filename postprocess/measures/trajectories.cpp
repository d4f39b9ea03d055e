// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "trajectories.h"

#include "orientation.h"

#include <cmath>

namespace ellipsoid::post {

Vector3 rotation_between(const Quaternion& p, const Quaternion& q) {
  Quaternion turn = q * Quaternion{p.w, -p.x, -p.y, -p.z};
  if (turn.w < 0.0)
    turn = {-turn.w, -turn.x, -turn.y, -turn.z};
  const Vector3 sine{turn.x, turn.y, turn.z};
  const double length = norm(sine);
  constexpr double hardly_turned = 1.0e-8; // the angle is twice the sine then, to rounding
  if (length < hardly_turned)
    return 2.0 * sine;
  return (2.0 * std::atan2(length, turn.w) / length) * sine;
}

void Trajectories::add(const ParticleSet& set, const PeriodicCell& cell) {
  move(set, cell);
  for (const Origin& origin : m_origins)
    compare(origin);
  if (m_frame % m_apart == 0 && m_origins.size() < m_most) {
    m_origins.push_back({m_frame, m_states});
    compare(m_origins.back());
  }
  ++m_frame;
}

void Trajectories::move(const ParticleSet& set, const PeriodicCell& cell) {
  for (const Particle& p : set.particles) {
    const auto [entry, is_new] = m_states.try_emplace(p.id);
    State& state = entry->second;
    // one that was away for a while begins anew: its way in between is not known
    if (is_new || state.last_seen + 1 != m_frame) {
      state = State{};
    } else {
      state.way += cell.nearest(p.centre - state.centre);
      state.angle += rotation_between(state.orientation, p.orientation);
    }
    state.centre = p.centre;
    state.orientation = p.orientation;
    state.direction = axes_by_length(p)[0];
    state.last_seen = m_frame;
  }
  for (auto entry = m_states.begin(); entry != m_states.end();)
    entry = entry->second.last_seen == m_frame ? std::next(entry) : m_states.erase(entry);
}

/// Both walk through their ids in ascending order.
void Trajectories::compare(const Origin& origin) {
  LagMeans& sums = m_sums[m_frame - origin.frame];
  auto now = m_states.begin();
  for (const auto& [id, then] : origin.states) {
    while (now != m_states.end() && now->first < id)
      ++now;
    if (now == m_states.end())
      return;
    if (now->first != id)
      continue;
    const Vector3 d = now->second.way - then.way, turn = now->second.angle - then.angle;
    const double cosine = dot(now->second.direction, then.direction);
    ++sums.pairs;
    sums.displacement += d;
    sums.squared_displacement += Vector3{d.x * d.x, d.y * d.y, d.z * d.z};
    sums.squared_rotation += dot(turn, turn);
    sums.direction += cosine;
    sums.direction_p2 += 1.5 * cosine * cosine - 0.5;
  }
}

LagMeans Trajectories::means(std::size_t lag) const {
  LagMeans m = m_sums.at(lag);
  if (m.pairs == 0)
    return m;
  const double share = 1.0 / static_cast<double>(m.pairs);
  m.displacement *= share;
  m.squared_displacement *= share;
  m.squared_rotation *= share;
  m.direction *= share;
  m.direction_p2 *= share;
  return m;
}

} // namespace ellipsoid::post
