// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "body_properties.h"
#include "field_blocks.h"
#include "field_points.h"
#include "field_rows.h"
#include "force_list_options.h"
#include "frame_loop.h"
#include "frame_options.h"
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

/// Longest way from a particle's centre to a contact that can be (length).
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
      : m_options(options), m_lists(options.forces), m_blocks(options.has_errors) {}

  void add(const ChosenFrame& chosen) {
    if (chosen.set.particles.empty())
      throw InputError("there are no particles");
    if (!m_points)
      begin(chosen);
    const PeriodicCell cell(chosen.set.box);
    FieldOptions material;
    if (m_options.density > 0.0)
      material.density = m_options.density;
    const std::vector<ForceContact> contacts = m_lists.at(chosen.frame.timestep, chosen.set, cell);
    const auto targets = m_points->targets(*m_function, cell, longest_way(chosen.set));
    add_frame(*targets, chosen.set, contacts, cell, material);
    const std::vector<FieldSums> sums = m_points->gathered(targets->sums());
    m_has_motion = m_has_motion && chosen.set.has_velocities;
    m_has_spins = m_has_spins && chosen.set.has_spins;
    if (!m_options.is_average) {
      Row row = frame_row(chosen);
      append_time(row, chosen.frame, m_options.time_step);
      write_frame(row, sums, chosen.frame.timestep);
      return;
    }
    if (m_blocks.frames() == 0)
      m_row = frame_row(chosen);
    m_last_step = chosen.frame.timestep;
    m_blocks.add(sums);
  }

  /// Of all frames so far: the rows of their mean, with --average.
  void add_mean() {
    if (m_blocks.frames() == 0)
      return;
    m_row.push_back({"last_timestep", "last time step", "", m_last_step});
    m_row.push_back({"frames", "frames", "", static_cast<std::int64_t>(m_blocks.frames())});
    std::vector<FieldSums> means;
    for (std::size_t n = 0; n < m_blocks.points(); ++n)
      means.push_back(m_blocks.mean(n));
    write_frame(m_row, means, m_last_step);
  }

  const Table& all() const { return m_all; }
  const Table& main() const { return m_main; }

 private:
  void begin(const ChosenFrame& chosen) {
    const double width = m_options.width > 0.0 ? m_options.width : usual_width(chosen.set);
    m_function.emplace(shape_of_word.at(m_options.kernel), width);
    m_points.emplace(m_options.points, chosen.set.box, width);
    if (!m_options.vti.empty() && !m_points->is_grid())
      throw InputError("--vti needs --grid");
    m_main.title = "Fields (" + m_options.kernel + ", width " + shown(Value(width)) + " m)";
  }

  KnownFields known() const {
    const ForceListOptions& lists = m_options.forces;
    return {m_has_motion, m_has_spins, lists.is_given(), !lists.walls.empty(),
            !lists.contact_columns.normals.empty() || !lists.wall_columns.normals.empty()};
  }

  void write_frame(const Row& begin, const std::vector<FieldSums>& sums, std::int64_t timestep) {
    std::vector<Fields> fields;
    for (std::size_t n = 0; n < sums.size(); ++n) {
      fields.push_back(fields_of(sums[n]));
      Row row = begin;
      row.push_back({"width_m", "width", "m", m_function->width()});
      const Row& point = m_points->row(n);
      row.insert(row.end(), point.begin(), point.end());
      Row few = begin;
      few.insert(few.end(), point.begin(), point.end());
      append_fields(row, fields.back(), known(), m_points->component_names());
      if (m_options.has_errors)
        append_field_errors(row, known(), m_points->component_names(), errors_at(n));
      append_main_fields(few, row, m_points->component_names());
      m_all.rows.push_back(std::move(row));
      m_main.rows.push_back(std::move(few));
    }
    if (m_options.vti.empty())
      return;
    ImageData image = m_points->image();
    image.values = grid_values(fields, known());
    write_text(name_with_step(m_options.vti, timestep), vti_text(image));
  }

  /// Of all numbers of the fields at a point; empty for less than two frames.
  std::vector<double> errors_at(std::size_t point) const {
    return m_blocks.standard_errors(
        point, [this](const FieldSums& sums) { return field_numbers(fields_of(sums), known()); });
  }

  const FieldsOptions& m_options;
  ForceLists m_lists;
  std::optional<CoarseGrainingFunction> m_function;
  std::optional<FieldPoints> m_points;
  bool m_has_motion = true, m_has_spins = true;
  std::int64_t m_last_step = 0;
  Row m_row; ///< of the first frame
  FieldBlocks m_blocks;
  Table m_all{"Fields", {}}, m_main;
};

int run(const FieldsOptions& options) {
  FieldFrames fields(options);
  const int code =
      for_chosen_frames(options.frames, [&](const ChosenFrame& chosen) { fields.add(chosen); });
  fields.add_mean();
  if (prints_text(options.frames) && !fields.main().rows.empty())
    write_text("-", as_text(fields.main()));
  OutputOptions files = options.frames;
  files.quiet = true;
  write_table(files, fields.all());
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
  command->add_option("--kernel", options->kernel, "function: gaussian, lucy or heaviside")
      ->check(CLI::IsMember({"gaussian", "lucy", "heaviside"}))
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
