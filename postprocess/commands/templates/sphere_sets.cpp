// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "sphere_sets.h"

#include "ellipsoid_counts.h"
#include "input_error.h"
#include "mesh_clump.h"
#include "messages.h"
#include "multisphere/ellipsoid_spheres.h"
#include "multisphere/sphere_list.h"
#include "multisphere/union_measures.h"
#include "progress_line.h"
#include "set_comparison.h"
#include "space_picture.h"
#include "sphere_set_measures.h"
#include "stl_mesh.h"
#include "table_charts.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <optional>

namespace ellipsoid::post {
namespace {

/// Of the unit of distances: spheres that stick out farther are told.
constexpr double far_beyond = 0.1;

/// A set with its name, and what it is compared with.
struct NamedSet {
  std::string source, spacing;
  SphereSet spheres;
};

std::string text_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path))
    throw InputError(path + ": cannot be opened; give a list of spheres that is there");
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (file.bad() || text.find('\0') != std::string::npos)
    throw InputError(path + ": expected lines x y z r, found something that is no text");
  return text;
}

/// The first line of spheres_csv() in the words of lists.
std::string with_plain_names(std::string text) {
  const std::string ours = spheres_csv({});
  if (text.compare(0, ours.size(), ours) == 0)
    text.replace(0, ours.size(), "index,x,y,z,r\n");
  return text;
}

SphereSet checked_list(const std::string& path) {
  try {
    SphereSet set = parse_sphere_list(with_plain_names(text_of_file(path))).spheres;
    check_values(set);
    check_connected(set);
    if (const int equal = leave_out_equal_spheres(set); equal > 0)
      report_warning(
          fmt::format("{}: {} spheres equal an earlier one and are left out", path, equal));
    return set;
  } catch (const std::invalid_argument& error) {
    throw InputError(path + ": " + error.what());
  }
}

Vector3 semiaxes_of(const SetOptions& options) {
  return {options.semiaxes[0], options.semiaxes[1], options.semiaxes[2]};
}

SphereSpacing spacing_of(const TemplateChoice& choice) {
  return choice.spacing.empty() ? SphereSpacing::medial : sphere_spacing_from_word(choice.spacing);
}

/// Counts that cannot be built are left out with a warning.
template <class Make>
void append_sets(std::vector<NamedSet>& sets, const std::string& source,
                 const TemplateChoice& choice, const Make& make) {
  std::string last;
  for (const int count : choice.counts) {
    try {
      sets.push_back({source, word_of(spacing_of(choice)), make(count)});
    } catch (const std::exception& error) {
      last = error.what();
      if (choice.counts.size() > 1)
        report_warning(last);
    }
  }
  if (sets.empty())
    throw InputError(choice.counts.size() > 1 ? "none of these templates can be built" : last);
}

SetError error_of(const TemplateChoice& choice) {
  if (choice.measure == "area")
    throw InputError("--measure area is of the section of a chain; sets of spheres take volume or "
                     "outline");
  return choice.measure == "outline" ? SetError::outline : SetError::volume;
}

std::vector<NamedSet> ellipsoid_sets(const SetOptions& options, TemplateChoice choice) {
  const Vector3 semiaxes = semiaxes_of(options);
  if (!is_planar(spacing_of(choice)) && semiaxes.y != semiaxes.z)
    throw InputError("spacing " + choice.spacing +
                     " needs semi-axes b = c: use spacing medial or minimax_volume");
  if (choice.tolerance > 0.0)
    choice.counts = {
        count_within(semiaxes, spacing_of(choice), error_of(choice), choice.tolerance)};
  std::vector<NamedSet> sets;
  append_sets(sets, "ellipsoid", choice, [&](int count) {
    return make_ellipsoid_spheres(semiaxes, count, spacing_of(choice));
  });
  return sets;
}

std::vector<NamedSet> mesh_sets(const SetOptions& options, TemplateChoice choice,
                                const MeshClumps& clumps) {
  if (choice.tolerance > 0.0) {
    if (error_of(choice) != SetError::volume)
      throw InputError("--tolerance with --from is of the volume: leave --measure out");
    choice.counts = {clumps.count_for(choice.tolerance, spacing_of(choice))};
  }
  std::vector<NamedSet> sets;
  append_sets(sets, options.mesh, choice,
              [&](int count) { return clumps.spheres(count, spacing_of(choice)); });
  return sets;
}

/// A sphere whose centre is not in the body was made for another one, or in another unit.
void check_inside(const NamedSet& set, const Solid& solid) {
  for (std::size_t k = 0; k < set.spheres.radii.size(); ++k) {
    const Vector3& c = set.spheres.centres[k];
    const double width = 1e-3 * norm(solid.box.upper - solid.box.lower);
    const ColumnGrid column{c.x - 0.5 * width, c.y - 0.5 * width, width, width, 1, 1};
    const ColumnParts parts = solid.columns(column).front();
    if (std::none_of(parts.begin(), parts.end(),
                     [&](const ColumnPart& part) { return c.z >= part.from && c.z <= part.to; }))
      throw InputError(fmt::format("{}: the centre of sphere {} ({:g}, {:g}, {:g}) lies outside "
                                   "the body, by {:g}; give spheres "
                                   "of this body, in the same unit and frame",
                                   set.source, k + 1, c.x, c.y, c.z, solid.distance(c)));
  }
}

/// A sphere that reaches far beyond the body has, perhaps, a radius of another one.
void warn_of_far_spheres(const NamedSet& set, const Target& target) {
  double farthest = 0.0;
  std::size_t which = 0, count = 0;
  for (std::size_t k = 0; k < set.spheres.radii.size(); ++k) {
    const double beyond =
        set.spheres.radii[k] - target.solid->distance(set.spheres.centres[k]); // at most
    count += beyond > far_beyond * target.unit;
    if (beyond > farthest) {
      farthest = beyond;
      which = k;
    }
  }
  if (count > 0)
    report_warning(fmt::format(
        "{}: {} of the {} spheres stick out of the body by more than {:g} {}, sphere {} by up to "
        "{:g} ({:.3g} {}); are its radius and the body's those of one unit?",
        set.source, count, set.spheres.count(), far_beyond, target.unit_name, which + 1, farthest,
        farthest / target.unit, target.unit_name));
}

void check_spheres_of_body(const NamedSet& set, const Target& target) {
  check_inside(set, *target.solid);
  warn_of_far_spheres(set, target);
}

Row measures_row(const UnionMeasures& m) {
  return {
      {"volume_m3", "volume", "m3", m.volume},       {"surface_m2", "surface", "m2", m.surface},
      {"centre_x_m", "centre x", "m", m.centre.x},   {"centre_y_m", "centre y", "m", m.centre.y},
      {"centre_z_m", "centre z", "m", m.centre.z},   {"inertia_xx_m5", "I_xx", "m5", m.inertia.xx},
      {"inertia_yy_m5", "I_yy", "m5", m.inertia.yy}, {"inertia_zz_m5", "I_zz", "m5", m.inertia.zz},
      {"inertia_xy_m5", "I_xy", "m5", m.inertia.xy}, {"inertia_xz_m5", "I_xz", "m5", m.inertia.xz},
      {"inertia_yz_m5", "I_yz", "m5", m.inertia.yz}};
}

Table table_of(const std::vector<NamedSet>& sets, const Target& target) {
  Table table{"Sets of spheres", {}};
  for (const NamedSet& set : sets) {
    show_progress_line(fmt::format("measures of N = {}", set.spheres.count()));
    Row row{{"source", "source", "", set.source},
            {"subspheres", "N", "", static_cast<std::int64_t>(set.spheres.count())},
            {"spacing", "spacing", "", set.spacing}};
    const UnionMeasures m = measure_union(set.spheres);
    const Row measures = measures_row(m);
    row.insert(row.end(), measures.begin(), measures.end());
    if (target.solid)
      append_comparison(row, m, set.spheres, target);
    table.rows.push_back(std::move(row));
  }
  clear_progress_line();
  return table;
}

/// One body of sub-spheres, seen from the side.
std::string picture_of(const std::string& path, const SphereSet& set, const std::string& title) {
  ParticleSet particles;
  Particle particle;
  particle.sphere_count = set.radii.size();
  double reach = 0.0;
  for (std::size_t k = 0; k < set.radii.size(); ++k) {
    particles.spheres.push_back({set.centres[k], set.radii[k]});
    reach = std::max(reach, norm(set.centres[k]) + set.radii[k]);
  }
  particle.semiaxes = {reach, reach, reach};
  particles.particles.push_back(particle);
  const ParticleColours colours = particle_colours(Frame(), particles, "", {}, {});
  return space_picture(picture_format(path), particles, colours, SpaceView(), title);
}

/// Files hold the set about its centre of mass, but for CSV, which keeps the frame.
void write_files(const NamedSet& set, const SetOptions& options, const TemplateChoice& choice) {
  const UnionMeasures m = measure_union(set.spheres);
  SphereBody body{fmt::format("{} N = {} ({})",
                              std::filesystem::path(set.source).filename().string(),
                              set.spheres.count(), set.spacing),
                  set.spheres, (1.0 / m.volume) * m.inertia};
  for (Vector3& centre : body.spheres.centres)
    centre -= m.centre;
  write_body_files(choice.files, body, set.spheres);
  if (!options.picture.empty())
    write_text(options.picture, picture_of(options.picture, body.spheres, body.title));
}

bool has_files(const SetOptions& options, const TemplateChoice& choice) {
  const BodyFiles& files = choice.files;
  return !(files.multisphere + files.molecule + files.spheres + options.picture).empty();
}

int run_needed(const SetOptions& options, const OutputOptions& output) {
  const std::vector<double> usual{0.2, 0.4, 0.6, 0.8, 1.0};
  const Table table =
      needed_table(options.needed_within, options.ratios.empty() ? usual : options.ratios);
  write_table(output, table);
  if (options.map.empty())
    return exit_good;
  const TableChart what{"b_a", "", {"c_a"}, "medial", "N needed, spacing medial"};
  write_text(options.map, draw_map(picture_format(options.map), table, what, 700, 560));
  if (const std::string words = left_out_of_map(table, what); !words.empty())
    report_warning(words);
  return exit_good;
}

/// What is given as the body: a surface before an ellipsoid.
Target target_of(const SetOptions& options, const std::optional<MeshClumps>& clumps) {
  if (clumps)
    return {clumps->solid(), std::cbrt(0.75 * clumps->solid().volume / M_PI), "r_V", {}};
  if (options.semiaxes.empty())
    return {};
  for (const double axis : options.semiaxes)
    if (!std::isfinite(axis) || !(axis > 0.0))
      throw InputError("--semiaxes needs three finite values > 0");
  return {solid_ellipsoid(semiaxes_of(options)),
          *std::min_element(options.semiaxes.begin(), options.semiaxes.end()), "c",
          semiaxes_of(options)};
}

} // namespace

int run_sets(const SetOptions& options, const TemplateChoice& choice, OutputOptions output) {
  if (options.needed_within > 0.0)
    return run_needed(options, output);
  if (!options.ratios.empty()) {
    write_table(output, ratio_table(options.ratios, choice.counts, spacing_of(choice)));
    return exit_good;
  }
  std::optional<MeshClumps> clumps;
  if (!options.mesh.empty())
    clumps.emplace(checked_closed(read_stl(options.mesh), options.mesh));
  const Target target = target_of(options, clumps);
  std::vector<NamedSet> sets;
  if (!options.clump.empty())
    sets.push_back({options.clump, "of the file", checked_list(options.clump)});
  else
    sets = clumps ? mesh_sets(options, choice, *clumps) : ellipsoid_sets(options, choice);
  if (!options.clump.empty() && target.solid)
    check_spheres_of_body(sets.front(), target);
  if (has_files(options, choice) && sets.size() != 1)
    throw InputError("files hold one template: give one --subspheres, or a --tolerance");
  for (const std::string* file :
       {&choice.files.multisphere, &choice.files.molecule, &choice.files.spheres})
    output.quiet = output.quiet || *file == "-";
  write_table(output, table_of(sets, target));
  if (has_files(options, choice))
    write_files(sets.front(), options, choice);
  return exit_good;
}

void add_set_options(CLI::App& command, SetOptions& options) {
  command
      .add_option("--semiaxes", options.semiaxes,
                  "a b c along x, y, z (m): a set of spheres in a plane for this ellipsoid; with "
                  "--clump: what the list is compared with")
      ->expected(3);
  command.add_option("--clump", options.clump,
                     "read a list of spheres: the host's multisphere file, CSV, CLUMP's output");
  command.add_option("--from", options.mesh,
                     "STL file of a closed surface: a clump for this body; with --clump: what the "
                     "list is compared with");
  command.add_option("--picture", options.picture, "draw the spheres, SVG or PNG");
  CLI::Option* needed =
      command.add_option("--needed", options.needed_within,
                         "table of the N needed to come within this share of the volume, over b/a "
                         "and c/a, for medial and minimax_volume");
  needed->check(CLI::Range(1e-4, 0.5));
  CLI::Option* ratios =
      command.add_option("--ratios", options.ratios,
                         "values of b/a and c/a: with --needed the rows of its table (without: "
                         "0.2,0.4,0.6,0.8,1), else a table of --subspheres over all pairs");
  ratios->delimiter(',')->check(CLI::Range(0.01, 1.0));
  command.add_option("--map", options.map, "of --needed: draw N of medial, SVG or PNG")
      ->needs(needed);
  for (const char* other : {"--semiaxes", "--clump", "--from", "--picture"})
    needed->excludes(command.get_option(other)), ratios->excludes(command.get_option(other));
  command.get_option("--from")->excludes(command.get_option("--semiaxes"));
}

} // namespace ellipsoid::post
