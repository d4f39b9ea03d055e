// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Shortest distances and images in boxes that repeat, against all images one by one.
#include "input_error.h"
#include "periodic_cell.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace ellipsoid::post {
namespace {

const std::array<Vector3, 3> tilted{Vector3{2.0, 0.0, 0.0}, Vector3{0.9, 3.0, 0.0},
                                    Vector3{-0.7, 1.4, 2.5}};

Vector3 image(const std::array<Vector3, 3>& edges, int i, int j, int k) {
  return double(i) * edges[0] + double(j) * edges[1] + double(k) * edges[2];
}

TEST(PeriodicCell, nearest_is_the_shortest_of_many_images) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> anywhere(-9.0, 9.0);
  for (const std::array<bool, 3>& repeats :
       {std::array<bool, 3>{true, true, true}, {true, true, false}, {false, true, false}}) {
    const PeriodicCell cell({0.3, -1.0, 2.0}, tilted, repeats);
    for (int trial = 0; trial < 500; ++trial) {
      const Vector3 d{anywhere(generator), anywhere(generator), anywhere(generator)};
      double shortest = norm(d);
      for (int i = -9; i <= 9; ++i)
        for (int j = -9; j <= 9; ++j)
          for (int k = -9; k <= 9; ++k)
            if ((repeats[0] || i == 0) && (repeats[1] || j == 0) && (repeats[2] || k == 0))
              shortest = std::min(shortest, norm(d + image(tilted, i, j, k)));
      EXPECT_NEAR(norm(cell.nearest(d)), shortest, 1e-12);
    }
  }
}

TEST(PeriodicCell, wrapped_points_lie_inside) {
  std::mt19937 generator(12);
  std::uniform_real_distribution<double> anywhere(-20.0, 20.0);
  const PeriodicCell cell({0.3, -1.0, 2.0}, tilted, {true, true, false});
  for (int trial = 0; trial < 500; ++trial) {
    const Vector3 p{anywhere(generator), anywhere(generator), anywhere(generator)};
    const Vector3 f = cell.fractions(cell.wrapped(p));
    EXPECT_TRUE(f.x >= -1e-12 && f.x < 1.0 + 1e-12 && f.y >= -1e-12 && f.y < 1.0 + 1e-12);
    EXPECT_NEAR(f.z, cell.fractions(p).z, 1e-12); // does not repeat
    const Vector3 back = cell.fractions(p - cell.wrapped(p) + cell.corner());
    EXPECT_NEAR(back.x, std::round(back.x), 1e-12);
    EXPECT_NEAR(back.y, std::round(back.y), 1e-12);
  }
}

TEST(PeriodicCell, shifts_reach_all_images_of_near_points) {
  std::mt19937 generator(13);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const PeriodicCell cell({}, tilted, {true, true, true});
  const double reach = 3.1;
  const std::vector<Vector3> shifts = cell.shifts(reach);
  EXPECT_EQ(norm(shifts.front()), 0.0);
  for (int trial = 0; trial < 50; ++trial) {
    const auto inside = [&] {
      return share(generator) * tilted[0] + share(generator) * tilted[1] +
             share(generator) * tilted[2];
    };
    const Vector3 p = inside(), q = inside();
    int found = 0, expected = 0;
    for (const Vector3& shift : shifts)
      found += norm(q + shift - p) < reach ? 1 : 0;
    for (int i = -9; i <= 9; ++i)
      for (int j = -9; j <= 9; ++j)
        for (int k = -9; k <= 9; ++k)
          expected += norm(q + image(tilted, i, j, k) - p) < reach ? 1 : 0;
    EXPECT_EQ(found, expected);
  }
}

TEST(PeriodicCell, a_frames_box_repeats_where_it_says_so) {
  Box box;
  std::fill(box.upper, box.upper + 3, 2.0);
  box.boundary = "pp ff pp";
  const PeriodicCell cell(box);
  EXPECT_TRUE(cell.is_periodic(0) && !cell.is_periodic(1) && cell.is_periodic(2));
  EXPECT_EQ(cell.volume(), 8.0);
  EXPECT_EQ(cell.thickness(1), 2.0);
  EXPECT_EQ(cell.nearest({1.5, 1.5, -1.5}).x, -0.5);
  EXPECT_EQ(cell.nearest({1.5, 1.5, -1.5}).y, 1.5);
  box.upper[0] = box.lower[0];
  EXPECT_THROW(PeriodicCell{box}, InputError);
  box.boundary = "";
  EXPECT_FALSE(PeriodicCell(box).is_periodic());
}

} // namespace
} // namespace ellipsoid::post
