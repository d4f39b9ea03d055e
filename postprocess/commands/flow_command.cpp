// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "flow_through.h"
#include "frame_loop.h"
#include "frame_options.h"
#include "spread.h"
#include "stl_mesh.h"
#include "time_option.h"

#include <memory>

namespace ellipsoid::post {
namespace {

struct FlowOptions {
  FrameOptions frames;
  std::vector<double> plane, disc;
  std::string face;
  double scale = 1.0, density = 0.0, time_step = 0.0;
  bool is_total = false;
};

FlowGate gate_of(const FlowOptions& options) {
  FlowGate gate;
  if (!options.face.empty()) {
    gate.triangles = read_stl(options.face);
    for (auto& triangle : gate.triangles)
      for (Vector3& corner : triangle)
        corner *= options.scale;
    return gate;
  }
  const std::vector<double>& p = options.plane.empty() ? options.disc : options.plane;
  gate.point = {p[0], p[1], p[2]};
  gate.normal = {p[3], p[4], p[5]};
  if (!(norm(gate.normal) > 0.0))
    throw InputError("the normal of the plane or disc has length 0");
  gate.normal = normalized(gate.normal);
  if (options.disc.empty())
    return gate;
  gate.radius = options.disc[6];
  if (!(*gate.radius > 0.0))
    throw InputError("--disc needs a radius > 0");
  return gate;
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
      : m_options(options), m_name(std::move(name)), m_flow(gate_of(options)) {
    m_sum.volume_share_mass = 0.0;
  }
  const std::string& name() const { return m_name; }

  void take(const ChosenFrame& chosen, Table& table) {
    const std::optional<double> density =
        m_options.density > 0.0 ? std::optional<double>(m_options.density) : std::nullopt;
    const auto step = m_flow.take(chosen.set, PeriodicCell(chosen.set.box), density);
    const std::optional<double> before = m_time;
    m_time = time_of(chosen.frame, m_options.time_step);
    m_timestep = chosen.frame.timestep;
    if (!step) {
      m_first_time = m_time;
      return;
    }
    add(*step);
    Value rate;
    if (before && m_time && *m_time > *before) {
      m_rates.push_back((step->mass_forward - step->mass_backward) / (*m_time - *before));
      rate = m_rates.back();
    }
    if (m_options.is_total)
      return;
    Row row = frame_row(chosen);
    append_time(row, chosen.frame, m_options.time_step);
    append_counts(row, *step);
    row.push_back({"mass_so_far_kg", "net mass so far", "kg", net_mass()});
    row.push_back({"rate_kg_per_s", "rate", "kg/s", rate});
    table.rows.push_back(std::move(row));
  }

  /// The whole run.
  Row total_row() const {
    Row row{{"run", "run", "", m_name}, {"timestep", "last time step", "", m_timestep}};
    append_counts(row, m_sum);
    if (!m_first_time || !m_time || !(*m_time > *m_first_time))
      return row;
    row.push_back({"duration_s", "duration", "s", *m_time - *m_first_time});
    row.push_back({"rate_kg_per_s", "mean rate", "kg/s", net_mass() / (*m_time - *m_first_time)});
    row.push_back({"rate_standard_deviation_kg_per_s", "standard deviation between frames", "kg/s",
                   spread_of(m_rates).standard_deviation});
    return row;
  }

 private:
  double net_mass() const { return m_sum.mass_forward - m_sum.mass_backward; }

  void add(const FlowStep& step) {
    m_sum.forward += step.forward;
    m_sum.backward += step.backward;
    m_sum.mass_forward += step.mass_forward;
    m_sum.mass_backward += step.mass_backward;
    m_sum.appeared += step.appeared;
    m_sum.vanished += step.vanished;
    if (m_sum.volume_share_mass && step.volume_share_mass)
      *m_sum.volume_share_mass += *step.volume_share_mass;
    else
      m_sum.volume_share_mass.reset();
  }

  const FlowOptions& m_options;
  std::string m_name;
  FlowThrough m_flow;
  std::optional<double> m_time, m_first_time; ///< of the last and first frame (s)
  std::int64_t m_timestep = 0;
  FlowStep m_sum;
  std::vector<double> m_rates; ///< between frames (mass/s)
};

int run(const FlowOptions& options) {
  Table table{"Flow", {}};
  std::unique_ptr<FlowRun> flow;
  const auto end_run = [&] {
    if (flow && options.is_total)
      table.rows.push_back(flow->total_row());
  };
  const int code = for_chosen_frames(options.frames, [&](const ChosenFrame& chosen) {
    if (!flow || flow->name() != chosen.run) {
      end_run();
      flow = std::make_unique<FlowRun>(options, chosen.run);
    }
    flow->take(chosen, table);
  });
  end_run();
  write_table(options.frames, table);
  return code;
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
      "normal. Rows: steps between frames; --total: the whole run, with the mean rate and its "
      "standard deviation between frames.");
  add_frame_options(*command, options->frames);
  add_time_option(*command, options->time_step);
  CLI::Option_group* gate = command->add_option_group("gate");
  gate->add_option("--through", options->plane, "plane: x y z of a point, and its normal nx ny nz")
      ->expected(6);
  gate->add_option("--disc", options->disc, "x y z of the middle, normal nx ny nz, radius")
      ->expected(7);
  auto* face = gate->add_option("--face", options->face,
                                "STL file; forward is the way of its triangles' normals");
  gate->require_option(1);
  command->add_option("--scale", options->scale, "factor on the lengths of the STL file")
      ->check(CLI::PositiveNumber)
      ->capture_default_str()
      ->needs(face);
  command->add_option("--density", options->density, "of the material, for files without masses")
      ->check(CLI::PositiveNumber);
  command->add_flag("--total", options->is_total, "one row for the whole run");
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

} // namespace ellipsoid::post
