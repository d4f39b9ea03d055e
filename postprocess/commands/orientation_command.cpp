// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "measure_rows.h"
#include "orientation.h"
#include "rows_command.h"
#include "time_option.h"

#include <memory>
#include <set>

namespace ellipsoid::post {
namespace {

struct OrientationOptions {
  FrameOptions frames;
  int bins = 18;
  std::string plane = "xy";
  double time_step = 0.0;
};

AnglePlane plane_of(const std::string& word) {
  return {static_cast<std::size_t>(word[0] - 'x'), static_cast<std::size_t>(word[1] - 'x')};
}

/// Particles of one type (or all) sorted by the axis that tells how they lie.
struct Group {
  std::string type;
  std::vector<std::size_t> longest, shortest;
  std::size_t spheres = 0;
};

Group group_of(const ParticleSet& set, const std::string& name, std::optional<std::int64_t> type) {
  Group group{name, {}, {}, 0};
  for (const std::size_t i : all_members(set)) {
    if (type && set.particles[i].type != *type)
      continue;
    switch (body_axis(set.particles[i])) {
    case BodyAxis::none:
      ++group.spheres;
      break;
    case BodyAxis::longest:
      group.longest.push_back(i);
      break;
    case BodyAxis::shortest:
      group.shortest.push_back(i);
      break;
    }
  }
  return group;
}

std::vector<Group> groups_of(const ParticleSet& set) {
  set.has_types.require_readable();
  std::set<std::int64_t> types;
  for (const Particle& p : set.particles)
    types.insert(p.type);
  std::vector<Group> groups{group_of(set, "all", {})};
  for (const std::int64_t type : types)
    if (types.size() > 1)
      groups.push_back(group_of(set, std::to_string(type), type));
  return groups;
}

void append_orientation(Row& row, const Orientation& o) {
  row.push_back({"nematic_order", "nematic order S", "", o.nematic_order});
  row.push_back({"director_x", "director: x", "", o.director.x});
  row.push_back({"director_y", "director: y", "", o.director.y});
  row.push_back({"director_z", "director: z", "", o.director.z});
  row.push_back({"biaxial_order", "biaxial order of triaxial bodies", "",
                 o.biaxial_order ? Value(*o.biaxial_order) : Value()});
  row.push_back({"plane_order", "order in the plane S2", "", o.plane_order});
  row.push_back({"plane_angle_deg", "director's angle in the plane", "deg", o.plane_angle_deg});
  row.push_back({"flow_angle_deg", "flow angle, mean", "deg", o.flow_angle_deg});
  row.push_back({"flow_angle_standard_deviation_deg", "flow angle, standard deviation", "deg",
                 o.flow_angle_deviation_deg});
  append_rose(row, o.rose);
}

Row group_row(const OrientationOptions& options, const ChosenFrame& chosen, const Group& group,
              const std::string& axis, std::size_t particles) {
  Row row = frame_row(chosen);
  append_time(row, chosen.frame, options.time_step);
  append_surface(row, chosen.set);
  row.push_back({"type", "type", "", group.type});
  row.push_back({"axis", "axis that counts", "", axis.empty() ? Value() : Value(axis)});
  row.push_back({"particles", "particles", "", static_cast<std::int64_t>(particles)});
  row.push_back({"spheres", "spheres left out", "", static_cast<std::int64_t>(group.spheres)});
  return row;
}

std::vector<Row> orientation_rows(const OrientationOptions& options, const ChosenFrame& chosen) {
  if (chosen.set.particles.empty())
    throw InputError("there are no particles");
  std::vector<Row> rows;
  for (const Group& group : groups_of(chosen.set)) {
    if (group.longest.empty() && group.shortest.empty())
      rows.push_back(group_row(options, chosen, group, "", 0)); // spheres have no direction
    for (const BodyAxis axis : {BodyAxis::longest, BodyAxis::shortest}) {
      const bool is_longest = axis == BodyAxis::longest;
      const auto& members = is_longest ? group.longest : group.shortest;
      if (members.empty())
        continue;
      rows.push_back(
          group_row(options, chosen, group, is_longest ? "longest" : "shortest", members.size()));
      append_orientation(rows.back(), orientation(chosen.set, members, axis, options.bins,
                                                  plane_of(options.plane)));
    }
  }
  return rows;
}

} // namespace

void add_orientation_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<OrientationOptions>();
  CLI::App* command =
      program.add_subcommand("orientation", "nematic order and angle rose of the long axes");
  command->footer(
      "n: along the longest semi-axis, wherever it is in the body; of discs (s1 / s2 < s2 / s3 "
      "with s1 >= s2 >= s3) along the shortest. Bodies of either kind have their own rows, types "
      "too; spheres are left out and counted. S: largest eigenvalue of Q = <3/2 (n n - I/3)>, "
      "director its eigenvector. Biaxial order: of the other two axes of triaxial bodies across "
      "the director (Allen 1990). S2 = |<exp(2 i theta)>|, theta the angle of n in --plane from "
      "its first axis; the plane's director is half the phase; flow angle: mean of theta in (-90, "
      "90] deg. Rose: share of particles per bin of theta from 0 to 180 deg.");
  add_frame_options(*command, options->frames, FrameUse::table);
  add_time_option(*command, options->time_step);
  command->add_option("--bins", options->bins, "bins of the rose")
      ->check(CLI::Range(1, 360))
      ->capture_default_str();
  command
      ->add_option("--plane", options->plane,
                   "plane of the angles: the direction of the flow, then the one across")
      ->check(CLI::IsMember({"xy", "yz", "zx", "yx", "zy", "xz"}))
      ->capture_default_str();
  command->callback([options, &exit_code] {
    exit_code =
        run_rows_command(options->frames, "Orientation", FrameOrder::any,
                         [&](const ChosenFrame& f) { return orientation_rows(*options, f); });
  });
}

} // namespace ellipsoid::post
