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

#include "ellipsoid/ellipsoid_contact.h"
#include "vectorised/batch_columns.h"

namespace ellipsoid {

class ContactBatch : public Batch {
 public:
  /// @param[in] i, j live until clear()
  /// @param[in] centre_distance x_j - x_i (length)
  /// @param[in] start unit normal from i to j: the last one known
  void add(const EllipsoidShape& i, const EllipsoidShape& j, const Vector3& centre_distance,
           const Vector3& start);

  /// Searches the contacts of all pairs added, but for a few that it leaves unsolved.
  void solve();
  /// Searches the pairs that solve() left unsolved.
  void solve_unsolved();

  /// Instead of solve(): for pairs that should be apart. One Newton step, no more.
  void find_gaps();
  /// A length by which the bodies of pair k are apart at least, with normal(k) as the proof; not
  /// positive where none was found.
  double gap(int k) const { return -columns_.out[Columns::overlap][k]; }
  Vector3 normal(int k) const { return InSpace{k}.vector(columns_.out, Columns::nx); }

  /// What find_contact_from() would say of pair k, to the tolerances of contact_tolerances.h.
  ContactGeometry geometry(int k) const;
  /// The same after solve_unsolved(), number by number.
  bool is_apart(int k) const { return columns_.out[Columns::overlap][k] < 0.0; }
  bool has_converged(int k) const { return columns_.out[Columns::unsolved][k] == 0.0; }
  double steps(int k) const { return columns_.out[Columns::step_count][k]; }
  double curvature_radius_i(int k) const { return columns_.out[Columns::radius_i][k]; }
  double curvature_radius_j(int k) const { return columns_.out[Columns::radius_j][k]; }

  /// Columns of numbers, one per pair.
  struct Columns {
    enum Input {
      axx_i,
      ayy_i,
      azz_i,
      axy_i,
      axz_i,
      ayz_i,
      axx_j,
      ayy_j,
      azz_j,
      axy_j,
      axz_j,
      ayz_j,
      dx,
      dy,
      dz,
      product_i,
      product_j,
      safe_overlap,
      start_x,
      start_y,
      start_z,
      input_count
    };
    enum Result {
      nx,
      ny,
      nz,
      px,
      py,
      pz,
      overlap,
      reduced_radius,
      radius_i,
      radius_j,
      step_count, ///< evaluations of the overlap function
      unsolved,   ///< 0: solved; 1: to be searched alone, or not converged
      result_count
    };
    alignas(64) double in[input_count][column_length];
    alignas(64) double out[result_count][column_length];
  };

  const Columns& columns() const { return columns_; }

 private:
  Columns columns_;
  const EllipsoidShape *shape_i_[capacity], *shape_j_[capacity];

  ContactGeometry search_alone(int k) const;
};

// Inline, and number by number: a vector that is copied as a whole right after its numbers were
// stored one by one keeps the processor waiting.

inline void ContactBatch::add(const EllipsoidShape& i, const EllipsoidShape& j,
                              const Vector3& centre_distance, const Vector3& start) {
  using C = Columns;
  const int k = next();
  const InSpace at{k};
  at.put(columns_.in, C::axx_i, i.a_matrix);
  at.put(columns_.in, C::axx_j, j.a_matrix);
  at.put(columns_.in, C::dx, centre_distance);
  columns_.in[C::product_i][k] = i.axes_product;
  columns_.in[C::product_j][k] = j.axes_product;
  columns_.in[C::safe_overlap][k] = i.smallest_curvature_radius + j.smallest_curvature_radius;
  at.put(columns_.in, C::start_x, start);
  shape_i_[k] = &i;
  shape_j_[k] = &j;
}

inline ContactGeometry ContactBatch::geometry(int k) const {
  using C = Columns;
  const auto out = [this, k](int column) { return columns_.out[column][k]; };
  if (out(C::unsolved) != 0.0)
    return search_alone(k);
  ContactGeometry c;
  c.overlap = out(C::overlap);
  c.status = c.overlap < 0.0 ? ContactStatus::separated : ContactStatus::touching;
  c.normal = normal(k);
  c.point = InSpace{k}.vector(columns_.out, C::px);
  c.reduced_radius = out(C::reduced_radius);
  c.curvature_radius_i = out(C::radius_i);
  c.curvature_radius_j = out(C::radius_j);
  c.iterations = static_cast<int>(out(C::step_count));
  return c;
}

} // namespace ellipsoid
