// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "ellipsoid/elliptic_hertz.h"

#include "ellipsoid/contact_tolerances.h"

#include <cmath>

namespace ellipsoid {

namespace {

/// A contact ellipse with axis ratio k.
struct EllipseTrial {
  double log_k;
  double k;
  EllipticIntegrals integrals;
  double log_ratio; ///< ln(B/A)

  explicit EllipseTrial(double log_k_)
      : log_k(log_k_), k(std::exp(log_k_)), integrals(elliptic_integrals(k)) {
    // Johnson 1985, eq. 4.28: B/A = (E/k^2 - K) / (K - E) = (K - D) / (k^2 D)
    log_ratio = std::log((integrals.first - integrals.second) / (k * k * integrals.second));
  }
};

/// The ellipse that belongs to ln(B/A), by a secant search for ln k.
EllipseTrial find_ellipse(double log_ratio) {
  // Start: k = (A/B)^(2/3) (Johnson 1985, eq. 4.30) with a fitted correction of the exponent, good
  // to 0.1 % up to B/A = 10^4.
  const double square = log_ratio * log_ratio, denominator = 1.0 + 0.031 * square;
  const double correction = 1.0 + 0.0047 * square / denominator;
  const double growth = 0.0094 * square / (denominator * denominator); // log_ratio d(correction)
  EllipseTrial trial(-2.0 / 3.0 * log_ratio / correction);
  double slope = -1.5 * correction * correction / (correction - growth);
  for (int k = 0; k < tolerance::elliptic_limit; ++k) {
    const double error = trial.log_ratio - log_ratio;
    if (std::fabs(error) <= tolerance::elliptic_error)
      break;
    const EllipseTrial next(std::fmin(0.0, trial.log_k - error / slope));
    if (next.log_k != trial.log_k && next.log_ratio != trial.log_ratio)
      slope = (next.log_ratio - trial.log_ratio) / (next.log_k - trial.log_k);
    trial = next;
  }
  return trial;
}

} // namespace

EllipticIntegrals elliptic_integrals(double k) {
  // Arithmetic-geometric mean (Abramowitz and Stegun 1964, 17.6.3, 17.6.4): K = pi / (2 a),
  // (K - E) / K = sum 2^(n-1) c_n^2, c_0^2 = e^2. Here c_n^2 / e^2, which has no difference of
  // nearly equal numbers for k near 1.
  double arithmetic = 0.5 * (1.0 + k), geometric = std::sqrt(k);
  double c = 0.5 * (1.0 - k), power = 1.0;
  double scaled_square = 0.25 * (1.0 - k) / (1.0 + k); // c_1^2 / e^2
  double sum = 0.5 + scaled_square;
  while (std::fabs(c) > tolerance::elliptic_rounding * arithmetic) {
    const double c_next = 0.25 * c * c / (0.5 * (arithmetic + geometric));
    scaled_square *= (c_next / c) * (c_next / c);
    c = c_next;
    const double mean = 0.5 * (arithmetic + geometric);
    geometric = std::sqrt(arithmetic * geometric);
    arithmetic = mean;
    power *= 2.0;
    sum += power * scaled_square;
  }
  const double K = 0.5 * M_PI / arithmetic;
  return {K, K * sum};
}

EllipticContact elliptic_hertz(const RelativeCurvature& curvature) {
  const EllipseTrial ellipse = find_ellipse(std::log(curvature.larger / curvature.smaller));
  const double k = ellipse.k, K = ellipse.integrals.first, D = ellipse.integrals.second;
  EllipticContact contact;
  contact.axis_ratio = k;
  // Johnson 1985, eqs. 4.26: with p0 = E* h / (b K), the larger semi-axis has a^2 = h D / (A K),
  // and the force is 2/3 pi a b p0
  contact.area_per_overlap = M_PI * k * D / (curvature.smaller * K);
  contact.effective_radius = 0.25 * M_PI * M_PI * D / (curvature.smaller * K * K * K);
  return contact;
}

} // namespace ellipsoid
