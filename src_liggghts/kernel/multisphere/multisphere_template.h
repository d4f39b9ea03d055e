// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// An ellipsoid of revolution (semi-axes a > b = c, a along the body's x axis) approximated by
// N spheres with their centres on the x axis: Markauskas et al. 2010, section 2.
//
// Conventions:
//  - lengths in any consistent unit; nothing here has an absolute length scale;
//  - spheres are ordered from -x to +x, the middle one sits at 0, the chain is symmetric;
//  - "section" is the cut through the x axis: a union of discs, beside the ellipse;
//  - "outline" is the boundary of that union.
#pragma once

#include "multisphere/sphere_spacing.h"

#include <array>
#include <string>
#include <vector>

namespace ellipsoid {

/// More spheres than this are refused: far beyond any use, and a bound on the solver's time.
constexpr int largest_sphere_count = 999;

/// More slender bodies are refused: no chain of so few spheres can approximate them.
constexpr double largest_aspect_ratio = 100.0;
/// Rounder bodies are spheres: distances within the chain would be lost in rounding.
constexpr double smallest_aspect_ratio = 1.000001;

struct MultisphereTemplate {
  double a = 0.0; ///< semi-axis along x of the approximated ellipsoid (length)
  double b = 0.0; ///< the two other semi-axes (length)
  SphereSpacing spacing = SphereSpacing::paper;
  std::vector<double> centres; ///< abscissae, ascending (length), N values
  std::vector<double> radii;   ///< (length), N values

  int count() const { return static_cast<int>(centres.size()); }
};

/// The chain of N spheres.
/// N = 1: the centre sphere of radius b for every spacing. N = 3 with spacing `paper`: by the
/// equations where these spheres overlap (a < 2b), else as `paper_touching`. `paper_touching`: N =
/// 1 or 3, side spheres of radius (a - b)/2 that touch the centre sphere; allowed up to a = 3b,
/// where they are as large as the centre sphere. All other chains overlap, or are refused.
/// @param[in] a, b semi-axes (length), a > b > 0, a/b within the limits above
/// @param[in] count N, odd
/// @param[in] spacing not `medial` nor `minimax_volume`, which are no chains
/// @throws std::invalid_argument one line: what, value, allowed range, remedy (names the smallest
///         N that works for this aspect ratio when neighbouring spheres do not overlap)
MultisphereTemplate make_multisphere(double a, double b, int count,
                                     SphereSpacing spacing = SphereSpacing::paper);

/// Smallest N >= 3 whose neighbouring spheres overlap
/// (condition after eq. 6); 0 if there is none up to largest_sphere_count.
int smallest_overlapping_count(double aspect_ratio, SphereSpacing spacing = SphereSpacing::paper);

/// The visible part of one sphere: between two cutting planes across the x axis.
struct CutOffSphere {
  int sphere = 0;     ///< index into centres and radii
  double begin = 0.0; ///< abscissa of the left cutting plane, or of the sphere's left end (length)
  double end = 0.0;   ///< the same to the right (length)
  double from = 0.0;  ///< begin from the sphere's centre: exactly -R at a free end (length)
  double to = 0.0;    ///< end from the sphere's centre: exactly R at a free end (length)
};

/// The cut-off spheres from left to right. A sphere that is covered by others does not appear;
/// spheres that do not overlap leave a gap.
std::vector<CutOffSphere> cut_off_spheres(const MultisphereTemplate& chain);

/// Exact measures of the section's outline and of the body, beside those of the ellipse.
struct MultisphereMeasures {
  double area = 0.0;      ///< of the section, eq. (9) (length^2)
  double volume = 0.0;    ///< eq. (10) (length^3)
  double perimeter = 0.0; ///< of the section (length)

  double area_ratio = 0.0;      ///< to the ellipse (figure 5a)
  double volume_ratio = 0.0;    ///< to the ellipsoid
  double perimeter_ratio = 0.0; ///< to the ellipse (figure 5b)

  double area_shape_factor = 0.0;      ///< eq. (26)
  double perimeter_shape_factor = 0.0; ///< eq. (27)

  double area_between = 0.0;      ///< area in exactly one of section and ellipse (length^2)
  double volume_between = 0.0;    ///< volume in exactly one of body and ellipsoid (length^3)
  double outline_deviation = 0.0; ///< largest distance between outline and ellipse (length)
  double outline_mean = 0.0;      ///< mean distance over the outline, positive outside (length)
  double outline_rms = 0.0;       ///< root-mean-square of these distances (length)
  double outline_rq = 0.0;        ///< the same about their mean (length)
};

MultisphereMeasures measure(const MultisphereTemplate& chain);

/// pi a b (length^2), eq. (2).
double ellipse_area(double a, double b);
/// 4/3 pi a b^2 (length^3), eq. (2).
double ellipsoid_volume(double a, double b);
/// Perimeter of the ellipse (length), to rounding.
double ellipse_perimeter(double a, double b);

/// What a tolerance is about. All are relative and 0 for a perfect approximation:
/// area_between / ellipse area (equal to eq. 26 while no sphere sticks out), volume_between /
/// ellipsoid volume, eq. (27), and outline_deviation / b.
enum class ShapeMeasure { area, volume, perimeter, outline };

/// "area", "volume", "perimeter", "outline".
const char* word_of(ShapeMeasure what);

double relative_error(const MultisphereMeasures& measures, const MultisphereTemplate& chain,
                      ShapeMeasure what);

/// Smallest N with relative_error <= tolerance, admissible for this aspect ratio.
/// @throws std::invalid_argument bad aspect ratio or tolerance, or none up to largest_sphere_count
int sphere_count_for(double aspect_ratio, ShapeMeasure what, double tolerance,
                     SphereSpacing spacing = SphereSpacing::paper);

/// One line of the comparison of spacings: the N each of them needs.
struct SpacingComparison {
  double aspect_ratio = 0.0;
  ShapeMeasure what = ShapeMeasure::area;
  int paper = 0, minimax_outline = 0, minimax_area = 0;
};

/// N needed for `tolerance` of area, volume and outline at each aspect ratio (three rows for each).
std::vector<SpacingComparison> compare_spacings(const std::vector<double>& aspect_ratios,
                                                double tolerance);

} // namespace ellipsoid
