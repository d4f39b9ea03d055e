// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Neighbours among bodies of very different sizes (hierarchical grid, multi-level cell lists).
//
// Bodies of a size class, from one radius down to half of it, lie in a grid of their own, whose
// cells are as large as they are. A body looks for its neighbours in the grid of each class, only
// as far as bodies of that class may be: a small one never goes through all small ones that would
// fit beside a large one.
#pragma once

#include "math/vector3.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ellipsoid {

class SizeGrids {
 public:
  /// Two bodies are neighbours if their centres are nearer than factor (r_i + r_j) + skin.
  struct Reach {
    double factor, skin;
  };
  /// @param[in] centres 3 numbers each (length), @param[in] radii > 0 (length)
  void build(const double* centres, const double* radii, std::size_t count, const Reach& reach);
  /// Whether the largest radius is twice the smallest or more.
  static bool are_worthwhile(const double* radii, std::size_t count);

  /// Neighbours of body i with a larger number than i, each once, in an order that depends on
  /// centres and radii only.
  const std::vector<int>& find(int i);

 private:
  struct Body {
    Vector3 centre;
    double radius;
  };
  struct Member {
    Body body;
    int number;
  };
  /// Cells with the same y and z follow each other along x, and so do their members.
  struct Grid {
    double largest_radius = 0.0, cell = 0.0; ///< (length)
    Vector3 low;
    int cells[3] = {1, 1, 1};
    std::vector<std::uint32_t> begins; ///< by cell; one more at the end
    std::vector<Member> members;

    int index_along(double x, int axis) const;
    std::size_t cell_of(const Vector3& centre) const;
    void shape(const Vector3& first, const Vector3& last, double edge, std::size_t bodies);
    void sort_in(const std::vector<int>& numbers, const std::vector<Body>& bodies);
  };
  std::vector<Grid> grids_;
  std::vector<Body> bodies_; ///< by number
  std::vector<int> near_;
  Reach reach_{1.0, 0.0};

  void find_in(const Grid& grid, int i, const Body& own);
  void find_among(const Member* begin, const Member* end, int i, const Body& own);
};

} // namespace ellipsoid
