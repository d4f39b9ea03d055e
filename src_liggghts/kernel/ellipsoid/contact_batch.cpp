// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "ellipsoid/contact_batch.h"

#include "ellipsoid/ellipsoid_overlap.h"
#include "vectorised/vector_versions.h"

#include <limits>

namespace ellipsoid {

namespace {

using Columns = ContactBatch::Columns;

/// Newton steps before a pair is left to the search of single pairs.
constexpr int step_limit = 4;

/// Where the search of the pairs stands, from one loop to the next (see batch_columns.h).
struct Work {
  enum Value {
    ix,
    iy,
    iz,
    jx,
    jy,
    jz,
    inverse_i,
    inverse_j,
    phi,
    shift_x,
    shift_y,
    shift_z, ///< later the normal, or direction, that it leads to
    radii,   // 6
    trace = radii + 6,
    inverse_determinant,
    largest_overlap, ///< below which the pair is solved
    value_count
  };
  alignas(64) double of[value_count][ContactBatch::column_length];
};

/// One pair, from the normal in the columns `normal_column` and the two after it of `normals`.
template <class Space, class Normals> struct PairSearch {
  using C = Columns;
  using Vector = typename Space::Vector;
  using Matrix = typename Space::Matrix;
  Columns& c;
  Work& w;
  const Normals& normals;
  int normal_column;
  Space at;

  Matrix a_i() const { return at.matrix(c.in, C::axx_i); }
  Matrix a_j() const { return at.matrix(c.in, C::axx_j); }
  Vector distance() const { return at.vector(c.in, C::dx); }
  Vector normal() const { return at.vector(normals, normal_column); }
  OverlapFunction<Vector> overlap_function() const {
    OverlapFunction<Vector> f;
    f.normal = normal();
    f.support_point_i = at.vector(w.of, Work::ix);
    f.support_point_j = at.vector(w.of, Work::jx);
    f.inverse_support_i = w.of[Work::inverse_i][at.k];
    f.inverse_support_j = w.of[Work::inverse_j][at.k];
    f.value = w.of[Work::phi][at.k];
    f.gradient = f.support_point_i + f.support_point_j - distance();
    return f;
  }
  void put(const OverlapFunction<Vector>& f) const {
    at.put(w.of, Work::ix, f.support_point_i);
    at.put(w.of, Work::jx, f.support_point_j);
    w.of[Work::inverse_i][at.k] = f.inverse_support_i;
    w.of[Work::inverse_j][at.k] = f.inverse_support_j;
    w.of[Work::phi][at.k] = f.value;
  }

  void evaluate() const { put(OverlapFunction(a_i(), a_j(), distance(), normal())); }

  /// Newton's step, and whether one step of third order is enough.
  void step() const {
    const OverlapFunction f = overlap_function();
    const OverlapHessian h(curvature_radii_sum(a_i(), a_j(), f), f.value);
    const bool apart_here = f.value < 0.0; // this normal is the proof
    const Vector shift = h.newton_shift(f);
    at.put(w.of, Work::shift_x, (apart_here ? 0.0 : 1.0) * shift);
    at.put(w.of, Work::radii, h.radii);
    w.of[Work::trace][at.k] = h.trace;
    w.of[Work::inverse_determinant][at.k] = h.inverse_determinant;

    // The overlap is small for the curvatures: H is near W_i + W_j, and phi has a minimum there.
    // Bitwise &: no branches.
    const double shallow = 2.0 * f.value * (h.trace + 2.0 * f.value);
    const bool convex = (shallow <= tangent_determinant(h.radii)) & (h.trace > 0.0);
    const double condition = h.trace * h.trace * h.inverse_determinant;
    const double rate = f.radius_change_rate();
    const double third =
        condition * (tolerance::third_order_squared_rate * condition * rate * rate +
                     tolerance::third_order_flat * flatness(f));
    const double squared = dot(shift, shift);
    const bool exact = third * third * squared * squared * squared <=
                       tolerance::batch_normal_error * tolerance::batch_normal_error;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    w.of[Work::largest_overlap][at.k] = apart_here         ? infinity
                                        : (convex & exact) ? c.in[C::safe_overlap][at.k]
                                                           : -infinity;
  }

  /// Largest (semi-axis / s)^2 of the two, or some more: how fast the radii of curvature change
  /// beside a flat spot, where they are largest (1 / rad^2).
  double flatness(const OverlapFunction<Vector>& f) const {
    const double i = trace(a_i()) * f.inverse_support_i * f.inverse_support_i,
                 j = trace(a_j()) * f.inverse_support_j * f.inverse_support_j;
    return i > j ? i : j;
  }

  void extrapolate() const {
    const OverlapFunction f = overlap_function();
    OverlapHessian<Matrix> h;
    h.radii = at.matrix(w.of, Work::radii);
    h.phi = f.value;
    h.trace = w.of[Work::trace][at.k];
    h.inverse_determinant = w.of[Work::inverse_determinant][at.k];
    const Vector shift = at.vector(w.of, Work::shift_x);
    const OverlapFunction g = extrapolated(a_i(), a_j(), f, h, shift);
    put(g);
    at.put(w.of, Work::shift_x, chosen(is_solved(), g.normal, f.normal + shift));
  }

  /// After extrapolate().
  bool is_solved() const { return w.of[Work::phi][at.k] < w.of[Work::largest_overlap][at.k]; }

  /// The contact of a pair that is solved; for the others a direction to go on from.
  template <bool is_first> void finish() const {
    const OverlapFunction g = overlap_function();
    const double r_i = c.in[C::product_i][at.k] * g.inverse_support_i * g.inverse_support_i;
    const double r_j = c.in[C::product_j][at.k] * g.inverse_support_j * g.inverse_support_j;
    const double det_sum = tangent_determinant(curvature_radii_sum(a_i(), a_j(), g));
    const bool unsolved = is_first ? true : c.out[C::unsolved][at.k] != 0.0;
    const auto result = [&](int column, double value) {
      c.out[column][at.k] = unsolved ? value : c.out[column][at.k];
    };
    const auto result_vector = [&](int column, const Vector& v) {
      at.put(c.out, column, is_first ? v : chosen(unsolved, v, at.vector(c.out, column)));
    };
    result_vector(C::nx, at.vector(w.of, Work::shift_x));
    result_vector(C::px, 0.5 * (g.support_point_i + distance() - g.support_point_j));
    result(C::overlap, g.value);
    result(C::reduced_radius, r_i * r_j / std::sqrt(det_sum));
    result(C::radius_i, r_i);
    result(C::radius_j, r_j);
    c.out[C::step_count][at.k] =
        is_first ? 1.0 : c.out[C::step_count][at.k] + (unsolved ? 1.0 : 0.0);
    c.out[C::unsolved][at.k] = (unsolved & !is_solved()) ? 1.0 : 0.0;
  }

  /// The normal after one Newton step.
  void turn() const {
    const OverlapFunction f = overlap_function();
    const OverlapHessian h(curvature_radii_sum(a_i(), a_j(), f), f.value);
    at.put(w.of, Work::shift_x, normalized(f.normal + h.newton_shift(f)));
  }

  /// The better one of two proofs: the normal as it is, and after one Newton step.
  void separate() const {
    const Vector next = at.vector(w.of, Work::shift_x);
    const double before = w.of[Work::phi][at.k];
    const double after = std::sqrt(dot(next, a_i() * next)) + std::sqrt(dot(next, a_j() * next)) -
                         dot(next, distance());
    const bool better = after < before;
    at.put(c.out, C::nx, chosen(better, next, normal()));
    c.out[C::overlap][at.k] = better ? after : before;
  }
};

/// From the normals in the columns `normal_column` and the two after it of `normals`.
template <class Space, bool is_first, class Normals>
inline void search_from(const Normals& normals, int normal_column, Columns& c, Work& w, int begin,
                        int end) {
  const auto pair = [&](int k) {
    return PairSearch<Space, Normals>{c, w, normals, normal_column, {k}};
  };
  for_items(begin, end, [&](int k) { pair(k).evaluate(); });
  for_items(begin, end, [&](int k) { pair(k).step(); });
  for_items(begin, end, [&](int k) { pair(k).extrapolate(); });
  for_items(begin, end, [&](int k) { pair(k).template finish<is_first>(); });
}

/// Makes normals of the directions of pairs that are not solved.
template <class Space> inline void turn_normals(Columns& c, int begin) {
  for_items(begin, begin + loop_width, [&c](int k) {
    const Space at{k};
    const auto direction = at.vector(c.out, Columns::nx);
    at.put(c.out, Columns::nx,
           chosen(c.out[Columns::unsolved][k] != 0.0, normalized(direction), direction));
  });
}

template <class Space> inline void search_pairs(Columns& c, int size) {
  using C = Columns;
  Work w;
  search_from<Space, true>(c.in, C::start_x, c, w, 0, size);
  for (int begin = 0; begin < size; begin += loop_width)
    for (int step = 1; step < step_limit && any(c.out[C::unsolved] + begin, loop_width); ++step) {
      turn_normals<Space>(c, begin);
      search_from<Space, false>(c.out, C::nx, c, w, begin, begin + loop_width);
    }
}

inline bool in_plane(const Columns& c, int size) {
  using C = Columns;
  return all_zero(c.in, {C::axz_i, C::ayz_i, C::axz_j, C::ayz_j, C::dz, C::start_z}, size);
}

inline void search_loop(Columns& c, int size) {
  if (in_plane(c, size))
    search_pairs<InPlane>(c, size);
  else
    search_pairs<InSpace>(c, size);
}

template <class Space> inline void separate_pairs(Columns& c, int size) {
  using C = Columns;
  Work w;
  const auto pair = [&](int k) {
    return PairSearch<Space, decltype(c.in)>{c, w, c.in, C::start_x, {k}};
  };
  for_items(0, size, [&](int k) { pair(k).evaluate(); });
  for_items(0, size, [&](int k) { pair(k).turn(); });
  for_items(0, size, [&](int k) { pair(k).separate(); });
}

inline void separate_all_loop(Columns& c, int size) {
  if (in_plane(c, size))
    separate_pairs<InPlane>(c, size);
  else
    separate_pairs<InSpace>(c, size);
}

} // namespace

void ContactBatch::solve() {
  WidestVersion<search_loop>::run(columns_, filled_up(columns_.in, size(), loop_width));
}

void ContactBatch::solve_unsolved() {
  using C = Columns;
  for (int k = 0; k < size(); ++k) {
    if (columns_.out[C::unsolved][k] == 0.0)
      continue;
    const ContactGeometry c = search_alone(k);
    const InSpace at{k};
    at.put(columns_.out, C::nx, c.normal);
    at.put(columns_.out, C::px, c.point);
    const auto put = [this, k](int column, double value) { columns_.out[column][k] = value; };
    put(C::overlap, c.overlap);
    put(C::reduced_radius, c.reduced_radius);
    put(C::radius_i, c.curvature_radius_i);
    put(C::radius_j, c.curvature_radius_j);
    put(C::step_count, c.iterations);
    put(C::unsolved, ellipsoid::has_converged(c.status) ? 0.0 : 1.0);
  }
}

void ContactBatch::find_gaps() {
  WidestVersion<separate_all_loop>::run(columns_, filled_up(columns_.in, size(), loop_width));
}

ContactGeometry ContactBatch::search_alone(int k) const {
  using C = Columns;
  const InSpace at{k};
  return find_contact_from(at.vector(columns_.in, C::start_x), *shape_i_[k], *shape_j_[k],
                           at.vector(columns_.in, C::dx));
}

} // namespace ellipsoid
