// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Measures of a chain of spheres: exact integrals over the cut-off spheres.
#include "multisphere/multisphere_measures.h"

#include "multisphere/multisphere_spacing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ellipsoid {
namespace {

constexpr double pi = 3.14159265358979323846;

/// Antiderivative of the disc's section width over u, the abscissa from its centre.
double disc_area_to(double radius, double u) {
  const double v = std::clamp(u, -radius, radius);
  return v * std::sqrt((radius - v) * (radius + v)) + radius * radius * arc_angle(radius, v);
}

double sphere_volume_to(double radius, double u) {
  const double v = std::clamp(u, -radius, radius);
  return pi * v * (radius * radius - v * v / 3.0);
}

/// Area of the ellipse to the left of x, less a constant (affine image of a disc of radius a).
double ellipse_area_to(double a, double b, double x) { return b / a * disc_area_to(a, x); }

double ellipsoid_volume_to(double a, double b, double x) {
  return (b / a) * (b / a) * sphere_volume_to(a, x);
}

double outline_deviation(const MultisphereTemplate& chain, const std::vector<CutOffSphere>& parts) {
  const double a = chain.a, b = chain.b, focal_squared = (a - b) * (a + b);
  // A tip that falls short: the vertex is the ellipse's farthest point from the outline.
  double largest = std::fmax(std::fabs(a - parts.back().end), std::fabs(a + parts.front().begin));
  for (const CutOffSphere& part : parts) {
    const auto k = static_cast<std::size_t>(part.sphere);
    const double centre = chain.centres[k], radius = chain.radii[k];
    for (const double u : {part.from, part.to}) {                   // notches
      const double height = std::sqrt((radius - u) * (radius + u)); // of a notch
      largest = std::fmax(largest, distance_from_ellipse(a, b, centre + u, height));
    }
    if (a * std::fabs(centre) >= focal_squared)
      continue;
    // Along an arc the distance is stationary only where the ellipse's normal passes the centre.
    const double inscribed = inscribed_radius(a, b, centre);
    const double foot = centre * a * a / focal_squared; // Markauskas et al. 2010, eq. 3
    const double crest = centre + radius * (foot - centre) / inscribed;
    if (crest > part.begin && crest < part.end)
      largest = std::fmax(largest, std::fabs(radius - inscribed));
  }
  return largest;
}

/// Integral of the absolute difference between chain and ellipse, from the antiderivatives of the
/// sphere's and of the ellipse's share.
template <class SphereTo, class EllipseTo>
double between(const MultisphereTemplate& chain, const std::vector<CutOffSphere>& parts,
               const SphereTo& sphere_to, const EllipseTo& ellipse_to) {
  const auto ellipse = [&](double from, double to) {
    return ellipse_to(chain.a, chain.b, to) - ellipse_to(chain.a, chain.b, from);
  };
  double sum = ellipse(-chain.a, chain.a);
  for (const CutOffSphere& part : parts)
    sum -= ellipse(part.begin, part.end);
  for (const OutlinePiece& piece : outline_pieces(chain, parts)) {
    const auto k = static_cast<std::size_t>(piece.sphere);
    const double c = chain.centres[k], r = chain.radii[k];
    sum += piece.sign * (sphere_to(r, piece.end) - sphere_to(r, piece.begin) -
                         ellipse(c + piece.begin, c + piece.end));
  }
  return sum;
}

} // namespace

double distance_from_ellipse(double a, double b, double px, double py) {
  const double x = std::fabs(px), y = std::fabs(py);
  if (y == 0.0)
    return std::fabs(inscribed_radius(a, b, x));
  // Foot (a^2 x/(t + a^2 - b^2), b^2 y/t); its ellipse equation falls monotonically with t.
  const double focal_squared = (a - b) * (a + b);
  const auto equation = [&](double t) {
    const double u = a * x / (t + focal_squared), v = b * y / t;
    return u * u + v * v - 1.0;
  };
  const double t = bisect(equation, b * y, std::hypot(a * x, b * y));
  const double foot_y = b * b * y / t;
  const double foot_x = a * a * x / (t + focal_squared);
  return std::hypot(x - foot_x, y - foot_y);
}

double arc_angle(double radius, double u) {
  return std::atan2(u, std::sqrt((radius - u) * (radius + u)));
}

std::vector<CutOffSphere> cut_off_spheres(const MultisphereTemplate& chain) {
  // Squared heights R^2 - (x - c)^2 differ by linear functions of x: the visible spheres are the
  // upper envelope of lines, built from left to right on a stack.
  const auto plane = [&chain](std::size_t l, std::size_t r) {
    return cutting_plane(chain.centres[l], chain.radii[l], chain.centres[r], chain.radii[r]);
  };
  struct Entry {
    std::size_t sphere;
    double left_plane;
  };
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<Entry> stack;
  for (std::size_t k = 0; k < chain.centres.size(); ++k) {
    double left_plane = -infinity;
    while (!stack.empty()) {
      left_plane = plane(stack.back().sphere, k);
      if (left_plane > stack.back().left_plane)
        break;
      stack.pop_back();
      left_plane = -infinity;
    }
    stack.push_back({k, left_plane});
  }
  std::vector<CutOffSphere> visible;
  for (std::size_t i = 0; i < stack.size(); ++i) {
    const std::size_t k = stack[i].sphere;
    const double centre = chain.centres[k], radius = chain.radii[k];
    const double right_plane = i + 1 < stack.size() ? stack[i + 1].left_plane : infinity;
    const double from = std::fmax(-radius, stack[i].left_plane - centre);
    const double to = std::fmin(radius, right_plane - centre);
    if (from < to)
      visible.push_back({static_cast<int>(k), centre + from, centre + to, from, to});
  }
  return visible;
}

std::vector<OutlinePiece> outline_pieces(const MultisphereTemplate& chain,
                                         const std::vector<CutOffSphere>& parts) {
  const double a = chain.a, b = chain.b, q = (1.0 - b / a) * (1.0 + b / a);
  std::vector<OutlinePiece> pieces;
  for (const CutOffSphere& part : parts) {
    const auto k = static_cast<std::size_t>(part.sphere);
    const double c = chain.centres[k], r = chain.radii[k];
    // Squared heights of sphere and ellipse differ by -q x^2 + 2 c x + r^2 - c^2 - b^2.
    const double constant = r * r - c * c - b * b, discriminant = c * c + q * constant;
    std::array<double, 4> u{part.from, part.from, part.from, part.to}; // x - c
    if (discriminant > 0.0) {
      u[1] = std::clamp((c - std::sqrt(discriminant)) / q - c, part.from, part.to);
      u[2] = std::clamp((c + std::sqrt(discriminant)) / q - c, part.from, part.to);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      if (!(u[i] < u[i + 1]))
        continue;
      const double middle = c + 0.5 * (u[i] + u[i + 1]);
      const bool outside = middle * (2.0 * c - q * middle) + constant > 0.0;
      pieces.push_back({part.sphere, u[i], u[i + 1], outside ? 1.0 : -1.0});
    }
  }
  return pieces;
}

double ellipse_area(double a, double b) { return pi * a * b; } // Markauskas et al. 2010, eq. 2

double ellipsoid_volume(double a, double b) { return 4.0 / 3.0 * pi * a * b * b; } // eq. 2

double ellipse_perimeter(double a, double b) {
  // Complete elliptic integral of the second kind by the arithmetic-geometric mean
  // (Abramowitz and Stegun, 17.6).
  double mean = a, geometric = b, weight = 0.5, sum = 0.5 * (a - b) * (a + b);
  while (std::fabs(mean - geometric) > 1e-15 * mean) {
    const double half_difference = 0.5 * (mean - geometric);
    const double next = 0.5 * (mean + geometric);
    geometric = std::sqrt(mean * geometric);
    mean = next;
    weight *= 2.0;
    sum += weight * half_difference * half_difference;
  }
  return 2.0 * pi * (a * a - sum) / mean;
}

double area_between(const MultisphereTemplate& chain, const std::vector<CutOffSphere>& parts) {
  return between(chain, parts, disc_area_to, ellipse_area_to);
}

double volume_between(const MultisphereTemplate& chain, const std::vector<CutOffSphere>& parts) {
  return between(chain, parts, sphere_volume_to, ellipsoid_volume_to);
}

MultisphereMeasures measure(const MultisphereTemplate& chain) {
  const std::vector<CutOffSphere> parts = cut_off_spheres(chain);
  MultisphereMeasures m;
  for (const CutOffSphere& part : parts) {
    const auto k = static_cast<std::size_t>(part.sphere);
    const double r = chain.radii[k];
    m.area += disc_area_to(r, part.to) - disc_area_to(r, part.from);           // eq. 9
    m.volume += sphere_volume_to(r, part.to) - sphere_volume_to(r, part.from); // eq. 10
    m.perimeter += 2.0 * r * (arc_angle(r, part.to) - arc_angle(r, part.from));
  }
  m.area_ratio = m.area / ellipse_area(chain.a, chain.b);
  m.volume_ratio = m.volume / ellipsoid_volume(chain.a, chain.b);
  m.perimeter_ratio = m.perimeter / ellipse_perimeter(chain.a, chain.b);
  m.area_shape_factor = std::fabs(m.area_ratio - 1.0);           // eq. 26
  m.perimeter_shape_factor = std::fabs(m.perimeter_ratio - 1.0); // eq. 27
  m.area_between = area_between(chain, parts);
  m.volume_between = volume_between(chain, parts);
  m.outline_deviation = outline_deviation(chain, parts);
  const OutlineRoughness roughness = outline_roughness(chain, parts);
  m.outline_mean = roughness.mean;
  m.outline_rms = roughness.about_ellipse;
  m.outline_rq = roughness.about_mean;
  return m;
}

} // namespace ellipsoid
