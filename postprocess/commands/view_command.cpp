// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "colour_map.h"
#include "contact_list_options.h"
#include "frame_loop.h"
#include "frame_options.h"
#include "gravity_options.h"
#include "messages.h"
#include "option_checks.h"
#include "picture_options.h"
#include "run_surfaces.h"
#include "table.h"
#include "view_page.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>

namespace ellipsoid::post {
namespace {

struct ViewOptions {
  FrameOptions frames;
  ContactListOptions contacts;
  RunSurfaceOptions surfaces;
  std::string output, title, up, colour_by;
  bool no_contacts = false, no_walls = false;
};

ByteColour bytes_of(const Colour& colour) {
  const auto byte = [](double share) { return static_cast<int>(std::lround(255.0 * share)); };
  return {byte(colour.red), byte(colour.green), byte(colour.blue)};
}

void fill_colours(ViewSettings& settings) {
  for (int k = 0; k < 256; ++k) {
    settings.even_colours.push_back(bytes_of(colour_of(k / 255.0)));
    settings.cyclic_colours.push_back(bytes_of(cyclic_colour(k / 255.0)));
  }
  // Okabe and Ito 2008: eight colours that colour-blind readers tell apart, without black
  settings.kind_colours = {{0, 114, 178},  {230, 159, 0}, {0, 158, 115},  {204, 121, 167},
                           {86, 180, 233}, {213, 94, 0},  {240, 228, 66}, {140, 140, 140}};
}

/// Walls of the run's log, and the meshes that the user names.
void add_walls(const ViewOptions& options, const std::string& first_file, ViewSettings& settings) {
  const RunSurfaces surfaces = run_surfaces(options.surfaces, first_file, options.no_walls);
  for (const PrimitivePlane& plane : surfaces.planes) {
    ViewWall wall;
    (plane.axis == 0   ? wall.point.x
     : plane.axis == 1 ? wall.point.y
                       : wall.point.z) = plane.position;
    (plane.axis == 0 ? wall.normal.x : plane.axis == 1 ? wall.normal.y : wall.normal.z) = 1.0;
    settings.walls.push_back(wall);
  }
  const auto unit = [](unsigned axis) {
    return Vector3{axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
  };
  for (const PrimitiveCylinder& cylinder : surfaces.cylinders)
    settings.cylinders.push_back({cylinder.middle[0] * unit((cylinder.axis + 1) % 3) +
                                      cylinder.middle[1] * unit((cylinder.axis + 2) % 3),
                                  unit(cylinder.axis), cylinder.radius});
  for (const ShownMesh& mesh : surfaces.meshes) {
    settings.meshes.push_back({mesh.name, {}});
    for (const auto& triangle : mesh.triangles)
      for (const Vector3& corner : triangle)
        for (const double x : {corner.x, corner.y, corner.z})
          settings.meshes.back().corners.push_back(static_cast<float>(x));
  }
}

std::vector<ViewContact> contacts_of(const ViewOptions& options, ContactLists& lists,
                                     const ChosenFrame& chosen) {
  std::vector<ViewContact> contacts;
  if (options.no_contacts)
    return contacts;
  if (!options.contacts.files.empty()) {
    for (const ForceLink& link :
         force_links(lists.at(chosen.frame.timestep), options.contacts.columns, chosen.set))
      contacts.push_back({link.i, link.j, link.force, 0.0});
    return contacts;
  }
  for (const PairContact& pair : find_contacts(chosen.set, 0.0).pairs)
    contacts.push_back({pair.i, pair.j, 0.0, pair.largest_overlap});
  return contacts;
}

void say_sizes(const ViewOptions& options, const ViewSurvey& survey, const ViewPage& page,
               std::size_t particles, std::size_t bytes) {
  fmt::print(stderr,
             "view: {}: {} frame{}, {:.3g} MB; {} bytes per particle and frame, {:.3g} after "
             "compression; coordinates to {:.2g} (length)\n",
             options.output, survey.frames(), survey.frames() == 1 ? "" : "s",
             1e-6 * static_cast<double>(bytes), page.bytes_per_particle(),
             static_cast<double>(bytes) / static_cast<double>(std::max<std::size_t>(1, particles)),
             page.position_error());
}

/// The axis that points up: as given, or of the first frame's log. 1: y, 2: z.
unsigned up_axis(const ViewOptions& options) {
  if (!options.up.empty())
    return options.up == "y" ? 1u : 2u;
  FrameOptions first = options.frames;
  first.frames = "first";
  unsigned axis = 2;
  const MuteMessages mute; // what is wrong with a file is said when it is read
  for_chosen_frames(first, [&](const ChosenFrame& chosen) {
    axis = up_direction("", chosen).axis == UpAxis::y ? 1u : 2u;
  });
  return axis;
}

/// A column that all frames have. Throws InputError for another one that the user asked for.
std::string colour_of_page(const ViewOptions& options, const ViewSurvey& survey) {
  const std::vector<std::string> names = survey.column_names();
  const std::string wanted = options.colour_by.empty() ? "speed" : options.colour_by;
  if (!options.colour_by.empty() && std::find(names.begin(), names.end(), wanted) == names.end())
    throw InputError(fmt::format("--colour {}: expected a column of all frames: {}", wanted,
                                 fmt::join(names, " ")));
  return wanted;
}

int write_view(const ViewOptions& options) {
  const unsigned up = up_axis(options);
  ViewSurvey survey(up);
  std::string first_file;
  std::size_t particles = 0;
  const int code = for_chosen_frames(options.frames, [&](const ChosenFrame& chosen) {
    if (first_file.empty())
      first_file = chosen.frame.location.file;
    survey.add(chosen.frame, chosen.set);
    for (const std::string& fault : chosen.frame.unreadable)
      if (!fault.empty())
        report_warning(fault + "; the column is left out", fault);
    particles += chosen.set.particles.size();
  });
  if (code != exit_good)
    return code;
  ViewSettings settings;
  settings.title =
      options.title.empty() ? std::filesystem::path(first_file).filename().string() : options.title;
  settings.colour_by = colour_of_page(options, survey);
  settings.up = up;
  settings.has_contacts = !options.no_contacts;
  settings.has_forces = !options.contacts.files.empty();
  fill_colours(settings);
  add_walls(options, first_file, settings);
  ViewPage page(survey, settings);
  ContactLists lists(options.contacts);
  const int second = for_chosen_frames(options.frames, [&](const ChosenFrame& chosen) {
    page.add(chosen.frame, chosen.set, contacts_of(options, lists, chosen), seconds_of(chosen));
  });
  if (second != exit_good)
    return second;
  const std::string html = page.html();
  write_text(options.output, html);
  say_sizes(options, survey, page, particles, html.size());
  return exit_good;
}

} // namespace

void add_view_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<ViewOptions>();
  options->frames.frames = "all";
  CLI::App* command = program.add_subcommand(
      "view", "one web page in which a run can be turned, played, cut and read");
  command->footer(
      "The page needs a browser with WebGL2 (any of 2023 or later) and nothing else: no "
      "network, no server, no other file. Bodies are drawn exactly, pixel by pixel.");
  add_frame_options(*command, options->frames, FrameUse::one_series);
  command->add_option("--output,-o", options->output, "file name, ends in .html")
      ->required()
      ->check(check_by([](const std::string& name) {
        if (std::filesystem::path(name).extension() != ".html")
          throw InputError("'" + name + "' does not end in .html");
      }));
  add_up_option(*command, options->up);
  command->add_option("--title", options->title, "words above the picture")
      ->default_str("name of the first file");
  command
      ->add_option(
          "--colour,--color", options->colour_by,
          "column that the page opens with: speed, spin, angle, tilt, type, or one of the file")
      ->default_str("speed");
  CLI::Option* log = add_run_surface_options(*command, options->surfaces);
  auto* no_walls = command->add_flag("--no-walls", options->no_walls, "without the log's walls");
  no_walls->excludes(log);
  auto* no_contacts =
      command->add_flag("--no-contacts", options->no_contacts, "without contacts: smaller, faster");
  add_force_list_options(*command, options->contacts, "force chains and forces to read", "shown");
  no_contacts->excludes("--contacts");
  command->callback([options, &exit_code] { exit_code = write_view(*options); });
}

} // namespace ellipsoid::post
