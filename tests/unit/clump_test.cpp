// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "multisphere/clump.h"

#include <gtest/gtest.h>
#include <limits>
#include <stdexcept>
#include <string>

using namespace ellipsoid;

namespace {

template <class Check> std::string message_of(const Check& check) {
  try {
    check();
  } catch (const std::invalid_argument& problem) {
    return problem.what();
  }
  return "";
}

const SphereSet three{{{0, 0, 0}, {1.5, 0, 0}, {1.5, 2.0, 0}}, {1.0, 1.0, 1.0}};

} // namespace

TEST(Clump, SoundSetsPass) {
  EXPECT_NO_THROW(check_spheres(three));
  EXPECT_NO_THROW(check_connected(three)); // the last two touch in a point
  EXPECT_EQ(connected_parts(three), (std::vector<int>{0, 0, 0}));
}

TEST(Clump, BadSpheresAreNamed) {
  SphereSet set = three;
  set.radii[1] = 0.0;
  EXPECT_NE(message_of([&] { check_spheres(set); }).find("sphere 2 has the radius 0;"),
            std::string::npos);
  set.radii[1] = std::numeric_limits<double>::infinity();
  EXPECT_NE(message_of([&] { check_spheres(set); }).find("sphere 2 has the radius inf;"),
            std::string::npos);
  set = three;
  set.centres[2].z = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(message_of([&] { check_spheres(set); }).find("sphere 3 has the centre"),
            std::string::npos);
  set = three;
  set.radii.pop_back();
  EXPECT_NE(message_of([&] { check_spheres(set); }).find("2 radii for 3 centres"),
            std::string::npos);
  EXPECT_NE(message_of([] { check_spheres({}); }).find("0 spheres; allowed are 1 to 9999"),
            std::string::npos);
  SphereSet many;
  many.centres.resize(300000);
  many.radii.assign(300000, 1.0);
  EXPECT_NE(message_of([&] { check_spheres(many); }).find("300000 spheres; allowed"),
            std::string::npos);
}

TEST(Clump, EqualSpheresAreLeftOutTheFirstStays) {
  SphereSet set{{{0, 0, 0}, {1.5, 0, 0}, {-0.0, 0, 0}, {0, 0, 0}, {1.5, 0, 0}, {0, 1, 0}},
                {1.0, 0.8, 1.0, 0.9, 0.8, 1.0}};
  EXPECT_NO_THROW(check_values(set));
  EXPECT_NE(message_of([&] { check_spheres(set); }).find("spheres 1 and 3 are equal"),
            std::string::npos);
  EXPECT_EQ(leave_out_equal_spheres(set), 2);
  EXPECT_EQ(set.radii, (std::vector<double>{1.0, 0.8, 0.9, 1.0}));
  EXPECT_EQ(set.centres[1].x, 1.5);
  EXPECT_EQ(set.centres[3].y, 1.0);
  EXPECT_NO_THROW(check_spheres(set));
  EXPECT_EQ(leave_out_equal_spheres(set), 0);
  EXPECT_EQ(set.count(), 4);
}

TEST(Clump, PartsOfDisconnectedSets) {
  const SphereSet apart{{{0, 0, 0}, {5, 0, 0}, {1, 0, 0}, {9, 0, 0}, {6, 0, 0}},
                        {1.0, 1.0, 1.0, 1.0, 1.0}};
  EXPECT_EQ(connected_parts(apart), (std::vector<int>{0, 1, 0, 2, 1}));
  const std::string message = message_of([&] { check_connected(apart); });
  EXPECT_NE(message.find("3 bodies apart, sphere 2 is 2 from that of sphere 1"), std::string::npos)
      << message;
}
