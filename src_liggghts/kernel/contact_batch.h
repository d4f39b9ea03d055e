// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Contacts of many pairs of ellipsoids at once, for pairs that touched a moment ago.
//
// The search of ellipsoid_contact.h is a chain of dependent operations: alone it waits for square
// roots and divisions most of the time. Here the same Newton step is a loop over pairs without
// branches, which the compiler turns into vector instructions. Every pair gets the same operations
// in the same order whatever the width of the vectors and whoever its neighbours in the batch are:
// results are the same, bit for bit, on every processor.
//
// A pair counts as solved only when its result proves itself: the predicted error of the normal is
// below the tolerance, the Hessian is positive definite, and the overlap is small enough for the
// minimum to be the only one. All other pairs (a few in a thousand) go through find_contact_from().
#pragma once

#include "ellipsoid_contact.h"

namespace ellipsoid {

class ContactBatch {
public:
  static constexpr int capacity = 64;

  int size() const { return size_; }
  bool full() const { return size_ == capacity; }
  void clear() { size_ = 0; }

  /// @param[in] i, j live until clear()
  /// @param[in] centre_distance x_j - x_i (length)
  /// @param[in] start unit normal from i to j: the last one known
  void add(const EllipsoidShape& i, const EllipsoidShape& j, const Vector3& centre_distance,
           const Vector3& start);

  /// Searches the contacts of all pairs added.
  void solve();

  /// What find_contact_from() would say of pair k, to the tolerances of contact_tolerances.h.
  ContactGeometry geometry(int k) const;

  /// Columns of numbers, one per pair.
  struct Columns {
    enum Input { axx_i, ayy_i, azz_i, axy_i, axz_i, ayz_i, axx_j, ayy_j, azz_j, axy_j, axz_j, ayz_j,
                 dx, dy, dz, product_i, product_j, safe_overlap, input_count };
    enum Result { nx, ny, nz, px, py, pz, overlap, reduced_radius, radius_i, radius_j,
                  steps, ///< evaluations of the overlap function
                  open,  ///< 0: solved
                  result_count };
    alignas(64) double in[input_count][capacity];
    alignas(64) double out[result_count][capacity];
  };

private:
  int size_ = 0;
  Columns columns_;
  Vector3 start_[capacity];
  const EllipsoidShape *shape_i_[capacity], *shape_j_[capacity];
};

} // namespace ellipsoid
