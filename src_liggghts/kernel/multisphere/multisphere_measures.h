// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The outline of a chain of spheres cut at its crossings with the ellipse: shared by the measures
// and by the placing that minimises the area between the two.
#pragma once

#include "multisphere/multisphere_template.h"

namespace ellipsoid {

/// Part of a sphere's arc on one side of the ellipse; abscissae from the sphere's centre.
struct OutlinePiece {
  int sphere = 0;
  double begin = 0.0, end = 0.0; ///< (length)
  double sign = 0.0;             ///< +1 outside the ellipse, -1 inside
};

std::vector<OutlinePiece> outline_pieces(const MultisphereTemplate& chain,
                                         const std::vector<CutOffSphere>& parts);

/// Distance of the point (x, y) from the ellipse's curve (length).
double distance_from_ellipse(double a, double b, double x, double y);

/// Distances of the outline from the ellipse, positive outside, over the outline's length (length).
struct OutlineRoughness {
  double mean = 0.0;
  double about_ellipse = 0.0; ///< root-mean-square
  double about_mean = 0.0;    ///< root-mean-square of what the mean leaves: Rq of ISO 4287
};

/// By Simpson's rule over each arc on one side of the ellipse.
OutlineRoughness outline_roughness(const MultisphereTemplate& chain,
                                   const std::vector<CutOffSphere>& parts);

/// Angle of the arc from the sphere's crest to the abscissa u from its centre, |u| <= radius (rad);
/// unlike asin(u / radius) accurate near the ends.
double arc_angle(double radius, double u);

/// Area in exactly one of section and ellipse (length^2).
double area_between(const MultisphereTemplate& chain, const std::vector<CutOffSphere>& parts);

/// Volume in exactly one of body and ellipsoid (length^3).
double volume_between(const MultisphereTemplate& chain, const std::vector<CutOffSphere>& parts);

} // namespace ellipsoid
