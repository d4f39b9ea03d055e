// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "law_batch.h"

#include "vector_versions.h"

#include <limits>

namespace ellipsoid {

namespace {

using Columns = ContactLawBatch::Columns;
using C = Columns;

inline Vector3 vector_in(const Columns& c, int first, int k) {
  return {c.in[first][k], c.in[first + 1][k], c.in[first + 2][k]};
}

inline void put(Columns& c, int first, int k, const Vector3& v) {
  c.out[first][k] = v.x;
  c.out[first + 1][k] = v.y;
  c.out[first + 2][k] = v.z;
}

/// advance_spring() without branches: both sides of each are computed, one is taken.
inline Vector3 advanced_spring(const Vector3& spring, const Vector3& slip_velocity,
                               double time_step, const Vector3& normal) {
  const Vector3 in_plane = spring - dot(spring, normal) * normal;
  const double squared_length = dot(spring, spring), remaining = dot(in_plane, in_plane);
  const double stretch = std::sqrt(squared_length / (remaining > 0.0 ? remaining : 1.0));
  return (remaining > 0.0 ? stretch : 1.0) * in_plane + time_step * slip_velocity; // eq. 18
}

/// tangential_force() along the displacement, without branches.
inline Vector3 limited_friction(const TangentialContact& c, Vector3& spring) {
  const Vector3 viscous = c.damping * c.relative_velocity;
  const Vector3 trial = -c.stiffness * spring - viscous;
  const double magnitude = norm(trial);
  const bool slips = magnitude > c.friction_limit;
  const Vector3 force = (slips ? c.friction_limit / magnitude : 1.0) * trial; // eq. 24
  const Vector3 shortened = (-1.0 / c.stiffness) * (force + viscous);
  const bool shortens = slips & (c.stiffness > 0.0);
  spring = {shortens ? shortened.x : spring.x, shortens ? shortened.y : spring.y,
            shortens ? shortened.z : spring.z};
  return force;
}

template <bool advances_springs>
inline void apply_law(Columns& c, int k, double time_step, double smallest_normal_force) {
  const auto in = [&c, k](int column) { return c.in[column][k]; };
  const Vector3 normal = vector_in(c, C::nx, k);
  const Vector3 lever_i = vector_in(c, C::lix, k), lever_j = vector_in(c, C::ljx, k);
  const Vector3 velocity = vector_in(c, C::vx, k) + (cross(vector_in(c, C::wix, k), lever_i) -
                                                     cross(vector_in(c, C::wjx, k), lever_j));
  const double normal_velocity = dot(velocity, normal);
  const Vector3 slip_velocity = velocity - normal_velocity * normal;

  const double overlap = in(C::overlap), root = std::sqrt(in(C::radius) * overlap);
  const double elastic = normal_stiffness(in(C::modulus), root) * overlap;
  const double mass = PairMasses{in(C::mass_i), in(C::mass_j)}.effective();
  const double pressing = elastic - in(C::normal_damping) * mass * normal_velocity; // eq. 23
  const double normal_force =
      pressing < smallest_normal_force ? smallest_normal_force : pressing;

  Vector3 spring = vector_in(c, C::sx, k);
  if (advances_springs)
    spring = advanced_spring(spring, slip_velocity, time_step, normal);
  const Vector3 friction = limited_friction(
      {tangential_stiffness(in(C::shear_modulus), root), in(C::tangential_damping) * mass,
       in(C::friction) * std::fabs(normal_force), slip_velocity},
      spring);

  const Vector3 force = normal_force * normal + friction;
  put(c, C::fx, k, force);
  put(c, C::tix, k, cross(lever_i, force));
  put(c, C::tjx, k, cross(force, lever_j));
  c.out[C::normal_force][k] = normal_force;
  put(c, C::new_sx, k, spring);
}

template <bool advances_springs> inline void apply_laws(Columns& c, int size) {
  const double time_step = c.pass.time_step;
  const double smallest_normal_force =
      c.pass.no_attraction ? 0.0 : -std::numeric_limits<double>::infinity();
#pragma GCC ivdep
  for (int k = 0; k < size; ++k)
    apply_law<advances_springs>(c, k, time_step, smallest_normal_force);
}

inline void law_loop(Columns& c, int size) {
  if (c.pass.advances_springs)
    apply_laws<true>(c, size);
  else
    apply_laws<false>(c, size);
}

ELLIPSOID_VECTOR_VERSIONS(law, Columns)

struct Places {
  const ContactBatch::Columns& from;
  Columns& to;
};

/// Normals of the law point from j to i.
inline void take_loop(Places& places, int size) {
  using From = ContactBatch::Columns;
  const auto& out = places.from.out;
  const auto& in = places.from.in;
  auto& to = places.to.in;
#pragma GCC ivdep
  for (int k = 0; k < size; ++k) {
    for (int l = 0; l < 3; ++l) {
      to[C::nx + l][k] = -out[From::nx + l][k];
      to[C::lix + l][k] = out[From::px + l][k];
      to[C::ljx + l][k] = out[From::px + l][k] - in[From::dx + l][k];
    }
    const double overlap = out[From::overlap][k];
    to[C::overlap][k] = overlap > 0.0 ? overlap : 0.0;
    to[C::radius][k] = out[From::reduced_radius][k];
  }
}

ELLIPSOID_VECTOR_VERSIONS(take, Places)

} // namespace

void ContactLawBatch::take_places(const ContactBatch& pairs) {
  resize(pairs.size());
  Places places{pairs.columns(), columns_};
  take(places, size());
}

void ContactLawBatch::solve(const LawPass& pass) {
  columns_.pass = pass;
  law(columns_, size());
}

} // namespace ellipsoid
