// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "pile.h"

#include <vector>

namespace ellipsoid::post {

/// A straight line y = intercept + slope x by least squares.
struct LineFit {
  double slope = 0.0, intercept = 0.0; ///< (1), (length)
  double residual = 0.0;               ///< root of the mean squared residual (length)
  double slope_error = 0.0;            ///< standard error of the slope for independent samples
};

/// Least squares through points; at least two different abscissas are needed.
LineFit fit_line(const std::vector<Point>& points);

/// One flank of a pile (paper, section 4.2.1 and figure 9b).
struct ReposeAngle {
  double angle_deg = 0.0;          ///< of the fitted line to the floor, positive downhill
  double standard_error_deg = 0.0; ///< see repose_angle
  double residual = 0.0;           ///< rms distance in y of the surface from the line (length)
  double residual_in_b = 0.0;      ///< the same over the mean smallest semi-axis
  Point a{0.0, 0.0}, b{0.0, 0.0};  ///< ends of the segment A-B on the line
  LineFit line;
  std::size_t columns = 0;
};

enum class Flank { right, left };

/// Angle of repose of one flank: least squares line through the free surface between A and B.
///
/// h(x) is the mean of y_max over x +- a (a: mean largest semi-axis), H its largest value over the
/// floor, at x_H. A is the first column from x_H downhill with h < (1 - cut_top) H, B the last one
/// before h falls below cut_bottom H for the first time: what lies beyond (a layer on the floor,
/// heaps of rolled-off particles) is not used. The line is fitted to y_max(x) itself in
/// equidistant columns from A to B. Columns on one particle are not independent: the standard
/// error counts as many as particle lengths 2a fit in the segment.
/// Throws InputError when the segment has less than 3 columns.
ReposeAngle repose_angle(const Pile& pile, const PileOptions& options, Flank flank);

} // namespace ellipsoid::post
