// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Which of many pairs of ellipsoids are far apart, found from scratch and together.
//
// Of all directions n ~ (A_i + A_j)^-1 d is tried: the first normal of Perram and Wertheim's search
// (ellipsoid_contact.h). Between long or flat bodies it separates most pairs that are apart, where
// the line of centres separates few.
#pragma once

#include "ellipsoid/ellipsoid_contact.h"
#include "vectorised/batch_columns.h"

namespace ellipsoid {

class FirstGaps : public Batch {
 public:
  /// @param[in] centre_distance x_j - x_i (length)
  void add(const EllipsoidShape& i, const EllipsoidShape& j, const Vector3& centre_distance) {
    const InSpace at{next()};
    at.put(columns_.in, Columns::axx_i, i.a_matrix);
    at.put(columns_.in, Columns::axx_j, j.a_matrix);
    at.put(columns_.in, Columns::dx, centre_distance);
  }
  void find();
  /// A length by which the bodies of pair k are apart at least, with normal(k) as the proof; not
  /// positive where that proves nothing, NaN for bodies with numbers that are none and for centres
  /// at the same index.
  double gap(int k) const { return columns_.out[Columns::distance][k]; }
  /// Unit, from i to j.
  Vector3 normal(int k) const { return InSpace{k}.vector(columns_.out, Columns::nx); }

  /// Columns of numbers, one per pair.
  struct Columns {
    enum Input { axx_i, axx_j = axx_i + 6, dx = axx_j + 6, input_count = dx + 3 };
    enum Result { nx, distance = nx + 3, result_count };
    alignas(64) double in[input_count][column_length];
    alignas(64) double out[result_count][column_length];
  };

 private:
  Columns columns_;
};

} // namespace ellipsoid
