// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "contact_list_options.h"
#include "film_frames.h"
#include "frame_loop.h"
#include "frame_options.h"
#include "messages.h"
#include "option_checks.h"
#include "picture_options.h"
#include "pile_measures.h"
#include "plane_options.h"
#include "render_pile.h"

#include <fmt/format.h>
#include <memory>

namespace ellipsoid::post {
namespace {

/// What the user gives stands; what all frames of a film take is found in a reading of its own.
FilmRange shared_range(const RenderOptions& options) {
  const bool needs_view = options.view.empty();
  const bool needs_colours = options.colour_range.empty() && !options.picture.colour_by.empty();
  if (options.frames.frames != "all" || (!needs_view && !needs_colours))
    return {};
  return film_range(options.frames, [&](FilmRange& range, const ChosenFrame& chosen) {
    const PileOptions settings = plane_settings(options.plane);
    if (needs_view)
      widen(range, whole_pile(chosen.set, plane_pile(chosen, settings), settings));
    if (needs_colours)
      widen_colours(range, chosen, options.picture.colour_by);
  });
}

/// A file of pictures, with what they share.
struct PileFilm {
  PictureNames names;
  ContactLists lists;
  FilmRange range;
};

void render(const RenderOptions& options, PileFilm& film, const ChosenFrame& chosen) {
  if (is_empty_of_film(options.frames, chosen))
    return;
  const PileOptions settings = plane_settings(options.plane);
  const Pile pile = plane_pile(chosen, settings);
  PilePictureOptions picture = options.picture;
  picture.show_fit = !options.no_fit;
  picture.view = film.range.plane;
  if (options.view.size() == 4)
    picture.view = PileView{options.view[0], options.view[1], options.view[2], options.view[3]};
  if (options.view.size() == 4)
    warn_of_empty_view(
        chosen.run, chosen.set,
        {{options.view[0], options.view[2]}, {options.view[1], options.view[3]}, "", {}}, 2);
  picture.colour_low = film.range.low;
  picture.colour_high = film.range.high;
  if (options.colour_range.size() == 2) {
    picture.colour_low = options.colour_range[0];
    picture.colour_high = options.colour_range[1];
  }
  if (!options.contacts.files.empty())
    picture.force_chains =
        force_links(film.lists.at(chosen.frame.timestep), options.contacts.columns, chosen.set);
  write_pile_picture(film.names.next(chosen), chosen, pile, settings, try_flanks(pile, settings),
                     picture);
}

} // namespace

int render_piles(const RenderOptions& options) {
  if (const std::string problem = film_name_problem(options.frames, options.output);
      !problem.empty()) {
    report_error(problem);
    return exit_bad_usage;
  }
  PileFilm film{PictureNames(options.output), ContactLists(options.contacts),
                shared_range(options)};
  const int code = for_chosen_frames(
      options.frames, [&](const ChosenFrame& chosen) { render(options, film, chosen); });
  return checked_code(code, film.names);
}

void add_render_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = program.add_subcommand("render", "picture of an in-plane pile, SVG or PNG");
  command->footer(
      "Outlines of ellipses or sub-spheres, wall and floor, the fitted line A-B with "
      "the angle of repose (see repose --help), a scale bar. A film: --frame all "
      "--output 'film_*.png' (the asterisk becomes the time step).\n"
      "Force chains (--contacts): a line between the centres of each touching pair, its "
      "width proportional to the normal force (to the force without --normal-columns), "
      "summed over the pair's contacts.");
  add_frame_options(*command, options->frames, FrameUse::pictures);
  add_plane_options(*command, options->plane);
  add_fit_options(*command, options->plane);
  command->add_option("--output,-o", options->output, "file name, ends in .svg or .png")
      ->required()
      ->check(picture_name_check());
  command->add_option("--width", options->picture.width, "pixels; the height follows")
      ->check(CLI::Range(100, 20000))
      ->capture_default_str();
  add_colour_options(*command, options->picture.colour_by, options->colour_range);
  command->add_option("--view", options->view, "x0 x1 y0 y1: shows this part only")->expected(4);
  command->add_option("--title", options->picture.title, "words above the picture");
  command->add_flag("--no-fit", options->no_fit, "without the line A-B");
  command->add_flag("--surface", options->picture.show_surface, "draw the free surface y_max(x)");
  command->add_flag("--discs", options->picture.show_discs, "draw inner outlines of sub-spheres");
  add_force_list_options(*command, options->contacts, "draws the force chains", "drawn");
  command->callback([command, options, &exit_code] {
    if (options->picture.colour_by.empty())
      refuse_without_effect(*command, {"--colour-range"}, "without --colour");
    if (options->no_fit)
      refuse_without_effect(*command, {"--cut-bottom", "--cut-top"}, "with --no-fit");
    if (options->no_fit && !options->picture.show_surface)
      refuse_without_effect(*command, {"--columns"}, "with --no-fit and without --surface");
    require_ascending_pairs("--colour-range", options->colour_range);
    require_ascending_pairs("--view", options->view);
    exit_code = render_piles(*options);
  });
}

} // namespace ellipsoid::post
