// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Free rotation: order, invariants, reversibility, and the limits with a closed form.
#include "motion/planar_motion.h"
#include "motion/rigid_body.h"

#include "free_turn.h"

#include <gtest/gtest.h>

#include <random>
#include <utility>

using namespace ellipsoid;

namespace {

const Vector3 moments{1.0, 1.9, 2.6}; // all different, a body that exists: 2.6 < 1.0 + 1.9

Quaternion any_quaternion(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return normalized(Quaternion{normal(random), normal(random), normal(random), normal(random)});
}

Vector3 any_vector(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return {normal(random), normal(random), normal(random)};
}

double distance(const Quaternion& p, const Quaternion& q) {
  return std::sqrt((p.w - q.w) * (p.w - q.w) + (p.x - q.x) * (p.x - q.x) +
                   (p.y - q.y) * (p.y - q.y) + (p.z - q.z) * (p.z - q.z));
}

/// A body turned about the space z axis by the first half of a planar step.
Quaternion rotate_about_z(const Quaternion& q, double angle) {
  double centre[3] = {}, velocity[3] = {}, force[3] = {}, omega[3] = {}, torque[3] = {};
  double momentum[3] = {0.0, 0.0, angle}, orientation[4] = {q.w, q.x, q.y, q.z};
  const double one = 1.0;
  const int group = 1;
  start_planar_step(
      {centre, velocity, force, omega, momentum, torque, orientation, &one, &one, &group, group}, 1,
      1.0, 0.5);
  return {orientation[0], orientation[1], orientation[2], orientation[3]};
}

Quaternion rotate_in_steps(Quaternion q, const Vector3& momentum, double time, int steps) {
  for (int k = 0; k < steps; ++k)
    q = rotate_freely(q, momentum, inverse(moments), time / steps).orientation;
  return q;
}

double energy(const Quaternion& q, const Vector3& momentum) {
  return 0.5 * dot(momentum, angular_velocity(momentum, moments, q));
}

} // namespace

TEST(RigidBody, MomentumAndVelocityAreInverse) {
  std::mt19937 random(1);
  for (int k = 0; k < 1000; ++k) {
    const Quaternion q = any_quaternion(random);
    const Vector3 omega = any_vector(random);
    const Vector3 again = angular_velocity(angular_momentum(omega, moments, q), moments, q);
    EXPECT_LT(norm(again - omega), 1e-14 * norm(omega));
  }
}

TEST(RigidBody, MomentumIsInertiaTensorTimesVelocity) {
  std::mt19937 random(2);
  for (int k = 0; k < 1000; ++k) {
    const Quaternion q = any_quaternion(random);
    const Vector3 omega = any_vector(random);
    const SymmetricMatrix3 tensor = rotated_diagonal(rotation(q), moments.x, moments.y, moments.z);
    EXPECT_LT(norm(angular_momentum(omega, moments, q) - tensor * omega), 1e-14 * norm(omega));
  }
}

TEST(RigidBody, DerivativeIsHalfOmegaTimesQuaternion) {
  std::mt19937 random(3);
  const double h = 1e-5;
  for (int k = 0; k < 200; ++k) {
    const Quaternion q = any_quaternion(random);
    const Vector3 momentum = any_vector(random);
    const Quaternion later = rotate_freely(q, momentum, inverse(moments), h).orientation,
                     earlier = rotate_freely(q, momentum, inverse(moments), -h).orientation;
    const Vector3 w = angular_velocity(momentum, moments, q);
    const Quaternion rate = Quaternion{0.0, 0.5 * w.x, 0.5 * w.y, 0.5 * w.z} * q;
    const Quaternion found{(later.w - earlier.w) / (2 * h), (later.x - earlier.x) / (2 * h),
                           (later.y - earlier.y) / (2 * h), (later.z - earlier.z) / (2 * h)};
    EXPECT_LT(distance(found, rate), 1e-8 * (1.0 + dot(w, w) * norm(w)));
  }
}

TEST(RigidBody, SecondOrder) {
  std::mt19937 random(4);
  for (int k = 0; k < 20; ++k) {
    const Quaternion q = any_quaternion(random);
    const Vector3 momentum = any_vector(random);
    const Quaternion reference = rotate_in_steps(q, momentum, 2.0, 20480);
    const double coarse = distance(rotate_in_steps(q, momentum, 2.0, 160), reference);
    const double fine = distance(rotate_in_steps(q, momentum, 2.0, 320), reference);
    EXPECT_NEAR(coarse / fine, 4.0, 0.1);
  }
}

TEST(RigidBody, NormIsKeptEnergyDoesNotDrift) {
  std::mt19937 random(5);
  const Vector3 momentum = any_vector(random);
  Quaternion q = any_quaternion(random);
  const double start = energy(q, momentum);
  double largest_early = 0.0, largest_late = 0.0;
  for (int k = 0; k < 200000; ++k) {
    q = rotate_freely(q, momentum, inverse(moments), 0.01).orientation;
    EXPECT_NEAR(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z, 1.0, 1e-15);
    double& largest = k < 100000 ? largest_early : largest_late;
    largest = std::max(largest, std::fabs(energy(q, momentum) / start - 1.0));
  }
  EXPECT_LT(largest_early, 1e-4);
  EXPECT_NEAR(largest_late / largest_early, 1.0, 0.01) << "the error of the energy grows";
}

TEST(RigidBody, FreeRotationGivesTheVelocityThere) {
  std::mt19937 random(10);
  for (const double step : {1e-4, 0.1, 3.0})
    for (int k = 0; k < 1000; ++k) {
      const Vector3 momentum = any_vector(random);
      const auto [q, omega] =
          rotate_freely(any_quaternion(random), momentum, inverse(moments), step);
      EXPECT_LT(norm(omega - angular_velocity(momentum, moments, q)), 4e-15 * norm(momentum));
      EXPECT_NEAR(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z, 1.0, 1e-15);
    }
}

TEST(RigidBody, TimeReversible) {
  std::mt19937 random(6);
  const Vector3 momentum = any_vector(random);
  const Quaternion start = any_quaternion(random);
  const Quaternion there = rotate_in_steps(start, momentum, 3.0, 100);
  EXPECT_LT(distance(rotate_in_steps(there, momentum, -3.0, 100), start), 1e-13);
}

TEST(RigidBody, AboutAPrincipalAxisTheRateIsExactToSecondOrder) {
  // momentum along body z: turns by L t / I3 about it
  const Quaternion q = normalized(Quaternion{0.3, -0.5, 0.7, 0.2});
  const Vector3 axis = rotation(q).to_space({0.0, 0.0, 1.0});
  const double angle = 0.8, time = angle * moments.z;
  const Quaternion found = rotate_in_steps(q, axis, time, 2000);
  const double s = std::sin(0.5 * angle);
  const Quaternion expected =
      Quaternion{std::cos(0.5 * angle), s * axis.x, s * axis.y, s * axis.z} * q;
  EXPECT_LT(distance(found, expected), 1e-7);
}

TEST(RigidBody, PlanarInertiaIsThePrincipalMomentItself) {
  const double half = std::sqrt(0.5);
  const std::pair<Quaternion, double> upright[] = {
      {Quaternion{}, moments.z}, {{half, half, 0, 0}, moments.y}, {{half, 0, half, 0}, moments.x}};
  for (const auto& [start, moment] : upright) {
    Quaternion q = start;
    for (int k = 0; k < 1000; ++k) {
      q = rotate_about_z(q, 0.7);
      EXPECT_EQ(planar_inertia(q, moments).about_z, moment);
      EXPECT_LT(planar_inertia(q, moments).misaligned, 1e-27);
    }
  }
}

TEST(RigidBody, PlanarInertiaOfTiltedBodies) {
  EXPECT_GT(planar_inertia(normalized(Quaternion{1.0, 0.1, 0.0, 0.0}), moments).misaligned, 1e-3);
  EXPECT_GT(planar_inertia(normalized(Quaternion{1.0, 0.0, 0.1, 0.0}), moments).misaligned, 1e-3);
}

TEST(RigidBody, PlanarInertiaOfSymmetricBodies) {
  // z anywhere across the symmetry axis; moments that differ by rounding only, as those of a data
  // file: which of the two is taken does not depend on the rounding of the orientation
  const Vector3 rod{1.0, 2.0, std::nextafter(2.0, 3.0)};
  for (int degrees = 0; degrees < 360; degrees += 15) {
    const double half_angle = 0.5 * degrees * std::acos(-1.0) / 180.0;
    Quaternion q{std::cos(half_angle), std::sin(half_angle), 0.0, 0.0};
    const double moment = planar_inertia(q, rod).about_z;
    EXPECT_TRUE(moment == rod.y || moment == rod.z);
    for (int k = 0; k < 1000; ++k) {
      q = rotate_about_z(q, 0.7);
      EXPECT_EQ(planar_inertia(q, rod).about_z, moment);
      EXPECT_LT(planar_inertia(q, rod).misaligned, 1e-27);
    }
  }
}

TEST(RigidBody, PlanarInertiaOfSpheres) {
  std::mt19937 random(7);
  for (int k = 0; k < 1000; ++k) {
    const PlanarInertia sphere = planar_inertia(any_quaternion(random), {2.0, 2.0, 2.0});
    EXPECT_EQ(sphere.about_z, 2.0);
    EXPECT_LT(sphere.misaligned, 1e-30);
  }
}

TEST(RigidBody, RotationAboutZ) {
  const Quaternion q = normalized(Quaternion{0.3, -0.5, 0.7, 0.2});
  double errors[2];
  for (int k = 0; k < 2; ++k) { // of one step, so third order
    const double angle = k == 0 ? 0.02 : 0.01;
    const Quaternion exact = Quaternion{std::cos(0.5 * angle), 0.0, 0.0, std::sin(0.5 * angle)} * q;
    errors[k] = distance(rotate_about_z(q, angle), exact);
  }
  EXPECT_NEAR(errors[0] / errors[1], 8.0, 0.05);
}

TEST(RigidBody, RotationAboutZIsAProductOfQuaternionsAndKeepsTheNorm) {
  std::mt19937 random(8);
  Quaternion q = any_quaternion(random), product = q;
  const double angle = 1e-3;
  for (int k = 0; k < 1000000; ++k) {
    q = rotate_about_z(q, angle);
    ASSERT_NEAR(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z, 1.0, 1e-15);
    if (k < 1000) {
      product = normalized(Quaternion{1.0, 0.0, 0.0, 0.5 * angle} * product);
      ASSERT_LT(distance(q, product), 1e-13);
    }
  }
}

TEST(RigidBody, RotationAboutZKeepsTheTilt) {
  std::mt19937 random(9);
  Quaternion q = any_quaternion(random);
  const Vector3 start = rotation(q).to_body({0.0, 0.0, 1.0});
  for (int k = 0; k < 1000000; ++k)
    q = rotate_about_z(q, 1e-3);
  EXPECT_LT(norm(rotation(q).to_body({0.0, 0.0, 1.0}) - start), 1e-12);
}
