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

inline void update_displacements(const double* now, double* before, int count,
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
  update_displacements(rows.poses.centres, rows.poses.last_centres, count,
                       rows.motions.displacements);
  square_changes(rows.poses.orientations, rows.poses.last_orientations, 4 * count, squares);
#pragma GCC ivdep
  for (int k = 0; k < count; ++k)
    turns[k] = radii[k] * largest_angle(std::sqrt(squares[4 * k] + squares[4 * k + 1] +
                                                  squares[4 * k + 2] + squares[4 * k + 3]));
}

struct ChainStep {
  const MultisphereRows& chains;
  Motions& motions;
};

/// Square of the farthest that a point at distance 1 moves when a body turns from its pose: half
/// the squared distance of the rotation matrices, 8 sin^2(angle / 2).
inline double turned_squared(const MultispherePose& before, const double* quaternion) {
  const Rotation3 now = rotation({quaternion[0], quaternion[1], quaternion[2], quaternion[3]});
  const Rotation3 then = orientation_of(before);
  const Vector3 x = now.column_x - then.column_x, y = now.column_y - then.column_y,
                z = now.column_z - then.column_z;
  return 0.5 * (dot(x, x) + dot(y, y) + dot(z, z));
}

inline void measure_chains_loop(ChainStep& step, int count) {
  update_displacements(step.chains.centres, step.chains.last_centres, count,
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
    MultispherePose& pose = step.chains.poses[k];
    const MultisphereBody& body = *pose.body;
    const Vector3 axis{x[k], y[k], z[k]}, change = axis - pose.axis;
    const double scale = step.chains.semiaxes[3 * k + 1], half_length = body.half_length();
    squares[k] = body.is_chain() ? dot(change, change) : turned_squared(pose, q + 4 * k);
    lengths[k] = scale * half_length;
    growth[k] = std::fabs(scale - pose.scale) * (half_length + body.largest_radius());
    pose.axis.x = axis.x;
    pose.axis.y = axis.y;
    pose.axis.z = axis.z;
    if (!body.is_chain())
      pose.second_axis = rotation({q[4 * k], q[4 * k + 1], q[4 * k + 2], q[4 * k + 3]}).column_y;
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

void measure_motions(const MultisphereRows& chains, Motions& motions) {
  ChainStep step{chains, motions};
  WidestVersion<measure_chains_loop>::run(step, motions.count);
}

} // namespace ellipsoid
