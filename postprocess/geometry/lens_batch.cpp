// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "lens_batch.h"

#include "vectorised/vector_versions.h"

#include <algorithm>
#include <cmath>

namespace ellipsoid::post {
namespace {

using Columns = LensBatch::Columns;

/// What a proof must exceed as a share of the largest value of f: far above rounding.
constexpr double proof_margin = 1.0e-9, level_margin = 1.0e-12;

/// A root's error (rad) after its last step, at most.
constexpr double largest_error = 1.0e-17;

/// Lenses with less than this half width (rad) are left to the search of single pairs.
constexpr double smallest_half_width = 1.0e-4;

constexpr int newton_steps = 4, root_steps = 2;

struct Direction {
  double cosine, sine;
};

/// Turned by 2 atan(a / 2) with a = over / under, which is a up to terms of third order.
inline Direction turned(const Direction& d, double over, double under) {
  const double square = over * over, four = 4.0 * under * under, scale = 1.0 / (four + square);
  const double c = (four - square) * scale, s = 4.0 * over * under * scale;
  return {d.cosine * c - d.sine * s, d.sine * c + d.cosine * s};
}

/// f, with its coefficients about any direction.
struct Level {
  double k, c1, s1, c2, s2;

  struct Jet {
    double value, slope, curvature;
  };
  Jet at(const Direction& d) const {
    const double c = d.cosine, s = d.sine, cc = c * c - s * s, ss = 2.0 * s * c;
    const double first = c1 * c + s1 * s, second = c2 * cc + s2 * ss;
    return {k + first + second, s1 * c - c1 * s + 2.0 * (s2 * cc - c2 * ss), -first - 4.0 * second};
  }
  /// By how much the proof that there are no roots but -w and w from the direction succeeds.
  double proof(const Direction& middle, double cos_w) const {
    const double c = middle.cosine, s = middle.sine, cc = c * c - s * s, ss = 2.0 * s * c;
    const double first = c1 * c + s1 * s, second = c2 * cc + s2 * ss, other = s2 * cc - c2 * ss;
    return -first - 2.0 * second * cos_w - 2.0 * std::sqrt(second * second + other * other);
  }
};

/// The lowest of eight directions.
inline Direction lowest_eighth(const Level& f) {
  constexpr double r = 0.70710678118654752;
  Direction best{1.0, 0.0};
  double lowest = f.c1 + f.c2;
  const auto consider = [&](double value, double cosine, double sine) {
    const bool is_lower = value < lowest;
    best.cosine = is_lower ? cosine : best.cosine;
    best.sine = is_lower ? sine : best.sine;
    lowest = is_lower ? value : lowest;
  };
  consider(r * (f.c1 + f.s1) + f.s2, r, r);
  consider(f.s1 - f.c2, 0.0, 1.0);
  consider(r * (f.s1 - f.c1) - f.s2, -r, r);
  consider(f.c2 - f.c1, -1.0, 0.0);
  consider(f.s2 - r * (f.c1 + f.s1), -r, -r);
  consider(-f.s1 - f.c2, 0.0, -1.0);
  consider(r * (f.c1 - f.s1) - f.s2, r, -r);
  return best;
}

struct FoundRoot {
  Direction at;
  bool is_exact;
};

/// By parabolas of value, slope and curvature, see bracketed_root() of outline_crossings.cpp.
/// @param[in] side 1: f rises at the root, -1: it falls
inline FoundRoot root_from(const Level& f, Direction d, double side, double bound) {
  bool is_exact = false;
  for (int step = 0; step < root_steps; ++step) {
    const auto jet = f.at(d);
    const double squared = jet.slope * jet.slope - 2.0 * jet.value * jet.curvature;
    const double steepness = std::sqrt(std::max(0.0, squared));
    const double over = -2.0 * jet.value, under = jet.slope + side * steepness;
    const double share = std::abs(over), whole = std::abs(under);
    is_exact = (squared > 0.0) & (side * jet.slope > 0.0) &
               (bound * share * share * share <= largest_error * steepness * whole * whole * whole);
    d = turned(d, over, under);
  }
  return {d, is_exact};
}

/// Grows with the angle, from 0 to 4, as in turn_of().
inline double turn_of(const Direction& d) {
  const double r = d.sine / (std::abs(d.cosine) + std::abs(d.sine));
  const double ahead = r >= 0.0 ? r : 4.0 + r;
  return d.cosine < 0.0 ? 2.0 - r : ahead;
}

/// Outline i where outline j is the unit circle about 0: d + p cos t + q sin t.
struct SeenOutline {
  double d_x, d_y, p_x, p_y, q_y; ///< q_x is 0

  Direction at(const Direction& t) const {
    return {d_x + t.cosine * p_x, d_y + t.cosine * p_y + t.sine * q_y};
  }
  /// Whether j's centre lies in i: where the outlines do not meet, whether j does.
  bool holds_centre() const {
    const double along_p = d_x * q_y, along_q = d_y * p_x - p_y * d_x, product = p_x * q_y;
    return along_p * along_p + along_q * along_q <= product * product;
  }
  Level level() const {
    const double pp = p_x * p_x + p_y * p_y, qq = q_y * q_y;
    return {d_x * d_x + d_y * d_y + 0.5 * (pp + qq) - 1.0, 2.0 * (d_x * p_x + d_y * p_y),
            2.0 * d_y * q_y, 0.5 * (pp - qq), p_y * q_y};
  }
};

inline SeenOutline seen_outline(const Columns& columns, int k) {
  using C = Columns;
  const auto in = [&columns, k](int column) { return columns.in[column][k]; };
  const double scale_x = 1.0 / in(C::ux_j), scale_y = 1.0 / in(C::vy_j);
  const double d_x = in(C::dx)*scale_x, p_x = in(C::ux_i)*scale_x;
  return {d_x, (in(C::dy)-in(C::uy_j)*d_x) * scale_y, p_x, (in(C::uy_i)-in(C::uy_j)*p_x) * scale_y,
          in(C::vy_i)*scale_y};
}

/// Newton's method to a minimum of f.
/// @param[in] bound of the curvature
inline Direction minimum_of(const Level& f, double bound) {
  Direction m = lowest_eighth(f);
  for (int step = 0; step < newton_steps; ++step) {
    const auto jet = f.at(m);
    const double steepest = jet.curvature > 0.1 * bound ? jet.curvature : bound;
    m = turned(m, -jet.slope, steepest);
  }
  return m;
}

/// The two roots beside a minimum, and whether they are proved to be all there are.
struct FoundLens {
  Direction begin, end;
  bool is_proved;
};

inline FoundLens lens_about(const Level& f, const Direction& m, double size, double bound) {
  const auto lowest = f.at(m);
  // sin^2 of half of w, exact for discs: there f - f(m) is proportional to 1 - cos u
  const double squared = -0.5 * lowest.value / lowest.curvature;
  const double twice_tangent = 2.0 * std::sqrt(std::max(0.0, squared / (1.0 - squared)));
  const FoundRoot begin = root_from(f, turned(m, -twice_tangent, 1.0), -1.0, bound);
  const FoundRoot end = root_from(f, turned(m, twice_tangent, 1.0), 1.0, bound);
  // the chord between both is at right angles to the direction in their middle
  const Direction chord{end.at.cosine - begin.at.cosine, end.at.sine - begin.at.sine};
  const double length = std::sqrt(chord.cosine * chord.cosine + chord.sine * chord.sine);
  const double inverse = 1.0 / length;
  const Direction middle{inverse * chord.sine, -inverse * chord.cosine};
  const double sin_w = 0.5 * length;
  const double cos_w = middle.cosine * end.at.cosine + middle.sine * end.at.sine;
  const bool is_proved = (lowest.value < -level_margin * size) & (lowest.curvature > 0.0) &
                         begin.is_exact & end.is_exact & (sin_w > smallest_half_width) &
                         (middle.cosine * m.cosine + middle.sine * m.sine > 0.0) &
                         (f.proof(middle, cos_w) > proof_margin * size);
  return {begin.at, end.at, is_proved};
}

inline void measure_pair(Columns& columns, int k) {
  using C = Columns;
  const auto put = [&columns, k](int column, double value) { columns.out[column][k] = value; };
  const auto put_end = [&put](int column, const Direction& d) {
    put(column, turn_of(d));
    put(column + 1, d.cosine);
    put(column + 2, d.sine);
  };
  const SeenOutline seen = seen_outline(columns, k);
  const Level f = seen.level();
  const double first_wave = std::sqrt(f.c1 * f.c1 + f.s1 * f.s1);
  const double second_wave = std::sqrt(f.c2 * f.c2 + f.s2 * f.s2);
  const double size = std::abs(f.k) + first_wave + second_wave;
  const double bound = first_wave + 4.0 * second_wave;
  const Direction m = minimum_of(f, bound);
  const auto lowest = f.at(m);
  const bool is_apart = (lowest.value > std::abs(lowest.slope) + level_margin * size) &
                        (f.proof(m, 1.0) > proof_margin * size) & !seen.holds_centre();
  const FoundLens lens = lens_about(f, m, size, bound);
  put(C::is_apart, is_apart ? 1.0 : 0.0);
  put(C::is_lens, lens.is_proved ? 1.0 : 0.0);
  put_end(C::begin_i, lens.begin);
  put_end(C::end_i, lens.end);
  // both outlines run counter-clockwise: where one leaves the other enters
  put_end(C::begin_j, seen.at(lens.end));
  put_end(C::end_j, seen.at(lens.begin));
}

inline void measure_loop(Columns& columns, int size) {
#pragma GCC ivdep
  for (int k = 0; k < size; ++k)
    measure_pair(columns, k);
}

} // namespace

void LensBatch::solve() {
  WidestVersion<measure_loop>::run(columns_, filled_up(columns_.in, size()));
}

} // namespace ellipsoid::post
