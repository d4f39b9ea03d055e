// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Coarse-graining functions and the fields they make, against numerical integration and closed
// forms.
#include "averages/coarse_graining_function.h"
#include "fields.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <random>

namespace ellipsoid::post {
namespace {

constexpr double pi = 3.141592653589793238462643;

/// Midpoint rule.
double integral(double begin, double end, int parts, const std::function<double(double)>& f) {
  double sum = 0.0;
  for (int k = 0; k < parts; ++k)
    sum += f(begin + (k + 0.5) * (end - begin) / parts);
  return sum * (end - begin) / parts;
}

const CoarseGrainingShape shapes[] = {CoarseGrainingShape::gaussian, CoarseGrainingShape::lucy,
                                      CoarseGrainingShape::wendland,
                                      CoarseGrainingShape::heaviside};

TEST(CoarseGrainingFunction, integral_over_space_is_one) {
  for (const CoarseGrainingShape shape : shapes) {
    const CoarseGrainingFunction phi(shape, 0.4);
    const double total = integral(0.0, phi.reach(), 20000,
                                  [&](double r) { return 4.0 * pi * r * r * phi.value(r * r); });
    EXPECT_NEAR(total, 1.0, 1e-7);
    EXPECT_NEAR(phi.between_planes(-9.0, 9.0), 1.0, 1e-12);
    EXPECT_EQ(phi.value(1.0001 * phi.reach() * phi.reach()), 0.0);
  }
}

TEST(CoarseGrainingFunction, values_are_those_of_the_literature) {
  const double w = 0.4, r = 0.5;
  // Weinhart et al. 2012: Gaussian cut off at 3 w; 0.97070911 of it lies inside
  EXPECT_NEAR(CoarseGrainingFunction(CoarseGrainingShape::gaussian, w).value(r * r),
              std::exp(-r * r / (2 * w * w)) / std::pow(std::sqrt(2 * pi) * w, 3) / 0.97070911,
              1e-7);
  // Lucy 1977: 105 / (16 pi c^3) (1 + 3 q) (1 - q)^3, q = r / c
  const double c = 2 * w, q = r / c;
  EXPECT_NEAR(CoarseGrainingFunction(CoarseGrainingShape::lucy, w).value(r * r),
              105 / (16 * pi * c * c * c) * (1 + 3 * q) * std::pow(1 - q, 3), 1e-12);
  // Wendland 1995, C2 in three dimensions: 21 / (2 pi c^3) (1 - q)^4 (1 + 4 q)
  EXPECT_NEAR(CoarseGrainingFunction(CoarseGrainingShape::wendland, w).value(r * r),
              21 / (2 * pi * c * c * c) * std::pow(1 - q, 4) * (1 + 4 * q), 1e-12);
  EXPECT_NEAR(CoarseGrainingFunction(CoarseGrainingShape::heaviside, w).value(0.1),
              1 / (4.0 / 3.0 * pi * w * w * w), 1e-12);
}

TEST(CoarseGrainingFunction, slopes_are_differences_of_the_values) {
  constexpr double step = 1e-6;
  for (const CoarseGrainingShape shape : shapes) {
    const CoarseGrainingFunction phi(shape, 0.4);
    for (const double r : {0.05, 0.2, 0.33, 0.39})
      EXPECT_NEAR(phi.slope_over_distance(r * r) * r,
                  (phi.value((r + step) * (r + step)) - phi.value((r - step) * (r - step))) /
                      (2 * step),
                  1e-7);
  }
}

TEST(CoarseGrainingFunction, a_gaussian_may_be_cut_off_anywhere) {
  const CoarseGrainingFunction phi = CoarseGrainingFunction::cut_gaussian(0.3, 0.5);
  EXPECT_NEAR(
      integral(0.0, 0.5, 20000, [&](double r) { return 4.0 * pi * r * r * phi.value(r * r); }), 1.0,
      1e-7);
  EXPECT_NEAR(phi.value(0.04) / phi.value(0.0), std::exp(-0.04 / 0.18), 1e-12);
  EXPECT_EQ(phi.value(0.26), 0.0);
}

TEST(CoarseGrainingFunction, lines_and_planes_are_integrals_of_the_values) {
  for (const CoarseGrainingShape shape : shapes) {
    const CoarseGrainingFunction phi(shape, 0.4);
    for (const double d : {0.0, 1e-9, 0.1, 0.35, 0.7})
      for (const double begin : {-2.0, -0.2, 0.05})
        for (const double end : {0.1, 0.3, 3.0})
          EXPECT_NEAR(
              phi.along_line(d * d, begin, end),
              integral(begin, end, 200000, [&](double t) { return phi.value(d * d + t * t); }),
              1e-5 / (0.4 * 0.4));
    for (const double z : {0.0, -0.1, 0.25, 0.6, 1.1})
      EXPECT_NEAR(phi.over_plane(z),
                  integral(0.0, phi.reach(), 200000,
                           [&](double r) { return 2.0 * pi * r * phi.value(r * r + z * z); }),
                  1e-4);
    for (const double begin : {-2.0, -0.2, 0.05})
      for (const double end : {-0.3, 0.3, 3.0})
        EXPECT_NEAR(phi.between_planes(begin, end),
                    integral(begin, end, 100000, [&](double z) { return phi.over_plane(z); }),
                    1e-8);
  }
}

const PeriodicCell tilted({-0.5, 0.2, 0.0},
                          {Vector3{2.0, 0.0, 0.0}, Vector3{0.7, 1.5, 0.0}, Vector3{-0.4, 0.6, 1.8}},
                          {true, true, true});

/// Moving triaxial bodies anywhere, and forces between some of them.
struct Cloud {
  ParticleSet set;
  std::vector<ForceContact> contacts;
  explicit Cloud(unsigned seed, int count = 12) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    const auto vector = [&] { return Vector3{any(generator), any(generator), any(generator)}; };
    for (int k = 0; k < count; ++k) {
      Particle p;
      p.mass = 1.5 + any(generator);
      p.centre = 3.0 * vector();
      p.velocity = vector();
      p.angular_velocity = vector();
      p.semiaxes = {0.2, 0.3, 0.1};
      p.orientation = normalized(
          Quaternion{1.1 + any(generator), any(generator), any(generator), any(generator)});
      set.particles.push_back(p);
    }
    for (std::size_t k = 0; k + 1 < set.particles.size(); ++k)
      contacts.push_back({k, k + 1, set.particles[k].centre + 0.3 * vector(), vector(), {}});
    contacts.push_back({2, {}, set.particles[2].centre + 0.3 * vector(), vector(), {}});
  }
};

Vector3 at(const PeriodicCell& cell, double i, double j, double k) {
  return cell.corner() + i * cell.edge(0) + j * cell.edge(1) + k * cell.edge(2);
}

TEST(Fields, integrals_over_a_periodic_cell_are_those_of_the_particles) {
  const Cloud cloud(5);
  const CoarseGrainingFunction phi(CoarseGrainingShape::lucy, 0.3);
  constexpr int n = 24;
  std::vector<Vector3> points;
  for (int i = 0; i < n * n * n; ++i)
    points.push_back(at(tilted, double(i % n) / n, double(i / n % n) / n, double(i / n / n) / n));
  const auto targets = point_targets(points, phi, tilted, 0.6);
  add_frame(*targets, cloud.set, cloud.contacts, tilted, {});
  FieldSums total{};
  for (const FieldSums& sums : targets->sums())
    for (std::size_t k = 0; k < field_size; ++k)
      total[k] += sums[k] * tilted.volume() / (n * n * n);
  double mass = 0.0, flux_xy = 0.0, stress_xy = 0.0, couple_zx = 0.0, solid = 0.0;
  Vector3 momentum;
  for (const Particle& p : cloud.set.particles) {
    mass += p.mass;
    solid += 4.0 / 3.0 * pi * 0.2 * 0.3 * 0.1;
    momentum += p.mass * p.velocity;
    flux_xy += p.mass * p.velocity.x * p.velocity.y;
  }
  for (const ForceContact& c : cloud.contacts) {
    // the contact lies near i; the way to j leads to the nearest image
    const Vector3 b_i = cloud.set.particles[c.i].centre - *c.point;
    stress_xy += c.force.x * b_i.y;
    couple_zx += cross(-b_i, c.force).z * b_i.x;
    if (!c.j)
      continue;
    const Vector3 b_j = -tilted.nearest(*c.point - cloud.set.particles[*c.j].centre);
    stress_xy += -c.force.x * b_j.y;
    couple_zx += cross(-b_j, -c.force).z * b_j.x;
  }
  constexpr double of_the_sum = 1.0e-5; // of 24^3 points
  EXPECT_NEAR(total[field_mass], mass, of_the_sum * mass);
  EXPECT_NEAR(total[field_solid], solid, of_the_sum * solid);
  EXPECT_NEAR(total[field_momentum + 1], momentum.y, of_the_sum * mass);
  EXPECT_NEAR(total[field_momentum_flux + 1], flux_xy, of_the_sum * mass);
  EXPECT_NEAR(total[field_contact_stress + 1], stress_xy, of_the_sum * mass);
  EXPECT_NEAR(total[field_couple_stress + 6], couple_zx, of_the_sum * mass);
  EXPECT_NEAR(total[field_boundary_force + 2], -cloud.contacts.back().force.z, of_the_sum * mass);
}

TEST(Fields, the_divergence_of_the_contact_stress_balances_the_forces) {
  const Cloud cloud(6);
  const CoarseGrainingFunction phi(CoarseGrainingShape::lucy, 0.3);
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  constexpr double step = 1.0e-4;
  for (int trial = 0; trial < 20; ++trial) {
    const Vector3 r = at(tilted, share(generator), share(generator), share(generator));
    std::vector<Vector3> points{r};
    for (const Vector3& axis : {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}})
      for (const double sign : {1.0, -1.0})
        points.push_back(r + sign * step * axis);
    const auto targets = point_targets(points, phi, tilted, 0.6);
    add_frame(*targets, cloud.set, cloud.contacts, tilted, {});
    const auto stress = [&](std::size_t point, std::size_t k) {
      return targets->sums()[point][field_contact_stress + k];
    };
    const auto images = [&](const Vector3& source) { // sum of phi over all images, one by one
      double sum = 0.0;
      for (int i = -4; i <= 4; ++i)
        for (int j = -4; j <= 4; ++j)
          for (int k = -4; k <= 4; ++k) {
            const Vector3 d = r - source - (at(tilted, i, j, k) - tilted.corner());
            sum += phi.value(dot(d, d));
          }
      return sum;
    };
    Vector3 expected; // - div sigma = sum of forces at the particles - force of the wall at it
    for (const ForceContact& c : cloud.contacts) {
      expected += images(cloud.set.particles[c.i].centre) * c.force;
      if (c.j)
        expected -= images(cloud.set.particles[*c.j].centre) * c.force;
      else
        expected -= images(*c.point) * c.force;
    }
    const double scale = 1.0 / std::pow(0.3, 3),
                 expectations[] = {expected.x, expected.y, expected.z};
    for (std::size_t row = 0; row < 3; ++row) {
      double divergence = 0.0;
      for (std::size_t column = 0; column < 3; ++column)
        divergence +=
            (stress(1 + 2 * column, 3 * row + column) - stress(2 + 2 * column, 3 * row + column)) /
            (2.0 * step);
      EXPECT_NEAR(-divergence, expectations[row], 1e-4 * scale);
    }
  }
}

TEST(Fields, one_pair_has_its_closed_form) {
  ParticleSet set;
  set.particles.resize(2);
  for (Particle& p : set.particles) {
    p.mass = 2.0;
    p.semiaxes = {1.0, 1.0, 1.0};
  }
  set.particles[0].centre = {0.0, 0.0, -1.0};
  set.particles[1].centre = {0.0, 0.0, 1.0};
  const double w = 0.7, f = 3.0, x = 0.4, z = 0.5;
  const CoarseGrainingFunction phi(CoarseGrainingShape::gaussian, w);
  const PeriodicCell open;
  const auto targets = point_targets({{x, 0.0, z}}, phi, open, 2.0);
  add_frame(*targets, set, {{0, 1, {}, {0.0, 0.0, -f}, Vector3{0.0, 0.0, 1.0}}}, open, {});
  const Fields fields = fields_of(targets->sums().front());
  // f L times the mean of a Gaussian (0.97070911 of it inside 3 w) along z from -1 to 1
  const double line =
      std::exp(-x * x / (2 * w * w)) / (2 * pi * w * w) * 0.5 *
      (std::erf((1 - z) / (std::sqrt(2.0) * w)) + std::erf((1 + z) / (std::sqrt(2.0) * w))) /
      0.97070911;
  // the cut-off at 3 w = 2.1 lies beyond both ends
  EXPECT_NEAR(fields.contact_stress[8], f * line, 1e-7 * f);
  EXPECT_NEAR(fields.contact_stress[0], 0.0, 1e-15);
  const double volume = 4.0 / 3.0 * pi;
  const double both = phi.value(x * x + 0.25) + phi.value(x * x + 2.25);
  EXPECT_NEAR(fields.fabric[8], volume * both, 1e-12);
  EXPECT_NEAR(fields.density, 2.0 * both, 1e-12);
}

TEST(Fields, planes_are_means_over_points) {
  const Cloud cloud(8);
  const PeriodicCell cell({-0.5, 0.2, 0.0},
                          {Vector3{2.0, 0.0, 0.0}, Vector3{0.0, 1.5, 0.0}, Vector3{0.0, 0.0, 1.8}},
                          {true, true, true});
  Box section;
  section.lower[0] = -0.3;
  section.upper[0] = 0.9;
  section.lower[1] = 0.4;
  section.upper[1] = 1.1;
  for (const CoarseGrainingShape shape : shapes)
    for (const std::size_t axis : {0u, 2u}) {
      const CoarseGrainingFunction phi(shape, 0.3);
      const double place = 0.77;
      std::vector<Vector3> points;
      constexpr int n = 150;
      for (int k = 0; k < n * n; ++k) {
        const double u = (k % n + 0.5) / n, v = (k / n + 0.5) / n;
        points.push_back(axis == 2 ? Vector3{-0.5 + 2.0 * u, 0.2 + 1.5 * v, place}
                                   : Vector3{place, 0.2 + 1.5 * u, 1.8 * v});
      }
      const auto one = point_targets(points, phi, cell, 0.6);
      const auto plane = plane_targets(axis, {place}, {}, phi, cell, 0.6);
      add_frame(*one, cloud.set, cloud.contacts, cell, {});
      add_frame(*plane, cloud.set, cloud.contacts, cell, {});
      for (std::size_t k = 0; k < field_size; ++k) {
        double mean = 0.0;
        for (const FieldSums& sums : one->sums())
          mean += sums[k] / (n * n);
        // the ball's edge is not smooth
        EXPECT_NEAR(plane->sums()[0][k], mean,
                    shape == CoarseGrainingShape::heaviside ? 0.02 : 1e-4)
            << k;
      }
    }
  // in a section particles count by their centres: 0.3 / 0.0 of them
  const CoarseGrainingFunction phi(CoarseGrainingShape::lucy, 0.3);
  const auto plane = plane_targets(2, {0.77}, section, phi, cell, 0.6);
  add_frame(*plane, cloud.set, {}, cell, {});
  double expected = 0.0;
  for (const Particle& p : cloud.set.particles) {
    const Vector3 c = cell.wrapped(p.centre);
    if (c.x >= -0.3 && c.x < 0.9 && c.y >= 0.4 && c.y < 1.1)
      for (const double shift : {-1.8, 0.0, 1.8})
        expected += p.mass * phi.over_plane(c.z + shift - 0.77) / (1.2 * 0.7);
  }
  EXPECT_GT(expected, 0.0);
  EXPECT_NEAR(plane->sums()[0][field_mass], expected, 1e-12);
}

TEST(Fields, temperatures_leave_out_the_mean_motion) {
  const CoarseGrainingFunction phi(CoarseGrainingShape::lucy, 1.0);
  const PeriodicCell open;
  Cloud cloud(9);
  for (Particle& p : cloud.set.particles) {
    p.velocity = {3.0, -1.0, 2.0};
    p.angular_velocity = {0.5, 0.25, -1.0};
  }
  const Vector3 near = cloud.set.particles[0].centre + Vector3{0.1, 0.2, 0.1};
  const auto still = point_targets({near}, phi, open, 0.6);
  add_frame(*still, cloud.set, {}, open, {});
  const Fields rigid = fields_of(still->sums()[0]);
  EXPECT_NEAR(rigid.temperature, 0.0, 1e-13);
  EXPECT_NEAR(rigid.rotational_temperature, 0.0, 1e-13);
  EXPECT_NEAR(rigid.angular_velocity.z, -1.0, 1e-12);
  EXPECT_NEAR(rigid.velocity.x, 3.0, 1e-12);
  // two equal balls at the same distance that fly and spin against each other
  ParticleSet pair;
  pair.particles.resize(2);
  for (std::size_t k = 0; k < 2; ++k) {
    Particle& p = pair.particles[k];
    const double sign = k == 0 ? 1.0 : -1.0;
    p.mass = 2.0;
    p.semiaxes = {0.5, 0.5, 0.5};
    p.centre = {0.3 * sign, 0.0, 0.0};
    p.velocity = {1.0 + 0.6 * sign, 0.0, 0.0};
    p.angular_velocity = {0.0, 4.0 * sign, 0.0};
  }
  const auto two = point_targets({{0.0, 0.0, 0.0}}, phi, open, 0.6);
  add_frame(*two, pair, {}, open, {});
  const Fields f = fields_of(two->sums()[0]);
  EXPECT_NEAR(f.temperature, 0.6 * 0.6 / 3.0, 1e-13);
  EXPECT_NEAR(f.rotational_temperature, 0.4 * 0.25 * 16.0 / 3.0, 1e-13); // I = 2/5 m r^2
  EXPECT_NEAR(f.kinetic_stress[0], f.density * 0.36, 1e-12);
}

TEST(Fields, a_turn_of_the_axes_turns_all_components) {
  Cloud cloud(10);
  const CoarseGrainingFunction phi(CoarseGrainingShape::gaussian, 1.0);
  const PeriodicCell open;
  const Quaternion turn = normalized(Quaternion{0.3, -0.5, 0.7, 0.2});
  const Quaternion back{turn.w, -turn.x, -turn.y, -turn.z};
  const Rotation3 axes = rotation(turn);
  const Vector3 point{0.2, 0.3, -0.4};
  const auto before = point_targets({point}, phi, open, 9.0);
  add_frame(*before, cloud.set, cloud.contacts, open, {});
  for (Particle& p : cloud.set.particles) { // everything in the turned coordinates
    p.centre = axes.to_body(p.centre);
    p.velocity = axes.to_body(p.velocity);
    p.angular_velocity = axes.to_body(p.angular_velocity);
    p.orientation = back * p.orientation;
  }
  for (ForceContact& c : cloud.contacts) {
    c.point = axes.to_body(*c.point);
    c.force = axes.to_body(c.force);
  }
  const auto after = point_targets({axes.to_body(point)}, phi, open, 9.0);
  add_frame(*after, cloud.set, cloud.contacts, open, {});
  const FieldSums expected = turned(before->sums()[0], axes);
  for (std::size_t k = 0; k < field_size; ++k)
    EXPECT_NEAR(after->sums()[0][k], expected[k], 1e-12) << k;
}

TEST(Fields, a_stack_carries_the_weight_above) {
  // balls on a floor at z = 0, the forces between them the weights above
  constexpr int count = 8;
  const double weight = 2.0, r = 0.5, area = 3.0 * 2.0;
  const PeriodicCell cell({0.0, 0.0, 0.0},
                          {Vector3{3.0, 0.0, 0.0}, Vector3{0.0, 2.0, 0.0}, Vector3{0.0, 0.0, 9.0}},
                          {true, true, false});
  ParticleSet set;
  std::vector<ForceContact> contacts;
  for (int k = 0; k < count; ++k) {
    Particle p;
    p.mass = weight / 10.0;
    p.semiaxes = {r, r, r};
    p.centre = {0.1, 0.2, r * (2 * k + 1)};
    set.particles.push_back(p);
    const auto n = static_cast<std::size_t>(k);
    const Vector3 force{0.0, 0.0, weight * (count - k)}, below{0.1, 0.2, 2 * r * k};
    if (k == 0)
      contacts.push_back({n, {}, below, force, Vector3{0.0, 0.0, -1.0}});
    else
      contacts.push_back({n, n - 1, below, force, Vector3{0.0, 0.0, -1.0}});
  }
  const CoarseGrainingFunction phi(CoarseGrainingShape::gaussian, 0.6);
  std::vector<double> heights;
  for (double z = -2.0; z < 10.0; z += 0.01)
    heights.push_back(z);
  const auto planes = plane_targets(2, heights, {}, phi, cell, 1.0);
  add_frame(*planes, set, contacts, cell, {});
  double above = 0.0; // weight of the material above, less what the floor bears
  for (std::size_t k = heights.size(); k-- > 1;) {
    const FieldSums &here = planes->sums()[k], &below = planes->sums()[k - 1];
    const double body_force =
        10.0 * 0.5 * (here[field_mass] + below[field_mass]) +
        0.5 * (here[field_boundary_force + 2] + below[field_boundary_force + 2]);
    above += 0.01 * body_force;
    EXPECT_NEAR(below[field_contact_stress + 8], above, 1e-4 * weight * count / area) << heights[k];
  }
  EXPECT_NEAR(planes->sums()[600][field_contact_stress + 8] * area, 4 * weight + 0.0, 0.3 * weight);
}

} // namespace
} // namespace ellipsoid::post
