// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "particles.h"

#include "clump_files.h"
#include "host_bodies.h"
#include "particle_columns.h"
#include "template_cache.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace ellipsoid::post {
namespace {

/// Number of sub-spheres of a row: 0 for a smooth particle.
int subspheres_at(const Frame& frame, Column subspheres, std::size_t row,
                  const ParticleOptions& options) {
  if (!subspheres)
    return options.subspheres.value_or(0);
  const double n = (*subspheres)[row];
  if (n < 0.0 || n != std::floor(n) || n > largest_set_count)
    throw bad_value(frame, row,
                    fmt::format("a whole number of sub-spheres from 0 to {}", largest_set_count),
                    fmt::format("{}", n));
  return static_cast<int>(n);
}

SphereSpacing spacing_at(const Frame& frame, Column spacing, std::size_t row,
                         const ParticleOptions& options) {
  if (!spacing)
    return options.spacing.value_or(SphereSpacing::paper);
  const double code = (*spacing)[row];
  if (const auto known = sphere_spacing_from_number(code))
    return *known;
  throw bad_value(frame, row,
                  "f_spacing " + numbers_of_spacings() + ", or 1000 and the number of a clump",
                  fmt::format("{}", code));
}

/// @param[in] scale of the set's lengths
void add_spheres(ParticleSet& set, Particle& particle, const SphereSet& spheres, double scale) {
  const Rotation3 r = rotation(particle.orientation);
  particle.first_sphere = set.spheres.size();
  particle.sphere_count = spheres.centres.size();
  for (std::size_t k = 0; k < spheres.centres.size(); ++k)
    set.spheres.push_back(
        {particle.centre + r.to_space(scale * spheres.centres[k]), scale * spheres.radii[k]});
}

void add_clump(ParticleSet& set, Particle& particle, const ClumpTemplate& clump) {
  const double size = particle.semiaxes.y / clump.semiaxes.y;
  particle.moments_per_mass = (size * size / clump.volume) * clump.moments;
  add_spheres(set, particle, clump.spheres, particle.semiaxes.y);
}

/// Exponents of superquadrics, whatever the program calls them: blockiness1, block2, c_block[1],
/// and the host's older names.
bool names_blockiness(std::string name) {
  if (name == "roundness1" || name == "roundness2")
    return true;
  if (name.size() > 2 && name[1] == '_') // of a compute, fix or variable
    name.erase(0, 2);
  for (const std::string word : {"block", "iness"})
    if (name.compare(0, word.size(), word) == 0)
      name.erase(0, word.size());
    else if (word == "block")
      return false;
  return name.find_first_not_of("0123456789xy[]") == std::string::npos;
}

/// Superquadrics other than ellipsoids cannot be measured.
void refuse_blocks(const NamedColumns& columns) {
  for (const std::string& name : columns.frame().names) {
    if (!names_blockiness(name))
      continue;
    const std::vector<double>& exponents = columns.frame().required(name, "which bodies these are");
    for (std::size_t row = 0; row < exponents.size(); ++row)
      if (exponents[row] != 2.0)
        throw bad_value(columns.frame(), row, fmt::format("{} 2, an ellipsoid", name),
                        fmt::format("{}", exponents[row]));
  }
}

/// The frame's box, with what the user says of its sides.
Box box_of(const Frame& frame, const std::string& periodic) {
  Box box = frame.box;
  if (periodic.empty())
    return box;
  box.boundary.clear();
  for (const char axis : {'x', 'y', 'z'})
    box.boundary += std::string(box.boundary.empty() ? "" : " ") +
                    (periodic != "none" && periodic.find(axis) != std::string::npos ? "pp" : "ff");
  return box;
}

/// An option for files without a column beside that column.
void refuse_both(Column column, bool is_given, const char* option, const char* name) {
  if (column && is_given)
    throw InputError(fmt::format("{} is for files without the column \"{}\", which this one has: "
                                 "leave it out",
                                 option, name));
}

void add_ellipsoids(ParticleSet& set, const NamedColumns& columns, const ParticleOptions& options) {
  const Frame& frame = columns.frame();
  const SizeColumns sizes(columns, options);
  const OrientationColumns orientations(columns);
  const CommonColumns common(columns);
  const Column subspheres = columns.find("f_subspheres"), spacing = columns.find("f_spacing");
  refuse_both(subspheres, options.subspheres.has_value(), "--subspheres", "f_subspheres");
  refuse_both(spacing, options.spacing.has_value(), "--spacing", "f_spacing");
  common.describe(set);
  for (const std::string& remark : {sizes.remark(), orientations.remark()})
    if (!remark.empty())
      set.remarks.push_back(remark);
  TemplateCache templates;
  const ClumpFiles clumps(options.clumps);
  set.particles.reserve(frame.rows);
  for (const std::size_t row : rows_by_id(columns)) {
    Particle p = common.at(row);
    p.semiaxes = sizes.at(row);
    p.orientation = orientations.at(row, p.semiaxes);
    if (!orientations.are_there())
      p.known_orientation = KnownOrientation::none;
    if (const int count = subspheres_at(frame, subspheres, row, options); count > 0) {
      const double code = spacing ? (*spacing)[row] : 0.0;
      try {
        if (code > clump_spacing)
          add_clump(set, p, clumps.find(code, count, p.semiaxes));
        else
          add_spheres(set, p,
                      templates.find(p.semiaxes, count, spacing_at(frame, spacing, row, options)),
                      1.0);
      } catch (const std::invalid_argument& error) {
        throw bad_value(frame, row, "a multi-sphere particle that can be built", error.what());
      }
    }
    set.particles.push_back(p);
  }
  if (options.spacing && set.spheres.empty() && !set.particles.empty())
    throw InputError("--spacing is for particles of sub-spheres; this file has none: leave it out, "
                     "or give --subspheres");
}

} // namespace

double Particle::largest_axis() const { return std::max({semiaxes.x, semiaxes.y, semiaxes.z}); }
Vector3 Particle::long_axis() const {
  const Rotation3 r = rotation(orientation);
  const double largest = largest_axis();
  return semiaxes.x == largest ? r.column_x : semiaxes.y == largest ? r.column_y : r.column_z;
}
double Particle::smallest_axis() const { return std::min({semiaxes.x, semiaxes.y, semiaxes.z}); }

double mean_smallest_axis(const ParticleSet& set, const std::vector<std::size_t>& members) {
  double sum = 0.0;
  for (const std::size_t i : members)
    sum += set.particles[i].smallest_axis();
  return members.empty() ? 0.0 : sum / static_cast<double>(members.size());
}

double mean_largest_axis(const ParticleSet& set, const std::vector<std::size_t>& members) {
  double sum = 0.0;
  for (const std::size_t i : members)
    sum += set.particles[i].largest_axis();
  return members.empty() ? 0.0 : sum / static_cast<double>(members.size());
}

std::vector<std::size_t> all_members(const ParticleSet& set) {
  std::vector<std::size_t> members(set.particles.size());
  std::iota(members.begin(), members.end(), std::size_t{0});
  return members;
}

ParticleSet particles_of(const Frame& frame, const ParticleOptions& options) {
  const NamedColumns columns(frame, options.columns);
  ParticleSet set;
  set.box = box_of(frame, options.periodic);
  refuse_blocks(columns);
  if (const Column body = bodies_column(columns, options))
    add_host_bodies(set, *body, columns, options);
  else
    add_ellipsoids(set, columns, options);
  return set;
}

} // namespace ellipsoid::post
