// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Showing particles in space: pictures, and files for ParaView.
#include "frame_loop.h"
#include "frame_options.h"
#include "picture_options.h"
#include "space_picture.h"
#include "template_files.h"
#include "upright_options.h"

#include <fmt/format.h>
#include <memory>

namespace ellipsoid::post {
namespace {

struct RenderSpaceOptions {
  FrameOptions frames;
  SpaceView view;
  std::string up = "z", colour_by, output, title;
  std::vector<double> colour_range, part;
  bool is_bare = false;
};

/// The view, with the part that is to be seen turned upright.
SpaceView view_of(const RenderSpaceOptions& options) {
  SpaceView view = options.view;
  if (options.part.size() != 6)
    return view;
  view.part = Box();
  for (unsigned k = 0; k < 3; ++k) {
    const unsigned from = options.up == "y" ? (k + 2) % 3 : k; // as upright() turns the axes
    view.part->lower[k] = options.part[2 * from];
    view.part->upper[k] = options.part[2 * from + 1];
    if (!(view.part->lower[k] < view.part->upper[k]))
      throw InputError("--view needs x0 < x1, y0 < y1 and z0 < z1");
  }
  return view;
}

void render_space(const RenderSpaceOptions& options, const ChosenFrame& chosen) {
  std::optional<double> low, high;
  if (options.colour_range.size() == 2) {
    low = options.colour_range[0];
    high = options.colour_range[1];
  }
  const auto colours = particle_colours(chosen.frame, chosen.set, options.colour_by, low, high);
  const ParticleSet set = upright(chosen.set, options.up);
  const SpaceView view = view_of(options);
  const std::string name = name_with_step(options.output, chosen.frame.timestep);
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
  add_frame_options(*command, options->frames);
  add_up_option(*command, options->up);
  command->add_option("--output,-o", options->output, "file name, ends in .png or .svg")
      ->required()
      ->check(picture_name_check());
  add_camera_options(*command, options->view);
  command->add_option("--colour,--color", options->colour_by,
                      "colour by a column of the file, or by angle or speed");
  command->add_option("--colour-range", options->colour_range, "ends of the colour scale")
      ->expected(2);
  command
      ->add_option("--view", options->part,
                   "x0 x1 y0 y1 z0 z1: fits this part of the space into the picture")
      ->expected(6);
  command->add_option("--title", options->title, "words above the picture");
  command->add_flag("--bare", options->is_bare, "PNG of the particles alone, no words and scales");
  command->callback([options, &exit_code] {
    exit_code = for_chosen_frames(options->frames,
                                  [&](const ChosenFrame& f) { render_space(*options, f); });
  });
}

} // namespace ellipsoid::post
