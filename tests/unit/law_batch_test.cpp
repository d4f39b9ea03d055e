// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The contact law in batches against the functions of contact_law.h, contact by contact: the same
// bits.
#include "law/law_batch.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

using namespace ellipsoid;

namespace {

struct Contact {
  ContactFrame frame;
  PairMotion motion;
  LawParameters parameters;
  PairMasses masses;
  Vector3 spring;
};

class RandomContacts {
 public:
  /// Some without a spring, some with a spring across the tangent plane, some that slip.
  explicit RandomContacts(bool in_plane = false) : in_plane_(in_plane) {}

  Contact next() {
    Contact c;
    const Vector3 normal = normalized(vector(1.0));
    c.frame = {normal, vector(2e-3), vector(2e-3), positive(1e-6), positive(2e-3), 1e-3, 1e-3};
    c.motion = {vector(0.05), spin(), spin()};
    c.parameters = {positive(2e8), positive(1e8), positive(1e3), positive(1e3), positive(1.0)};
    c.masses = {positive(1e-6), positive(1e-6)};
    const double kind = positive(1.0);
    c.spring = kind < 0.2 ? Vector3{} : kind < 0.4 ? positive(1e-7) * normal : vector(1e-7);
    if (kind > 0.9)
      c.frame.overlap = 0.0;
    return c;
  }

 private:
  std::mt19937_64 random_{20260};
  std::normal_distribution<double> gauss_;
  std::uniform_real_distribution<double> uniform_;
  bool in_plane_;
  Vector3 vector(double size) {
    const double x = size * gauss_(random_), y = size * gauss_(random_);
    return {x, y, in_plane_ ? 0.0 : size * gauss_(random_)};
  }
  Vector3 spin() { return in_plane_ ? Vector3{0.0, 0.0, 10.0 * gauss_(random_)} : vector(10.0); }
  double positive(double size) { return size * uniform_(random_); }
};

/// Contact by contact, by the functions of contact_law.h.
ContactAction single(const Contact& c, const LawPass& pass, Vector3& spring, bool& slips) {
  const ContactFrame& at = c.frame;
  const Vector3 velocity = c.motion.velocity + (cross(c.motion.omega_i, at.lever_i) -
                                                cross(c.motion.omega_j, at.lever_j));
  const double normal_velocity = dot(velocity, at.normal);
  const Vector3 slip_velocity = velocity - normal_velocity * at.normal;
  const double root = std::sqrt(at.reduced_radius * at.overlap);
  double normal_force = normal_stiffness(c.parameters.effective_modulus, root) * at.overlap -
                        c.parameters.normal_damping * c.masses.effective() * normal_velocity;
  if (pass.no_attraction && normal_force < 0.0)
    normal_force = 0.0;
  if (pass.advances_springs)
    advance_spring(spring, slip_velocity, pass.time_step, at.normal);
  const double limit = c.parameters.friction * std::fabs(normal_force);
  const Vector3 friction = tangential_force(
      SlipDirection::displacement,
      {tangential_stiffness(c.parameters.effective_shear_modulus, root),
       c.parameters.tangential_damping * c.masses.effective(), limit, slip_velocity},
      spring);
  slips = norm(friction) > (1.0 - 1e-12) * limit;
  const Vector3 force = normal_force * at.normal + friction;
  return {force, cross(at.lever_i, force), cross(force, at.lever_j), normal_force};
}

void expect_same(const Vector3& found, const Vector3& expected) {
  EXPECT_EQ(found.x, expected.x);
  EXPECT_EQ(found.y, expected.y);
  EXPECT_EQ(found.z, expected.z);
}

} // namespace

class LawBatchTest : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Motion, LawBatchTest, testing::Values(false, true),
                         [](const auto& info) { return info.param ? "in_plane" : "in_space"; });

TEST_P(LawBatchTest, GivesTheBitsOfSingleContacts) {
  RandomContacts random(GetParam());
  int slipping = 0, sticking = 0;
  for (const LawPass& pass :
       {LawPass{5e-6, true, false}, LawPass{5e-6, true, true}, LawPass{5e-6, false, false}})
    for (const int count : {1, 7, 16, ContactLawBatch::capacity}) {
      ContactLawBatch batch;
      std::vector<Contact> contacts;
      for (int k = 0; k < count; ++k) {
        contacts.push_back(random.next());
        const Contact& c = contacts.back();
        batch.add(c.frame);
        batch.set_state(k, c.motion, c.parameters, c.masses, c.spring);
      }
      batch.solve(pass);
      for (int k = 0; k < count; ++k) {
        Contact& c = contacts[static_cast<std::size_t>(k)];
        bool slips = false;
        const ContactAction expected = single(c, pass, c.spring, slips);
        const ContactAction found = batch.action(k);
        expect_same(found.force, expected.force);
        expect_same(found.torque_i, expected.torque_i);
        expect_same(found.torque_j, expected.torque_j);
        EXPECT_EQ(found.normal_force, expected.normal_force);
        expect_same(batch.spring(k), c.spring);
        ++(slips ? slipping : sticking);
      }
    }
  EXPECT_GT(slipping, 50);
  EXPECT_GT(sticking, 50);
}

TEST(ContactLawBatch, ActionIsReaction) {
  RandomContacts random;
  ContactLawBatch forth, back;
  std::vector<Contact> contacts;
  for (int k = 0; k < ContactLawBatch::capacity; ++k) {
    const Contact c = random.next();
    forth.add(c.frame);
    forth.set_state(k, c.motion, c.parameters, c.masses, c.spring);
    back.add({-c.frame.normal, c.frame.lever_j, c.frame.lever_i, c.frame.overlap,
              c.frame.reduced_radius, c.frame.radius_j, c.frame.radius_i});
    back.set_state(k, {-c.motion.velocity, c.motion.omega_j, c.motion.omega_i}, c.parameters,
                   {c.masses.j, c.masses.i}, -c.spring);
  }
  const LawPass pass{5e-6, true, false};
  forth.solve(pass);
  back.solve(pass);
  for (int k = 0; k < ContactLawBatch::capacity; ++k) {
    const ContactAction there = forth.action(k), here = back.action(k);
    expect_same(here.force, -there.force);
    expect_same(here.torque_i, there.torque_j);
    expect_same(here.torque_j, there.torque_i);
    expect_same(back.spring(k), -forth.spring(k));
  }
}
