// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Gear's predictor-corrector: exact for polynomials, order of convergence against closed forms and
// against a second integrator, derivatives at the start.
#include "motion/gear_predictor_corrector.h"

#include "free_turn.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

using namespace ellipsoid;

namespace {

const Vector3 moments{1.0, 1.9, 2.6};
const Quaternion orientation = normalized(Quaternion{0.3, -0.5, 0.7, 0.2});
const Vector3 omega{0.9, -1.1, 0.6};

/// Error at t = 4 of the damped oscillator y'' = -y - y'/5 that starts with y = 1, y' = 0.
double oscillator_error(int steps) {
  const double damping = 0.2, rate = std::sqrt(1.0 - 0.25 * damping * damping), time = 4.0;
  const auto acceleration = [damping](double y, double v) { return -y - damping * v; };
  double y = 1.0, v = 0.0;
  GearDerivatives d{acceleration(y, v), 0.0, 0.0, 0.0};
  double lower = v;
  for (std::size_t k = 1; k < 4; ++k) { // the derivatives obey the same equation
    d[k] = acceleration(lower, d[k - 1]);
    lower = d[k - 1];
  }
  const Gear gear(time / steps);
  for (int n = 0; n < steps; ++n) {
    gear.predict(y, v, d.data());
    gear.correct(y, v, d.data(), acceleration(y, v));
  }
  const double decay = std::exp(-0.5 * damping * time);
  return std::fabs(y -
                   decay * (std::cos(rate * time) + 0.5 * damping / rate * std::sin(rate * time)));
}

double distance(const Quaternion& p, const Quaternion& q) {
  return std::sqrt((p.w - q.w) * (p.w - q.w) + (p.x - q.x) * (p.x - q.x) +
                   (p.y - q.y) * (p.y - q.y) + (p.z - q.z) * (p.z - q.z));
}

/// A free body's orientation after `time` by the second-order splitting, extrapolated.
Quaternion free_turn(double time) {
  const Vector3 momentum = angular_momentum(omega, moments, orientation);
  const auto turned = [&](int steps) {
    Quaternion q = orientation;
    for (int k = 0; k < steps; ++k)
      q = rotate_freely(q, momentum, inverse(moments), time / steps).orientation;
    return q;
  };
  const Quaternion coarse = turned(20000), fine = turned(40000);
  return normalized(Quaternion{(4.0 * fine.w - coarse.w) / 3.0, (4.0 * fine.x - coarse.x) / 3.0,
                               (4.0 * fine.y - coarse.y) / 3.0, (4.0 * fine.z - coarse.z) / 3.0});
}

} // namespace

TEST(Gear, ExactForPolynomialsOfFifthDegree) {
  const double c[6] = {0.3, -1.2, 0.7, 1.5, -0.4, 0.9}, h = 0.1;
  const auto derivative = [&c](int order, double t) {
    double sum = 0.0;
    for (int n = order; n < 6; ++n) {
      double factor = c[n];
      for (int k = 0; k < order; ++k)
        factor *= n - k;
      sum += factor * std::pow(t, n - order);
    }
    return sum;
  };
  double y = derivative(0, 0.0), v = derivative(1, 0.0);
  GearDerivatives d{derivative(2, 0.0), derivative(3, 0.0), derivative(4, 0.0), derivative(5, 0.0)};
  const Gear gear(h);
  for (int n = 1; n <= 20; ++n) {
    gear.predict(y, v, d.data());
    gear.correct(y, v, d.data(), derivative(2, n * h));
  }
  EXPECT_NEAR(y / derivative(0, 20 * h), 1.0, 1e-13);
  EXPECT_NEAR(v / derivative(1, 20 * h), 1.0, 1e-13);
  for (int k = 0; k < 4; ++k)
    EXPECT_NEAR(d[static_cast<std::size_t>(k)] / derivative(k + 2, 20 * h), 1.0, 1e-11);
}

TEST(Gear, FifthOrderForADampedOscillator) {
  for (int steps = 100; steps <= 400; steps *= 2) {
    const double order = std::log2(oscillator_error(steps) / oscillator_error(2 * steps));
    std::cout << steps << " steps: error " << oscillator_error(steps) << ", order " << order
              << "\n";
    EXPECT_NEAR(order, 5.0, 0.2);
  }
}

TEST(Gear, DerivativesOfAFreeRotationAreItsTaylorSeries) {
  const auto d = rotation_derivatives(orientation, omega, Vector3{}, moments);
  const Quaternion rate = quaternion_rate(orientation, omega);
  const double start[4] = {orientation.w, orientation.x, orientation.y, orientation.z},
               rates[4] = {rate.w, rate.x, rate.y, rate.z};
  double error[2];
  for (int n = 0; n < 2; ++n) {
    const double t = 0.2 / (1 + n);
    double q[4];
    for (std::size_t k = 0; k < 4; ++k)
      q[k] = start[k] +
             t * (rates[k] +
                  t * (d[k][0] / 2 + t * (d[k][1] / 6 + t * (d[k][2] / 24 + t * d[k][3] / 120))));
    error[n] = distance({q[0], q[1], q[2], q[3]}, free_turn(t));
  }
  EXPECT_NEAR(std::log2(error[0] / error[1]), 6.0, 0.3);
}

TEST(Gear, SecondDerivativesAgreeWithEulersEquations) {
  const Vector3 torque{0.4, 0.8, -0.3};
  const Vector3 alpha = angular_acceleration(orientation, omega, torque, moments);
  const Quaternion second = quaternion_acceleration(orientation, omega, alpha);
  const auto d = rotation_derivatives(orientation, omega, torque, moments);
  EXPECT_NEAR(d[0][0], second.w, 1e-15);
  EXPECT_NEAR(d[1][0], second.x, 1e-15);
  EXPECT_NEAR(d[2][0], second.y, 1e-15);
  EXPECT_NEAR(d[3][0], second.z, 1e-15);
  // the momentum's rate is the torque: R(dt) I(dt) omega(dt) by differences
  const double h = 1e-5;
  const auto momentum_after = [&](double t) {
    const Quaternion rate = quaternion_rate(orientation, omega);
    const Quaternion q =
        normalized(Quaternion{orientation.w + t * rate.w + 0.5 * t * t * second.w,
                              orientation.x + t * rate.x + 0.5 * t * t * second.x,
                              orientation.y + t * rate.y + 0.5 * t * t * second.y,
                              orientation.z + t * rate.z + 0.5 * t * t * second.z});
    return angular_momentum(omega + t * alpha, moments, q);
  };
  const Vector3 found = 0.5 / h * (momentum_after(h) - momentum_after(-h));
  EXPECT_LT(norm(found - torque), 1e-9);
}

TEST(Gear, AngularVelocityComesBackFromTheRate) {
  const Vector3 again = angular_velocity_of_rate(orientation, quaternion_rate(orientation, omega));
  EXPECT_LT(norm(again - omega), 1e-15);
}
