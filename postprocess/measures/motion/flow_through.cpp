// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "flow_through.h"

#include "bed.h"
#include "body_properties.h"

#include <algorithm>
#include <cmath>

namespace ellipsoid::post {
namespace {

/// Unit quaternion that turns `axis` to z.
Quaternion turning_to_z(const Vector3& axis) {
  if (axis.z < -1.0 + 1.0e-12)
    return {0.0, 1.0, 0.0, 0.0};
  const Vector3 z{0.0, 0.0, 1.0}, turn = cross(axis, z);
  return normalized(Quaternion{1.0 + axis.z, turn.x, turn.y, turn.z});
}

/// Share of the union of a body's spheres with dot(normal, r - point) > 0.
double share_of_spheres(const ParticleSet& set, const Particle& particle, const Vector3& point,
                        const Vector3& normal) {
  const Rotation3 turn = rotation(turning_to_z(normal));
  ParticleSet alone; // turned so that the normal is z
  double low = 1.0e300, high = -1.0e300;
  for (std::size_t k = 0; k < particle.sphere_count; ++k) {
    const Sphere& s = set.spheres[particle.first_sphere + k];
    alone.spheres.push_back({turn.to_space(s.centre - point), s.radius});
    low = std::min(low, alone.spheres.back().centre.z - s.radius);
    high = std::max(high, alone.spheres.back().centre.z + s.radius);
  }
  if (low >= 0.0 || high <= 0.0)
    return low >= 0.0 ? 1.0 : 0.0;
  Particle body = particle;
  body.first_sphere = 0;
  body.centre = turn.to_space(particle.centre - point);
  // sections are looked for within the semi-axes about the centre
  const double reach = std::max(high - body.centre.z, body.centre.z - low);
  body.semiaxes = {reach, reach, reach};
  alone.particles.push_back(body);
  BedRegion region;
  const double wide = 4.0 * (high - low) + 4.0 * reach;
  region.x0 = body.centre.x - wide;
  region.x1 = body.centre.x + wide;
  region.y0 = body.centre.y - wide;
  region.y1 = body.centre.y + wide;
  constexpr int planes = 200;
  region.z0 = low;
  region.z1 = 0.0;
  const double below = bed_porosity(alone, region, planes).solid_volume;
  region.z0 = 0.0;
  region.z1 = high;
  const double beyond = bed_porosity(alone, region, planes).solid_volume;
  return beyond / (below + beyond);
}

} // namespace

double share_beyond(const ParticleSet& set, const Particle& particle, const Vector3& point,
                    const Vector3& normal) {
  if (!particle.is_smooth())
    return share_of_spheres(set, particle, point, normal);
  // mapped to the unit ball the plane is this far beyond the centre
  const Vector3 n = rotation(particle.orientation).to_body(normal);
  const Vector3& s = particle.semiaxes;
  const double reach = norm(Vector3{s.x * n.x, s.y * n.y, s.z * n.z});
  const double h = dot(point - particle.centre, normal) / reach;
  if (h >= 1.0 || h <= -1.0)
    return h >= 1.0 ? 0.0 : 1.0;
  return 0.25 * (1.0 - h) * (1.0 - h) * (2.0 + h); // cap of the unit ball over 4 pi / 3
}

namespace {

constexpr double rounding = 1.0e-9; // of a length

std::array<double, 3> shares_of(const Vector3& point, const PeriodicCell& cell) {
  const Vector3 f = cell.fractions(point);
  return {f.x, f.y, f.z};
}

/// Sums of whole numbers of edges, each within its bounds.
std::vector<Vector3> images_between(const std::array<double, 3>& first,
                                    const std::array<double, 3>& last, const PeriodicCell& cell) {
  std::vector<Vector3> images{Vector3{}};
  for (std::size_t k = 0; k < 3; ++k) {
    if (!cell.is_periodic(k))
      continue;
    std::vector<Vector3> more;
    for (const Vector3& image : images)
      for (double n = first[k]; n <= last[k]; n += 1.0)
        more.push_back(image + n * cell.edge(k));
    images = std::move(more);
  }
  return images;
}

/// All images of a way, from one that begins in the box, that may come to where a gate lies.
std::vector<Vector3> images_at(const SharesOfEdges& gate, const Vector3& begin, const Vector3& way,
                               const PeriodicCell& cell) {
  const auto from = shares_of(begin, cell), to = shares_of(begin + way, cell);
  std::array<double, 3> first{}, last{};
  for (std::size_t k = 0; k < 3; ++k) {
    first[k] = std::ceil(gate.least[k] - std::max(from[k], to[k]) - rounding);
    last[k] = std::floor(gate.greatest[k] - std::min(from[k], to[k]) + rounding);
  }
  return images_between(first, last, cell);
}

/// The images of a way that come through the box: where it begins, where it ends, and between.
std::vector<Vector3> images_on_the_way(const Vector3& around, const PeriodicCell& cell) {
  std::array<double, 3> first{}, last{};
  const auto edges = shares_of(cell.corner() + around, cell);
  for (std::size_t k = 0; k < 3; ++k) {
    first[k] = std::min(0.0, std::round(edges[k]));
    last[k] = std::max(0.0, std::round(edges[k]));
  }
  return images_between(first, last, cell);
}

/// Crossings of a way with an endless plane; images of it that lie in each other count once.
std::vector<GateCrossing> plane_crossings(const FlowGate& gate, const Vector3& begin,
                                          const Vector3& way, const Vector3& around,
                                          const PeriodicCell& cell) {
  std::vector<GateCrossing> passed;
  std::vector<double> planes;
  for (const Vector3& image : images_on_the_way(around, cell)) {
    const double plane = dot(image, gate.normal);
    if (std::any_of(planes.begin(), planes.end(), [&](double known) {
          return std::abs(plane - known) <= rounding * norm(around);
        }))
      continue;
    planes.push_back(plane);
    for (const GateCrossing& crossing : crossings(gate, begin + image, begin + image + way))
      passed.push_back(crossing);
  }
  return passed;
}

} // namespace

/// Adds what one particle's way from frame to frame contributes to a step.
void FlowThrough::move(const Particle& particle, const State& before, const State& now, double mass,
                       const PeriodicCell& cell, FlowStep& step) const {
  const Vector3 straight = now.centre - before.centre, way = steps_.way(before.place, now.place);
  steps_.count_long(way, step.long_steps);
  const Vector3 around = straight - way; // the box, from the image at the start to that at the end
  std::vector<GateCrossing> passed;
  if (!gate_.is_bounded())
    passed = plane_crossings(gate_, before.centre, way, around, cell);
  else
    for (const Vector3& image : images_at(shares_, before.centre, way, cell))
      for (const GateCrossing& crossing :
           crossings(gate_, before.centre + image, before.centre + image + way))
        passed.push_back(crossing);
  const bool goes_around = norm(around) > rounding * norm(straight);
  if (goes_around && std::abs(dot(around, gate_.normal)) > rounding * norm(around))
    step.volume_share_mass.reset();
  int net = 0;
  for (const GateCrossing& crossing : passed)
    net += crossing.direction;
  step.several_times += std::abs(net) > 1 && steps_.goes_around(way) ? 1 : 0;
  if (net != 0) {
    (net > 0 ? step.forward : step.backward) += 1;
    (net > 0 ? step.mass_forward : step.mass_backward) += mass;
    const auto last = std::max_element(passed.begin(), passed.end(),
                                       [net](const GateCrossing& a, const GateCrossing& b) {
                                         return a.direction * net < b.direction * net ||
                                                (a.direction == b.direction && a.share < b.share);
                                       });
    step.passages.push_back(
        {particle.id, net > 0, mass, last->share, last->position, last->normal, way});
  }
  if (step.volume_share_mass && (gate_.holds(now.centre) || gate_.holds(before.centre)))
    *step.volume_share_mass += mass * (now.beyond - before.beyond);
}

std::optional<FlowStep> FlowThrough::advance(const ParticleSet& set, const PeriodicCell& cell,
                                             const std::optional<double>& density) {
  FlowStep step;
  if (gate_.triangles.empty())
    step.volume_share_mass = 0.0;
  steps_.advance(set, cell);
  shares_ = shares_of_edges(gate_, cell);
  std::map<std::int64_t, State> states;
  for (const Particle& p : set.particles) {
    if (!density)
      set.has_masses.require_readable();
    if (!density && !(p.mass > 0.0))
      throw InputError("a flow needs a column \"mass\" with masses > 0, or --density");
    const double mass = density ? *density * body_volume(set, p) : p.mass;
    State state{cell.wrapped(p.centre), steps_.place(p), 0.0};
    if (gate_.triangles.empty())
      state.beyond = share_beyond(set, p, gate_.point + (p.centre - state.centre), gate_.normal);
    if (const auto before = states_.find(p.id); before != states_.end()) {
      move(p, before->second, state, mass, cell, step);
      states_.erase(before);
    } else {
      ++step.appeared;
      step.fresh.push_back(p.id);
    }
    states[p.id] = state;
  }
  step.vanished = states_.size();
  states_ = std::move(states);
  if (has_frame_)
    return step;
  has_frame_ = true;
  return {};
}

} // namespace ellipsoid::post
