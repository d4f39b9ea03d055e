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

/// Where the search of the pairs of a block stands.
struct Block {
  enum Value { shift_x, shift_y, shift_z, slope, phi, ix, iy, iz, jx, jy, jz, inverse_i, inverse_j,
               value_count };
  alignas(64) double of[value_count][block];
};

/// Numbers of one pair of the batch; `m` is its place in the block that begins with pair `begin`.
struct PairColumns {
  Columns& c;
  Block& b;
  int k, m;

  SymmetricMatrix3 matrix(int column) const {
    return {c.in[column][k],     c.in[column + 1][k], c.in[column + 2][k],
            c.in[column + 3][k], c.in[column + 4][k], c.in[column + 5][k]};
  }
  Vector3 distance() const {
    return {c.in[Columns::dx][k], c.in[Columns::dy][k], c.in[Columns::dz][k]};
  }
  Vector3 normal() const {
    return {c.out[Columns::nx][k], c.out[Columns::ny][k], c.out[Columns::nz][k]};
  }
  Vector3 block_vector(int value) const {
    return {b.of[value][m], b.of[value + 1][m], b.of[value + 2][m]};
  }
  bool open() const { return c.out[Columns::open][k] != 0.0; }
  void put(int column, double value) const { c.out[column][k] = value; }
  /// Leaves solved pairs as they are.
  void put_block(int value, double number) const {
    b.of[value][m] = open() ? number : b.of[value][m];
  }
  void put_block(int value, const Vector3& v) const {
    put_block(value, v.x);
    put_block(value + 1, v.y);
    put_block(value + 2, v.z);
  }
};

/// One evaluation of phi at the pair's normal: the shift to the next one, and whether the pair is
/// solved with it.
inline void newton_step(const PairColumns& p) {
  using C = Columns;
  const SymmetricMatrix3 a_i = p.matrix(C::axx_i), a_j = p.matrix(C::axx_j);
  const OverlapFunction f(a_i, a_j, p.distance(), p.normal());
  const OverlapHessian h(curvature_radii_sum(a_i, a_j, f), f.value);
  const double inverse = 1.0 / h.determinant;
  const Vector3 shift = h.newton_shift(f, inverse);
  const double slope = dot(f.gradient, shift), squared = dot(shift, shift);
  const double error = h.trace * h.trace * inverse * f.radius_change_rate() * squared;

  // bitwise &, |: no branches
  const bool convex =
      (h.determinant > tolerance::convexity * h.trace * h.trace) & (h.trace > 0.0);
  const bool exact =
      (error <= tolerance::batch_normal_error) &
      (squared <= tolerance::batch_extrapolated_step * tolerance::batch_extrapolated_step);
  const double next_value = f.value + 0.5 * slope;
  const bool apart_here = f.value < 0.0;
  const bool solved = (convex & exact & (next_value <= p.c.in[C::safe_overlap][p.k])) |
                      (exact & (next_value < 0.0)) | apart_here;

  const double share = apart_here ? 0.0 : 1.0; // this normal is the proof
  p.put_block(Block::shift_x, share * shift);
  p.put_block(Block::slope, share * slope);
  p.put_block(Block::phi, f.value);
  p.put_block(Block::ix, f.support_point_i);
  p.put_block(Block::jx, f.support_point_j);
  p.put_block(Block::inverse_i, f.inverse_support_i);
  p.put_block(Block::inverse_j, f.inverse_support_j);
  p.put(C::steps, p.c.out[C::steps][p.k] + (p.open() ? 1.0 : 0.0));
  p.put(C::open, p.open() & !solved ? 1.0 : 0.0);
}

/// To the next normal of a pair that is not solved.
inline void turn_normal(const PairColumns& p) {
  using C = Columns;
  const Vector3 normal = p.normal(), next = normalized(normal + p.block_vector(Block::shift_x));
  p.put(C::nx, p.open() ? next.x : normal.x);
  p.put(C::ny, p.open() ? next.y : normal.y);
  p.put(C::nz, p.open() ? next.z : normal.z);
}

/// The contact of a solved pair, at the end of its last shift.
inline void finish_pair(const PairColumns& p) {
  using C = Columns;
  const SymmetricMatrix3 a_i = p.matrix(C::axx_i), a_j = p.matrix(C::axx_j);
  OverlapFunction f;
  f.normal = p.normal();
  f.support_point_i = p.block_vector(Block::ix);
  f.support_point_j = p.block_vector(Block::jx);
  f.inverse_support_i = p.b.of[Block::inverse_i][p.m];
  f.inverse_support_j = p.b.of[Block::inverse_j][p.m];
  f.value = p.b.of[Block::phi][p.m];
  const OverlapFunction g = extrapolated(a_i, a_j, f, p.block_vector(Block::shift_x),
                                         p.b.of[Block::slope][p.m]);
  const double det_sum = tangent_determinant(curvature_radii_sum(a_i, a_j, g));
  const Vector3 point = 0.5 * (g.support_point_i + p.distance() - g.support_point_j);
  const double r_i = p.c.in[C::product_i][p.k] * g.inverse_support_i * g.inverse_support_i;
  const double r_j = p.c.in[C::product_j][p.k] * g.inverse_support_j * g.inverse_support_j;
  p.put(C::nx, g.normal.x);
  p.put(C::ny, g.normal.y);
  p.put(C::nz, g.normal.z);
  p.put(C::px, point.x);
  p.put(C::py, point.y);
  p.put(C::pz, point.z);
  p.put(C::overlap, g.value);
  p.put(C::reduced_radius, r_i * r_j / std::sqrt(det_sum));
  p.put(C::radius_i, r_i);
  p.put(C::radius_j, r_j);
}

inline void solve_block(Columns& c, int begin) {
  Block b;
  for (int step = 0;; ++step) {
#pragma GCC ivdep
    for (int m = 0; m < block; ++m)
      newton_step({c, b, begin + m, m});
    int open = 0;
    for (int k = begin; k < begin + block; ++k)
      open |= static_cast<int>(c.out[Columns::open][k] != 0.0);
    if (open == 0 || step + 1 == step_limit)
      break;
#pragma GCC ivdep
    for (int m = 0; m < block; ++m)
      turn_normal({c, b, begin + m, m});
  }
#pragma GCC ivdep
  for (int m = 0; m < block; ++m)
    finish_pair({c, b, begin + m, m});
}

inline void search_loop(Columns& c, int size) {
  for (int begin = 0; begin < size; begin += block)
    solve_block(c, begin);
}

ELLIPSOID_VECTOR_VERSIONS(search, Columns)

/// The better one of two proofs: the normal as it is, and after one Newton step.
inline void separate(const PairColumns& p) {
  using C = Columns;
  const SymmetricMatrix3 a_i = p.matrix(C::axx_i), a_j = p.matrix(C::axx_j);
  const Vector3 distance = p.distance(), normal = p.normal();
  const OverlapFunction f(a_i, a_j, distance, normal);
  const OverlapHessian h(curvature_radii_sum(a_i, a_j, f), f.value);
  const Vector3 next = normalized(normal + h.newton_shift(f, 1.0 / h.determinant));
  const double value = std::sqrt(dot(next, a_i * next)) + std::sqrt(dot(next, a_j * next)) -
                       dot(next, distance);
  const bool better = value < f.value;
  p.put(C::nx, better ? next.x : normal.x);
  p.put(C::ny, better ? next.y : normal.y);
  p.put(C::nz, better ? next.z : normal.z);
  p.put(C::overlap, better ? value : f.value);
}

inline void separate_all_loop(Columns& c, int size) {
  for (int begin = 0; begin < size; begin += block) {
    Block unused;
#pragma GCC ivdep
    for (int m = 0; m < block; ++m)
      separate({c, unused, begin + m, m});
  }
}

ELLIPSOID_VECTOR_VERSIONS(separate_all, Columns)

} // namespace

void ContactBatch::fill_last_block() {
  filled_up(columns_.in, size(), block);
  filled_up(columns_.out, size(), block);
}

void ContactBatch::solve() {
  fill_last_block();
  search(columns_, size());
}

void ContactBatch::solve_open() {
  using C = Columns;
  for (int k = 0; k < size(); ++k) {
    if (columns_.out[C::open][k] == 0.0)
      continue;
    const ContactGeometry c = search_alone(k);
    const auto put = [this, k](int column, double value) { columns_.out[column][k] = value; };
    const auto put_vector = [&put](int column, const Vector3& v) {
      put(column, v.x);
      put(column + 1, v.y);
      put(column + 2, v.z);
    };
    put_vector(C::nx, c.normal);
    put_vector(C::px, c.point);
    put(C::overlap, c.overlap);
    put(C::reduced_radius, c.reduced_radius);
    put(C::radius_i, c.curvature_radius_i);
    put(C::radius_j, c.curvature_radius_j);
    put(C::steps, c.iterations);
    put(C::open, c.status == ContactStatus::not_converged ? 1.0 : 0.0);
  }
}

void ContactBatch::find_gaps() {
  fill_last_block();
  separate_all(columns_, size());
}

ContactGeometry ContactBatch::search_alone(int k) const {
  using C = Columns;
  const auto in = [this, k](int column) { return columns_.in[column][k]; };
  return find_contact_from({in(C::start_x), in(C::start_y), in(C::start_z)}, *shape_i_[k],
                           *shape_j_[k], {in(C::dx), in(C::dy), in(C::dz)});
}

} // namespace ellipsoid
