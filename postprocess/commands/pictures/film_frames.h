// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// What the pictures of a film share: one part of space, one range of colours.
#pragma once

#include "frame_loop.h"
#include "pile_picture.h"

#include <functional>
#include <optional>
#include <string>

namespace ellipsoid::post {

/// What all frames together take.
struct FilmRange {
  std::optional<PileView> plane;   ///< around the piles in the plane
  std::optional<Box> space;        ///< around the particles in space
  std::optional<double> low, high; ///< of the colours
};

/// Adds one frame to what is shared.
using AddToFilm = std::function<void(FilmRange&, const ChosenFrame&)>;

/// Goes through all frames once, without messages; those without particles are left out.
/// Throws InputError for runs that can be read once only (pipes).
FilmRange film_range(const FrameOptions& frames, const AddToFilm& add);

void widen(FilmRange& range, const PileView& view);
/// By the particles' bounding balls.
void widen(FilmRange& range, const ParticleSet& set);
/// By the scale of the colours; nothing for kinds and one colour.
void widen_colours(FilmRange& range, const ChosenFrame& chosen, const std::string& colour_by);

/// Whether a frame of a film is to be left out, with a remark: it holds no particles.
bool is_empty_of_film(const FrameOptions& frames, const ChosenFrame& chosen);

} // namespace ellipsoid::post
