// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "neighbours/size_grids.h"

#include <algorithm>
#include <cmath>

namespace ellipsoid {

namespace {

/// Radii below 2^-15 of the largest are in the class of the smallest ones.
constexpr int largest_class = 15;
/// Grids have no more cells than this for each body.
constexpr std::size_t cells_per_body = 4;
/// Distances that are rounded in another way count as near.
constexpr double rounding = 1e-12;

double component(const Vector3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

int class_of(double radius, double largest) {
  return static_cast<int>(
      std::clamp(std::floor(std::log2(largest / radius)), 0.0, double{largest_class}));
}

Vector3 lower(const Vector3& a, const Vector3& b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
Vector3 upper(const Vector3& a, const Vector3& b) { return -lower(-a, -b); }

} // namespace

bool SizeGrids::are_worthwhile(const double* radii, std::size_t count) {
  if (count == 0)
    return false;
  const auto [least, largest] = std::minmax_element(radii, radii + count);
  return *largest >= 2.0 * *least;
}

/// Of a coordinate (length); those beyond the grid, or not a number, are in its last cells.
int SizeGrids::Grid::index_along(double x, int axis) const {
  const double cells_away = (x - component(low, axis)) / cell;
  return cells_away > 0.0
             ? static_cast<int>(std::min(cells_away, static_cast<double>(cells[axis] - 1)))
             : 0;
}

std::size_t SizeGrids::Grid::cell_of(const Vector3& centre) const {
  const auto x = static_cast<std::size_t>(index_along(centre.x, 0)),
             y = static_cast<std::size_t>(index_along(centre.y, 1)),
             z = static_cast<std::size_t>(index_along(centre.z, 2));
  return x + static_cast<std::size_t>(cells[0]) * (y + static_cast<std::size_t>(cells[1]) * z);
}

/// Makes cells of an edge, or larger ones where bodies are few.
void SizeGrids::Grid::shape(const Vector3& first, const Vector3& last, double edge,
                            std::size_t bodies) {
  low = first;
  cell = edge;
  std::size_t all = 0;
  do {
    all = 1;
    for (int axis : {0, 1, 2}) {
      const double count = std::ceil((component(last, axis) - component(first, axis)) / cell);
      cells[axis] = count > 1.0 && std::isfinite(count)
                        ? static_cast<int>(std::min(count, 1e6)) // coarser next time
                        : 1;
      all *= static_cast<std::size_t>(cells[axis]);
    }
    cell *= 1.26; // twice the volume
  } while (all > cells_per_body * bodies + 64);
  cell /= 1.26;
  begins.assign(all + 1, 0);
}

void SizeGrids::Grid::sort_in(const std::vector<int>& numbers, const std::vector<Body>& bodies) {
  const auto cell_of_body = [this, &bodies](int number) {
    return cell_of(bodies[static_cast<std::size_t>(number)].centre);
  };
  for (const int number : numbers)
    ++begins[cell_of_body(number) + 1];
  for (std::size_t k = 1; k < begins.size(); ++k)
    begins[k] += begins[k - 1];
  std::vector<std::uint32_t> next(begins.begin(), begins.end() - 1);
  members.resize(numbers.size());
  for (const int number : numbers)
    members[next[cell_of_body(number)]++] = {bodies[static_cast<std::size_t>(number)], number};
}

void SizeGrids::build(const double* centres, const double* radii, std::size_t count,
                      const Reach& reach) {
  reach_ = reach;
  grids_.clear();
  bodies_.clear();
  if (count == 0)
    return;
  const double largest = *std::max_element(radii, radii + count);
  std::vector<std::vector<int>> classes(largest_class + 1);
  Vector3 first{centres[0], centres[1], centres[2]}, last = first;
  bodies_.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    bodies_.push_back({{centres[3 * k], centres[3 * k + 1], centres[3 * k + 2]}, radii[k]});
    first = lower(first, bodies_[k].centre);
    last = upper(last, bodies_[k].centre);
    classes[static_cast<std::size_t>(class_of(radii[k], largest))].push_back(static_cast<int>(k));
  }
  for (const std::vector<int>& numbers : classes) {
    if (numbers.empty())
      continue;
    grids_.emplace_back();
    Grid& grid = grids_.back();
    for (const int number : numbers)
      grid.largest_radius =
          std::max(grid.largest_radius, bodies_[static_cast<std::size_t>(number)].radius);
    grid.shape(first, last, grid.largest_radius * reach.factor + 0.5 * reach.skin, numbers.size());
    grid.sort_in(numbers, bodies_);
  }
}

const std::vector<int>& SizeGrids::find(int i) {
  near_.clear();
  for (const Grid& grid : grids_)
    find_in(grid, i, bodies_[static_cast<std::size_t>(i)]);
  return near_;
}

void SizeGrids::find_in(const Grid& grid, int i, const Body& own) {
  const double way =
      (1.0 + rounding) * (reach_.factor * (own.radius + grid.largest_radius) + reach_.skin);
  int first[3], last[3];
  for (int axis : {0, 1, 2}) {
    first[axis] = grid.index_along(component(own.centre, axis) - way, axis);
    last[axis] = grid.index_along(component(own.centre, axis) + way, axis);
  }
  const auto row = [&grid](int y, int z) {
    return static_cast<std::size_t>(grid.cells[0]) *
           (static_cast<std::size_t>(y) +
            static_cast<std::size_t>(grid.cells[1]) * static_cast<std::size_t>(z));
  };
  for (int z = first[2]; z <= last[2]; ++z)
    for (int y = first[1]; y <= last[1]; ++y) {
      const std::uint32_t* begins = &grid.begins[row(y, z)];
      find_among(grid.members.data() + begins[first[0]], grid.members.data() + begins[last[0] + 1],
                 i, own);
    }
}

/// Without branches: which bodies are near, and which come after i, cannot be guessed.
void SizeGrids::find_among(const Member* begin, const Member* end, int i, const Body& own) {
  std::size_t found = near_.size();
  near_.resize(found + static_cast<std::size_t>(end - begin));
  for (const Member* other = begin; other < end; ++other) {
    const Vector3 distance = other->body.centre - own.centre;
    const double near =
        (1.0 + rounding) * (reach_.factor * (own.radius + other->body.radius) + reach_.skin);
    near_[found] = other->number;
    found += static_cast<std::size_t>(other->number > i) &
             static_cast<std::size_t>(dot(distance, distance) <= near * near);
  }
  near_.resize(found);
}

} // namespace ellipsoid
