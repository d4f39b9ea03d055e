// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "measure_rows.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>
#include <string>

namespace ellipsoid::post {
namespace {

std::int64_t whole(std::size_t n) { return static_cast<std::int64_t>(n); }

/// Spheres of an ellipsoid are one kind, any others (clumps, the host's bodies) another.
std::string surface_of(const Particle& p) {
  if (p.is_smooth())
    return "smooth";
  return p.is_host_body || p.moments_per_mass.x > 0.0 ? "clump" : "multisphere";
}

} // namespace

void append_pile(Row& row, const ParticleSet& set, const PileBody& pile,
                 const PileOptions& options) {
  append_surface(row, set);
  const bool is_true = options.outline == OutlineKind::true_shape;
  row.push_back({"outline", "outline", "", std::string(is_true ? "true" : "ellipse")});
  row.push_back({"particles", "particles of the pile", "", whole(pile.members.size())});
  row.push_back({"strays", "particles outside the pile", "", whole(pile.strays)});
  row.push_back({"pile_height_m", "height", "m", pile.top - options.floor});
  row.push_back({"pile_length_m", "length", "m", pile.right - pile.left});
}

void append_surface(Row& row, const ParticleSet& set) {
  std::size_t fewest = 0, most = 0;
  std::set<std::string> words;
  for (const Particle& p : set.particles) {
    words.insert(surface_of(p));
    most = std::max(most, p.sphere_count);
    if (!p.is_smooth())
      fewest = fewest == 0 ? p.sphere_count : std::min(fewest, p.sphere_count);
  }
  row.push_back({"surface", "surface", "", words.size() == 1 ? *words.begin() : "mixed"});
  Value number;
  if (most > 0)
    number = fewest == most ? Value(whole(most)) : Value(fmt::format("{} to {}", fewest, most));
  row.push_back({"subspheres", "sub-spheres N", "", number});
}

namespace {

void append_angle(Row& row, double angle_deg, double error_deg, const std::string& side) {
  const std::string key = side.empty() ? "" : "_" + side, name = side.empty() ? "" : " " + side;
  row.push_back({"repose_angle" + key + "_deg", "angle of repose" + name, "deg", angle_deg});
  row.push_back(
      {"repose_angle_standard_error" + key + "_deg", "standard error" + name, "deg", error_deg});
}

void append_repose(Row& row, const ReposeAngle& angle, const std::string& side) {
  const std::string key = side.empty() ? "" : "_" + side, name = side.empty() ? "" : " " + side;
  append_angle(row, angle.angle_deg, angle.standard_error_deg, side);
  row.push_back({"surface_residual" + key + "_b", "rms distance from the line" + name, "b",
                 angle.residual_in_b});
  row.push_back({"point_a_x" + key + "_m", "A: x" + name, "m", angle.a.x()});
  row.push_back({"point_a_y" + key + "_m", "A: y" + name, "m", angle.a.y()});
  row.push_back({"point_b_x" + key + "_m", "B: x" + name, "m", angle.b.x()});
  row.push_back({"point_b_y" + key + "_m", "B: y" + name, "m", angle.b.y()});
}

} // namespace

void append_flanks(Row& row, const std::vector<ReposeAngle>& flanks) {
  if (flanks.size() == 1)
    append_repose(row, flanks.front(), "");
  if (flanks.size() < 2)
    return;
  const ReposeAngle &left = flanks[0], &right = flanks[1];
  append_angle(row, 0.5 * (left.angle_deg + right.angle_deg),
               0.5 * std::hypot(left.standard_error_deg, right.standard_error_deg), "");
  append_repose(row, left, "left");
  append_repose(row, right, "right");
}

void append_porosity(Row& row, const Porosity& p) {
  row.push_back({"porosity", "porosity", "", p.porosity});
  row.push_back({"porosity_by_sum", "porosity by sum of section areas", "",
                 p.porosity_by_sum ? Value(*p.porosity_by_sum) : Value()});
  row.push_back({"total_area_m2", "total area", "m2", p.total_area});
  row.push_back({"solid_area_m2", "solid area", "m2", p.solid_area});
  row.push_back({"overlap_area_share", "overlap over solid area", "", p.overlap_share});
}

void append_coordination(Row& row, const Coordination& z, double mean_b) {
  row.push_back({"zpp", "coordination number, particle-particle", "", z.zpp});
  row.push_back({"zss", "coordination number, sphere-sphere", "", z.zss});
  row.push_back(
      {"zpp_without_rattlers", "particle-particle without rattlers", "", z.zpp_without_rattlers});
  row.push_back({"contacts", "particle-particle contacts", "", whole(z.pairs)});
  row.push_back({"wall_contacts", "contacts with walls", "", whole(z.wall_contacts)});
  row.push_back({"rattlers", "rattlers", "", whole(z.rattlers)});
  row.push_back({"mean_overlap_b", "overlap, mean", "b", z.mean_overlap / mean_b});
  row.push_back({"largest_overlap_b", "overlap, largest", "b", z.largest_overlap / mean_b});
  if (z.not_converged > 0)
    row.push_back({"contacts_not_converged", "contacts whose search did not converge", "",
                   whole(z.not_converged)});
}

void append_distribution(Row& row, const Coordination& z) {
  for (std::size_t k = 0; k < z.distribution.size(); ++k)
    row.push_back({fmt::format("particles_with_{}_contacts", k),
                   fmt::format("particles with {} contacts", k), "", whole(z.distribution[k])});
}

void append_rest(Row& row, const RestCheck& rest) {
  if (!rest.is_known) {
    row.push_back({"is_at_rest", "at rest", "", std::string("unknown: no velocities")});
    return;
  }
  row.push_back({"is_at_rest", "at rest", "", rest.is_at_rest});
  row.push_back({"largest_speed_m_per_s", "largest speed", "m/s", rest.largest_speed});
}

void append_rose(Row& row, const std::vector<double>& rose) {
  const double width = 180.0 / static_cast<double>(rose.size());
  for (std::size_t k = 0; k < rose.size(); ++k) {
    const double begin = width * static_cast<double>(k);
    row.push_back({fmt::format("rose_{:g}_to_{:g}_deg", begin, begin + width),
                   fmt::format("share from {:g} to {:g} deg", begin, begin + width), "", rose[k]});
  }
}

} // namespace ellipsoid::post
