// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "frame_loop.h"
#include "frame_options.h"
#include "pile_picture.h"

#include <set>
#include <string>

namespace ellipsoid::post {

/// Refuses names of pictures that end neither in .svg nor in .png.
CLI::Validator picture_name_check();

/// Names of the pictures of a command: the asterisk of a pattern becomes the time step, with ten
/// digits, so that the names of a film are in the order of time.
class PictureNames {
 public:
  explicit PictureNames(std::string pattern) : pattern_(std::move(pattern)) {}
  /// Throws InputError for a name that has been given already: nothing is overwritten.
  std::string next(const ChosenFrame& chosen);

 private:
  std::string pattern_;
  std::set<std::string> given_;
};

/// A message for a name without an asterisk for all frames of a run, or nothing.
std::string film_name_problem(const FrameOptions& frames, const std::string& name);

/// Words above a picture that has no other title.
std::string frame_title(const ChosenFrame& chosen);

/// Writes the picture of one frame. Throws InputError.
void write_pile_picture(const std::string& name, const ChosenFrame& chosen, const Pile& pile,
                        const PileOptions& pile_options, const std::vector<ReposeAngle>& flanks,
                        const PilePictureOptions& options);

} // namespace ellipsoid::post
