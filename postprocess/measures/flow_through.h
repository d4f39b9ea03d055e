// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// What passes a plane, a disc or the triangles of a face between the frames of a run.
#pragma once

#include "particles.h"
#include "periodic_cell.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace ellipsoid::post {

/// Where particles are counted. Forward is the way of the normal (of triangles: the right hand).
struct FlowGate {
  Vector3 point, normal{0.0, 0.0, 1.0};          ///< of the plane; normal: unit
  std::optional<double> radius;                  ///< of a disc about the point (length)
  std::vector<std::array<Vector3, 3>> triangles; ///< if any: instead of plane and disc
};

/// What passed between two frames.
struct FlowStep {
  std::size_t forward = 0, backward = 0;          ///< particles, by their centres
  double mass_forward = 0.0, mass_backward = 0.0; ///< of these
  /// By the share of each body's volume beyond the plane, net; none through triangles, and where
  /// a body came around the box.
  std::optional<double> volume_share_mass;
  std::size_t appeared = 0, vanished = 0; ///< particles that the other frame does not have
};

/// Share of a body's volume beyond a plane (0 to 1). Exact for ellipsoids; of spheres from plane
/// sections of their union.
double share_beyond(const ParticleSet& set, const Particle& particle, const Vector3& point,
                    const Vector3& normal);

/// Follows particles by their ids. Between two frames they move along straight lines, by less than
/// half of an edge that repeats.
class FlowThrough {
 public:
  explicit FlowThrough(FlowGate gate) : m_gate(std::move(gate)) {}

  /// The next frame. The first one gives nothing.
  /// Throws InputError without masses, where `density` is none.
  std::optional<FlowStep> take(const ParticleSet& set, const PeriodicCell& cell,
                               const std::optional<double>& density);

 private:
  struct State {
    Vector3 centre;
    double beyond = 0.0; ///< share of the volume
  };
  int crossing(const Vector3& from, const Vector3& to) const;
  void move(const Particle& particle, const State& before, const State& now, double mass,
            const PeriodicCell& cell, FlowStep& step) const;
  bool lies_in_gate(const Vector3& centre) const;

  FlowGate m_gate;
  bool m_has_frame = false;
  std::map<std::int64_t, State> m_states;
};

} // namespace ellipsoid::post
