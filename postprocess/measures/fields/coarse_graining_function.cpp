// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "coarse_graining_function.h"

#include <algorithm>
#include <cmath>

namespace ellipsoid::post {
namespace {

const double root_half_pi = std::sqrt(0.5 * M_PI), root_half = std::sqrt(0.5);

double reach_of(CoarseGrainingShape shape, double width) {
  return shape == CoarseGrainingShape::gaussian ? 3.0 * width
         : shape == CoarseGrainingShape::lucy   ? 2.0 * width
                                                : width;
}

/// phi(0), so that the integral over space is 1 (1/length^3).
double factor_of(CoarseGrainingShape shape, double width, double reach) {
  const double cube = width * width * width, cutoff = reach / width;
  switch (shape) {
  case CoarseGrainingShape::gaussian: { // share of the uncut Gaussian inside the cut-off
    const double share =
        std::erf(root_half * cutoff) - cutoff / root_half_pi * std::exp(-0.5 * cutoff * cutoff);
    return 1.0 / (std::pow(2.0 * M_PI, 1.5) * cube * share);
  }
  case CoarseGrainingShape::lucy:
    return 105.0 / (16.0 * M_PI * reach * reach * reach);
  case CoarseGrainingShape::heaviside:
    return 3.0 / (4.0 * M_PI * cube);
  }
  return 0.0;
}

} // namespace

CoarseGrainingFunction::CoarseGrainingFunction(CoarseGrainingShape shape, double width)
    : shape_(shape), width_(width), reach_(reach_of(shape, width)),
      factor_(factor_of(shape, width, reach_)) {}

double CoarseGrainingFunction::value(double distance_squared) const {
  if (distance_squared > reach_ * reach_)
    return 0.0;
  switch (shape_) {
  case CoarseGrainingShape::gaussian:
    return factor_ * std::exp(-0.5 * distance_squared / (width_ * width_));
  case CoarseGrainingShape::lucy: {
    const double q = std::sqrt(distance_squared) / reach_;
    return factor_ * (1.0 + q * q * (-6.0 + q * (8.0 - 3.0 * q)));
  }
  case CoarseGrainingShape::heaviside:
    return factor_;
  }
  return 0.0;
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
  const double d2 = distance_squared, t = end;
  switch (shape_) {
  case CoarseGrainingShape::gaussian:
    return factor_ * std::exp(-0.5 * d2 / (width_ * width_)) * root_half_pi * width_ *
           std::erf(root_half * t / width_);
  case CoarseGrainingShape::lucy: {
    const double c2 = reach_ * reach_, t2 = t * t, r = std::sqrt(d2 + t2), d = std::sqrt(d2);
    const double square = t * (d2 + t2 / 3.0);
    const double fourth = t * (d2 * d2 + t2 * (2.0 / 3.0 * d2 + 0.2 * t2));
    const double logarithm = d2 > 0.0 ? 0.375 * d2 * d2 * std::asinh(t / d) : 0.0;
    const double cube = 0.125 * t * r * (2.0 * t2 + 5.0 * d2) + logarithm;
    return factor_ *
           (t - 6.0 * square / c2 + 8.0 * cube / (c2 * reach_) - 3.0 * fourth / (c2 * c2));
  }
  case CoarseGrainingShape::heaviside:
    return factor_ * t;
  }
  return 0.0;
}

double CoarseGrainingFunction::over_plane(double distance) const {
  const double z2 = distance * distance, c2 = reach_ * reach_;
  if (z2 > c2)
    return 0.0;
  switch (shape_) {
  case CoarseGrainingShape::gaussian: {
    const double w2 = width_ * width_;
    return 2.0 * M_PI * w2 * factor_ * (std::exp(-0.5 * z2 / w2) - std::exp(-0.5 * c2 / w2));
  }
  case CoarseGrainingShape::lucy: {
    const double q = std::abs(distance) / reach_, q2 = q * q;
    const double inside = q2 * (0.5 + q2 * (-1.5 + q * (1.6 - 0.5 * q)));
    return 2.0 * M_PI * c2 * factor_ * (0.1 - inside);
  }
  case CoarseGrainingShape::heaviside:
    return M_PI * (c2 - z2) * factor_;
  }
  return 0.0;
}

double CoarseGrainingFunction::between_planes(double begin, double end) const {
  return plane_from_centre(std::clamp(end, -reach_, reach_)) -
         plane_from_centre(std::clamp(begin, -reach_, reach_));
}

/// Odd in `abscissa`.
double CoarseGrainingFunction::plane_from_centre(double abscissa) const {
  const double z = abscissa, c2 = reach_ * reach_;
  switch (shape_) {
  case CoarseGrainingShape::gaussian: {
    const double w2 = width_ * width_;
    return 2.0 * M_PI * w2 * factor_ *
           (width_ * root_half_pi * std::erf(root_half * z / width_) -
            z * std::exp(-0.5 * c2 / w2));
  }
  case CoarseGrainingShape::lucy: {
    const double q = z / reach_, q2 = q * q;
    const double inside =
        q * q2 * (1.0 / 6.0 + q2 * (-0.3 + std::abs(q) * (4.0 / 15.0 - std::abs(q) / 14.0)));
    return 2.0 * M_PI * c2 * reach_ * factor_ * (0.1 * q - inside);
  }
  case CoarseGrainingShape::heaviside:
    return M_PI * (c2 * z - z * z * z / 3.0) * factor_;
  }
  return 0.0;
}

} // namespace ellipsoid::post
