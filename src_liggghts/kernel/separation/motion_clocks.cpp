// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "separation/motion_clocks.h"

#include "vectorised/batch.h"
#include "vectorised/vector_versions.h"

namespace ellipsoid {

namespace {

/// Those of the bodies that moved.
struct Rows {
  const Motions& now;
  double *displacements, *turns; ///< in the step before; become those of `now`
  const double* paces;
  double* times;
};

inline void advance_all_loop(Rows& rows, int count) {
  const double *turns = rows.now.turns, *paces = rows.paces;
  double *turns_before = rows.turns, *times = rows.times;
  alignas(64) double squares[3 * Motions::capacity];
  square_changes(rows.now.displacements, rows.displacements, 3 * count, squares);
#pragma GCC ivdep
  for (int k = 0; k < count; ++k) {
    times[k] += std::sqrt(squares[3 * k] + squares[3 * k + 1] + squares[3 * k + 2]) +
                std::fabs(turns[k] - turns_before[k]) + paces[k];
    turns_before[k] = turns[k];
  }
}

} // namespace

void MotionClocks::advance_from(std::size_t first, const Motions& motions) {
  Rows rows{motions, &displacement_[3 * first], &turn_[first], &pace_[first], &time_[first]};
  WidestVersion<advance_all_loop>::run(rows, motions.count);
}

} // namespace ellipsoid
