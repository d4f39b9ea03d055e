// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "motion_batch.h"

#include "batch.h"
#include "vector_versions.h"

namespace ellipsoid {

namespace {

struct Rows {
  const PoseRows& poses;
  Motions& motions;
};

inline void take_all_loop(Rows& rows, int count) {
  const double *axes = rows.poses.semiaxes, *x = rows.poses.centres;
  double* last_x = rows.poses.last_centres;
  double *displacements = rows.motions.displacements, *turns = rows.motions.turns;
  alignas(64) double squares[4 * Motions::capacity];
#pragma GCC ivdep
  for (int l = 0; l < 3 * count; ++l) {
    displacements[l] = x[l] - last_x[l];
    last_x[l] = x[l];
  }
  take_squared_changes(rows.poses.orientations, rows.poses.last_orientations, 4 * count, squares);
#pragma GCC ivdep
  for (int k = 0; k < count; ++k)
    turns[k] = turning_radius(axes[3 * k], axes[3 * k + 1], axes[3 * k + 2]) *
               largest_angle(std::sqrt(squares[4 * k] + squares[4 * k + 1] + squares[4 * k + 2] +
                                       squares[4 * k + 3]));
}

ELLIPSOID_VECTOR_VERSIONS(take_all, Rows)

} // namespace

void take_motions(const PoseRows& poses, Motions& motions) {
  Rows rows{poses, motions};
  take_all(rows, motions.count);
}

} // namespace ellipsoid
