// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Chain with the smallest area between its outline and the ellipse, by damped Newton
// (Levenberg-Marquardt) steps from the equal-ripple chain. The gradient is exact: for a sphere it
// is an integral over its arc, weighted +1 outside and -1 inside the ellipse; cutting planes do
// not contribute since the outline is continuous there.
#include "multisphere/multisphere_measures.h"
#include "multisphere/multisphere_spacing.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace ellipsoid {
namespace {

/// In units of spacing and ripple: far above rounding, far below any use of the chain.
constexpr double step_tolerance = 1e-9;
constexpr double rounding_step = 1e-3;   ///< the same where rounding stops the descent: the area is
                                         ///< then smallest to 1e-6 of itself
constexpr double difference_step = 1e-4; ///< for the Hessian: relative error 1e-8
constexpr int iteration_limit = 300;
constexpr double largest_damping = 1e8;
constexpr std::size_t reach = 3; ///< unknowns further apart than this do not interact

/// e_0, x_1, e_1, x_2, e_2, ...: a sphere's radius is that of the inscribed one plus e_k. Distances
/// x in units of the mean spacing, e in units of the start's ripple, so that all are of order one.
using Vector = std::vector<double>;

class AreaBetween {
 public:
  AreaBetween(double a, double b, const HalfChain& start)
      : a_(a), b_(b),
        spacing_(start.centres.back() / static_cast<double>(start.centres.size() - 1)),
        ripple_(start.radii[0] - b) {}

  Vector unknowns_of(const HalfChain& half) const {
    Vector unknowns;
    for (std::size_t k = 0; k < half.centres.size(); ++k) {
      const double x = half.centres[k];
      if (k > 0)
        unknowns.push_back(x / spacing_);
      unknowns.push_back((half.radii[k] - inscribed_radius(a_, b_, x)) / ripple_);
    }
    return unknowns;
  }

  HalfChain half_chain_of(const Vector& unknowns) const {
    HalfChain half;
    for (std::size_t i = 0; i < unknowns.size(); i += 2) {
      const double x = i == 0 ? 0.0 : unknowns[i - 1] * spacing_;
      half.centres.push_back(x);
      half.radii.push_back(inscribed_radius(a_, b_, x) + unknowns[i] * ripple_);
    }
    return half;
  }

  bool is_valid(const Vector& unknowns) const {
    const HalfChain half = half_chain_of(unknowns);
    for (std::size_t k = 0; k < half.centres.size(); ++k)
      if (!(half.radii[k] > 0.0) || (k > 0 && !(half.centres[k] > half.centres[k - 1])))
        return false;
    return true;
  }

  /// Of the half with x > 0.
  double value(const Vector& unknowns) const {
    const MultisphereTemplate chain = chain_of(unknowns);
    return 0.5 * area_between(chain, cut_off_spheres(chain));
  }

  Vector gradient(const Vector& unknowns) const {
    const MultisphereTemplate chain = chain_of(unknowns);
    const int middle = chain.count() / 2;
    Vector g(unknowns.size(), 0.0);
    for (const OutlinePiece& piece : outline_pieces(chain, cut_off_spheres(chain))) {
      if (piece.sphere < middle)
        continue;
      const auto sphere = static_cast<std::size_t>(piece.sphere);
      const double r = chain.radii[sphere], from = piece.begin, to = piece.end;
      const double to_radius = 2.0 * piece.sign * r * (arc_angle(r, to) - arc_angle(r, from));
      const double to_centre =
          2.0 * piece.sign * (std::sqrt((r - from) * (r + from)) - std::sqrt((r - to) * (r + to)));
      if (piece.sphere == middle) {
        g[0] += 0.5 * ripple_ * to_radius;
      } else {
        const auto k = static_cast<std::size_t>(piece.sphere - middle);
        g[2 * k - 1] += spacing_ * (to_centre + radius_slope(chain.centres[sphere]) * to_radius);
        g[2 * k] += ripple_ * to_radius;
      }
    }
    return g;
  }

  /// Symmetric band matrix: row i holds columns i - reach .. i. Central differences of the
  /// gradient, all unknowns of one residue class at once.
  std::vector<Vector> hessian(const Vector& unknowns) const {
    const std::size_t size = unknowns.size(), stride = 2 * reach + 1;
    std::vector<Vector> columns(stride);
    for (std::size_t colour = 0; colour < stride; ++colour) {
      Vector up = unknowns, down = unknowns;
      for (std::size_t i = colour; i < size; i += stride) {
        up[i] += difference_step;
        down[i] -= difference_step;
      }
      const Vector g_up = gradient(up), g_down = gradient(down);
      for (std::size_t i = 0; i < size; ++i)
        columns[colour].push_back((g_up[i] - g_down[i]) / (2.0 * difference_step));
    }
    std::vector<Vector> h(size, Vector(reach + 1, 0.0));
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = i < reach ? 0 : i - reach; j <= i; ++j)
        h[i][j + reach - i] = 0.5 * (columns[j % stride][i] + columns[i % stride][j]);
    return h;
  }

 private:
  MultisphereTemplate chain_of(const Vector& unknowns) const {
    return mirrored(a_, b_, SphereSpacing::minimax_area, half_chain_of(unknowns));
  }

  /// Derivative of inscribed_radius().
  double radius_slope(double x) const {
    const double focal_squared = (a_ - b_) * (a_ + b_);
    if (a_ * x >= focal_squared)
      return -1.0;
    return -b_ * b_ * x / (focal_squared * inscribed_radius(a_, b_, x));
  }

  double a_, b_, spacing_, ripple_;
};

/// Solves (H + damping |diag H|) x = -g by Cholesky; false when that is not positive definite.
bool solve_band(std::vector<Vector> h, const Vector& g, double damping, Vector& x) {
  const std::size_t size = g.size();
  x.assign(size, 0.0);
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t first = i < reach ? 0 : i - reach;
    h[i][reach] += damping * std::fabs(h[i][reach]);
    double right = -g[i];
    for (std::size_t j = first; j <= i; ++j) {
      double sum = h[i][j + reach - i];
      for (std::size_t k = std::max(first, j < reach ? 0 : j - reach); k < j; ++k)
        sum -= h[i][k + reach - i] * h[j][k + reach - j];
      if (j < i) {
        h[i][j + reach - i] = sum / h[j][reach];
        right -= h[i][j + reach - i] * x[j];
      } else {
        if (!(sum > 0.0))
          return false;
        h[i][reach] = std::sqrt(sum);
        x[i] = right / h[i][reach];
      }
    }
  }
  for (std::size_t i = size; i-- > 0;) {
    for (std::size_t j = i + 1; j < std::min(size, i + reach + 1); ++j)
      x[i] -= h[j][i + reach - j] * x[j];
    x[i] /= h[i][reach];
  }
  return true;
}

double largest_magnitude(const Vector& v) {
  double largest = 0.0;
  for (const double x : v)
    largest = std::fmax(largest, std::fabs(x));
  return largest;
}

} // namespace

HalfChain minimax_area_half_chain(double a, double b, int n) {
  const HalfChain start = minimax_outline_half_chain(a, b, n);
  if (!neighbours_overlap(start))
    return start;
  const AreaBetween target(a, b, start);
  Vector unknowns = target.unknowns_of(start), g = target.gradient(unknowns), step;
  double value = target.value(unknowns), damping = 1e-3;
  std::vector<Vector> h = target.hessian(unknowns);
  for (int iteration = 0; iteration < iteration_limit && damping < largest_damping; ++iteration) {
    bool accepted = false;
    if (solve_band(h, g, damping, step)) {
      Vector trial = unknowns;
      for (std::size_t i = 0; i < trial.size(); ++i)
        trial[i] += step[i];
      if (damping <= 1e-3 && largest_magnitude(step) < step_tolerance)
        return target.half_chain_of(trial);
      if (target.is_valid(trial)) {
        const Vector g_trial = target.gradient(trial);
        const double trial_value = target.value(trial);
        // Near the minimum the value is flat to rounding: there the gradient decides.
        accepted = trial_value < value || largest_magnitude(g_trial) < largest_magnitude(g);
        if (accepted) {
          unknowns = trial;
          g = g_trial;
          value = trial_value;
        }
      }
    }
    damping *= accepted ? 0.1 : 5.0;
    if (accepted)
      h = target.hessian(unknowns);
  }
  // With very many spheres rounding ends the descent before step_tolerance is met.
  if (solve_band(h, g, 0.0, step) && largest_magnitude(step) < rounding_step)
    return target.half_chain_of(unknowns);
  throw std::invalid_argument(
      "multisphere template: spacing minimax_area did not converge for a = " + std::to_string(a) +
      ", b = " + std::to_string(b) + ", N = " + std::to_string(2 * n + 1) +
      ": use spacing paper or minimax_outline");
}

} // namespace ellipsoid
