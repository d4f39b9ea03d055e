// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "averages/fields_at_particles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ellipsoid {
namespace {

Vector3 least(const Vector3& a, const Vector3& b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
Vector3 greatest(const Vector3& a, const Vector3& b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

void add_product(Tensor& to, double factor, const Vector3& a, const Vector3& b) {
  const double row[] = {factor * a.x, factor * a.y, factor * a.z}, column[] = {b.x, b.y, b.z};
  for (std::size_t k = 0; k < to.size(); ++k)
    to[k] += row[k / 3] * column[k % 3];
}

SpaceBlock block_around(const std::vector<MovingMass>& places, double margin) {
  constexpr double far = std::numeric_limits<double>::max();
  SpaceBlock block{{far, far, far}, {-far, -far, -far}};
  for (const MovingMass& place : places) {
    block.low = least(block.low, place.position);
    block.high = greatest(block.high, place.position);
  }
  const Vector3 around{margin, margin, margin};
  return places.empty() ? SpaceBlock{{1.0, 1.0, 1.0}, {-1.0, -1.0, -1.0}} // holds nothing
                        : SpaceBlock{block.low - around, block.high + around};
}

constexpr std::int64_t most_cells = std::int64_t{1} << 20; // along an axis: a key has 3 x 21 bits

} // namespace

FieldsAtParticles::FieldsAtParticles(const CoarseGrainingFunction& function,
                                     std::vector<MovingMass> places, double longest)
    : function_(function), places_(std::move(places)), sums_(places_.size()),
      reached_(block_around(places_, function.reach())) {
  const Vector3 size = reached_.high - reached_.low;
  edge_ = std::max({function.reach(), longest,
                    std::max({size.x, size.y, size.z}) / static_cast<double>(most_cells)});
  for (std::size_t k = 0; k < places_.size(); ++k)
    places_of_cell_[key_of(cell_of(places_[k].position))].push_back(k);
}

FieldsAtParticles::Cell FieldsAtParticles::cell_of(const Vector3& point) const {
  const auto along = [this](double x, double low, double high) {
    return static_cast<std::int64_t>(std::floor((std::clamp(x, low, high) - low) / edge_));
  };
  return {along(point.x, reached_.low.x, reached_.high.x),
          along(point.y, reached_.low.y, reached_.high.y),
          along(point.z, reached_.low.z, reached_.high.z)};
}

std::uint64_t FieldsAtParticles::key_of(const Cell& cell) {
  std::uint64_t key = 0;
  for (const std::int64_t index : cell)
    key = key << 21U | static_cast<std::uint64_t>(index);
  return key;
}

template <class Action>
void FieldsAtParticles::for_each_place_near(const Vector3& low, const Vector3& high,
                                            const Action& action) const {
  if (places_.empty())
    return;
  const Vector3 around{function_.reach(), function_.reach(), function_.reach()};
  const Cell first = cell_of(low - around), last = cell_of(high + around);
  for (std::int64_t i = first[0]; i <= last[0]; ++i)
    for (std::int64_t j = first[1]; j <= last[1]; ++j)
      for (std::int64_t k = first[2]; k <= last[2]; ++k)
        if (const auto cell = places_of_cell_.find(key_of({i, j, k}));
            cell != places_of_cell_.end())
          for (const std::size_t place : cell->second)
            action(place);
}

void FieldsAtParticles::add(const MovingMass& mass) {
  for_each_place_near(mass.position, mass.position, [&](std::size_t k) {
    const Vector3 way = places_[k].position - mass.position;
    const double squared = dot(way, way), weighted = mass.mass * function_.value(squared);
    if (weighted == 0.0)
      return;
    Sums& sums = sums_[k];
    const Vector3 velocity = mass.velocity - places_[k].velocity;
    const Vector3 gradient = mass.mass * function_.slope_over_distance(squared) * way;
    sums.density += weighted;
    sums.momentum += weighted * velocity;
    add_product(sums.momentum_flux, weighted, velocity, velocity);
    sums.density_gradient += gradient;
    add_product(sums.momentum_gradient, 1.0, velocity, gradient);
  });
}

void FieldsAtParticles::add(const ForceLine& line) {
  const Vector3 way = line.end - line.begin;
  const double length = norm(way);
  if (!(length > 0.0))
    return;
  const Vector3 along = (1.0 / length) * way;
  for_each_place_near(
      least(line.begin, line.end), greatest(line.begin, line.end), [&](std::size_t k) {
        const Vector3 to_place = places_[k].position - line.begin;
        const double foot = dot(to_place, along);
        const Vector3 off = to_place - foot * along;
        const double share = function_.along_line(dot(off, off), -foot, length - foot) / length;
        add_product(sums_[k].contact_stress, -share, line.force, -way);
      });
}

Tensor FieldsAtParticles::stress(std::size_t place) const {
  const Sums& sums = sums_[place];
  Tensor found = sums.contact_stress;
  for (std::size_t k = 0; k < found.size(); ++k)
    found[k] -= sums.momentum_flux[k];
  add_product(found, 1.0 / sums.density, sums.momentum, sums.momentum);
  return found;
}

Tensor FieldsAtParticles::strain_rate(std::size_t place) const {
  const Sums& sums = sums_[place];
  Tensor gradient = sums.momentum_gradient; // of p = rho V; that of V follows
  add_product(gradient, -1.0 / sums.density, sums.momentum, sums.density_gradient);
  Tensor found{};
  for (std::size_t k = 0; k < found.size(); ++k)
    found[k] = 0.5 * (gradient[k] + gradient[k % 3 * 3 + k / 3]) / sums.density;
  return found;
}

} // namespace ellipsoid
