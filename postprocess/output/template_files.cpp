// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "template_files.h"

#include "ellipsoid/ellipsoid_properties.h"
#include "multisphere/ellipsoid_spheres.h"

#include <cmath>
#include <fmt/format.h>

namespace ellipsoid::post {
namespace {

constexpr double pi = 3.141592653589793238462643;

/// A point of the outline above the x axis.
struct OutlinePoint {
  double x = 0.0, distance = 0.0; ///< distance from the axis; 0 at the two ends
};

/// The outline turned about the x axis; its first and last points lie on the axis.
SurfaceMesh turned(const std::vector<OutlinePoint>& outline, const MeshFineness& fineness) {
  const auto meridians = static_cast<std::size_t>(fineness.meridians);
  SurfaceMesh mesh;
  const std::size_t rings = outline.size() - 2;
  mesh.points.push_back({outline.front().x, 0.0, 0.0});
  for (std::size_t k = 1; k <= rings; ++k)
    for (std::size_t m = 0; m < meridians; ++m) {
      const double angle = 2.0 * pi * static_cast<double>(m) / static_cast<double>(meridians);
      mesh.points.push_back({outline[k].x, outline[k].distance * std::cos(angle),
                             outline[k].distance * std::sin(angle)});
    }
  mesh.points.push_back({outline.back().x, 0.0, 0.0});
  const auto at = [meridians](std::size_t ring, std::size_t m) {
    return 1 + ring * meridians + m % meridians;
  };
  const std::size_t last = mesh.points.size() - 1;
  for (std::size_t m = 0; m < meridians; ++m) {
    mesh.triangles.push_back({0, at(0, m + 1), at(0, m)});
    for (std::size_t ring = 0; ring + 1 < rings; ++ring) {
      mesh.triangles.push_back({at(ring, m), at(ring, m + 1), at(ring + 1, m)});
      mesh.triangles.push_back({at(ring, m + 1), at(ring + 1, m + 1), at(ring + 1, m)});
    }
    mesh.triangles.push_back({last, at(rings - 1, m), at(rings - 1, m + 1)});
  }
  return mesh;
}

/// Points on one cut-off sphere from its left to its right cutting plane, both included.
void append_arc(std::vector<OutlinePoint>& outline, double centre, double radius, double begin,
                double end, int arcs) {
  const auto angle_of = [&](double x) {
    return std::acos(std::fmax(-1.0, std::fmin(1.0, (x - centre) / radius)));
  };
  const double from = angle_of(begin), to = angle_of(end); // from > to
  const int parts = 1 + static_cast<int>((from - to) / pi * arcs);
  for (int k = 0; k <= parts; ++k) {
    const double angle = from + (to - from) * k / parts;
    const OutlinePoint p{centre + radius * std::cos(angle), radius * std::sin(angle)};
    if (outline.empty() || std::abs(p.x - outline.back().x) > 1e-9 * radius)
      outline.push_back(p);
  }
}

} // namespace

SphereBody body_of(const MultisphereTemplate& chain) {
  const Vector3 moments = principal_moments({chain.a, chain.b, chain.b}, 1.0);
  return {fmt::format("multi-sphere ellipsoid a = {} b = {} N = {} ({})", chain.a, chain.b,
                      chain.count(), word_of(chain.spacing)),
          spheres_of(chain),
          {moments.x, moments.y, moments.z, 0.0, 0.0, 0.0}};
}

std::string host_multisphere_file(const SphereSet& set) {
  std::string text;
  for (std::size_t k = 0; k < set.centres.size(); ++k) {
    const Vector3& c = set.centres[k];
    text += fmt::format("{} {} {} {}\n", c.x, c.y, c.z, set.radii[k]);
  }
  return text;
}

std::string host_multisphere_words(const SphereBody& body, const std::string& file, double mass) {
  const SymmetricMatrix3 t = mass * body.inertia;
  return fmt::format(
      "nspheres {} ntry 100000 spheres file {} scale 1.0 type 1 mass {} inertia_tensor {} {} {} {} "
      "{} {} use_density",
      body.spheres.count(), file, mass, t.xx, t.xy, t.xz, t.yy, t.yz, t.zz);
}

std::string molecule_file(const SphereBody& body, double mass) {
  std::string text = fmt::format("{}\n\n{} atoms\n", body.title, body.spheres.count());
  if (mass > 0.0) {
    const SymmetricMatrix3 t = mass * body.inertia;
    text += fmt::format("{} mass\n0 0 0 com\n{} {} {} {} {} {} inertia\n", mass, t.xx, t.yy, t.zz,
                        t.xy, t.xz, t.yz);
  }
  text += "\nCoords\n\n";
  const std::vector<Vector3>& centres = body.spheres.centres;
  for (std::size_t k = 0; k < centres.size(); ++k)
    text += fmt::format("{} {} {} {}\n", k + 1, centres[k].x, centres[k].y, centres[k].z);
  text += "\nTypes\n\n";
  for (std::size_t k = 0; k < centres.size(); ++k)
    text += fmt::format("{} 1\n", k + 1);
  text += "\nDiameters\n\n";
  for (std::size_t k = 0; k < centres.size(); ++k)
    text += fmt::format("{} {}\n", k + 1, 2.0 * body.spheres.radii[k]);
  return text;
}

std::string spheres_csv(const SphereSet& set) {
  std::string text = "index,x_m,y_m,z_m,radius_m\n";
  for (std::size_t k = 0; k < set.centres.size(); ++k) {
    const Vector3& c = set.centres[k];
    text += fmt::format("{},{},{},{},{}\n", k + 1, c.x, c.y, c.z, set.radii[k]);
  }
  return text;
}

SurfaceMesh outline_of_revolution(const MultisphereTemplate& chain, const MeshFineness& fineness) {
  std::vector<OutlinePoint> outline;
  for (const CutOffSphere& part : cut_off_spheres(chain)) {
    const auto k = static_cast<std::size_t>(part.sphere);
    append_arc(outline, chain.centres[k], chain.radii[k], part.begin, part.end, fineness.arcs);
  }
  return turned(outline, fineness);
}

SurfaceMesh ellipsoid_surface(const Vector3& semiaxes, const MeshFineness& fineness) {
  std::vector<OutlinePoint> outline;
  append_arc(outline, 0.0, 1.0, -1.0, 1.0, fineness.arcs);
  SurfaceMesh mesh = turned(outline, fineness);
  for (Vector3& p : mesh.points)
    p = {semiaxes.x * p.x, semiaxes.y * p.y, semiaxes.z * p.z};
  return mesh;
}

} // namespace ellipsoid::post
