// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "averages/coarse_graining_function.h"

#include <algorithm>
#include <cmath>

namespace ellipsoid {
namespace {

const double root_half_pi = std::sqrt(0.5 * M_PI), root_half = std::sqrt(0.5);

double reach_of(CoarseGrainingShape shape, double width) {
  switch (shape) {
  case CoarseGrainingShape::gaussian:
    return 3.0 * width;
  case CoarseGrainingShape::lucy:
  case CoarseGrainingShape::wendland:
    return 2.0 * width;
  case CoarseGrainingShape::heaviside:
    return width;
  }
  return width;
}

std::array<double, 6> coefficients_of(CoarseGrainingShape shape) {
  switch (shape) {
  case CoarseGrainingShape::lucy:
    return {1.0, 0.0, -6.0, 8.0, -3.0, 0.0};
  case CoarseGrainingShape::wendland:
    return {1.0, 0.0, -10.0, 20.0, -15.0, 4.0};
  case CoarseGrainingShape::gaussian:
  case CoarseGrainingShape::heaviside:
    break;
  }
  return {1.0, 0.0, 0.0, 0.0, 0.0, 0.0};
}

/// phi(0) of a Gaussian, so that the integral over space is 1 (1/length^3).
double gaussian_factor(double width, double reach) {
  const double cutoff = reach / width; // the share of the uncut Gaussian inside it:
  const double share =
      std::erf(root_half * cutoff) - cutoff / root_half_pi * std::exp(-0.5 * cutoff * cutoff);
  return 1.0 / (std::pow(2.0 * M_PI, 1.5) * width * width * width * share);
}

} // namespace

CoarseGrainingFunction::CoarseGrainingFunction(CoarseGrainingShape shape, double width)
    : CoarseGrainingFunction(shape, width, reach_of(shape, width)) {}

CoarseGrainingFunction CoarseGrainingFunction::cut_gaussian(double width, double reach) {
  return {CoarseGrainingShape::gaussian, width, reach};
}

CoarseGrainingFunction::CoarseGrainingFunction(CoarseGrainingShape shape, double width,
                                               double reach)
    : shape_(shape), coefficients_(coefficients_of(shape)), width_(width), reach_(reach),
      factor_(1.0) {
  factor_ = shape == CoarseGrainingShape::gaussian ? gaussian_factor(width, reach)
                                                   : 1.0 / between_planes(-reach, reach);
}

double CoarseGrainingFunction::value(double distance_squared) const {
  if (distance_squared > reach_ * reach_)
    return 0.0;
  if (shape_ == CoarseGrainingShape::gaussian)
    return factor_ * std::exp(-0.5 * distance_squared / (width_ * width_));
  const double q = std::sqrt(distance_squared) / reach_;
  double sum = 0.0;
  for (std::size_t n = coefficients_.size(); n-- > 0;)
    sum = sum * q + coefficients_[n];
  return factor_ * sum;
}

double CoarseGrainingFunction::slope_over_distance(double distance_squared) const {
  if (distance_squared > reach_ * reach_)
    return 0.0;
  if (shape_ == CoarseGrainingShape::gaussian)
    return -value(distance_squared) / (width_ * width_);
  const double q = std::sqrt(distance_squared) / reach_;
  double sum = 0.0;
  for (std::size_t n = coefficients_.size(); n-- > 2;) // the coefficient of q is 0
    sum = sum * q + static_cast<double>(n) * coefficients_[n];
  return factor_ * sum / (reach_ * reach_);
}

double CoarseGrainingFunction::along_line(double distance_squared, double begin, double end) const {
  const double half = reach_ * reach_ - distance_squared;
  if (!(half > 0.0))
    return 0.0;
  const double limit = std::sqrt(half);
  begin = std::clamp(begin, -limit, limit);
  end = std::clamp(end, -limit, limit);
  return begin < end
             ? line_from_foot(distance_squared, end) - line_from_foot(distance_squared, begin)
             : 0.0;
}

/// Odd in `end`.
double CoarseGrainingFunction::line_from_foot(double distance_squared, double end) const {
  if (shape_ == CoarseGrainingShape::gaussian)
    return factor_ * std::exp(-0.5 * distance_squared / (width_ * width_)) * root_half_pi * width_ *
           std::erf(root_half * end / width_);
  return factor_ * polynomial_from_foot(distance_squared / (reach_ * reach_), end / reach_) *
         reach_;
}

/// Lengths over the reach. The integrals of r^n follow from those of r^(n-2).
double CoarseGrainingFunction::polynomial_from_foot(double distance_squared, double end) const {
  const double d2 = distance_squared, t = end, r = std::sqrt(d2 + t * t);
  const double logarithm = d2 > 0.0 ? d2 * std::asinh(t / std::sqrt(d2)) : 0.0;
  std::array<double, 6> integral{t, 0.5 * (t * r + logarithm)};
  double sum = coefficients_[0] * integral[0], power = r;
  for (std::size_t n = 2; n < integral.size(); ++n) {
    power *= r;
    integral[n] =
        (t * power + static_cast<double>(n) * d2 * integral[n - 2]) / static_cast<double>(n + 1);
    sum += coefficients_[n] * integral[n];
  }
  return sum;
}

double CoarseGrainingFunction::over_plane(double distance) const {
  const double z2 = distance * distance, c2 = reach_ * reach_;
  if (z2 > c2)
    return 0.0;
  if (shape_ == CoarseGrainingShape::gaussian) {
    const double w2 = width_ * width_;
    return 2.0 * M_PI * w2 * factor_ * (std::exp(-0.5 * z2 / w2) - std::exp(-0.5 * c2 / w2));
  }
  const double q = std::abs(distance) / reach_;
  double sum = 0.0, power = q * q;
  for (std::size_t n = 0; n < coefficients_.size(); ++n, power *= q)
    sum += coefficients_[n] * (1.0 - power) / static_cast<double>(n + 2);
  return 2.0 * M_PI * c2 * factor_ * sum;
}

double CoarseGrainingFunction::between_planes(double begin, double end) const {
  return plane_from_centre(std::clamp(end, -reach_, reach_)) -
         plane_from_centre(std::clamp(begin, -reach_, reach_));
}

/// Odd in `abscissa`.
double CoarseGrainingFunction::plane_from_centre(double abscissa) const {
  const double z = abscissa, c2 = reach_ * reach_;
  if (shape_ == CoarseGrainingShape::gaussian) {
    const double w2 = width_ * width_;
    return 2.0 * M_PI * w2 * factor_ *
           (width_ * root_half_pi * std::erf(root_half * z / width_) -
            z * std::exp(-0.5 * c2 / w2));
  }
  const double q = z / reach_;
  double sum = 0.0, power = q * q;
  for (std::size_t n = 0; n < coefficients_.size(); ++n, power *= std::abs(q))
    sum += coefficients_[n] * q * (1.0 - power / static_cast<double>(n + 3)) /
           static_cast<double>(n + 2);
  return 2.0 * M_PI * c2 * reach_ * factor_ * sum;
}

} // namespace ellipsoid
