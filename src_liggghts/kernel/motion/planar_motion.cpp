// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "motion/planar_motion.h"

#include "vectorised/vector_versions.h"

#pragma GCC diagnostic ignored "-Wpsabi" // the functions with wide vectors are inline

#include <cmath>
#include <cstddef>
#include <cstring>

namespace ellipsoid {

namespace {

struct PlanarStep {
  PlanarRows rows;
  double time_step, half_step;
};

// What is done per body is little: the numbers of its rows are taken two and four at a time.
using Two = double __attribute__((vector_size(16)));
using Four = double __attribute__((vector_size(32)));

/// Rows begin at any address of a number, vectors do not: compilers make one instruction of the
/// copy.
template <class Vector> inline Vector load(const double* row) {
  Vector v;
  std::memcpy(&v, row, sizeof v);
  return v;
}
template <class Vector> inline void save(const Vector& v, double* row) {
  std::memcpy(row, &v, sizeof v);
}

struct Kicked {
  Two velocity;
  double rate;
};

/// Half a step of force and torque. Velocities out of the plane become 0: they would bring forces.
inline Kicked kick(const PlanarRows& p, std::ptrdiff_t k, double half_step) {
  const double scale = half_step / p.masses[k];
  const Two velocity = load<Two>(p.velocities + 3 * k) + scale * load<Two>(p.forces + 3 * k);
  const double momentum = p.momenta[3 * k + 2] + half_step * p.torques[3 * k + 2];
  const double rate = momentum * p.inverse_inertia[k];
  save(velocity, p.velocities + 3 * k);
  p.velocities[3 * k + 2] = 0.0;
  p.momenta[3 * k + 2] = momentum;
  save(Two{0.0, 0.0}, p.omega + 3 * k);
  p.omega[3 * k + 2] = rate;
  return {velocity, rate};
}

/// Sum of the four, in each entry.
inline Four sum(const Four& v) {
  const Four pairs = v + Four{v[1], v[0], v[3], v[2]};
  return pairs + Four{pairs[2], pairs[3], pairs[0], pairs[1]};
}

/// Turns a quaternion about the space z axis by twice `half` (rad).
inline void turn(double* orientation, double half) {
  const Four q = load<Four>(orientation);
  const Four t =
      q + half * Four{-1.0, -1.0, 1.0, 1.0} * Four{q[3], q[2], q[1], q[0]}; // (1 + half z) q
  const Four excess = sum(t * t) - 1.0;
  constexpr double small = 1e-6;    // most steps have less: no root, no division;
  if (std::fabs(excess[0]) < small) // the first term left out, 5/16 excess^3, is far below rounding
    save<Four>(t * (1.0 - excess * (0.5 - 0.375 * excess)), orientation);
  else
    save<Four>(t * (1.0 / std::sqrt(1.0 + excess[0])), orientation);
}

inline void start_loop(PlanarStep& s, int count) {
  const PlanarRows p = s.rows;
  const double time_step = s.time_step, half_step = s.half_step;
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    if (!(p.groups[k] & p.group))
      continue;
    const Kicked kicked = kick(p, k, half_step);
    double* const centre = p.centres + 3 * k;
    save<Two>(load<Two>(centre) + time_step * kicked.velocity, centre);
    turn(p.orientations + 4 * k, 0.5 * time_step * kicked.rate);
  }
}
inline void end_loop(PlanarStep& s, int count) {
  const PlanarRows p = s.rows;
  const double half_step = s.half_step;
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    if (!(p.groups[k] & p.group))
      continue;
    kick(p, k, half_step);
    p.forces[3 * k + 2] = 0.0;
    save(Two{0.0, 0.0}, p.torques + 3 * k);
    save(Two{0.0, 0.0}, p.momenta + 3 * k);
  }
}

} // namespace

void start_planar_step(const PlanarRows& rows, int count, double time_step, double half_step) {
  PlanarStep step{rows, time_step, half_step};
  WidestVersion<start_loop>::run(step, count);
}

void end_planar_step(const PlanarRows& rows, int count, double half_step) {
  PlanarStep step{rows, 0.0, half_step};
  WidestVersion<end_loop>::run(step, count);
}

} // namespace ellipsoid
