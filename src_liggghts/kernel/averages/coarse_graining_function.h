// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Coarse-graining functions phi(|r|) with integral 1 over space, which turn discrete particles into
// continuous fields (Goldhirsch 2010): their values and slopes, integrals along lines, and
// integrals over planes.
#pragma once

#include <array>

namespace ellipsoid {

enum class CoarseGrainingShape {
  gaussian, ///< ~ exp(-r^2 / 2 w^2), cut off at 3 w
  lucy,     ///< ~ 1 - 6 q^2 + 8 q^3 - 3 q^4, q = r / 2w, cut off at 2 w (Lucy 1977)
  wendland, ///< ~ (1 - q)^4 (1 + 4 q), q = r / 2w, cut off at 2 w (Wendland 1995)
  heaviside ///< constant in a ball of radius w
};

class CoarseGrainingFunction {
 public:
  /// @param[in] width w (length), > 0
  CoarseGrainingFunction(CoarseGrainingShape shape, double width);
  /// @param[in] width w (length), > 0; @param[in] reach where it is cut off (length), > 0
  static CoarseGrainingFunction cut_gaussian(double width, double reach);

  double width() const { return width_; }
  double reach() const { return reach_; } ///< phi is 0 beyond (length)

  /// phi at a squared distance (1/length^3).
  double value(double distance_squared) const;
  /// Derivative of phi with respect to the distance, over the distance, at a squared distance
  /// (1/length^5); 0 for `heaviside`, and the edge of a cut Gaussian is left out.
  double slope_over_distance(double distance_squared) const;
  /// Integral of phi over the part of a line from `begin` to `end` (>= begin), measured from the
  /// point of the line that is nearest to the centre; its squared distance is given (1/length^2).
  double along_line(double distance_squared, double begin, double end) const;
  /// Integral of phi over the plane at this distance (1/length).
  double over_plane(double distance) const;
  /// Integral of over_plane() between two abscissae (1), any order: signed.
  double between_planes(double begin, double end) const;

 private:
  /// Of phi / phi(0) as a polynomial in r / reach, by ascending powers.
  using Coefficients = std::array<double, 6>;

  double line_from_foot(double distance_squared, double end) const;
  double polynomial_from_foot(double distance_squared, double end) const;
  double plane_from_centre(double abscissa) const;

  CoarseGrainingFunction(CoarseGrainingShape shape, double width, double reach);

  CoarseGrainingShape shape_;
  Coefficients coefficients_; // not used by the Gaussian
  double width_, reach_, factor_;
};

} // namespace ellipsoid
