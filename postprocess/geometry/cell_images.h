// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "cell_grid.h"
#include "periodic_cell.h"

#include <vector>

namespace ellipsoid::post {

/// A ball, or an image of it.
struct CellImage {
  std::size_t owner = 0; ///< the ball
  Vector3 shift;         ///< from the ball to here (length)
};

/// All balls, moved into the cell, in their order; then those of their images that come so near
/// the cell that they may meet a ball in it.
/// @param[in] radii of the balls (length)
std::vector<CellImage> cell_images(const std::vector<Vector3>& centres,
                                   const std::vector<double>& radii, const PeriodicCell& cell);

/// Whether a pair of images is to be counted: one across a boundary is found from both sides.
/// @param[in] p, q their indices in the list, p < q; `count` balls
bool counts_as_pair(const std::vector<CellImage>& images, std::size_t p, std::size_t q,
                    std::size_t count);

/// Pairs of balls across periodic boundaries.
class BallsWithImages {
 public:
  BallsWithImages(const std::vector<Vector3>& centres, const std::vector<double>& radii,
                  const PeriodicCell& cell)
      : count_(centres.size()), images_(cell_images(centres, radii, cell)) {
    for (const CellImage& image : images_) {
      centres_.push_back(centres[image.owner] + image.shift);
      radii_.push_back(radii[image.owner]);
    }
  }

  /// Calls visit(i, j, shift) once for every pair of balls that overlap, images included: the
  /// centre of j, moved by the shift, is the one near that of i. i = j: a ball and its own image.
  template <class Visitor> void for_pairs(const Visitor& visit) {
    CellGrid grid(centres_, radii_);
    grid.for_pairs([&](std::size_t p, std::size_t q) {
      if (counts_as_pair(images_, p, q, count_))
        visit(images_[p].owner, images_[q].owner, images_[q].shift - images_[p].shift);
    });
  }

 private:
  std::size_t count_;
  std::vector<CellImage> images_;
  std::vector<Vector3> centres_;
  std::vector<double> radii_;
};

} // namespace ellipsoid::post
