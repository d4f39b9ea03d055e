// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "contact_batch.h"

#include "ellipsoid_overlap.h"
#include "vector_versions.h"

namespace ellipsoid {

namespace {

using Columns = ContactBatch::Columns;

/// Pairs that go through the Newton steps together: a few vectors.
constexpr int block = 16;
static_assert(ContactBatch::capacity % block == 0, "whole blocks");

/// Newton steps before a pair is left to the search of single pairs.
constexpr int step_limit = 4;

/// One Newton step of pair k: its result if the step settles it, else the next normal.
inline void newton_step(Columns& c, int k) {
  using C = Columns;
  const auto in = [&c, k](int column) { return c.in[column][k]; };
  const SymmetricMatrix3 a_i{in(C::axx_i), in(C::ayy_i), in(C::azz_i),
                             in(C::axy_i), in(C::axz_i), in(C::ayz_i)};
  const SymmetricMatrix3 a_j{in(C::axx_j), in(C::ayy_j), in(C::azz_j),
                             in(C::axy_j), in(C::axz_j), in(C::ayz_j)};
  const Vector3 distance{in(C::dx), in(C::dy), in(C::dz)};
  const Vector3 normal{c.out[C::nx][k], c.out[C::ny][k], c.out[C::nz][k]};

  const OverlapFunction f(a_i, a_j, distance, normal);
  const TangentFrame frame(normal);
  const TangentMatrix radii = curvature_radii_sum(a_i, a_j, f, frame);
  const TangentMatrix hessian{radii.xx - f.value, radii.xy, radii.yy - f.value};
  const double determinant = hessian.determinant(), trace = hessian.trace();
  const double inverse = 1.0 / determinant;
  const double g1 = dot(frame.first, f.gradient), g2 = dot(frame.second, f.gradient);
  const double first = -inverse * (hessian.yy * g1 - hessian.xy * g2);
  const double second = -inverse * (hessian.xx * g2 - hessian.xy * g1);
  const double squared = first * first + second * second;
  const double error = trace * trace * inverse * f.radius_change_rate() * squared;
  const Vector3 shift = first * frame.first + second * frame.second;

  const OverlapFunction g = extrapolated(a_i, a_j, f, shift, first * g1 + second * g2);
  const double det_sum =
      curvature_radii_sum(a_i, a_j, g, TangentFrame(g.normal)).determinant();

  // bitwise &, |: no branches
  const bool convex = (determinant > tolerance::convexity * trace * trace) & (trace > 0.0);
  const bool exact =
      (error <= tolerance::batch_normal_error) &
      (squared <= tolerance::batch_extrapolated_step * tolerance::batch_extrapolated_step);
  const bool apart = (f.value < 0.0) | ((g.value < 0.0) & exact);
  const bool solved = (convex & exact & (g.value <= in(C::safe_overlap))) | apart;

  const bool active = c.out[C::open][k] != 0.0;
  const auto put = [&c, k, active](int column, double value) {
    c.out[column][k] = active ? value : c.out[column][k];
  };
  const Vector3 point = 0.5 * (g.support_point_i + distance - g.support_point_j);
  const double r_i = std::sqrt(in(C::product_i)) / (g.support_i * g.support_i);
  const double r_j = std::sqrt(in(C::product_j)) / (g.support_j * g.support_j);
  put(C::nx, g.normal.x);
  put(C::ny, g.normal.y);
  put(C::nz, g.normal.z);
  put(C::px, point.x);
  put(C::py, point.y);
  put(C::pz, point.z);
  put(C::overlap, f.value < 0.0 ? f.value : g.value);
  put(C::reduced_radius, r_i * r_j / std::sqrt(det_sum));
  put(C::radius_i, r_i);
  put(C::radius_j, r_j);
  put(C::steps, c.out[C::steps][k] + 1.0);
  put(C::open, solved ? 0.0 : 1.0);
}

inline void solve_block(Columns& c, int begin) {
  for (int step = 0; step < step_limit; ++step) {
#pragma GCC ivdep
    for (int k = begin; k < begin + block; ++k)
      newton_step(c, k);
    double open = 0.0;
    for (int k = begin; k < begin + block; ++k)
      open += c.out[Columns::open][k];
    if (open == 0.0)
      return;
  }
}

inline void search_loop(Columns& c, int size) {
  for (int begin = 0; begin < size; begin += block)
    solve_block(c, begin);
}

ELLIPSOID_VECTOR_VERSIONS(search, Columns)

} // namespace

void ContactBatch::solve() {
  // the last block is filled up with its first pair, which is there
  const int last = size_ - size_ % block;
  for (int k = size_; k % block != 0; ++k) {
    for (int column = 0; column < Columns::input_count; ++column)
      columns_.in[column][k] = columns_.in[column][last];
    for (int column = 0; column < Columns::result_count; ++column)
      columns_.out[column][k] = columns_.out[column][last];
  }
  search(columns_, size_);
}

ContactGeometry ContactBatch::search_alone(int k) const {
  using C = Columns;
  const auto in = [this, k](int column) { return columns_.in[column][k]; };
  return find_contact_from({in(C::start_x), in(C::start_y), in(C::start_z)}, *shape_i_[k],
                           *shape_j_[k], {in(C::dx), in(C::dy), in(C::dz)});
}

} // namespace ellipsoid
