// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "height_map.h"

#include <optional>
#include <vector>

namespace ellipsoid::post {

enum class BedShape { box, cylinder };

/// The part of space in which a bed's porosity is taken; z points up.
struct BedRegion {
  BedShape shape = BedShape::box;
  double x0 = 0.0, x1 = 0.0, y0 = 0.0, y1 = 0.0;  ///< box (length)
  double axis_x = 0.0, axis_y = 0.0, radius = 0.; ///< cylinder (length)
  double z0 = 0.0, z1 = 0.0;                      ///< (length)
};

struct BedPorosity {
  double porosity = 0.0;
  double error = 0.0;        ///< estimate of the error of the integration over z
  double total_volume = 0.0; ///< (length^3)
  double solid_volume = 0.0; ///< (length^3)
};

/// A slice of a profile: a layer between heights, or a ring between radii.
struct BedSlice {
  double begin = 0.0, end = 0.0; ///< (length)
  double porosity = 0.0;
};

/// The free surface of a bed, cut at which the region ends; none: the region is whole.
using BedSurface = std::optional<HeightMap>;

/// Porosity in a region: the exact area of the union of sections (each point counted once) in
/// planes of constant z, integrated over z by the midpoint rule in `planes` planes (rounded up to a
/// multiple of 4). The error estimate is the change when only planes 0, 3, 4, 7, 8 ... are used.
/// A cylinder's section is a regular polygon of 360 corners with the circle's area. Below a surface
/// the region's volume is summed over the surface's columns (shares of columns at the region's
/// edge: exact for a box, in 16 parts for a cylinder).
BedPorosity bed_porosity(const ParticleSet& upright, const BedRegion& region, int planes,
                         const BedSurface& surface = {});

/// Porosity of `slices` layers of equal thickness (without those that lie above the surface).
std::vector<BedSlice> height_profile(const ParticleSet& upright, const BedRegion& region,
                                     int slices, int planes, const BedSurface& surface = {});

/// Porosity of `slices` rings of equal width about a cylinder's axis (with the same exception).
std::vector<BedSlice> radial_profile(const ParticleSet& upright, const BedRegion& region,
                                     int slices, int planes, const BedSurface& surface = {});

/// The particles, and in a box that repeats their images, that reach into a region: to be handed to
/// the functions above and to the free surface.
ParticleSet particles_in(const ParticleSet& upright, const BedRegion& region);

/// Volume of the union of all particles above a floor, by the same rule over their whole height
/// (length^3).
double solid_volume(const ParticleSet& upright, const std::vector<std::size_t>& members, int planes,
                    double floor);

} // namespace ellipsoid::post
