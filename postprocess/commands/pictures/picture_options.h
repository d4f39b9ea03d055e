// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "frame_loop.h"
#include "frame_options.h"
#include "pile_picture.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace ellipsoid::post {

/// Refuses names of pictures that end neither in .svg nor in .png.
CLI::Validator picture_name_check();

/// Options --colour and --colour-range.
void add_colour_options(CLI::App& command, std::string& colour_by, std::vector<double>& range);

/// Names of the pictures of a command: the asterisk of a pattern becomes the time step, with ten
/// digits, so that the names of a film are in the order of time.
class PictureNames {
 public:
  explicit PictureNames(std::string pattern) : pattern_(std::move(pattern)) {}
  /// Throws InputError for a name that has been given already: nothing is overwritten.
  std::string next(const ChosenFrame& chosen);
  bool has_given() const { return !given_.empty(); }

 private:
  std::string pattern_;
  std::set<std::string> given_;
};

/// A message for a name without an asterisk for all frames of a run, or nothing.
std::string film_name_problem(const FrameOptions& frames, const std::string& name);

/// The exit code of a command that made pictures of all its frames: an error if there was none.
int checked_code(int code, const PictureNames& names);

/// Warns where --view shows no particle. @param[in] axes 2: x and y count, 3: z too
void warn_of_empty_view(const std::string& run, const ParticleSet& set, const Box& view,
                        std::size_t axes);

/// Time of a frame (s): of the file, or of its step and the log beside it.
std::optional<double> seconds_of(const ChosenFrame& chosen);

/// Words above a picture that has no other title.
std::string frame_title(const ChosenFrame& chosen);

/// Writes the picture of one frame. Throws InputError.
void write_pile_picture(const std::string& name, const ChosenFrame& chosen, const Pile& pile,
                        const PileOptions& pile_options, const std::vector<ReposeAngle>& flanks,
                        const PilePictureOptions& options);

} // namespace ellipsoid::post
