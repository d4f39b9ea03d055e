// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "body_properties.h"
#include "field_blocks.h"
#include "field_points.h"
#include "field_rows.h"
#include "force_list_options.h"
#include "frame_loop.h"
#include "frame_options.h"
#include "long_tables.h"
#include "option_checks.h"
#include "step_names.h"
#include "time_option.h"

#include <algorithm>
#include <map>
#include <memory>

namespace ellipsoid::post {
namespace {

const std::map<std::string, CoarseGrainingShape> shape_of_word = {
    {"gaussian", CoarseGrainingShape::gaussian},
    {"lucy", CoarseGrainingShape::lucy},
    {"wendland", CoarseGrainingShape::wendland},
    {"heaviside", CoarseGrainingShape::heaviside}};

struct FieldsOptions {
  FrameOptions frames;
  FieldPointOptions points;
  ForceListOptions forces;
  std::string kernel = "gaussian", vti;
  double width = 0.0, density = 0.0, time_step = 0.0;
  bool is_average = false, has_errors = false;
};

/// A width for the first frame: the mean radius of the balls of the particles' volumes.
double usual_width(const ParticleSet& set) {
  double sum = 0.0;
  for (const Particle& p : set.particles)
    sum += volume_radius(body_volume(set, p));
  return sum / static_cast<double>(set.particles.size());
}

/// No contact of a particle is farther from its centre than this (length).
double longest_way(const ParticleSet& set) {
  double longest = 0.0;
  for (const Particle& p : set.particles)
    longest = std::max(longest, p.largest_axis());
  return 2.0 * longest;
}

/// Fields of the frames, one after the other or averaged.
class FieldFrames {
 public:
  explicit FieldFrames(const FieldsOptions& options)
      : options_(options), lists_(options.forces), blocks_(options.has_errors) {}

  void add(const ChosenFrame& chosen) {
    if (chosen.set.particles.empty())
      throw InputError("there are no particles");
    if (!points_)
      begin(chosen);
    const PeriodicCell cell(chosen.set.box);
    FieldOptions material;
    if (options_.density > 0.0)
      material.density = options_.density;
    const std::vector<ForceContact> contacts = lists_.at(chosen.frame.timestep, chosen.set, cell);
    const auto targets = points_->targets(*function_, cell, longest_way(chosen.set));
    add_frame(*targets, chosen.set, contacts, cell, material);
    const std::vector<FieldSums> sums = points_->gathered(targets->sums());
    has_motion_ = has_motion_ && chosen.set.has_velocities;
    has_spins_ = has_spins_ && chosen.set.has_spins;
    if (!options_.is_average) {
      Row row = frame_row(chosen);
      append_time(row, chosen.frame, options_.time_step);
      write_frame(row, sums, chosen.frame.timestep);
      return;
    }
    if (blocks_.frames() == 0)
      row_ = frame_row(chosen);
    last_step_ = chosen.frame.timestep;
    blocks_.add(sums);
  }

  /// With --average: adds the rows of the mean over all frames so far.
  void add_mean() {
    if (blocks_.frames() == 0)
      return;
    row_.push_back({"last_timestep", "last time step", "", last_step_});
    row_.push_back({"frames", "frames", "", static_cast<std::int64_t>(blocks_.frames())});
    std::vector<FieldSums> means;
    for (std::size_t n = 0; n < blocks_.points(); ++n)
      means.push_back(blocks_.mean(n));
    write_frame(row_, means, last_step_);
  }

  const std::string& title() const { return title_; }
  const RowStore& all() const { return all_; }
  const RowStore& main() const { return main_; }

 private:
  void begin(const ChosenFrame& chosen) {
    const double width = options_.width > 0.0 ? options_.width : usual_width(chosen.set);
    function_.emplace(shape_of_word.at(options_.kernel), width);
    points_.emplace(options_.points, chosen.set.box, width);
    if (!options_.vti.empty() && !points_->is_grid())
      throw InputError("--vti needs --grid");
    title_ = "Fields (" + options_.kernel + ", width " + shown(Value(width)) + " m)";
  }

  KnownFields known() const {
    const ForceListOptions& lists = options_.forces;
    return {has_motion_, has_spins_, lists.is_given(), !lists.walls.empty(),
            !lists.contact_columns.normals.empty() || !lists.wall_columns.normals.empty()};
  }

  void write_frame(const Row& begin, const std::vector<FieldSums>& sums, std::int64_t timestep) {
    std::vector<Fields> fields;
    for (std::size_t n = 0; n < sums.size(); ++n) {
      fields.push_back(fields_of(sums[n]));
      Row row = begin;
      row.push_back({"width_m", "width", "m", function_->width()});
      const Row& point = points_->row(n);
      row.insert(row.end(), point.begin(), point.end());
      Row few = begin;
      few.insert(few.end(), point.begin(), point.end());
      append_fields(row, fields.back(), known(), points_->component_names());
      if (options_.has_errors)
        append_field_errors(row, known(), points_->component_names(), errors_at(n));
      append_main_fields(few, row, points_->component_names());
      all_.add(row);
      main_.add(few);
    }
    if (options_.vti.empty())
      return;
    ImageData image = points_->image();
    image.values = grid_values(fields, known());
    write_text(name_with_step(options_.vti, timestep), vti_text(image));
  }

  /// Standard errors of all numbers of the fields at a point; empty for less than two frames.
  std::vector<double> errors_at(std::size_t point) const {
    return blocks_.standard_errors(
        point, [this](const FieldSums& sums) { return field_numbers(fields_of(sums), known()); });
  }

  const FieldsOptions& options_;
  ForceLists lists_;
  std::optional<CoarseGrainingFunction> function_;
  std::optional<FieldPoints> points_;
  bool has_motion_ = true, has_spins_ = true;
  std::int64_t last_step_ = 0;
  Row row_; ///< of the first frame
  FieldBlocks blocks_;
  std::string title_; ///< of the table for people
  RowStore all_, main_;
};

int run(const FieldsOptions& options) {
  FieldFrames fields(options);
  const int code =
      for_chosen_frames(options.frames, [&](const ChosenFrame& chosen) { fields.add(chosen); });
  fields.add_mean();
  write_rows(options.frames, fields.title(), fields.all(), fields.main());
  return code;
}

void refuse_options_without_effect(const CLI::App& command, const FieldsOptions& options) {
  if (options.points.profile.empty())
    refuse_without_effect(command, {"--slices"}, "without --profile");
  if (options.points.profile != "radius")
    refuse_without_effect(command, {"--cylinder", "--axis"}, "without --profile radius");
  if (!options.points.at.empty())
    refuse_without_effect(command, {"--box"}, "with --at");
  if (options.points.profile == "radius")
    refuse_without_effect(command, {"--box"}, "with --profile radius");
  if (options.is_average)
    refuse_without_effect(command, {"--dt"}, "with --average");
  if (options.frames.frames != "all")
    refuse_without_effect(command, {"--average"}, "without --frame all");
}

} // namespace

void add_fields_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<FieldsOptions>();
  CLI::App* command = program.add_subcommand(
      "fields", "coarse-grained density, velocity, temperature, stress, couple stress and fabric");
  command->footer(
      "Every particle is smeared out by a function phi of width w with integral 1: density = sum "
      "of m phi(r - r_i), and so on (Goldhirsch 2010). Contact stress: f b times the mean of phi "
      "over the way b from the contact to the centre, on either side; at walls the rest is the "
      "boundary force (Weinhart et al. 2012). Stresses are positive in compression. Means over "
      "frames (--average) are means of the sums; fluctuations are taken about the mean velocity. "
      "Standard errors: jackknife over 20 to 40 blocks of frames (fewer frames: one each).");
  add_frame_options(*command, options->frames, FrameUse::rows);
  add_time_option(*command, options->time_step);
  add_field_point_options(*command, options->points);
  command
      ->add_option("--kernel", options->kernel, "function: gaussian, lucy, wendland or heaviside")
      ->check(CLI::IsMember({"gaussian", "lucy", "wendland", "heaviside"}))
      ->capture_default_str();
  command
      ->add_option("--width", options->width,
                   "w of the function (default: mean radius of balls of the particles' volumes)")
      ->check(CLI::PositiveNumber);
  command->add_option("--density", options->density, "of the material, for files without masses")
      ->check(CLI::PositiveNumber);
  auto* average =
      command->add_flag("--average", options->is_average, "one result: the mean over all frames");
  command
      ->add_flag("--standard-errors", options->has_errors,
                 "with the standard errors of the means, from blocks of frames")
      ->needs(average);
  add_force_list_options(*command, options->forces);
  command->add_option("--vti", options->vti,
                      "file for ParaView with the fields on the grid; * stands for the time step");
  command->callback([command, options, &exit_code] {
    refuse_options_without_effect(*command, *options);
    exit_code = run(*options);
  });
}

} // namespace ellipsoid::post
