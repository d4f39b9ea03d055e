// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "trajectories.h"

#include "orientation.h"

#include <algorithm>
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
  steps_.advance(set, cell);
  move(set);
  for (const Origin& origin : origins_)
    compare(origin);
  if (frame_ % apart_ == 0 && origins_.size() < most_) {
    origins_.push_back({frame_, states_});
    compare(origins_.back());
  }
  ++frame_;
}

void Trajectories::move(const ParticleSet& set) {
  for (const Particle& p : set.particles) {
    const auto [entry, is_new] = states_.try_emplace(p.id);
    State& state = entry->second;
    // one that was away for a while begins anew: its way in between is not known
    if (is_new || state.last_seen + 1 != frame_) {
      state = State{};
      state.first_seen = frame_;
    } else {
      const Vector3 way = steps_.way(state.place, steps_.place(p));
      state.way += way;
      steps_.count_long(way, long_steps_);
      state.angle += rotation_between(state.orientation, p.orientation);
    }
    state.place = steps_.place(p);
    state.orientation = p.orientation;
    state.known = std::max(state.known, p.known_orientation); // in the order of the enumeration
    state.direction = axes_by_length(p)[0];
    state.last_seen = frame_;
  }
  for (auto entry = states_.begin(); entry != states_.end();)
    entry = entry->second.last_seen == frame_ ? std::next(entry) : states_.erase(entry);
}

/// Both walk through their ids in ascending order.
void Trajectories::compare(const Origin& origin) {
  LagMeans& sums = sums_[frame_ - origin.frame];
  auto now = states_.begin();
  for (const auto& [id, then] : origin.states) {
    while (now != states_.end() && now->first < id)
      ++now;
    if (now == states_.end())
      return;
    if (now->first != id || now->second.first_seen > origin.frame)
      continue;
    const Vector3 d = now->second.way - then.way, turn = now->second.angle - then.angle;
    const double cosine = dot(now->second.direction, then.direction);
    ++sums.pairs;
    sums.displacement += d;
    sums.squared_displacement += Vector3{d.x * d.x, d.y * d.y, d.z * d.z};
    if (now->second.known == KnownOrientation::whole) {
      ++sums.rotations;
      sums.squared_rotation += dot(turn, turn);
    }
    if (now->second.known != KnownOrientation::none) {
      ++sums.directions;
      sums.direction += cosine;
      sums.direction_p2 += 1.5 * cosine * cosine - 0.5;
    }
  }
}

LagMeans Trajectories::means(std::size_t lag) const {
  LagMeans m = sums_.at(lag);
  if (m.pairs == 0)
    return m;
  const double share = 1.0 / static_cast<double>(m.pairs);
  m.displacement *= share;
  m.squared_displacement *= share;
  m.squared_rotation /= static_cast<double>(std::max(m.rotations, std::size_t{1}));
  m.direction /= static_cast<double>(std::max(m.directions, std::size_t{1}));
  m.direction_p2 /= static_cast<double>(std::max(m.directions, std::size_t{1}));
  return m;
}

std::optional<Vector3> Trajectories::rotation_vector(std::int64_t id) const {
  const State& state = states_.at(id);
  return state.known == KnownOrientation::whole ? std::optional(state.angle) : std::nullopt;
}

} // namespace ellipsoid::post
