// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// What passes a plane, a disc or the triangles of a face between the frames of a run.
#pragma once

#include "flow_gate.h"
#include "frame_steps.h"

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace ellipsoid::post {

/// A particle that passed a gate.
struct Passage {
  std::int64_t id = 0;
  bool is_forward = true;
  double mass = 0.0;
  double share = 0.0; ///< of the time between the two frames
  Vector3 position;   ///< of its centre, as it passed (length)
  Vector3 normal;     ///< of the gate there, forward (unit)
  Vector3 way;        ///< from frame to frame (length)
};

/// What passed between two frames.
struct FlowStep {
  std::size_t forward = 0, backward = 0;          ///< particles, by their centres
  double mass_forward = 0.0, mass_backward = 0.0; ///< of these
  /// By the share of each body's volume beyond the plane, net; none through triangles, and where
  /// a body came around the box.
  std::optional<double> volume_share_mass;
  std::size_t appeared = 0, vanished = 0; ///< particles that the other frame does not have
  LongSteps long_steps;                   ///< see FrameSteps
  std::size_t several_times = 0;          ///< particles that passed more than once, counted once
  std::vector<std::int64_t> fresh;        ///< ids of those that appeared
  std::vector<Passage> passages;          ///< one for each particle that passed
};

/// Share of a body's volume beyond a plane (0 to 1). Exact for ellipsoids; of spheres from plane
/// sections of their union.
double share_beyond(const ParticleSet& set, const Particle& particle, const Vector3& point,
                    const Vector3& normal);

/// Follows particles by their ids. Between two frames they move along straight lines, by less than
/// half of an edge that repeats, unless their positions are unwrapped.
class FlowThrough {
 public:
  explicit FlowThrough(FlowGate gate) : gate_(std::move(gate)) {}

  /// The next frame. The first one gives nothing.
  /// Throws InputError without masses, where `density` is none.
  std::optional<FlowStep> advance(const ParticleSet& set, const PeriodicCell& cell,
                                  const std::optional<double>& density);

 private:
  struct State {
    Vector3 centre;      ///< in the box
    Vector3 place;       ///< see FrameSteps
    double beyond = 0.0; ///< share of the volume
  };
  void move(const Particle& particle, const State& before, const State& now, double mass,
            const PeriodicCell& cell, FlowStep& step) const;

  FlowGate gate_;
  SharesOfEdges shares_; ///< where the gate lies in the last frame's box
  FrameSteps steps_;
  bool has_frame_ = false;
  std::map<std::int64_t, State> states_;
};

} // namespace ellipsoid::post
