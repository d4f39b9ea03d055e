// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "multisphere/motion_batch.h"

#include "vectorised/batch.h"
#include "vectorised/vector_versions.h"

namespace ellipsoid {

namespace {

struct Rows {
  const PoseRows& poses;
  Motions& motions;
};

inline void take_displacements(const double* now, double* before, int count,
                               double* displacements) {
#pragma GCC ivdep
  for (int l = 0; l < 3 * count; ++l) {
    displacements[l] = now[l] - before[l];
    before[l] = now[l];
  }
}

inline void measure_loop(Rows& rows, int count) {
  const double* radii = rows.poses.turning_radii;
  double* turns = rows.motions.turns;
  alignas(64) double squares[4 * Motions::capacity];
  take_displacements(rows.poses.centres, rows.poses.last_centres, count,
                     rows.motions.displacements);
  square_changes(rows.poses.orientations, rows.poses.last_orientations, 4 * count, squares);
#pragma GCC ivdep
  for (int k = 0; k < count; ++k)
    turns[k] = radii[k] * largest_angle(std::sqrt(squares[4 * k] + squares[4 * k + 1] +
                                                  squares[4 * k + 2] + squares[4 * k + 3]));
}

struct ChainStep {
  const ChainRows& chains;
  Motions& motions;
};

inline void measure_chains_loop(ChainStep& step, int count) {
  take_displacements(step.chains.centres, step.chains.last_centres, count,
                     step.motions.displacements);
  using Column = double[Motions::capacity];
  alignas(64) Column x, y, z, squares, lengths, growth;
  const double* q = step.chains.orientations;
#pragma GCC ivdep
  for (int k = 0; k < count; ++k) {
    const Vector3 axis = rotation({q[4 * k], q[4 * k + 1], q[4 * k + 2], q[4 * k + 3]}).column_x;
    x[k] = axis.x;
    y[k] = axis.y;
    z[k] = axis.z;
  }
  for (int k = 0; k < count; ++k) {
    ChainPose& pose = step.chains.poses[k];
    const SphereChain& chain = *pose.chain;
    const Vector3 axis{x[k], y[k], z[k]}, change = axis - pose.axis;
    const double scale = step.chains.semiaxes[3 * k + 1], half_length = chain.half_length();
    squares[k] = dot(change, change);
    lengths[k] = scale * half_length;
    growth[k] = std::fabs(scale - pose.scale) * (half_length + chain.largest_radius());
    pose.axis.x = axis.x;
    pose.axis.y = axis.y;
    pose.axis.z = axis.z;
    pose.scale = scale;
  }
  double* turns = step.motions.turns;
#pragma GCC ivdep
  for (int k = 0; k < count; ++k)
    turns[k] = lengths[k] * std::sqrt(squares[k]) + growth[k];
}

} // namespace

void measure_motions(const PoseRows& poses, Motions& motions) {
  Rows rows{poses, motions};
  WidestVersion<measure_loop>::run(rows, motions.count);
}

void measure_motions(const ChainRows& chains, Motions& motions) {
  ChainStep step{chains, motions};
  WidestVersion<measure_chains_loop>::run(step, motions.count);
}

} // namespace ellipsoid
