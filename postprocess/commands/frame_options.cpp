// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "frame_options.h"

#include "option_checks.h"

#include <fmt/format.h>

namespace ellipsoid::post {
namespace {

std::string check_frames(const std::string& word) {
  if (word == "last" || word == "first" || word == "all")
    return "";
  if (!word.empty() && word.find_first_not_of("0123456789") == std::string::npos)
    return "";
  return fmt::format("--frame \"{}\": allowed are last, first, all, or a time step", word);
}

/// How columns are understood where the file does not say it.
void add_particle_options(CLI::App& command, FrameOptions& options) {
  command
      .add_option("--semiaxes", options.particles.semiaxes,
                  "a b c of all particles, for files without columns shapex shapey shapez")
      ->expected(3)
      ->check(CLI::PositiveNumber);
  command
      .add_option("--subspheres", options.particles.subspheres,
                  "number N of sub-spheres of all particles, for files without f_subspheres")
      ->check(CLI::Range(0, largest_sphere_count));
  command
      .add_option("--spacing", options.spacing_word,
                  "spacing of these sub-spheres: paper, minimax_outline, minimax_area")
      ->capture_default_str()
      ->check(check_by([&options](const std::string& word) {
        options.particles.spacing = sphere_spacing_from_word(word);
      }));
  command
      .add_option("--size-scale", options.particles.sphere_size_scale,
                  "factor on all sizes of the file (0.5 where it holds diameters)")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

} // namespace

void add_frame_options(CLI::App& command, FrameOptions& options) {
  command
      .add_option(
          "runs", options.runs,
          "dump files (.gz too, \"-\": standard input); files that differ only in their time "
          "step are one run, and so is a quoted pattern 'dump.*'; every other file is a run")
      ->required();
  auto* one_run = command.add_flag("--one-run", options.one_run, "all files together are one run");
  command.add_flag("--each-file", options.each_file, "every file is a run of its own")
      ->excludes(one_run);
  command.add_option("--frame", options.frames, "last, first, all, or the time step of one frame")
      ->check(CLI::Validator(check_frames, "FRAME"))
      ->capture_default_str();
  add_particle_options(command, options);
  command
      .add_option("--threads", options.threads,
                  "frames measured at the same time with --frame all (0: one per processor)")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  add_output_options(command, options);
}

} // namespace ellipsoid::post
