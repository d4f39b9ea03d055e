// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Clumps from lists: centre of mass and principal frame against sampling of the union, text
// formats.
#include "multisphere/clump_template.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

using namespace ellipsoid;

namespace {

std::string error_of(const std::string& text) {
  try {
    make_clump(parse_sphere_list(text));
  } catch (const std::invalid_argument& problem) {
    return problem.what();
  }
  return "";
}

/// Volume, first and second moments of the union by points in its box.
struct Sampled {
  double volume = 0.0;
  Vector3 centre;
  SymmetricMatrix3 inertia;

  Sampled(const SphereSet& set, double half, int count) {
    std::mt19937_64 engine{20260611};
    std::uniform_real_distribution<double> along(-half, half);
    const double share = std::pow(2.0 * half, 3) / count;
    for (int n = 0; n < count; ++n) {
      const Vector3 p{along(engine), along(engine), along(engine)};
      bool inside = false;
      for (std::size_t k = 0; k < set.radii.size() && !inside; ++k)
        inside = norm(p - set.centres[k]) < set.radii[k];
      if (!inside)
        continue;
      volume += share;
      centre += share * p;
      inertia = inertia + share * SymmetricMatrix3{p.y * p.y + p.z * p.z,
                                                   p.x * p.x + p.z * p.z,
                                                   p.x * p.x + p.y * p.y,
                                                   -p.x * p.y,
                                                   -p.x * p.z,
                                                   -p.y * p.z};
    }
  }
};

const std::string hook = "0 0 0 1\n1.2 0 0 0.8\n2.0 0.5 0 0.6\n2.2 1.2 0.3 0.5\n0 0 0.9 0.5\n";

} // namespace

TEST(ClumpTemplate, CentreOfMassAndPrincipalFrameBySampling) {
  const ClumpTemplate clump = make_clump(parse_sphere_list(hook));
  const double size = clump.semiaxes.y;
  const Sampled sampled(clump.spheres, clump.bounding_radius / size, 4000000);
  const double volume = clump.volume / (size * size * size);
  EXPECT_NEAR(sampled.volume / volume, 1.0, 3e-3);
  EXPECT_LE(norm(sampled.centre), 3e-3 * volume);
  const Vector3 moments = (1.0 / std::pow(size, 5)) * clump.moments;
  const double sum = moments.x + moments.y + moments.z;
  for (const double product : {sampled.inertia.xy, sampled.inertia.xz, sampled.inertia.yz})
    EXPECT_LE(std::fabs(product), 3e-3 * sum);
  EXPECT_NEAR(sampled.inertia.xx, moments.x, 5e-3 * sum);
  EXPECT_NEAR(sampled.inertia.yy, moments.y, 5e-3 * sum);
  EXPECT_NEAR(sampled.inertia.zz, moments.z, 5e-3 * sum);
  EXPECT_LE(moments.x, moments.y);
  EXPECT_LE(moments.y, moments.z);
}

TEST(ClumpTemplate, DumbbellInAnyPoseIsTheSameBody) {
  // Two unit spheres 1 apart: volume 2 (4/3 pi - cap), cap pi h^2 (3 - h) / 3 with h = 1/2.
  const double cap = M_PI * 0.25 * 2.5 / 3.0, volume = 2.0 * (4.0 / 3.0 * M_PI - cap);
  for (const std::string& text :
       {std::string("-0.5 0 0 1\n0.5 0 0 1\n"), std::string("7 3 -2 1\n7.6 3.8 -2 1\n"),
        std::string("7,3,-2,1\n7.48,3.6,-1.36,1\n")}) {
    const ClumpTemplate clump = make_clump(parse_sphere_list(text));
    EXPECT_NEAR(clump.volume, volume, 1e-12 * volume);
    EXPECT_NEAR(clump.semiaxes.x, 1.5, 1e-12);
    EXPECT_NEAR(clump.semiaxes.y, 1.0, 1e-12);
    EXPECT_NEAR(clump.semiaxes.z, 1.0, 1e-12);
    EXPECT_NEAR(clump.bounding_radius, 1.5, 1e-12);
    EXPECT_NEAR(clump.moments.y, clump.moments.z, 1e-12 * clump.moments.y);
    EXPECT_NEAR(std::fabs(clump.spheres.centres[0].x), 0.5, 1e-12);
  }
}

TEST(ClumpTemplate, PrincipalAxesOfTheListStay) {
  // The long axis along y: already principal, so the frame is that of the list, bit for bit.
  const ClumpTemplate clump = make_clump(parse_sphere_list("0 -0.5 0 1\n0 0.5 0 1\n"));
  EXPECT_EQ(clump.spheres.centres[1].y * clump.semiaxes.y, 0.5);
  EXPECT_EQ(clump.spheres.centres[1].x, 0.0);
  EXPECT_LT(clump.moments.y, clump.moments.x);
}

TEST(ClumpTemplate, DoubledSpheresCountOnce) {
  const ClumpTemplate once = make_clump(parse_sphere_list(hook));
  const ClumpTemplate twice = make_clump(parse_sphere_list(hook + hook + "-0.0 0 -0 1\n"));
  EXPECT_EQ(once.equal_spheres, 0);
  EXPECT_EQ(twice.equal_spheres, 6);
  EXPECT_TRUE(are_same(once, twice));
  EXPECT_EQ(once.volume, twice.volume);
}

TEST(ClumpTemplate, BodyFrameListComesBack) {
  const ClumpTemplate clump = make_clump(parse_sphere_list(hook));
  SphereSet set = clump.spheres;
  for (Vector3& centre : set.centres)
    centre *= clump.semiaxes.y;
  for (double& radius : set.radii)
    radius *= clump.semiaxes.y;
  const SphereList list = parse_sphere_list(body_frame_list(set, "a hook"));
  EXPECT_TRUE(list.is_body_frame);
  const ClumpTemplate again = make_clump(list);
  EXPECT_TRUE(again.is_principal);
  EXPECT_TRUE(are_same(clump, again));
  EXPECT_TRUE(has_shape_of(clump, 3.0 * again.semiaxes));
  EXPECT_FALSE(has_shape_of(clump, {again.semiaxes.x, again.semiaxes.y, 1.001 * again.semiaxes.z}));
  const ClumpTemplate shifted = make_clump(parse_sphere_list("# frame: body\n" + hook));
  EXPECT_FALSE(shifted.is_principal); // whoever says so has to give the moments
  EXPECT_FALSE(are_same(clump, shifted));
}

TEST(ClumpTemplate, FormatsOfLists) {
  const SphereList plain = parse_sphere_list("# host\n\n 0 0 0 1\n1.5\t0  0 1 \r\n");
  for (const char* text :
       {"0,0,0,1\n1.5,0,0,1\n", "x,y,z,r\n0,0,0,1\n1.5,0,0,1\n",
        "id;radius;X;Y;Z\n1;1;0;0;0\n2;1;1.5;0;0\n", "% CLUMP\n0 0 0 1e0\n1.5 0 0 1",
        "\xEF\xBB\xBFx,y,z,r\r\n0,0,0,1\r\n\r\n1.5,0,0,1\r\n", "0 0 0 1\r1.5 0 0 1\r",
        "0 0 0 1 # first\n// none\n1.5 0 0 1# last\n"}) {
    const SphereList list = parse_sphere_list(text);
    ASSERT_EQ(list.spheres.count(), 2) << text;
    EXPECT_EQ(list.spheres.centres[1].x, 1.5);
    EXPECT_EQ(list.spheres.radii, plain.spheres.radii);
    EXPECT_FALSE(list.is_body_frame);
  }
}

TEST(ClumpTemplate, BadListsInOneLine) {
  const std::pair<const char*, const char*> cases[] = {
      {"", "no sphere; lines x y z r"},
      {"0 0 0 1\n0 0 zero 1\n", "line 2: 'zero'"},
      {"0 0 0 1\n0 0 1\n", "line 2: 3 values, the first line has 4"},
      {"0 0 0\n", "line 1: 3 values"},
      {"1 0 0 0 1\n", "line 1: 5 values"},
      {"x,y,z\n1,2,3\n", "no column r"},
      {"x,y,z,r,Radius\n0,0,0,1,1\n", "line 1: two columns r"},
      {"0 0 0 1\r\n1 0 0 x\r\n", "line 2: 'x'"},
      {"0 0 0 1e200\n", "radii from 1e-30 to 1e+30"},
      {"0 0 0 1e-200\n", "radii from 1e-30 to 1e+30"},
      {"0 0 1e60 1\n", "choose another unit"},
      {"0 0 0 1\n1 0 0 0\n", "sphere 2 has the radius 0"},
      {"0 0 0 1\n1 0 0 -1\n", "sphere 2 has the radius -1"},
      {"0 0 0 1\n1 0 nan 1\n", "sphere 2 has the centre"},
      {"0 0 0 1\n5 0 0 1\n", "2 bodies apart, sphere 2 is 3 from"}};
  for (const auto& [text, message] : cases)
    EXPECT_NE(error_of(text).find(message), std::string::npos) << text << error_of(text);
  std::string many;
  for (int k = 0; k < 300000; ++k)
    many += "0 0 0 1\n";
  EXPECT_NE(error_of(many).find("300000 spheres; allowed are 1 to 9999"), std::string::npos);
}
