// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "flow_profile.h"
#include "flow_through.h"
#include "frame_clock.h"
#include "frame_loop.h"
#include "frame_options.h"
#include "messages.h"
#include "option_checks.h"
#include "residence_times.h"
#include "spread.h"
#include "stl_mesh.h"
#include "time_option.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <memory>

namespace ellipsoid::post {
namespace {

struct FlowOptions {
  FrameOptions frames;
  std::vector<double> plane, disc, inlet, strips;
  std::string face, passages;
  double scale = 1.0, density = 0.0, time_step = 0.0;
  int profile = 0; ///< rings or strips; 0: none
  bool is_total = false;
};

/// A plane by a point and its normal.
FlowGate plane_gate(const std::vector<double>& p, const char* option) {
  FlowGate gate;
  gate.point = {p[0], p[1], p[2]};
  gate.normal = {p[3], p[4], p[5]};
  if (!(norm(gate.normal) > 0.0))
    throw InputError(std::string(option) + ": the normal has length 0");
  gate.normal = normalized(gate.normal);
  return gate;
}

FlowGate gate_of(const FlowOptions& options) {
  FlowGate gate;
  if (!options.face.empty()) {
    gate.triangles = read_stl(options.face);
    for (auto& triangle : gate.triangles)
      for (Vector3& corner : triangle)
        corner *= options.scale;
    return gate;
  }
  if (options.disc.empty())
    return plane_gate(options.plane, "--through");
  gate = plane_gate(options.disc, "--disc");
  gate.radius = options.disc[6];
  if (!(*gate.radius > 0.0))
    throw InputError("--disc needs a radius > 0");
  return gate;
}

/// Where passages are sorted, if that is asked for.
std::optional<FlowProfile> profile_of(const FlowOptions& options) {
  if (options.profile == 0)
    return {};
  const auto count = static_cast<std::size_t>(options.profile);
  if (options.strips.empty() && options.disc.empty())
    throw InputError("--profile sorts by radius with --disc; else say the direction: --strips");
  if (options.strips.empty()) {
    const std::vector<double>& d = options.disc;
    return FlowProfile::rings({d[0], d[1], d[2]}, d[6], count);
  }
  const std::vector<double>& s = options.strips;
  const Vector3 along{s[0], s[1], s[2]};
  if (!(norm(along) > 0.0) || !(s[3] < s[4]))
    throw InputError("--strips needs a direction that is not 0, and two places in ascending order");
  return FlowProfile::strips(normalized(along), s[3], s[4], count);
}

void append_bin(Row& row, const FlowBin& bin, double duration) {
  const auto mean = [&bin](double value) { return bin.mass > 0.0 ? Value(value) : Value(); };
  const double variance = std::max(0.0, bin.speed_square - bin.speed * bin.speed);
  row.push_back({"begin_m", "from", "m", bin.begin});
  row.push_back({"end_m", "to", "m", bin.end});
  row.push_back({"forward", "particles forward", "", static_cast<std::int64_t>(bin.forward)});
  row.push_back({"backward", "particles backward", "", static_cast<std::int64_t>(bin.backward)});
  row.push_back({"mass_rate_kg_per_s", "net mass rate", "kg/s", bin.net_mass / duration});
  row.push_back({"mass_flux_kg_per_m2_s", "net mass flux", "kg/m2/s",
                 bin.area ? Value(bin.net_mass / duration / *bin.area) : Value()});
  row.push_back({"normal_speed_m_per_s", "speed along the normal", "m/s", mean(bin.speed)});
  row.push_back({"normal_speed_standard_deviation_m_per_s", "its standard deviation", "m/s",
                 mean(std::sqrt(variance))});
  row.push_back({"speed_across_m_per_s", "speed across the normal", "m/s", mean(bin.across)});
}

void append_residence(Row& row, const std::vector<double>& times) {
  const Spread s = spread_of(times);
  const auto known = [&s](double value) { return s.count > 0 ? Value(value) : Value(); };
  row.push_back({"residence_count", "residence times", "", static_cast<std::int64_t>(s.count)});
  row.push_back({"residence_mean_s", "residence time, mean", "s", known(s.mean)});
  row.push_back({"residence_standard_deviation_s", "residence time, standard deviation", "s",
                 known(s.standard_deviation)});
  row.push_back({"residence_shortest_s", "residence time, shortest", "s", known(s.lowest)});
  row.push_back({"residence_longest_s", "residence time, longest", "s", known(s.highest)});
}

void append_counts(Row& row, const FlowStep& step) {
  const auto whole = [](std::size_t n) { return static_cast<std::int64_t>(n); };
  row.push_back({"forward", "particles forward", "", whole(step.forward)});
  row.push_back({"backward", "particles backward", "", whole(step.backward)});
  row.push_back({"mass_forward_kg", "mass forward", "kg", step.mass_forward});
  row.push_back({"mass_backward_kg", "mass backward", "kg", step.mass_backward});
  row.push_back({"mass_by_volume_share_kg", "net mass by volume share", "kg",
                 step.volume_share_mass ? Value(*step.volume_share_mass) : Value()});
  row.push_back({"appeared", "particles that appeared", "", whole(step.appeared)});
  row.push_back({"vanished", "particles that vanished", "", whole(step.vanished)});
}

/// One run's flow, step by step.
class FlowRun {
 public:
  FlowRun(const FlowOptions& options, std::string name)
      : options_(options), name_(std::move(name)), flow_(gate_of(options)),
        profile_(profile_of(options)) {
    if (!options.inlet.empty())
      inlet_.emplace(plane_gate(options.inlet, "--inlet"));
    sum_.volume_share_mass = 0.0;
  }
  const std::string& name() const { return name_; }

  void advance(const ChosenFrame& chosen, Table& steps, Table& passages) {
    if (!clock_.advances(chosen))
      return;
    ++frames_;
    const std::optional<double> density =
        options_.density > 0.0 ? std::optional<double>(options_.density) : std::nullopt;
    const PeriodicCell cell(chosen.set.box);
    const auto step = flow_.advance(chosen.set, cell, density);
    const auto entered = inlet_ ? inlet_->advance(chosen.set, cell, density) : std::nullopt;
    const std::optional<double> before = time_;
    time_ = time_of(chosen.frame, options_.time_step);
    timestep_ = chosen.frame.timestep;
    if (!time_ && (inlet_ || profile_ || !options_.passages.empty()))
      throw InputError(std::string(inlet_     ? "--inlet"
                                   : profile_ ? "--profile"
                                              : "--passages") +
                       " needs times, which the file does not state: give --dt");
    if (!step) {
      first_time_ = time_;
      return;
    }
    ++steps_;
    add(*step);
    const bool has_times = before && time_ && *time_ > *before;
    const std::vector<double> residence =
        has_times ? follow(*step, entered, *before, passages) : std::vector<double>();
    if (has_times)
      rates_.push_back((step->mass_forward - step->mass_backward) / (*time_ - *before));
    if (options_.is_total || profile_)
      return;
    Row row = frame_row(chosen);
    append_time(row, chosen.frame, options_.time_step);
    append_counts(row, *step);
    row.push_back({"mass_so_far_kg", "net mass so far", "kg", net_mass()});
    row.push_back({"rate_kg_per_s", "rate", "kg/s", has_times ? Value(rates_.back()) : Value()});
    if (time_)
      append_residence(row, residence);
    steps.rows.push_back(std::move(row));
  }

  static Row passage_columns() { return passage_row("", {}, 0.0, 1.0, {}); }

  /// After the last frame: the rows of the whole run.
  /// Throws InputError if it has no two frames.
  void append_totals(Table& table) const {
    warn_of_long_steps(name_, sum_.long_steps);
    if (sum_.several_times > 0)
      report_warning(
          fmt::format("{}: {} steps of particles between frames go more than once around "
                      "the box and pass each time, but count once: write frames more "
                      "often",
                      name_, sum_.several_times));
    if (frames_ == 1)
      throw InputError(name_ + ": expected at least two frames, found one: flow is what happens "
                               "between them");
    if (steps_ == 0)
      return; // what is wrong with the frames has been said
    if (profile_)
      append_profile(table);
    else if (options_.is_total)
      table.rows.push_back(total_row());
  }

 private:
  double net_mass() const { return sum_.mass_forward - sum_.mass_backward; }
  bool has_duration() const { return first_time_ && time_ && *time_ > *first_time_; }

  void append_profile(Table& table) const {
    if (!has_duration())
      throw InputError(name_ + ": the last frame is not later than the first one");
    for (const FlowBin& bin : profile_->bins()) {
      Row row{{"run", "run", "", name_}};
      append_bin(row, bin, *time_ - *first_time_);
      table.rows.push_back(std::move(row));
    }
    if (profile_->beyond() > 0)
      report_warning(name_ + ": " + std::to_string(profile_->beyond()) +
                     " particles passed beyond the strips");
  }

  Row total_row() const {
    Row row{{"run", "run", "", name_}, {"timestep", "last time step", "", timestep_}};
    append_counts(row, sum_);
    if (!has_duration())
      return row;
    row.push_back({"duration_s", "duration", "s", *time_ - *first_time_});
    row.push_back({"rate_kg_per_s", "mean rate", "kg/s", net_mass() / (*time_ - *first_time_)});
    row.push_back({"rate_standard_deviation_kg_per_s", "standard deviation between frames", "kg/s",
                   spread_of(rates_).standard_deviation});
    append_residence(row, residence_.times());
    row.push_back({"residence_unknown", "left, not seen to enter", "",
                   static_cast<std::int64_t>(residence_.unknown())});
    return row;
  }

  /// Who entered and who left, between two times. @return residence times of those who left
  std::vector<double> follow(const FlowStep& step, const std::optional<FlowStep>& entered,
                             double before, Table& passages) {
    const double duration = *time_ - before;
    if (!inlet_)
      for (const std::int64_t id : step.fresh)
        residence_.enter(id, *time_);
    if (entered)
      for (const Passage& passage : entered->passages)
        if (passage.is_forward)
          residence_.enter(passage.id, before + passage.share * duration);
    if (profile_)
      profile_->add(step.passages, duration);
    std::vector<double> times;
    for (const Passage& passage : step.passages) {
      const double time = before + passage.share * duration;
      std::optional<double> residence;
      if (passage.is_forward)
        residence = residence_.leave(passage.id, time);
      if (residence)
        times.push_back(*residence);
      if (!options_.passages.empty())
        passages.rows.push_back(passage_row(name_, passage, time, duration, residence));
    }
    return times;
  }

  /// @param[in] run its name
  static Row passage_row(const std::string& run, const Passage& passage, double time,
                         double duration, const std::optional<double>& residence) {
    const Vector3 velocity = (1.0 / duration) * passage.way;
    return {{"run", "run", "", run},
            {"id", "id", "", passage.id},
            {"time_s", "time", "s", time},
            {"direction", "direction", "", std::int64_t(passage.is_forward ? 1 : -1)},
            {"mass_kg", "mass", "kg", passage.mass},
            {"x_m", "x", "m", passage.position.x},
            {"y_m", "y", "m", passage.position.y},
            {"z_m", "z", "m", passage.position.z},
            {"velocity_x_m_per_s", "velocity x", "m/s", velocity.x},
            {"velocity_y_m_per_s", "velocity y", "m/s", velocity.y},
            {"velocity_z_m_per_s", "velocity z", "m/s", velocity.z},
            {"residence_s", "residence time", "s", residence ? Value(*residence) : Value()}};
  }

  void add(const FlowStep& step) {
    sum_.forward += step.forward;
    sum_.backward += step.backward;
    sum_.mass_forward += step.mass_forward;
    sum_.mass_backward += step.mass_backward;
    sum_.appeared += step.appeared;
    sum_.vanished += step.vanished;
    sum_.long_steps += step.long_steps;
    sum_.several_times += step.several_times;
    if (sum_.volume_share_mass && step.volume_share_mass)
      *sum_.volume_share_mass += *step.volume_share_mass;
    else
      sum_.volume_share_mass.reset();
  }

  const FlowOptions& options_;
  std::string name_;
  FrameClock clock_;
  FlowThrough flow_;
  std::optional<FlowThrough> inlet_;
  std::optional<FlowProfile> profile_;
  ResidenceTimes residence_;
  std::optional<double> time_, first_time_; ///< of the last and first frame (s)
  std::int64_t timestep_ = 0;
  std::size_t frames_ = 0, steps_ = 0; ///< read, and measured between two of them
  FlowStep sum_;
  std::vector<double> rates_; ///< between frames (mass/s)
};

int run(const FlowOptions& options) {
  Table table{"Flow", {}}, passages{"Passages", {}, FlowRun::passage_columns()};
  std::unique_ptr<FlowRun> flow;
  int code = exit_good;
  const auto end_run = [&] {
    try {
      if (flow)
        flow->append_totals(table);
    } catch (const InputError& error) {
      report_error(error.what());
      code = exit_bad_data;
    }
  };
  const int read = for_chosen_frames(options.frames, [&](const ChosenFrame& chosen) {
    if (!flow || flow->name() != chosen.run) {
      end_run();
      flow = std::make_unique<FlowRun>(options, chosen.run);
    }
    flow->advance(chosen, table, passages);
  });
  end_run();
  code = std::max(code, read);
  write_table(options.frames, table);
  if (!options.passages.empty() && (code == exit_good || !passages.rows.empty()))
    write_text(options.passages, as_csv(passages));
  return code;
}

void add_gate_options(CLI::App& command, FlowOptions& options) {
  CLI::Option_group* gate = command.add_option_group("gate");
  gate->add_option("--through", options.plane, "plane: x y z of a point, and its normal nx ny nz")
      ->expected(6);
  gate->add_option("--disc", options.disc, "x y z of the middle, normal nx ny nz, radius")
      ->expected(7);
  auto* face = gate->add_option("--face", options.face,
                                "STL file; forward is the way of its triangles' normals");
  gate->require_option(1);
  command.add_option("--scale", options.scale, "factor on the lengths of the STL file")
      ->check(CLI::PositiveNumber)
      ->capture_default_str()
      ->needs(face);
}

/// What is made of single passages.
void add_passage_options(CLI::App& command, FlowOptions& options, CLI::Option* total) {
  command
      .add_option("--inlet", options.inlet,
                  "plane where residence times begin: x y z of a point, and its normal nx ny nz, "
                  "the way in (default: where a particle is first seen)")
      ->expected(6);
  auto* profile = command.add_option(
      "--profile", options.profile,
      "rows are rings of the disc, or strips, of equal width: rates, and speeds of what passes");
  profile->check(CLI::Range(1, 10000))->excludes(total);
  command
      .add_option("--strips", options.strips,
                  "of the profile: direction ux uy uz, and where the strips begin and end along it")
      ->expected(5)
      ->needs(profile);
  command.add_option("--passages", options.passages,
                     "file (.csv) with a row for every passage: time, place, velocity, residence "
                     "time");
}

} // namespace

void add_flow_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<FlowOptions>();
  options->frames.frames = "all";
  CLI::App* command = program.add_subcommand(
      "flow", "mass and number through a plane, a disc or an STL face between frames");
  command->footer(
      "A particle passes when its centre does, along a straight line from frame to frame (the "
      "shortest one in periodic boxes). By volume share: mass times the change of the share of its "
      "volume beyond the plane, so that a body passes little by little. Forward: the way of the "
      "normal. Residence time: from the inlet, or from the first frame that has the particle (but "
      "the run's first one), to its passage forward. Rows: steps between frames; --total: the "
      "whole run, with the mean rate and its standard deviation between frames.");
  add_frame_options(*command, options->frames, FrameUse::rows);
  add_time_option(*command, options->time_step);
  add_gate_options(*command, *options);
  command->add_option("--density", options->density, "of the material, for files without masses")
      ->check(CLI::PositiveNumber);
  auto* total = command->add_flag("--total", options->is_total, "one row for the whole run");
  add_passage_options(*command, *options, total);
  command->callback([command, options, &exit_code] {
    if (options->profile > 0 && options->passages.empty())
      refuse_without_effect(*command, {"--inlet"}, "with --profile and without --passages");
    exit_code = run(*options);
  });
}

} // namespace ellipsoid::post
