// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Chain with the smallest area between its outline and the ellipse, by damped Newton
// (Levenberg-Marquardt) steps from the equal-ripple chain. The gradient is exact: for a sphere it
// is an integral over its arc, weighted +1 outside and -1 inside the ellipse; cutting planes do
// not contribute since the outline is continuous there.
#include "multisphere_measures.h"
#include "multisphere_spacing.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace ellipsoid {
namespace {

/// Relative to a: far above the rounding of the gradient, far below any use of the chain.
constexpr double step_tolerance = 1e-12;
constexpr double difference_step = 1e-6; ///< for the Hessian, relative to b: near eps^(1/3)
constexpr int iteration_limit = 500;
constexpr std::size_t reach = 3; ///< unknowns further apart than this do not interact

using Vector = std::vector<double>; ///< R_0, x_1, R_1, x_2, R_2, ...

HalfChain half_chain_of(const Vector& unknowns) {
  HalfChain half{{0.0}, {unknowns[0]}};
  for (std::size_t i = 1; i < unknowns.size(); i += 2) {
    half.centres.push_back(unknowns[i]);
    half.radii.push_back(unknowns[i + 1]);
  }
  return half;
}

Vector unknowns_of(const HalfChain& half) {
  Vector unknowns{half.radii[0]};
  for (std::size_t k = 1; k < half.centres.size(); ++k) {
    unknowns.push_back(half.centres[k]);
    unknowns.push_back(half.radii[k]);
  }
  return unknowns;
}

class AreaBetween {
 public:
  AreaBetween(double a, double b) : a_(a), b_(b) {}

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
      const double r = chain.radii[static_cast<std::size_t>(piece.sphere)];
      const double from = piece.begin, to = piece.end;
      const double to_radius = 2.0 * piece.sign * r * (arc_angle(r, to) - arc_angle(r, from));
      const double to_centre =
          2.0 * piece.sign * (std::sqrt((r - from) * (r + from)) - std::sqrt((r - to) * (r + to)));
      if (piece.sphere == middle) {
        g[0] += 0.5 * to_radius;
      } else {
        const auto k = static_cast<std::size_t>(piece.sphere - middle);
        g[2 * k - 1] += to_centre;
        g[2 * k] += to_radius;
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
        up[i] += difference_step * b_;
        down[i] -= difference_step * b_;
      }
      const Vector g_up = gradient(up), g_down = gradient(down);
      for (std::size_t i = 0; i < size; ++i)
        columns[colour].push_back((g_up[i] - g_down[i]) / (2.0 * difference_step * b_));
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

  double a_, b_;
};

/// Solves (H + damping) x = -g by Cholesky; false when the matrix is not positive definite.
bool solve_band(std::vector<Vector> h, const Vector& g, double damping, Vector& x) {
  const std::size_t size = g.size();
  x.assign(size, 0.0);
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t first = i < reach ? 0 : i - reach;
    h[i][reach] += damping;
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
  const AreaBetween target(a, b);
  Vector unknowns = unknowns_of(minimax_outline_half_chain(a, b, n));
  double value = target.value(unknowns), damping = 0.0;
  Vector g = target.gradient(unknowns), step;
  std::vector<Vector> h = target.hessian(unknowns);
  for (int iteration = 0; iteration < iteration_limit; ++iteration) {
    bool accepted = false;
    if (solve_band(h, g, damping, step)) {
      Vector trial = unknowns;
      for (std::size_t i = 0; i < trial.size(); ++i)
        trial[i] += step[i];
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
      if (largest_magnitude(step) < step_tolerance * a)
        return half_chain_of(unknowns);
    }
    damping = accepted ? (damping < 1e-6 ? 0.0 : 0.2 * damping) : std::fmax(1e-3, 4.0 * damping);
    if (accepted)
      h = target.hessian(unknowns);
  }
  throw std::runtime_error(
      "multisphere template: spacing minimax_area did not converge for a = " + std::to_string(a) +
      ", b = " + std::to_string(b) + ", N = " + std::to_string(2 * n + 1) +
      ": use spacing paper or minimax_outline");
}

} // namespace ellipsoid
