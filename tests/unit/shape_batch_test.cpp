// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Shapes made in batches against shapes made one by one: the same bits.
#include "shape_batch.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

using namespace ellipsoid;

TEST(ShapeBatch, GivesTheBitsOfSingleShapes) {
  std::mt19937_64 random(20202);
  std::normal_distribution<double> gauss;
  std::uniform_real_distribution<double> positive(0.1, 2.0);
  for (const int count : {1, 7, 16, ShapeBatch::capacity}) {
    ShapeBatch batch;
    EllipsoidShape expected[ShapeBatch::capacity];
    for (int k = 0; k < count; ++k) {
      const Vector3 semiaxes{positive(random), positive(random), positive(random)};
      const Quaternion orientation =
          normalized(Quaternion{gauss(random), gauss(random), gauss(random), gauss(random)});
      expected[k] = make_shape(semiaxes, orientation);
      batch.add(semiaxes, orientation);
    }
    EXPECT_EQ(batch.full(), count == ShapeBatch::capacity);
    batch.solve();
    for (int k = 0; k < count; ++k) {
      EllipsoidShape shape;
      batch.store(k, shape);
      EXPECT_EQ(std::memcmp(&shape, &expected[k], sizeof shape), 0) << "shape " << k;
      EXPECT_GT(shape.axes_product, 0.0);
    }
  }
}
