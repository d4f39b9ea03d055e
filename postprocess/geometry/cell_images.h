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
      : m_count(centres.size()), m_images(cell_images(centres, radii, cell)) {
    for (const CellImage& image : m_images) {
      m_centres.push_back(centres[image.owner] + image.shift);
      m_radii.push_back(radii[image.owner]);
    }
  }

  /// Calls visit(i, j, shift) once for every pair of balls that overlap, images included: the
  /// centre of j, moved by the shift, is the one near that of i. i = j: a ball and its own image.
  template <class Visitor> void for_pairs(const Visitor& visit) {
    CellGrid grid(m_centres, m_radii);
    grid.for_pairs([&](std::size_t p, std::size_t q) {
      if (counts_as_pair(m_images, p, q, m_count))
        visit(m_images[p].owner, m_images[q].owner, m_images[q].shift - m_images[p].shift);
    });
  }

 private:
  std::size_t m_count;
  std::vector<CellImage> m_images;
  std::vector<Vector3> m_centres;
  std::vector<double> m_radii;
};

} // namespace ellipsoid::post
