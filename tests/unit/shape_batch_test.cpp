// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Shapes made together against shapes made one by one: the same bits.
#include "ellipsoid/shape_batch.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <vector>

using namespace ellipsoid;

TEST(ShapeBatch, GivesTheBitsOfSingleShapes) {
  std::mt19937_64 random(20202);
  std::normal_distribution<double> gauss;
  std::uniform_real_distribution<double> positive(0.1, 2.0);
  for (const int count : {0, 1, 7, 16, 63, 64, 65, 200}) {
    std::vector<double> semiaxes, orientations;
    std::vector<EllipsoidShape> expected, shapes(static_cast<std::size_t>(count) + 1);
    for (int k = 0; k < count; ++k) {
      const Vector3 axes{positive(random), positive(random), positive(random)};
      const Quaternion q =
          normalized(Quaternion{gauss(random), gauss(random), gauss(random), gauss(random)});
      semiaxes.insert(semiaxes.end(), {axes.x, axes.y, axes.z});
      orientations.insert(orientations.end(), {q.w, q.x, q.y, q.z});
      expected.push_back(make_shape(axes, q));
      EXPECT_GT(expected.back().axes_product, 0.0);
    }
    expected.emplace_back(); // one behind the last, left alone
    make_shapes({semiaxes.data(), orientations.data(), shapes.data()}, count);
    for (std::size_t k = 0; k < expected.size(); ++k)
      EXPECT_EQ(std::memcmp(&shapes[k], &expected[k], sizeof(EllipsoidShape)), 0) << "shape " << k;
  }
}
