// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Random numbers, vectors and orientations for the kernel's tests. Every seed is fixed.
#pragma once

#include "math/vector3.h"

#include <random>

namespace contact_test {

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  /// Three normal numbers.
  ellipsoid::Vector3 vector(double deviation = 1.0) {
    std::normal_distribution<double> normal(0.0, deviation);
    return {normal(engine_), normal(engine_), normal(engine_)};
  }
  /// Uniform over all rotations.
  ellipsoid::Quaternion orientation() {
    std::normal_distribution<double> normal;
    return normalized(
        ellipsoid::Quaternion{normal(engine_), normal(engine_), normal(engine_), normal(engine_)});
  }

 private:
  std::mt19937_64 engine_;
};

} // namespace contact_test
