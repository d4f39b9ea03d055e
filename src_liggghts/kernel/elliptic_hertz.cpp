// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "elliptic_hertz.h"

#include "contact_tolerances.h"

#include <cmath>

namespace ellipsoid {

namespace {

/// ln(B/A) of a contact ellipse with axis ratio k: Johnson 1985, eq. 4.28,
/// B/A = (E/k^2 - K) / (K - E) = (K - D) / (k^2 D).
double log_curvature_ratio(double k, const EllipticIntegrals& integrals) {
  const double K = integrals.first, D = integrals.second;
  return std::log((K - D) / (k * k * D));
}

/// The axis ratio k that belongs to B/A: a secant search for ln k, on which ln(B/A) depends almost
/// linearly, from the approximation k = (A/B)^(2/3) (Johnson 1985, eq. 4.30).
double contact_axis_ratio(double log_ratio) {
  constexpr double first_slope = -1.5;
  double x = log_ratio / first_slope, slope = first_slope;
  double error = log_curvature_ratio(std::exp(x), elliptic_integrals(std::exp(x))) - log_ratio;
  for (int k = 0; k < tolerance::elliptic_limit && std::fabs(error) > tolerance::elliptic_error;
       ++k) {
    const double step = -error / slope;
    const double x_new = std::fmin(0.0, x + step), k_new = std::exp(x_new);
    const double error_new = log_curvature_ratio(k_new, elliptic_integrals(k_new)) - log_ratio;
    if (x_new != x && error_new != error)
      slope = (error_new - error) / (x_new - x);
    x = x_new;
    error = error_new;
  }
  return std::exp(x);
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
  const double k = contact_axis_ratio(std::log(curvature.larger / curvature.smaller));
  const EllipticIntegrals integrals = elliptic_integrals(k);
  const double K = integrals.first, D = integrals.second;
  EllipticContact contact;
  contact.axis_ratio = k;
  // Johnson 1985, eqs. 4.26: with p0 = E* h / (b K), the larger semi-axis has a^2 = h D / (A K),
  // and the force is 2/3 pi a b p0
  contact.area_per_overlap = M_PI * k * D / (curvature.smaller * K);
  contact.effective_radius = 0.25 * M_PI * M_PI * D / (curvature.smaller * K * K * K);
  return contact;
}

} // namespace ellipsoid
