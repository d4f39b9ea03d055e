// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "collisions.h"
#include "contact_list_options.h"
#include "frame_clock.h"
#include "frame_loop.h"
#include "frame_options.h"
#include "messages.h"
#include "option_checks.h"
#include "particle_values.h"
#include "time_option.h"
#include "trajectories.h"

#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <memory>
#include <optional>

namespace ellipsoid::post {
namespace {

struct TrajectoryOptions {
  FrameOptions frames;
  std::size_t origins = 1, apart = 1;
  double time_step = 0.0;
  bool lists_collisions = false;
  ContactListOptions contacts;
  std::string per_particle;
};

/// Ways and rotations of every particle since it was first seen; no columns of rotations where the
/// file tells those of no particle.
void write_ways(const TrajectoryOptions& options, const ChosenFrame& chosen,
                const Trajectories& trajectories) {
  std::vector<ParticleValues> columns{{"way_x_m", {}},        {"way_y_m", {}},
                                      {"way_z_m", {}},        {"rotation_x_rad", {}},
                                      {"rotation_y_rad", {}}, {"rotation_z_rad", {}}};
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  bool any_turn = false;
  for (const Particle& p : chosen.set.particles) {
    const Vector3 way = trajectories.way(p.id);
    const std::optional<Vector3> known = trajectories.rotation_vector(p.id);
    any_turn = any_turn || known.has_value();
    const Vector3 turn = known.value_or(Vector3{unknown, unknown, unknown});
    const double values[] = {way.x, way.y, way.z, turn.x, turn.y, turn.z};
    for (std::size_t k = 0; k < columns.size(); ++k)
      columns[k].values.push_back(values[k]);
  }
  if (!any_turn)
    columns.resize(3);
  write_particle_values(options.per_particle, chosen, columns);
}

/// One run: its frames, and its rows.
struct FollowedRun {
  std::string name;
  Trajectories trajectories;
  std::vector<std::optional<double>> times; ///< of the frames (s)
  std::vector<std::int64_t> steps;
  FrameClock clock;
};

/// A lag is a number of frames: from every origin it must be the same time.
void require_even_frames(const FollowedRun& run) {
  constexpr double rounding = 1e-6; // six digits of a time in the file
  const auto moment = [&run](std::size_t k) {
    return run.times[k] && run.times[0] ? *run.times[k] : static_cast<double>(run.steps[k]);
  };
  for (std::size_t k = 2; k < run.steps.size(); ++k) {
    const double first = moment(1) - moment(0), here = moment(k) - moment(k - 1);
    if (std::abs(here - first) > 1e-3 * first + rounding * std::abs(moment(k)))
      throw InputError(fmt::format(
          "{}: with several --origins frames must be evenly spaced in time, found time steps {} "
          "and {} after {} and {}: take --origins 1, or leave frames out",
          run.name, run.steps[k - 1], run.steps[k], run.steps[0], run.steps[1]));
  }
}

Row lag_row(const FollowedRun& run, std::size_t lag) {
  const LagMeans m = run.trajectories.means(lag);
  Row row{{"run", "run", "", run.name}, {"lag_frames", "lag, frames", "", std::int64_t(lag)}};
  row.push_back({"lag_timesteps", "lag, time steps", "", run.steps[lag] - run.steps[0]});
  Value diffusion;
  const double squared =
      m.squared_displacement.x + m.squared_displacement.y + m.squared_displacement.z;
  if (run.times[lag] && run.times[0]) {
    const double lag_time = *run.times[lag] - *run.times[0];
    row.push_back({"lag_s", "lag", "s", lag_time});
    if (lag_time > 0.0 && m.pairs > 0)
      diffusion = squared / (6.0 * lag_time);
    row.push_back({"diffusion_m2_per_s", "MSD / 6 lag", "m2/s", diffusion});
  }
  const auto add = [&row](const std::string& key, const std::string& name, const std::string& unit,
                          const Value& value) {
    row.push_back({key, name, unit, value});
  };
  const auto known = [](double value, std::size_t count) {
    return count > 0 ? Value(value) : Value();
  };
  row.push_back({"pairs", "particles and origins", "", static_cast<std::int64_t>(m.pairs)});
  const auto add_mean = [&](const std::string& key, const std::string& name,
                            const std::string& unit,
                            double value) { add(key, name, unit, known(value, m.pairs)); };
  add_mean("displacement_x_m", "mean displacement x", "m", m.displacement.x);
  add_mean("displacement_y_m", "mean displacement y", "m", m.displacement.y);
  add_mean("displacement_z_m", "mean displacement z", "m", m.displacement.z);
  add_mean("msd_m2", "mean square displacement", "m2", squared);
  add_mean("msd_x_m2", "MSD along x", "m2", m.squared_displacement.x);
  add_mean("msd_y_m2", "MSD along y", "m2", m.squared_displacement.y);
  add_mean("msd_z_m2", "MSD along z", "m2", m.squared_displacement.z);
  add("rotation_squared_rad2", "mean square rotation", "rad2",
      known(m.squared_rotation, m.rotations));
  add("direction_correlation", "u(0).u(t)", "", known(m.direction, m.directions));
  add("direction_correlation_p2", "P2(u(0).u(t))", "", known(m.direction_p2, m.directions));
  return row;
}

/// Bodies that are left out of the means of rotations, of the first lag.
void warn_of_unknown_turns(const FollowedRun& run) {
  if (run.trajectories.sums().empty())
    return;
  const LagMeans& first = run.trajectories.sums().begin()->second;
  if (first.rotations < first.pairs)
    report_warning(fmt::format("{}: the file does not tell how {} of {} particles turn (spheres "
                               "without a quaternion, chains of the host's spheres about their "
                               "axis): they are left out of the mean square rotation",
                               run.name, first.pairs - first.rotations, first.pairs),
                   run.name + " unknown turns");
}

Row collision_row(const std::string& run, const Collision& c, bool has_overlaps) {
  Row row{{"run", "run", "", run}};
  row.push_back({"id_1", "id 1", "", c.id_1});
  row.push_back({"id_2", "id 2", "", c.id_2});
  row.push_back({"begin_s", "begin", "s", c.begin});
  row.push_back({"duration_s", "duration", "s", c.end - c.begin});
  row.push_back({"normal_speed_m_per_s", "speed of approach", "m/s", c.normal_speed});
  row.push_back({"tangential_speed_m_per_s", "tangential speed", "m/s", c.tangential_speed});
  row.push_back({"departure_speed_m_per_s", "speed of departure", "m/s", c.departure_speed});
  row.push_back({"largest_overlap_m", "largest overlap", "m",
                 has_overlaps ? Value(c.largest_overlap) : Value()});
  return row;
}

/// The table of all collisions; what is not whole is counted on standard error.
int list_collisions(const TrajectoryOptions& options) {
  Table table{"Collisions", {}};
  std::string name;
  auto collisions = std::make_unique<Collisions>();
  FrameClock clock;
  ContactLists lists(options.contacts);
  const bool has_overlaps =
      options.contacts.files.empty() || !options.contacts.columns.overlap.empty();
  const auto end_run = [&] {
    if (!name.empty())
      fmt::print(stderr, "{}: {} pairs touched from the start, {} touch at the end\n", name,
                 collisions->from_the_start(), collisions->not_ended());
  };
  const int code = for_chosen_frames(options.frames, [&](const ChosenFrame& chosen) {
    const std::optional<double> time = time_of(chosen.frame, options.time_step);
    if (!time)
      throw InputError("--collisions needs times, which the file does not state: give --dt");
    if (chosen.run != name) {
      end_run();
      name = chosen.run;
      collisions = std::make_unique<Collisions>();
      clock = {};
    }
    if (!clock.advances(chosen))
      return;
    const std::vector<TouchingPair> pairs =
        options.contacts.files.empty()
            ? touching_pairs(chosen.set)
            : listed_pairs(lists.at(chosen.frame.timestep), options.contacts.columns, chosen.set);
    for (const Collision& c : collisions->advance(chosen.set, pairs, *time))
      table.rows.push_back(collision_row(name, c, has_overlaps));
  });
  end_run();
  if (code == exit_good)
    table.columns = collision_row("", {}, has_overlaps);
  write_table(options.frames, table);
  return code;
}

int run(const TrajectoryOptions& options) {
  if (options.lists_collisions)
    return list_collisions(options);
  std::vector<FollowedRun> runs;
  const int code = for_chosen_frames(options.frames, [&](const ChosenFrame& chosen) {
    if (runs.empty() || runs.back().name != chosen.run)
      runs.push_back({chosen.run, Trajectories(options.origins, options.apart), {}, {}, {}});
    FollowedRun& followed = runs.back();
    if (!followed.clock.advances(chosen))
      return;
    followed.trajectories.add(chosen.set, PeriodicCell(chosen.set.box));
    followed.times.push_back(time_of(chosen.frame, options.time_step));
    followed.steps.push_back(chosen.frame.timestep);
    if (!options.per_particle.empty())
      write_ways(options, chosen, followed.trajectories);
  });
  Table table{"Trajectories", {}};
  for (const FollowedRun& followed : runs) {
    warn_of_long_steps(followed.name, followed.trajectories.long_steps());
    warn_of_unknown_turns(followed);
    if (options.origins > 1)
      require_even_frames(followed);
    for (const auto& entry : followed.trajectories.sums())
      table.rows.push_back(lag_row(followed, entry.first));
  }
  write_table(options.frames, table);
  return code;
}

/// Contact lists in place of contacts that are recomputed.
void add_collision_list_options(CLI::App& command, ContactListOptions& options,
                                CLI::Option* collisions) {
  auto* lists = add_contact_list_options(command, options, "collisions are those of the lists");
  lists->needs(collisions);
  command
      .add_option("--point-columns", options.columns.points,
                  "of the contact list: x y z of the contact point (default: between the centres)")
      ->expected(3)
      ->needs(lists);
  command
      .add_option("--normal-columns", options.columns.normals,
                  "of the contact list: x y z of the normal (default: from centre to centre)")
      ->expected(3)
      ->needs(lists);
  command
      .add_option("--overlap-column", options.columns.overlap, "of the contact list: the overlap")
      ->needs(lists);
}

} // namespace

void add_trajectory_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<TrajectoryOptions>();
  options->frames.frames = "all";
  CLI::App* command = program.add_subcommand(
      "trajectory",
      "mean square displacement and rotation over time, ways of particles, collisions");
  command->footer(
      "Particles are followed by their ids, through periodic boundaries; between two frames they "
      "must move less than half of a repeating edge and turn less than half a turn. Rows: lags "
      "between an origin and later frames, means over particles and origins. MSD: mean of |r(t) - "
      "r(0)|^2; rotation: mean square of the summed angle vectors; u: the longest semi-axis.");
  add_frame_options(*command, options->frames, FrameUse::rows);
  add_time_option(*command, options->time_step);
  command
      ->add_option("--origins", options->origins,
                   "frames from which lags are counted, the first ones")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  command->add_option("--apart", options->apart, "frames from one origin to the next")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  add_particle_values_option(*command, options->per_particle);
  auto* collisions =
      command->add_flag("--collisions", options->lists_collisions,
                        "lists the collisions of pairs instead: duration and relative velocity");
  add_collision_list_options(*command, options->contacts, collisions);
  command->callback([command, options, &exit_code] {
    if (options->lists_collisions)
      refuse_without_effect(*command, {"--origins", "--apart", "--per-particle"},
                            "with --collisions");
    else if (options->origins == 1)
      refuse_without_effect(*command, {"--apart"}, "with one of --origins");
    exit_code = run(*options);
  });
}

} // namespace ellipsoid::post
