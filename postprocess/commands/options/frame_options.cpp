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

/// Sizes and sub-spheres where the file does not say them.
void add_size_options(CLI::App& command, ParticleOptions& particles) {
  command
      .add_option("--semiaxes", particles.semiaxes,
                  "a b c of all particles, for files without sizes")
      ->expected(3)
      ->check(CLI::PositiveNumber);
  command
      .add_option("--subspheres", particles.subspheres,
                  "number N of sub-spheres of all particles, for files without f_subspheres")
      ->check(CLI::Range(0, largest_sphere_count));
  command
      .add_option_function<std::string>(
          "--spacing",
          [&particles](const std::string& word) {
            particles.spacing = sphere_spacing_from_word(word);
          },
          "spacing of these sub-spheres: " + words_of_spacings() + " (default: paper)")
      ->check(check_by([](const std::string& word) { sphere_spacing_from_word(word); }));
  command
      .add_option(
          "--clump", particles.clumps,
          "NUMBER=FILE: the spheres of clump NUMBER (f_spacing 1000 + NUMBER), from the file "
          "that its template read, or wrote")
      ->expected(1)
      ->allow_extra_args(false)
      ->take_all();
  command
      .add_option(
          "--size-scale", particles.size_scale,
          "factor on all sizes of the file (0.5 where it holds whole axes); default: 1, for "
          "LAMMPS's names 0.5")
      ->check(CLI::PositiveNumber);
}

/// What columns and the box mean where the file does not say it.
void add_column_options(CLI::App& command, ParticleOptions& particles) {
  command
      .add_option_function<std::vector<std::string>>(
          "--column",
          [&particles](const std::vector<std::string>& assignments) {
            for (const std::string& assignment : assignments)
              add_column_name(particles.columns, assignment);
          },
          "NAME=COLUMN: the file's COLUMN is what the table of columns calls NAME; once for each "
          "column")
      ->expected(1)
      ->allow_extra_args(false)
      ->take_all()
      ->check(check_by([](const std::string& assignment) {
        ColumnNames names;
        add_column_name(names, assignment);
      }));
  command.add_option(
      "--bodies", particles.bodies,
      "column whose values > 0 join rows to rigid bodies of spheres, or none; default: "
      "id_multisphere");
  command
      .add_option("--periodic", particles.periodic,
                  "axes along which the box repeats (x, xy, xyz ...) or none; default: as the file "
                  "says (VTK files do not)")
      ->check(CLI::IsMember({"none", "x", "y", "z", "xy", "xz", "yz", "xyz"}));
}

void add_thread_option(CLI::App& command, FrameOptions& options) {
  command
      .add_option("--threads", options.threads,
                  "frames measured at the same time with --frame all (0: one per processor)")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  command.parse_complete_callback([&command, &options] {
    if (options.frames != "all")
      refuse_without_effect(command, {"--threads"}, "without --frame all");
  });
}

} // namespace

void add_frame_options(CLI::App& command, FrameOptions& options, FrameUse use) {
  command
      .add_option(
          "runs", options.runs,
          "dump files (compressed too, \"-\": standard input); files that differ only in their "
          "time step are one run, and so is a quoted pattern 'dump.*'; every other file is a run")
      ->required();
  auto* one_run = command.add_flag("--one-run", options.one_run, "all files together are one run");
  options.takes_one_run = use == FrameUse::one_series;
  if (!options.takes_one_run)
    command.add_flag("--each-file", options.each_file, "every file is a run of its own")
        ->excludes(one_run);
  command.add_option("--frame", options.frames, "last, first, all, or the time step of one frame")
      ->check(CLI::Validator(check_frames, "FRAME"))
      ->capture_default_str();
  add_size_options(command, options.particles);
  add_column_options(command, options.particles);
  if (use == FrameUse::table)
    add_thread_option(command, options);
  if (use == FrameUse::table || use == FrameUse::rows)
    add_output_options(command, options);
  if (use == FrameUse::page)
    add_table_file_options(command, options);
}

} // namespace ellipsoid::post
