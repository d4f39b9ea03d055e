// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "bed.h"

#include "contacts.h"
#include "images.h"
#include "porosity_value.h"
#include "union_area.h"

#include <algorithm>
#include <cmath>

namespace ellipsoid::post {
namespace {

ConvexPolygon section_of(const BedRegion& region) {
  if (region.shape == BedShape::box)
    return {{region.x0, region.y0},
            {region.x1, region.y0},
            {region.x1, region.y1},
            {region.x0, region.y1}};
  constexpr int corners = 360;
  constexpr double step = 2.0 * M_PI / corners;
  // a regular polygon with circumradius R has the area n/2 R^2 sin(2 pi / n)
  const double circumradius = region.radius * std::sqrt(step / std::sin(step));
  ConvexPolygon polygon;
  for (int k = 0; k < corners; ++k)
    polygon.emplace_back(region.axis_x + circumradius * std::cos(k * step),
                         region.axis_y + circumradius * std::sin(k * step));
  return polygon;
}

void check(const BedRegion& region) {
  const bool has_section = region.shape == BedShape::box
                               ? region.x1 > region.x0 && region.y1 > region.y0
                               : region.radius > 0.0;
  if (!has_section || !(region.z1 > region.z0))
    throw InputError("the region is empty: lower bounds must lie below upper ones, the radius "
                     "must be > 0");
}

/// Share of a square column about (x, y) in the region's section.
double share_of_column(const BedRegion& region, double x, double y, double width) {
  if (region.shape == BedShape::box) {
    const auto common = [width](double low, double high, double middle) {
      return std::max(0.0,
                      std::min(high, middle + 0.5 * width) - std::max(low, middle - 0.5 * width));
    };
    return common(region.x0, region.x1, x) * common(region.y0, region.y1, y) / (width * width);
  }
  constexpr int parts = 4;
  int inside = 0;
  for (int k = 0; k < parts * parts; ++k) {
    const double dx = x + ((k % parts + 0.5) / parts - 0.5) * width - region.axis_x;
    const double dy = y + ((k / parts + 0.5) / parts - 0.5) * width - region.axis_y;
    inside += dx * dx + dy * dy <= region.radius * region.radius ? 1 : 0;
  }
  return static_cast<double>(inside) / (parts * parts);
}

/// Volume of the region below the free surface.
double volume_below(const HeightMap& surface, const BedRegion& region) {
  double sum = 0.0;
  for (std::size_t j = 0; j < surface.columns_y(); ++j)
    for (std::size_t i = 0; i < surface.columns_x(); ++i)
      sum += share_of_column(region, surface.x(i), surface.y(j), surface.width()) *
             std::clamp(surface.height(i, j) - region.z0, 0.0, region.z1 - region.z0);
  return sum * surface.width() * surface.width();
}

/// Areas of the union in planes in the middles of equal layers.
std::vector<double> section_areas(const ParticleSet& set, const std::vector<std::size_t>& members,
                                  const ConvexPolygon* section, double z0, double z1, int planes) {
  std::vector<double> areas, reaches;
  for (const std::size_t i : members)
    reaches.push_back(bounding_radius(set, set.particles[i]));
  std::vector<std::size_t> near;
  for (int k = 0; k < planes; ++k) {
    const double z = z0 + (k + 0.5) * (z1 - z0) / planes;
    near.clear();
    for (std::size_t m = 0; m < members.size(); ++m)
      if (std::abs(set.particles[members[m]].centre.z - z) <= reaches[m])
        near.push_back(members[m]);
    const auto shapes = outlines(set, near, z, OutlineKind::true_shape);
    areas.push_back(
        union_in_region(shapes, section ? *section : surrounding_rectangle(shapes)).area);
  }
  return areas;
}

double sum_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values)
    sum += value;
  return sum;
}

/// The share by which the midpoint sum changes when only planes 0, 3, 4, 7, 8 ... of it are used.
double coarser_difference(const std::vector<double>& areas) {
  double coarse = 0.0;
  for (std::size_t k = 0; k < areas.size(); ++k)
    if (k % 4 == 0 || k % 4 == 3)
      coarse += 2.0 * areas[k];
  const double fine = sum_of(areas);
  return fine > 0.0 ? std::abs(coarse - fine) / fine : 0.0;
}

} // namespace

BedPorosity bed_porosity(const ParticleSet& upright, const BedRegion& region, int planes,
                         const BedSurface& surface) {
  check(region);
  const ConvexPolygon section = section_of(region);
  const int used = 4 * ((planes + 3) / 4);
  const auto areas =
      section_areas(upright, all_members(upright), &section, region.z0, region.z1, used);
  BedPorosity result;
  result.total_volume =
      surface ? volume_below(*surface, region) : polygon_area(section) * (region.z1 - region.z0);
  if (!(result.total_volume > 0.0))
    return result; // wholly above the free surface
  result.solid_volume = sum_of(areas) * (region.z1 - region.z0) / used;
  result.porosity = porosity_of(result.solid_volume, result.total_volume);
  result.error = coarser_difference(areas) * result.solid_volume / result.total_volume;
  return result;
}

std::vector<BedSlice> height_profile(const ParticleSet& upright, const BedRegion& region,
                                     int slices, int planes, const BedSurface& surface) {
  std::vector<BedSlice> profile;
  for (int k = 0; k < slices; ++k) {
    BedRegion layer = region;
    layer.z0 = region.z0 + k * (region.z1 - region.z0) / slices;
    layer.z1 = region.z0 + (k + 1) * (region.z1 - region.z0) / slices;
    const BedPorosity p = bed_porosity(upright, layer, std::max(4, planes / slices), surface);
    if (p.total_volume > 0.0)
      profile.push_back({layer.z0, layer.z1, p.porosity});
  }
  return profile;
}

std::vector<BedSlice> radial_profile(const ParticleSet& upright, const BedRegion& region,
                                     int slices, int planes, const BedSurface& surface) {
  std::vector<BedSlice> profile;
  double inner_total = 0.0, inner_solid = 0.0;
  for (int k = 0; k < slices; ++k) {
    BedRegion disc = region;
    disc.radius = (k + 1) * region.radius / slices;
    const BedPorosity p = bed_porosity(upright, disc, planes, surface);
    if (p.total_volume > inner_total)
      profile.push_back({k * region.radius / slices, disc.radius,
                         porosity_of(p.solid_volume - inner_solid, p.total_volume - inner_total)});
    inner_total = p.total_volume;
    inner_solid = p.solid_volume;
  }
  return profile;
}

double solid_volume(const ParticleSet& upright, const std::vector<std::size_t>& members, int planes,
                    double floor) {
  double low = 1e300, high = floor;
  for (const std::size_t i : members) {
    const Particle& p = upright.particles[i];
    const double reach = bounding_radius(upright, p);
    low = std::min(low, p.centre.z - reach);
    high = std::max(high, p.centre.z + reach);
  }
  low = std::max(low, floor);
  if (!(high > low))
    return 0.0;
  const auto areas = section_areas(upright, members, nullptr, low, high, planes);
  return sum_of(areas) * (high - low) / planes;
}

ParticleSet particles_in(const ParticleSet& upright, const BedRegion& region) {
  const bool is_box = region.shape == BedShape::box;
  const double r = region.radius;
  return with_images(
      upright,
      {is_box ? region.x0 : region.axis_x - r, is_box ? region.y0 : region.axis_y - r, region.z0},
      {is_box ? region.x1 : region.axis_x + r, is_box ? region.y1 : region.axis_y + r, region.z1});
}

} // namespace ellipsoid::post
