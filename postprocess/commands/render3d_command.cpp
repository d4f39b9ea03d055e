// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Showing particles in space: pictures, and files for ParaView.
#include "film_frames.h"
#include "frame_loop.h"
#include "frame_options.h"
#include "gravity_options.h"
#include "messages.h"
#include "option_checks.h"
#include "picture_options.h"
#include "render_space.h"
#include "space_picture.h"
#include "template_files.h"

#include <fmt/format.h>
#include <memory>

namespace ellipsoid::post {
namespace {

/// The view, with the part that is to be seen turned upright.
SpaceView view_of(const RenderSpaceOptions& options, UpAxis up) {
  SpaceView view = options.view;
  if (options.part.size() != 6)
    return view;
  view.part = Box();
  for (unsigned k = 0; k < 3; ++k) {
    const unsigned from = up == UpAxis::y ? (k + 2) % 3 : k; // as turned_upright() does
    view.part->lower[k] = options.part[2 * from];
    view.part->upper[k] = options.part[2 * from + 1];
  }
  return view;
}

/// The walls and meshes of a run, turned upright as turned_upright() turns particles.
void add_surfaces(SpaceView& view, const RenderSpaceOptions& options, const ChosenFrame& chosen,
                  UpAxis up) {
  if (!options.show_walls && options.surfaces.meshes.empty() && options.surfaces.log.empty())
    return;
  const RunSurfaces surfaces = run_surfaces(options.surfaces, chosen.frame.location.file,
                                            !options.show_walls && options.surfaces.log.empty());
  const bool is_turned = up == UpAxis::y;
  for (const PrimitivePlane& plane : surfaces.planes)
    view.planes.push_back({is_turned ? (plane.axis + 1) % 3 : plane.axis, plane.position});
  for (const ShownMesh& mesh : surfaces.meshes)
    for (auto triangle : mesh.triangles) {
      for (Vector3& corner : triangle)
        if (is_turned)
          corner = {corner.z, corner.x, corner.y};
      view.triangles.push_back(triangle);
    }
}

/// What all frames of a film take, as far as the user does not say it.
FilmRange shared_range(const RenderSpaceOptions& options) {
  const bool needs_view = options.part.empty();
  const bool needs_colours = options.colour_range.empty() && !options.colour_by.empty();
  if (options.frames.frames != "all" || (!needs_view && !needs_colours))
    return {};
  return film_range(options.frames, [&](FilmRange& range, const ChosenFrame& chosen) {
    if (needs_view)
      widen(range, turned_upright(chosen.set, up_direction(options.up, chosen).axis));
    if (needs_colours)
      widen_colours(range, chosen, options.colour_by);
  });
}

void render_space(const RenderSpaceOptions& options, PictureNames& names, const FilmRange& range,
                  const ChosenFrame& chosen) {
  if (is_empty_of_film(options.frames, chosen))
    return;
  std::optional<double> low = range.low, high = range.high;
  if (options.colour_range.size() == 2) {
    low = options.colour_range[0];
    high = options.colour_range[1];
  }
  const auto colours = particle_colours(chosen.frame, chosen.set, options.colour_by, low, high);
  const UpAxis up = up_direction(options.up, chosen).axis;
  const ParticleSet set = turned_upright(chosen.set, up);
  SpaceView view = view_of(options, up);
  if (view.part)
    warn_of_empty_view(chosen.run, set, *view.part, 3);
  if (range.space)
    view.part = range.space;
  if (up == UpAxis::y)
    view.axis_names = {"z", "x", "y"};
  add_surfaces(view, options, chosen, up);
  const std::string name = names.next(chosen);
  const PictureFormat format = picture_format(name);
  if (options.is_bare && format != PictureFormat::png)
    throw InputError(name + ": --bare makes a PNG: choose a name that ends in .png");
  if (options.is_bare || (format == PictureFormat::png && !draws_png()))
    write_text(name, png_bytes(draw_space(set, colours.colours, view).image));
  else
    write_text(name, space_picture(format, set, colours, view,
                                   options.title.empty() ? frame_title(chosen) : options.title));
  fmt::print(stderr, "picture: {}\n", name);
  if (colours.has_scale)
    fmt::print(stderr, "colours: {} from {:.4g} to {:.4g}\n", colours.label, colours.low,
               colours.high);
}

} // namespace

int render_spaces(const RenderSpaceOptions& options) {
  if (const std::string problem = film_name_problem(options.frames, options.output);
      !problem.empty()) {
    report_error(problem);
    return exit_bad_usage;
  }
  PictureNames names(options.output);
  const FilmRange range = shared_range(options);
  const int code = for_chosen_frames(options.frames, [&](const ChosenFrame& chosen) {
    render_space(options, names, range, chosen);
  });
  return checked_code(code, names);
}

namespace {

void add_camera_options(CLI::App& command, SpaceView& view) {
  command.add_option("--width", view.width, "pixels")
      ->check(CLI::Range(16, 10000))
      ->capture_default_str();
  command.add_option("--height", view.height, "pixels")
      ->check(CLI::Range(16, 10000))
      ->capture_default_str();
  command.add_option("--azimuth", view.azimuth_deg, "of the camera about the up axis (deg)")
      ->capture_default_str();
  command.add_option("--elevation", view.elevation_deg, "of the camera (deg)")
      ->check(CLI::Range(-90.0, 90.0))
      ->capture_default_str();
  command.add_option("--zoom", view.zoom, "1: everything fits")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

} // namespace

void add_render3d_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<RenderSpaceOptions>();
  CLI::App* command = program.add_subcommand(
      "render3d", "picture of particles in space: shaded ellipsoids or sub-spheres, PNG or SVG");
  command->footer("Parallel projection; every point is an exact intersection of a ray with a body. "
                  "No display and no OpenGL are needed. A film: --frame all -o 'film_*.png', with "
                  "--view and --colour-range so that all frames have the same scale.");
  add_frame_options(*command, options->frames, FrameUse::pictures);
  add_up_option(*command, options->up);
  command->add_option("--output,-o", options->output, "file name, ends in .png or .svg")
      ->required()
      ->check(picture_name_check());
  add_camera_options(*command, options->view);
  add_colour_options(*command, options->colour_by, options->colour_range);
  command
      ->add_option("--view", options->part,
                   "x0 x1 y0 y1 z0 z1: fits this part of the space into the picture")
      ->expected(6);
  command->add_option("--title", options->title, "words above the picture");
  command->add_flag("--show-box", options->view.show_box, "draw the edges of the simulation box");
  command->add_flag("--show-walls", options->show_walls,
                    "draw the plane walls and meshes of the run's log");
  add_run_surface_options(*command, options->surfaces);
  command->add_flag("!--no-axes", options->view.show_axes, "without the arrows along x, y and z");
  command->add_flag("--bare", options->is_bare, "PNG of the particles alone, no words and scales");
  command->callback([command, options, &exit_code] {
    if (options->colour_by.empty())
      refuse_without_effect(*command, {"--colour-range"}, "without --colour");
    if (!options->show_walls)
      refuse_without_effect(*command, {"--log"}, "without --show-walls");
    if (options->is_bare)
      refuse_without_effect(*command,
                            {"--title", "--no-axes", "--show-box", "--show-walls", "--mesh"},
                            "with --bare");
    require_ascending_pairs("--colour-range", options->colour_range);
    require_ascending_pairs("--view", options->part);
    exit_code = render_spaces(*options);
  });
}

} // namespace ellipsoid::post
