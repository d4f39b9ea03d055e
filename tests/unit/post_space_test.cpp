// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Measures in space: heaps, beds, orientation, contacts, energies with known answers.
#include "bed.h"
#include "contact_forces.h"
#include "energy.h"
#include "heap.h"
#include "orientation.h"
#include "space_picture.h"
#include "space_scenery.h"
#include "template_files.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace ellipsoid::post {
namespace {

constexpr double pi = 3.141592653589793238462643;

Particle ball(double radius, const Vector3& centre) {
  Particle p;
  p.semiaxes = {radius, radius, radius};
  p.centre = centre;
  return p;
}

Quaternion random_turn(std::mt19937& generator) {
  std::normal_distribution<double> normal;
  return normalized(
      Quaternion{normal(generator), normal(generator), normal(generator), normal(generator)});
}

/// Balls whose centres lie close together on a cone of the given slope about (0.3, -0.2).
ParticleSet cone(double degrees, double height, double radius) {
  ParticleSet set;
  const double slope = std::tan(degrees * pi / 180.0), step = 0.5 * radius;
  for (double r = 0.0; height - slope * r > 0.0; r += step) {
    const int count = 1 + static_cast<int>(2.0 * pi * r / step);
    for (int k = 0; k < count; ++k) {
      const double turn = 2.0 * pi * k / count;
      set.particles.push_back(
          ball(radius, {0.3 + r * std::cos(turn), -0.2 + r * std::sin(turn), height - slope * r}));
    }
  }
  return set;
}

TEST(Heap, a_cone_has_its_angle_in_every_sector) {
  for (const double degrees : {15.0, 25.0}) {
    const HeapAngle heap = heap_angle(cone(degrees, 1.0, 0.04), {});
    // the axis shifts by less than a column; rings and balls wave the surface by radius / 30
    EXPECT_NEAR(heap.spread.mean, degrees, 0.2);
    EXPECT_LT(heap.spread.half_range, 0.5);
    EXPECT_NEAR(heap.axis_x, 0.3, 0.01);
    EXPECT_NEAR(heap.axis_y, -0.2, 0.01);
    EXPECT_EQ(heap.sector_angles_deg.size(), 12u);
  }
}

TEST(Heap, the_up_axis_is_only_a_turn) {
  const ParticleSet upright = cone(25.0, 0.5, 0.04);
  ParticleSet lying = upright; // the file's y is up: (x, y, z) of the plan are the file's z, x, y
  for (Particle& p : lying.particles)
    p.centre = {p.centre.y, p.centre.z, p.centre.x};
  EXPECT_EQ(heap_angle(turned_upright(lying, UpAxis::y), {}).spread.mean,
            heap_angle(upright, {}).spread.mean);
}

TEST(HeightMap, tops_lie_on_the_surface) {
  std::mt19937 generator(3);
  for (int trial = 0; trial < 200; ++trial) {
    Particle p = ball(1.0, {0.5, -1.0, 2.0});
    p.semiaxes = {3.0, 2.0, 1.0};
    p.orientation = random_turn(generator);
    double z = 0.0;
    const double x = 0.5 + 0.004 * trial, y = -1.2;
    ASSERT_TRUE(top_of_ellipsoid(p, x, y, z));
    const Vector3 b = rotation(p.orientation).to_body(Vector3{x, y, z} - p.centre);
    EXPECT_NEAR(b.x * b.x / 9.0 + b.y * b.y / 4.0 + b.z * b.z, 1.0, 1e-12);
    EXPECT_FALSE(top_of_ellipsoid(p, 5.0, y, z));
  }
}

/// A cubic lattice of touching ellipsoids that fills a box.
ParticleSet cubic(int count, const Vector3& s) {
  ParticleSet set;
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j)
      for (int k = 0; k < count; ++k) {
        Particle p = ball(1.0, {s.x * (2 * i + 1), s.y * (2 * j + 1), s.z * (2 * k + 1)});
        p.semiaxes = s;
        set.particles.push_back(p);
      }
  return set;
}

TEST(Bed, a_cubic_lattice_has_one_minus_pi_over_six) {
  const Vector3 s{3.0, 2.0, 1.0};
  const ParticleSet set = cubic(4, s);
  BedRegion box{BedShape::box, 0.0, 24.0, 0.0, 16.0, 0.0, 0.0, 0.0, 0.0, 8.0};
  const BedPorosity p = bed_porosity(set, box, 800);
  EXPECT_NEAR(p.porosity, 1.0 - pi / 6.0, p.error + 1e-12);
  EXPECT_LT(p.error, 1e-4);
  // half of a layer of particles in z, whole ones in x and y
  box.z0 = 2.0;
  box.z1 = 5.0;
  EXPECT_NEAR(bed_porosity(set, box, 1200).porosity, 1.0 - pi / 6.0, 1e-5);
  // a box of empty space between four particles is not quite empty; one far away is
  box.z0 = 20.0;
  box.z1 = 21.0;
  EXPECT_EQ(bed_porosity(set, box, 8).porosity, 1.0);
  box.z1 = 20.0;
  EXPECT_THROW(bed_porosity(set, box, 8), InputError);
}

TEST(Bed, profiles_of_one_ball) {
  ParticleSet set;
  set.particles = {ball(1.0, {0.0, 0.0, 0.0})};
  const BedRegion cylinder{BedShape::cylinder, 0, 0, 0, 0, 0.0, 0.0, 1.0, -1.0, 1.0};
  EXPECT_NEAR(bed_porosity(set, cylinder, 2000).porosity, 1.0 / 3.0, 1e-5);
  const auto layers = height_profile(set, cylinder, 4, 800);
  // spherical segment from z0 to z1: pi (z1 - z0 - (z1^3 - z0^3) / 3)
  EXPECT_NEAR(layers[0].porosity, 1.0 - (0.5 - (1.0 - 0.125) / 3.0) / 0.5, 1e-5);
  EXPECT_NEAR(layers[1].porosity, 1.0 - (0.5 - 0.125 / 3.0) / 0.5, 1e-5);
  const auto rings = radial_profile(set, cylinder, 2, 2000);
  // inside radius r: 4 pi / 3 (1 - (1 - r^2)^(3/2)) of 2 pi r^2
  const double inner = 4.0 / 3.0 * (1.0 - std::pow(0.75, 1.5));
  EXPECT_NEAR(rings[0].porosity, 1.0 - inner / 0.5, 1e-3);
  EXPECT_NEAR(rings[1].porosity, 1.0 - (4.0 / 3.0 - inner) / 1.5, 1e-3);
}

TEST(Bed, below_its_surface_in_a_box_that_is_too_high) {
  const ParticleSet set = cubic(4, {1.0, 1.0, 1.0}); // the surface: tops of balls over 8 x 8
  const HeightMap surface(set, all_members(set), 0.01, 0.0);
  const BedRegion box{BedShape::box, 0.0, 8.0, 0.0, 8.0, 0.0, 0.0, 0.0, 0.0, 20.0};
  // Over a cell of 2 x 2: 28 below the middles of the highest balls, half a ball over them; the
  // columns beside the balls' shadow (4 - pi) reach down to the floor.
  const double cell = 7.0 * pi + 2.0 * pi / 3.0;
  const BedPorosity p = bed_porosity(set, box, 4000, surface);
  EXPECT_NEAR(p.total_volume, 16.0 * cell, 2e-3 * p.total_volume);
  EXPECT_NEAR(p.porosity, 1.0 - 4.0 * (4.0 * pi / 3.0) / cell, 2e-3);
  // a box whose edges cut columns has the exact share of them
  BedRegion half = box;
  half.x1 = 4.003;
  const BedPorosity q = bed_porosity(set, half, 4000, surface);
  EXPECT_NEAR(q.total_volume, 0.5 * p.total_volume, 1e-3 * p.total_volume);
  // a cylinder round one stack of balls
  const BedRegion round{BedShape::cylinder, 0, 0, 0, 0, 1.0, 1.0, 1.0, 0.0, 20.0};
  EXPECT_NEAR(bed_porosity(set, round, 4000, surface).total_volume, cell, 2e-3 * cell);
  // layers above the surface have no porosity
  EXPECT_EQ(height_profile(set, box, 10, 400, surface).size(), 4u);
}

TEST(Bed, solid_volume_of_turned_ellipsoids_far_apart) {
  std::mt19937 generator(8);
  ParticleSet set;
  for (int k = 0; k < 5; ++k) {
    Particle p = ball(1.0, {10.0 * k, 0.0, 0.1 * k});
    p.semiaxes = {3.0, 2.0, 1.0};
    p.orientation = random_turn(generator);
    set.particles.push_back(p);
  }
  EXPECT_NEAR(solid_volume(set, all_members(set), 2000, -1e3), 5.0 * 4.0 / 3.0 * pi * 6.0, 1e-3);
}

/// Bodies with these semi-axes and their longest axis along `angle` (rad) in the xy plane.
Particle long_body(const Vector3& semiaxes, double angle) {
  Particle p;
  p.semiaxes = semiaxes;
  const double z_turn = std::cos(0.5 * angle), z_part = std::sin(0.5 * angle);
  const Quaternion turn{z_turn, 0.0, 0.0, z_part};
  const double half = std::sqrt(0.5); // turns by 90 degrees about z (y to x) and y (z to x)
  const bool along_y = semiaxes.y > semiaxes.x && semiaxes.y > semiaxes.z;
  const bool along_z = semiaxes.z > semiaxes.x && semiaxes.z > semiaxes.y;
  const Quaternion to_x = along_y   ? Quaternion{half, 0.0, 0.0, -half}
                          : along_z ? Quaternion{half, 0.0, half, 0.0}
                                    : Quaternion{};
  p.orientation = turn * to_x;
  return p;
}

TEST(Orientation, the_longest_axis_counts_wherever_it_is) {
  for (const Vector3& semiaxes :
       {Vector3{3.0, 1.0, 1.0}, Vector3{1.0, 3.0, 1.0}, Vector3{1.0, 1.0, 3.0}}) {
    ParticleSet set;
    for (int k = 0; k < 10; ++k) // along 30 degrees' direction, either sign
      set.particles.push_back(long_body(semiaxes, pi / 6.0 + (k % 2) * pi));
    EXPECT_EQ(body_axis(set.particles[0]), BodyAxis::longest);
    const Orientation o = orientation(set, all_members(set), BodyAxis::longest, 18);
    EXPECT_NEAR(o.nematic_order, 1.0, 1e-14);
    EXPECT_NEAR(o.plane_order, 1.0, 1e-14);
    EXPECT_NEAR(o.plane_angle_deg, 30.0, 1e-12);
    EXPECT_NEAR(o.flow_angle_deg, 30.0, 1e-12);
    EXPECT_NEAR(std::abs(o.director.x), std::cos(pi / 6.0), 1e-12);
    EXPECT_FALSE(o.biaxial_order);
  }
}

TEST(Orientation, random_bodies_have_no_order) {
  ParticleSet set;
  std::mt19937 generator(2);
  set.particles.assign(20000, long_body({3.0, 2.0, 1.0}, 0.0));
  for (Particle& p : set.particles)
    p.orientation = random_turn(generator);
  const Orientation o = orientation(set, all_members(set), BodyAxis::longest, 18);
  EXPECT_LT(o.nematic_order, 0.02); // 1 / sqrt(20000) = 0.007
  EXPECT_LT(o.plane_order, 0.03);
  EXPECT_LT(*o.biaxial_order, 0.03);
}

TEST(Orientation, discs_lie_by_their_shortest_axis) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> turn(0.0, 2.0 * pi);
  ParticleSet set;
  for (int k = 0; k < 400; ++k) { // flat on the xz plane, turned about y
    Particle p = long_body({2.0, 0.5, 2.0}, 0.0);
    const double angle = turn(generator);
    p.orientation = {std::cos(0.5 * angle), 0.0, std::sin(0.5 * angle), 0.0};
    set.particles.push_back(p);
  }
  EXPECT_EQ(body_axis(set.particles[0]), BodyAxis::shortest);
  const Orientation o = orientation(set, all_members(set), BodyAxis::shortest, 18);
  EXPECT_NEAR(o.nematic_order, 1.0, 1e-12);
  EXPECT_NEAR(std::abs(o.director.y), 1.0, 1e-12);
  EXPECT_EQ(body_axis(ball(1.0, {})), BodyAxis::none);
  EXPECT_EQ(body_axis(long_body({3.0, 1.5, 1.0}, 0.0)), BodyAxis::longest);
  EXPECT_EQ(body_axis(long_body({3.0, 2.5, 1.0}, 0.0)), BodyAxis::shortest);
}

TEST(Orientation, biaxial_order_is_one_where_all_axes_lie_the_same_way) {
  ParticleSet set;
  std::mt19937 generator(4);
  std::uniform_real_distribution<double> turn(0.0, 2.0 * pi);
  const Quaternion anyhow = random_turn(generator);
  set.particles.assign(200, long_body({1.0, 3.0, 2.0}, 0.0));
  for (Particle& p : set.particles)
    p.orientation = anyhow;
  EXPECT_NEAR(*orientation(set, all_members(set), BodyAxis::longest, 9).biaxial_order, 1.0, 1e-12);
  for (Particle& p : set.particles) { // turned about their long axis, the body's y
    const double angle = turn(generator);
    p.orientation = anyhow * Quaternion{std::cos(0.5 * angle), 0.0, std::sin(0.5 * angle), 0.0};
  }
  const Orientation o = orientation(set, all_members(set), BodyAxis::longest, 9);
  EXPECT_NEAR(o.nematic_order, 1.0, 1e-12);
  EXPECT_LT(*o.biaxial_order, 0.2); // 1 / sqrt(200) = 0.07
}

TEST(Orientation, the_flow_angle_is_a_mean_in_its_own_plane) {
  ParticleSet set;
  for (const double degrees : {-80.0, 20.0, 30.0})
    set.particles.push_back(long_body({3.0, 1.0, 1.0}, degrees * pi / 180.0));
  const Orientation o = orientation(set, all_members(set), BodyAxis::longest, 9);
  EXPECT_NEAR(o.flow_angle_deg, -10.0, 1e-12);
  EXPECT_NEAR(o.flow_angle_deviation_deg, std::sqrt((4900.0 + 900.0 + 1600.0) / 2.0), 1e-10);
  const Orientation turned = orientation(set, all_members(set), BodyAxis::longest, 9, {1, 0});
  EXPECT_NEAR(turned.flow_angle_deg, (-10.0 + 70.0 + 60.0) / 3.0, 1e-12); // 90 - angle
}

TEST(Contacts, fabric_and_forces) {
  const PrincipalAxes fabric = mean_dyad({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  EXPECT_NEAR(fabric.values[0], 0.5, 1e-15);
  EXPECT_NEAR(fabric.values[2], 0.25, 1e-15);
  EXPECT_NEAR(std::abs(fabric.direction.x), 1.0, 1e-12);
  const ForceStatistics f = force_statistics({{3, 4, 0}, {0, 1, 0}, {0, 0, -1}, {1, 0, 0}});
  EXPECT_DOUBLE_EQ(f.mean, 2.0);
  EXPECT_DOUBLE_EQ(f.largest, 5.0);
  EXPECT_DOUBLE_EQ(f.strong_share, 0.25);
  EXPECT_DOUBLE_EQ(f.strong_load_share, 0.625);
  EXPECT_DOUBLE_EQ(f.distribution[2], 0.75 / 0.25); // three at half the mean
  EXPECT_DOUBLE_EQ(f.distribution[10], 0.25 / 0.25);
}

TEST(Contacts, links_of_force_chains) {
  ParticleSet set;
  for (const std::int64_t id : {3, 5, 9}) {
    set.particles.push_back(ball(1.0, {static_cast<double>(id), 0.0, 0.0}));
    set.particles.back().id = id;
  }
  Frame list;
  list.location = {"list", 10, 1};
  list.rows = 4;
  list.names = {"i", "j", "fx", "fy", "fz", "nx", "ny", "nz"};
  list.columns = {{3, 5, 9, 5}, {5, 3, 5, 9}, {3, -1, 0, 0}, {4, 0, 2, 0},
                  {0, 0, 0, 0}, {2, 1, 0, 1}, {0, 0, 1, 0},  {0, 0, 0, 0}};
  const ContactColumns all{{"i", "j"}, {"fx", "fy", "fz"}, {}, {}, {}};
  const auto links = force_links(list, all, set);
  ASSERT_EQ(links.size(), 2u); // rows of a pair are added, in either order of its ids
  EXPECT_DOUBLE_EQ(links[0].force, 5.0 + 1.0);
  EXPECT_DOUBLE_EQ(links[1].force, 2.0);
  EXPECT_EQ(links[0].begin.x, 3.0);
  EXPECT_EQ(links[0].end.x, 5.0);
  const auto normal =
      force_links(list, {{"i", "j"}, {"fx", "fy", "fz"}, {"nx", "ny", "nz"}, {}, {}}, set);
  EXPECT_DOUBLE_EQ(normal[0].force, 3.0 + 1.0);
  list.columns[0][2] = 7;
  try {
    force_links(list, all, set);
    FAIL() << "an unknown particle was accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "list:12: frame 1: expected the id of a particle in column \"i\", "
                               "found 7, which the dump of the particles does not have");
  }
}

/// Area of the pixels that are not white (pixels), and the middle of them.
struct Shadow {
  double area = 0.0, x = 0.0, y = 0.0;
};

Shadow shadow_of(const PixelImage& image) {
  Shadow shadow;
  for (std::size_t k = 0; k < image.width * image.height; ++k)
    if (image.samples[3 * k] < 255 || image.samples[3 * k + 2] < 255) {
      shadow.area += 1.0;
      shadow.x += static_cast<double>(k % image.width) + 0.5;
      shadow.y += static_cast<double>(k / image.width) + 0.5;
    }
  shadow.x /= shadow.area;
  shadow.y /= shadow.area;
  return shadow;
}

TEST(SpacePicture, an_ellipsoid_throws_the_shadow_of_its_projection) {
  // area of a parallel projection along n: pi sqrt((b c n_x)^2 + (a c n_y)^2 + (a b n_z)^2)
  std::mt19937 generator(20100603);
  for (int trial = 0; trial < 10; ++trial) {
    ParticleSet set;
    Particle p = ball(1.0, {0.3, -0.2, 0.1});
    p.semiaxes = {2.0, 1.2, 0.7};
    p.orientation = random_turn(generator);
    set.particles.push_back(p);
    SpaceView view;
    view.azimuth_deg = 35.0 * trial;
    view.elevation_deg = -80.0 + 17.0 * trial;
    const SpacePixels pixels = draw_space(set, {Colour{0.2, 0.4, 0.6}}, view);
    const double azimuth = view.azimuth_deg * pi / 180.0,
                 elevation = view.elevation_deg * pi / 180.0;
    const Vector3 n = rotation(p.orientation)
                          .to_body({std::cos(azimuth) * std::cos(elevation),
                                    std::sin(azimuth) * std::cos(elevation), std::sin(elevation)});
    const double area = pi * std::hypot(1.2 * 0.7 * n.x, 2.0 * 0.7 * n.y, 2.0 * 1.2 * n.z);
    const Shadow shadow = shadow_of(pixels.image);
    // pixels that are covered in part count as whole ones: half a pixel around the outline
    const double scale = pixels.pixels_per_length;
    EXPECT_NEAR(shadow.area / (scale * scale), area, 2.0 * 2.0 * pi * 2.0 / scale);
    EXPECT_NEAR(shadow.x, 600.0, 1.0);
    EXPECT_NEAR(shadow.y, 450.0, 1.0);
  }
}

TEST(SpacePicture, a_chosen_part_of_the_space_sets_scale_and_position) {
  ParticleSet set;
  set.particles.push_back(ball(0.5, {2.0, 3.0, 4.0}));
  SpaceView view;
  view.azimuth_deg = -90.0; // along y: x to the right, z upwards
  view.elevation_deg = 0.0;
  view.part = Box();
  for (int k = 0; k < 3; ++k)
    view.part->upper[k] = 8.0;
  const SpacePixels pixels = draw_space(set, {Colour{}}, view);
  EXPECT_NEAR(pixels.pixels_per_length, 0.94 * 900.0 / 8.0, 1e-9);
  const Shadow shadow = shadow_of(pixels.image);
  EXPECT_NEAR(shadow.x, 600.0 + (2.0 - 4.0) * pixels.pixels_per_length, 1.0);
  EXPECT_NEAR(shadow.y, 450.0 - (4.0 - 4.0) * pixels.pixels_per_length, 1.0);
}

/// The colour of the pixel where a place in the camera's plane is seen.
std::array<int, 3> pixel_at(const SpacePixels& pixels, double x, double y) {
  const auto column = static_cast<std::size_t>(pixels.origin.x + x * pixels.pixels_per_length);
  const auto row = static_cast<std::size_t>(pixels.origin.y - y * pixels.pixels_per_length);
  const std::size_t first = 3 * (row * pixels.image.width + column);
  return {pixels.image.samples[first], pixels.image.samples[first + 1],
          pixels.image.samples[first + 2]};
}

TEST(SpacePicture, bodies_hide_what_lies_behind_them_and_nothing_else) {
  ParticleSet set;
  set.particles.push_back(ball(1.0, {}));
  SpaceView view;
  view.azimuth_deg = 0.0; // towards the camera: x; to the right: y; upwards: z
  view.elevation_deg = 0.0;
  view.part = Box();
  for (int k = 0; k < 3; ++k) {
    view.part->lower[k] = -3.0;
    view.part->upper[k] = 3.0;
  }
  const std::vector<Colour> colours{{0.2, 0.4, 0.6}};
  const SpacePixels plain = draw_space(set, colours, view);
  const auto with_wall_at = [&](double x) {
    SpaceScenery scenery;
    scenery.walls = {{{x, -2.0, -2.0}, {x, 2.0, -2.0}, {x, 2.0, 2.0}, {x, -2.0, 2.0}}};
    scenery.lines = {{{x, -2.0, 0.5}, {x, 2.0, 0.5}, LineKind::mesh}};
    scenery.line_width = 5.0;
    return draw_space(set, colours, view, &scenery);
  };
  const SpacePixels before = with_wall_at(1.5), behind = with_wall_at(-1.5),
                    through = with_wall_at(0.5);
  const auto mixed = [](int body, double wall) {
    return static_cast<int>(std::lround(body + wall_opacity * (255.0 * wall - body)));
  };
  const std::array<int, 3> body = pixel_at(plain, 0.1, 0.0);
  const std::array<int, 3> line{77, 107, 140}; // 0.30, 0.42, 0.55
  EXPECT_EQ(pixel_at(behind, 0.1, 0.0), body);
  EXPECT_EQ(pixel_at(behind, 0.1, 0.5), pixel_at(plain, 0.1, 0.5));
  EXPECT_EQ(pixel_at(before, 0.1, 0.5), line);
  EXPECT_EQ(pixel_at(through, 0.1, 0.0), body);  // the ball's top, at 1, lies before the wall
  EXPECT_EQ(pixel_at(through, 0.95, 0.5), line); // beside the ball
  for (int k = 0; k < 3; ++k) {
    const double wall = std::array<double, 3>{0.45, 0.47, 0.50}[static_cast<std::size_t>(k)];
    const auto part = static_cast<std::size_t>(k);
    EXPECT_NEAR(pixel_at(before, 0.1, 0.0)[part], mixed(body[part], wall), 1);
    // at 0.95 from the middle the ball reaches 0.31, behind the wall at 0.5
    EXPECT_NEAR(pixel_at(through, 0.95, 0.0)[part], mixed(pixel_at(plain, 0.95, 0.0)[part], wall),
                1);
    EXPECT_NEAR(pixel_at(behind, 1.5, 0.0)[part], mixed(255, wall), 1);
    EXPECT_EQ(pixel_at(behind, 2.5, 0.0)[part], 255);
  }
}

TEST(SpacePicture, lines_of_any_slope_are_drawn_from_end_to_end) {
  ParticleSet set;
  set.particles.push_back(ball(0.1, {0.0, 2.8, 2.8}));
  SpaceView view;
  view.width = 400;
  view.height = 300;
  view.azimuth_deg = 0.0; // to the right: y; upwards: z
  view.elevation_deg = 0.0;
  view.part = Box();
  for (int k = 0; k < 3; ++k) {
    view.part->lower[k] = -3.0;
    view.part->upper[k] = 3.0;
  }
  const std::array<int, 3> line{77, 107, 140}; // 0.30, 0.42, 0.55
  for (int degrees = -170; degrees <= 180; degrees += 10) {
    const double y = 2.0 * std::cos(degrees * pi / 180.0), z = 2.0 * std::sin(degrees * pi / 180.0);
    SpaceScenery scenery;
    scenery.lines = {{{0.0, 0.0, 0.0}, {0.0, y, z}, LineKind::mesh}};
    scenery.line_width = 5.0;
    const SpacePixels pixels = draw_space(set, {{0.2, 0.4, 0.6}}, view, &scenery);
    for (int part = 0; part <= 20; ++part)
      EXPECT_EQ(pixel_at(pixels, y * part / 20.0, z * part / 20.0), line) << degrees << " " << part;
    EXPECT_NE(pixel_at(pixels, 1.1 * y, 1.1 * z), line) << degrees;
  }
}

TEST(Energy, of_a_spinning_ellipsoid) {
  ParticleSet set;
  Particle p = ball(1.0, {1.0, 2.0, 3.0});
  p.semiaxes = {3.0, 2.0, 1.0};
  p.mass = 5.0;
  p.velocity = {1.0, 2.0, 2.0};
  p.orientation = {std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5)}; // body x along space y
  p.angular_velocity = {0.0, 2.0, 0.0};
  set.particles = {p};
  set.has_velocities = set.has_spins = true;
  EnergyOptions options;
  options.gravity = Vector3{0.0, -9.81, 0.0};
  Energy e = energy(set, options);
  EXPECT_DOUBLE_EQ(e.translation, 22.5);
  EXPECT_NEAR(e.rotation.value(), 0.5 * (2.0 * 2.0 + 1.0) * 4.0, 1e-13); // I1 = m (b^2 + c^2) / 5
  EXPECT_DOUBLE_EQ(e.potential.value(), 5.0 * 9.81 * 2.0);
  options.inertia = Vector3{7.0, 1.0, 1.0};
  e = energy(set, options);
  EXPECT_NEAR(e.rotation.value(), 0.5 * 7.0 * 4.0, 1e-13);
  options.gravity.reset();
  EXPECT_FALSE(energy(set, options).potential.has_value());
  set.has_spins = false;
  EXPECT_THROW(energy(set, options), InputError); // inertia without rotation
  options.inertia.reset();
  EXPECT_FALSE(energy(set, options).rotation.has_value());
  set.has_velocities = false;
  EXPECT_THROW(energy(set, options), InputError);
}

namespace {

/// Positive when the triangles are turned outwards.
double enclosed_volume(const SurfaceMesh& mesh) {
  double volume = 0.0;
  for (const auto& t : mesh.triangles)
    volume += dot(mesh.points[t[0]], cross(mesh.points[t[1]], mesh.points[t[2]])) / 6.0;
  return volume;
}

} // namespace

TEST(SurfaceMesh, encloses_the_volume_and_is_closed) {
  const MultisphereTemplate chain = make_multisphere(2.7, 1.15, 9);
  const SurfaceMesh mesh = outline_of_revolution(chain);
  // circles by 32-gons: sin(2 pi / 32) / (2 pi / 32) = 0.9936 of the volume
  EXPECT_NEAR(enclosed_volume(mesh) / measure(chain).volume, 0.9936, 3e-3);
  // and 25 chords from pole to pole, inside by 1 - (pi / 25)^2 / 4 to the next order
  const double chords = 1.0 - pi * pi / 2500.0;
  EXPECT_NEAR(enclosed_volume(ellipsoid_surface({3.0, 2.0, 1.0})) / (8.0 * pi), 0.9936 * chords,
              2e-4);
  EXPECT_EQ(mesh.triangles.size(), 2 * (mesh.points.size() - 2)); // Euler: closed, no holes
}

} // namespace
} // namespace ellipsoid::post
