// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "film_frames.h"

#include "contacts.h"
#include "messages.h"
#include "particle_colours.h"

#include <algorithm>
#include <fmt/format.h>
#include <sys/stat.h>

namespace ellipsoid::post {
namespace {

/// A pipe is empty when it has been read.
void require_files(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    struct stat status {};
    const bool is_pipe =
        name == "-" || (stat(name.c_str(), &status) == 0 && !S_ISREG(status.st_mode));
    if (is_pipe)
      throw InputError(name +
                       ": all frames of a film are looked at before the first picture, which a "
                       "pipe cannot give: give --view (and --colour-range), or a file");
  }
}

} // namespace

FilmRange film_range(const FrameOptions& frames, const AddToFilm& add) {
  require_files(frames.runs);
  FilmRange range;
  const MuteMessages mute; // the second reading says it
  for_chosen_frames(frames, [&](const ChosenFrame& chosen) {
    if (!chosen.set.particles.empty())
      add(range, chosen);
  });
  return range;
}

void widen(FilmRange& range, const PileView& view) {
  if (!range.plane)
    range.plane = view;
  range.plane =
      PileView{std::min(range.plane->left, view.left), std::max(range.plane->right, view.right),
               std::min(range.plane->bottom, view.bottom), std::max(range.plane->top, view.top)};
}

void widen(FilmRange& range, const ParticleSet& set) {
  for (const Particle& p : set.particles) {
    const double reach = bounding_radius(set, p);
    const double centre[3] = {p.centre.x, p.centre.y, p.centre.z};
    const bool is_first = !range.space;
    if (is_first)
      range.space = Box();
    for (std::size_t k = 0; k < 3; ++k) {
      double &lower = range.space->lower[k], &upper = range.space->upper[k];
      lower = is_first ? centre[k] - reach : std::min(lower, centre[k] - reach);
      upper = is_first ? centre[k] + reach : std::max(upper, centre[k] + reach);
    }
  }
}

void widen_colours(FilmRange& range, const ChosenFrame& chosen, const std::string& colour_by) {
  const ParticleColours colours = particle_colours(chosen.frame, chosen.set, colour_by, {}, {});
  if (!colours.has_scale || !colours.kinds.empty())
    return;
  range.low = std::min(range.low.value_or(colours.low), colours.low);
  range.high = std::max(range.high.value_or(colours.high), colours.high);
}

bool is_empty_of_film(const FrameOptions& frames, const ChosenFrame& chosen) {
  if (frames.frames != "all" || !chosen.set.particles.empty())
    return false;
  report_warning(fmt::format("{}: the frame of time step {} holds no particles: no picture of it",
                             chosen.run, chosen.frame.timestep));
  return true;
}

} // namespace ellipsoid::post
