// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Eqs. (18), (23), (24) as functions of plain values.
#include "law/contact_law.h"

#include <gtest/gtest.h>

using namespace ellipsoid;

namespace {

constexpr double modulus = 183e6, poisson = 0.2, shear = modulus / (2.0 * (1.0 + poisson));

void expect_near(const Vector3& found, const Vector3& expected, double tolerance) {
  EXPECT_LE(norm(found - expected), tolerance)
      << "(" << found.x << ", " << found.y << ", " << found.z << ") for (" << expected.x << ", "
      << expected.y << ", " << expected.z << ")";
}

} // namespace

TEST(ContactLaw, LikeMaterialsGiveThePublishedStiffness) {
  const double radius = 1.3e-3, overlap = 2e-7, root = std::sqrt(radius * overlap);
  const double e_star = modulus / (2.0 * (1.0 - poisson * poisson));
  const double g_star = shear / (2.0 * (2.0 - poisson));
  const double published = 2.0 / 3.0 * modulus / (1.0 - poisson * poisson) *
                           std::sqrt(radius * overlap * overlap * overlap); // eq. 23
  EXPECT_NEAR(normal_stiffness(e_star, root) * overlap, published, 1e-14 * published);
  const double per_length = 8.0 / 3.0 * shear * root / (2.0 - poisson); // eq. 24
  EXPECT_NEAR(tangential_stiffness(g_star, root), per_length, 1e-14 * per_length);
}

TEST(ContactLaw, SpringBelowTheLimit) {
  Vector3 spring{1e-6, 0.0, -2e-6};
  const TangentialContact<> contact{3000.0, 0.2, 1.0, {0.01, 0.0, 0.02}};
  const Vector3 force = friction<SlipDirection::displacement>(contact, spring);
  expect_near(force, {-3e-3 - 2e-3, 0.0, 6e-3 - 4e-3}, 1e-17);
  expect_near(spring, {1e-6, 0.0, -2e-6}, 0.0);
}

TEST(ContactLaw, SlidingKeepsTheDirectionAndShortensTheSpring) {
  Vector3 spring{3e-4, 0.0, 4e-4};
  const TangentialContact<> contact{3000.0, 0.0, 0.6, {0.01, 0.0, 0.02}};
  const Vector3 force = friction<SlipDirection::displacement>(contact, spring);
  expect_near(force, {-0.36, 0.0, -0.48}, 1e-15); // 0.6 against the spring
  expect_near(-3000.0 * spring, force, 1e-15);
}

TEST(ContactLaw, ShortenedSpringGivesTheSameForceAgain) {
  Vector3 spring{3e-4, 0.0, 4e-4};
  const TangentialContact<> contact{3000.0, 5.0, 0.6, {0.01, 0.0, -0.02}};
  const Vector3 force = friction<SlipDirection::displacement>(contact, spring);
  EXPECT_NEAR(norm(force), 0.6, 1e-15);
  expect_near(friction<SlipDirection::displacement>(contact, spring), force, 1e-14);
}

TEST(ContactLaw, VelocityDirectionIsAgainstThePresentVelocity) {
  Vector3 spring{1e-6, 0.0, -2e-6};
  const TangentialContact<> contact{3000.0, 0.2, 1.0, {0.0, 0.0, 0.02}};
  const Vector3 force = friction<SlipDirection::velocity>(contact, spring);
  // magnitude of (24): |k spring + damping|, limited, along the velocity
  expect_near(force, {0.0, 0.0, -std::hypot(3e-3, -6e-3 + 4e-3)}, 1e-17);
  const TangentialContact<> at_rest{3000.0, 0.2, 1.0, {}};
  expect_near(friction<SlipDirection::velocity>(at_rest, spring), {}, 0.0);
}

TEST(ContactLaw, VelocityDirectionIsLimitedToo) {
  Vector3 spring{3e-4, 0.0, 4e-4};
  const TangentialContact<> contact{3000.0, 0.0, 0.6, {0.0, 0.0, -0.02}};
  expect_near(friction<SlipDirection::velocity>(contact, spring), {0.0, 0.0, 0.6}, 1e-15);
  EXPECT_NEAR(3000.0 * norm(spring), 0.6, 1e-15);
}

TEST(ContactLaw, NothingWithoutFriction) {
  Vector3 spring{3e-4, 0.0, 4e-4};
  const TangentialContact<> contact{3000.0, 5.0, 0.0, {0.01, 0.0, 0.02}};
  expect_near(friction<SlipDirection::displacement>(contact, spring), {}, 0.0);
}

TEST(ContactLaw, NoSlipNoSpringNoForce) {
  Vector3 spring;
  expect_near(friction<SlipDirection::displacement>({3000.0, 5.0, 0.6, {}}, spring), {}, 0.0);
}

TEST(ContactLaw, TheSpringGrowsWithTheSlip) {
  Vector3 spring;
  const Vector3 normal{0.0, 1.0, 0.0};
  for (int k = 0; k < 1000; ++k)
    advance_spring(spring, {0.03, 0.0, -0.04}, 1e-6, normal);
  expect_near(spring, {3e-5, 0.0, -4e-5}, 1e-18); // eq. 18
}

TEST(ContactLaw, TheSpringTurnsWithTheTangentPlaneAndKeepsItsLength) {
  Vector3 spring{1e-5, 0.0, 0.0};
  const int steps = 10000;
  for (int k = 1; k <= steps; ++k) { // the normal turns from y by 60 degrees towards x
    const double angle = M_PI / 3.0 * k / steps;
    advance_spring(spring, {}, 1e-6, {std::sin(angle), std::cos(angle), 0.0});
  }
  expect_near(spring, {0.5e-5, -std::sqrt(0.75) * 1e-5, 0.0}, 1e-17);
}

TEST(ContactLaw, ASpringAcrossTheTangentPlaneVanishes) {
  Vector3 spring{0.0, 1e-5, 0.0};
  advance_spring(spring, {}, 1e-6, {0.0, 1.0, 0.0});
  expect_near(spring, {}, 0.0);
}
