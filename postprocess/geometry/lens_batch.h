// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Crossings of many pairs of outlines at once, for outlines that are apart or overlap a little, as
// those of particles do.
//
// Along outline i the level of j is f(t) = k + c1 cos t + s1 sin t + c2 cos 2t + s2 sin 2t. Newton
// steps lead to a minimum of f, and from there to a root on each side of it. That there are no
// other roots is proved in closed form: with t = m + v and roots at v = -w and w
//   f = (cos w - cos v) (G - 2 C2 cos v - 2 S2 sin v),  G = -C1 - 2 C2 cos w,
// C1, C2, S2 the coefficients about m, so that f has no other root when G > 2 sqrt(C2^2 + S2^2).
// With w = 0 the same proves that f - f(m) >= 0. Pairs without a proof are left to
// outline_crossings.h. All pairs take the same operations: the compiler turns the loop into vector
// instructions.
#pragma once

#include "outline_crossings.h"
#include "vectorised/batch.h"

namespace ellipsoid::post {

class LensBatch : public Batch {
 public:
  enum class Verdict {
    unknown,
    apart, ///< neither crosses nor lies in the other
    lens,  ///< two crossings
  };

  void add(const PlaneEllipse& i, const PlaneEllipse& j);
  /// Looks at all pairs added.
  void solve();

  Verdict verdict(int k) const;
  /// The part of outline i inside j, and that of j inside i, of a pair with a lens.
  ArcInterval of_i(int k) const { return interval(k, Columns::begin_i); }
  ArcInterval of_j(int k) const { return interval(k, Columns::begin_j); }

  /// Columns of numbers, one per pair.
  struct Columns {
    enum Input { dx, dy, ux_i, uy_i, vy_i, ux_j, uy_j, vy_j, input_count };
    /// Three numbers for each end of an arc: turn, cosine, sine.
    enum Result {
      begin_i,
      end_i = 3,
      begin_j = 6,
      end_j = 9,
      is_apart = 12,
      is_lens,
      result_count
    };
    alignas(64) double in[input_count][column_length];
    alignas(64) double out[result_count][column_length];
  };

 private:
  ArcEnd arc_end(int k, int column) const {
    return {columns_.out[column][k], columns_.out[column + 1][k], columns_.out[column + 2][k]};
  }
  ArcInterval interval(int k, int begin) const {
    return {arc_end(k, begin), arc_end(k, begin + 3)};
  }

  Columns columns_;
};

inline void LensBatch::add(const PlaneEllipse& i, const PlaneEllipse& j) {
  const int k = next();
  const auto put = [this, k](int column, double value) { columns_.in[column][k] = value; };
  put(Columns::dx, i.centre.x() - j.centre.x());
  put(Columns::dy, i.centre.y() - j.centre.y());
  put(Columns::ux_i, i.ux);
  put(Columns::uy_i, i.uy);
  put(Columns::vy_i, i.vy);
  put(Columns::ux_j, j.ux);
  put(Columns::uy_j, j.uy);
  put(Columns::vy_j, j.vy);
}

inline LensBatch::Verdict LensBatch::verdict(int k) const {
  if (columns_.out[Columns::is_apart][k] != 0.0)
    return Verdict::apart;
  return columns_.out[Columns::is_lens][k] != 0.0 ? Verdict::lens : Verdict::unknown;
}

} // namespace ellipsoid::post
