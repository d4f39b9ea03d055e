// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "frame_loop.h"
#include "frame_options.h"
#include "pile_picture.h"

namespace ellipsoid::post {

/// Refuses names of pictures that end neither in .svg nor in .png.
CLI::Validator picture_name_check();

/// A name with the time step in the place of its asterisk: ten digits, so that the names of a film
/// are in the order of time.
std::string name_with_step(const std::string& path, std::int64_t step);

/// Words above a picture that has no other title.
std::string frame_title(const ChosenFrame& chosen);

/// Writes the picture of one frame; `path` may hold an asterisk, which becomes the time step.
/// Throws InputError.
void write_pile_picture(const std::string& path, const ChosenFrame& chosen, const Pile& pile,
                        const PileOptions& pile_options, const std::vector<ReposeAngle>& flanks,
                        const PilePictureOptions& options);

} // namespace ellipsoid::post
