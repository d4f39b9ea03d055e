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
  double *times, *margins;
  int used_up; ///< of the margins
};

inline void advance_all_loop(Rows& rows, int count) {
  const double *turns = rows.now.turns, *paces = rows.paces;
  double *turns_before = rows.turns, *times = rows.times, *margins = rows.margins;
  const double* moved = rows.now.displacements;
  alignas(64) double squares[3 * Motions::capacity];
  square_changes(moved, rows.displacements, 3 * count, squares);
  int used_up = 0;
#pragma GCC ivdep
  for (int k = 0; k < count; ++k) {
    times[k] += std::sqrt(squares[3 * k] + squares[3 * k + 1] + squares[3 * k + 2]) +
                std::fabs(turns[k] - turns_before[k]) + paces[k];
    turns_before[k] = turns[k];
    const double x = moved[3 * k], y = moved[3 * k + 1], z = moved[3 * k + 2];
    margins[k] -= std::sqrt(x * x + y * y + z * z) + turns[k];
    used_up += margins[k] < 0.0;
  }
  rows.used_up = used_up;
}

} // namespace

void MotionClocks::advance_from(std::size_t first, const Motions& motions) {
  Rows rows{motions,
            &displacement_[3 * first],
            &turn_[first],
            &pace_[first],
            &time_[first],
            &margin_[first],
            0};
  WidestVersion<advance_all_loop>::run(rows, motions.count);
  used_up_ += rows.used_up;
}

} // namespace ellipsoid
