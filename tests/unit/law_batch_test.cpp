// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Every law of the batch against formulas written down here a second time, contact by contact and
// with branches; the paper's law (Markauskas et al. 2010) bit by bit.
#include "law/law_batch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

using namespace ellipsoid;

namespace {

struct Contact {
  ContactFrame frame;
  PairMotion motion;
  LawParameters parameters;
  PairMasses masses;
  Vector3 spring, rolling_torque;
};

class RandomContacts {
 public:
  /// Some without a spring, some with a spring across the tangent plane, some that slip.
  explicit RandomContacts(bool in_plane = false) : in_plane_(in_plane) {}

  /// Parameters are uniform between 0 and these, which are right in size for the law.
  Contact next(const std::vector<double>& parameters) {
    Contact c;
    const Vector3 normal = normalized(vector(1.0));
    const auto radius = [this] { return 1e-4 + positive(2e-3); };
    c.frame = {normal, vector(2e-3), vector(2e-3), positive(1e-6), radius(), radius(), radius()};
    c.motion = {vector(0.05), spin(10.0), spin(10.0)};
    for (std::size_t p = 0; p < parameters.size(); ++p)
      c.parameters.values[p] = positive(parameters[p]);
    c.masses = {positive(1e-6), positive(1e-6)};
    const double kind = positive(1.0);
    c.spring = kind < 0.2 ? Vector3{} : kind < 0.4 ? positive(1e-7) * normal : vector(1e-7);
    c.rolling_torque = spin(1e-9);
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
  Vector3 spin(double size) {
    return in_plane_ ? Vector3{0.0, 0.0, size * gauss_(random_)} : vector(size);
  }
  double positive(double size) { return size * uniform_(random_); }
};

// --- the formulas a second time --------------------------------------------------------------

struct Normal {
  double force, kn, kt, gamma_t; ///< kn: elastic force over overlap
};

/// Motion at the contact point.
struct Sliding {
  Vector3 velocity; ///< tangential
  double approach;  ///< along the normal
};
Sliding sliding(const Contact& c) {
  const Vector3 v = c.motion.velocity + (cross(c.motion.omega_i, c.frame.lever_i) -
                                         cross(c.motion.omega_j, c.frame.lever_j));
  const double along = dot(v, c.frame.normal);
  return {v - along * c.frame.normal, along};
}

Normal spring_dashpot(double kn, double gamma_n, double kt, double gamma_t, double h, double vn) {
  return {kn * h - gamma_n * vn, kn, kt, gamma_t};
}

Normal expected_normal(const std::string& style, const Contact& c, double vn) {
  const double R = c.frame.reduced_radius, h = c.frame.overlap,
               m = c.masses.i * c.masses.j / (c.masses.i + c.masses.j);
  const double* p = c.parameters.values;
  const double root = std::sqrt(R * h);
  if (style == "hertz/viscous")
    return spring_dashpot(4.0 / 3.0 * p[0] * root, p[2] * m, 16.0 / 3.0 * p[1] * root, 0.0, h, vn);
  if (style == "hooke/viscous")
    return spring_dashpot(p[0], p[2] * m, p[1], 0.0, h, vn);
  if (style == "hertz") {
    const double sn = 2.0 * p[0] * root, st = 8.0 * p[1] * root;
    return spring_dashpot(2.0 / 3.0 * sn, -2.0 * std::sqrt(5.0 / 6.0) * p[2] * std::sqrt(sn * m),
                          st, -2.0 * std::sqrt(5.0 / 6.0) * p[2] * std::sqrt(st * m), h, vn);
  }
  if (style == "hooke") {
    const double kn = 16.0 / 15.0 * std::sqrt(R) * p[0] *
                      std::pow(15.0 * m * p[1] * p[1] / (16.0 * std::sqrt(R) * p[0]), 0.2);
    const double gamma = std::sqrt(4.0 * m * kn * p[2] * p[2] / (p[2] * p[2] + M_PI * M_PI));
    return spring_dashpot(kn, gamma, kn, gamma, h, vn);
  }
  if (style == "hertz/stiffness")
    return spring_dashpot(root * p[0], root * m * p[2], root * p[1], root * m * p[3], h, vn);
  if (style == "hooke/stiffness")
    return spring_dashpot(p[0], m * p[2], p[1], m * p[3], h, vn);
  EXPECT_EQ(style, "hooke/stiffness absolute") << "a law without a second formula";
  return spring_dashpot(p[0], p[2], p[1], p[3], h, vn);
}

double expected_pull(const std::string& style, const Contact& c) {
  const ContactFrame& f = c.frame;
  const double density = c.parameters.values[LawParameters::of_cohesion];
  if (style == "sjkr2")
    return density * 2.0 * M_PI * 2.0 * f.reduced_radius * f.overlap;
  EXPECT_EQ(style, "sjkr") << "a law without a second formula";
  // circle in which two spheres intersect, from its radius: a^2 = r_i^2 - x^2
  const double scale = f.reduced_radius * (1.0 / f.radius_i + 1.0 / f.radius_j);
  const double ri = scale * f.radius_i, rj = scale * f.radius_j;
  const long double d = static_cast<long double>(ri) + rj - f.overlap;
  const long double x =
      (d * d + static_cast<long double>(ri) * ri - static_cast<long double>(rj) * rj) / (2.0L * d);
  return density * M_PI * static_cast<double>((ri - x) * (ri + x));
}

/// The circle's radius comes from a difference of radii, in long double: so much of it is rounding.
double rounding_of_pull(const Contact& c) {
  const double density = c.parameters.values[LawParameters::of_cohesion];
  return 1e-3 * density * std::pow(c.frame.radius_i + c.frame.radius_j, 2);
}

/// The spring of the last step carried on, as the paper's law has it.
Vector3 paper_spring(Vector3 spring, const Vector3& velocity, double dt, const Vector3& normal) {
  const double squared = dot(spring, spring);
  if (squared > 0.0) {
    spring -= dot(spring, normal) * normal;
    const double remaining = dot(spring, spring);
    if (remaining > 0.0)
      spring *= std::sqrt(squared / remaining);
  }
  spring += dt * velocity;
  return spring;
}

Vector3 expected_friction(const std::string& style, const Contact& c, const Normal& normal,
                          const Vector3& velocity, const LawSettings& pass, Vector3& spring) {
  const double* p = c.parameters.values + LawParameters::of_tangential;
  const double limit = p[0] * std::fabs(normal.force);
  const Vector3& n = c.frame.normal;
  if (style == "off")
    return {};
  if (style == "no_history") {
    const double speed = norm(velocity);
    const double gamma = limit < normal.gamma_t * speed ? limit / speed : normal.gamma_t;
    return -gamma * velocity;
  }
  if (style == "history") {
    if (pass.is_time_step) {
      spring += pass.time_step * velocity;
      spring -= dot(spring, n) * n;
    }
    const Vector3 elastic = -normal.kt * spring;
    if (norm(elastic) <= limit)
      return elastic - normal.gamma_t * velocity;
    const Vector3 force = limit / norm(elastic) * elastic;
    spring = -1.0 / normal.kt * force;
    return force;
  }
  const double eta = p[1] * c.masses.effective();
  if (pass.is_time_step)
    spring = paper_spring(spring, velocity, pass.time_step, n);
  const Vector3 trial = -normal.kt * spring - eta * velocity;
  const double magnitude = norm(trial), limited = magnitude > limit ? limit : magnitude;
  if (style == "history/viscous velocity") {
    if (normal.kt * norm(spring) > limit)
      spring *= limit / (normal.kt * norm(spring));
    const double speed = norm(velocity);
    return speed > 0.0 ? -limited / speed * velocity : Vector3{};
  }
  EXPECT_EQ(style, "history/viscous") << "a law without a second formula";
  if (magnitude <= limit)
    return trial;
  const Vector3 force = limited / magnitude * trial;
  if (normal.kt > 0.0)
    spring = -1.0 / normal.kt * (force + eta * velocity);
  return force;
}

Vector3 expected_rolling(const std::string& style, const Contact& c, const Normal& normal,
                         const LawSettings& pass, Vector3& remembered) {
  const double R = c.frame.reduced_radius, mu = c.parameters.values[LawParameters::of_rolling];
  const Vector3 rate = c.motion.omega_i - c.motion.omega_j;
  const auto resisted = [&](const Vector3& v) {
    return pass.resists_torsion ? v : v - dot(v, c.frame.normal) * c.frame.normal;
  };
  if (style == "cdt")
    return resisted(mu * normal.kn * c.frame.overlap * R / norm(rate) * rate);
  EXPECT_EQ(style, "epsd2") << "a law without a second formula";
  remembered += pass.time_step * normal.kt * R * R * resisted(rate);
  const double largest = std::fabs(normal.force) * R * mu;
  if (norm(remembered) > largest)
    remembered *= largest / norm(remembered);
  return remembered;
}

/// What the laws do to contact c, and its memory after the step.
ContactAction expected_action(const ContactLaws& laws, const LawSettings& pass, Contact& c) {
  const Sliding motion = sliding(c);
  Normal normal = expected_normal(laws[LawKind::normal]->style, c, motion.approach);
  normal.kt *= pass.tangential_stiffness_factor;
  if (!pass.tangential_damping)
    normal.gamma_t = 0.0;
  if (pass.no_attraction && normal.force < 0.0)
    normal.force = 0.0;
  double along = normal.force;
  if (const BatchedLaw* cohesion = laws[LawKind::cohesion]) {
    along -= expected_pull(cohesion->style, c);
    if (pass.cohesion_lessens_friction)
      normal.force = along;
  }
  const Vector3 force =
      along * c.frame.normal + expected_friction(laws[LawKind::tangential]->style, c, normal,
                                                 motion.velocity, pass, c.spring);
  ContactAction action{force, cross(c.frame.lever_i, force), cross(force, c.frame.lever_j),
                       normal.force};
  if (const BatchedLaw* rolling = laws[LawKind::rolling]) {
    const Vector3 torque = expected_rolling(rolling->style, c, normal, pass, c.rolling_torque);
    action.torque_i -= torque;
    action.torque_j += torque;
  }
  return action;
}

// --- comparison --------------------------------------------------------------------------------

void expect_same(const Vector3& found, const Vector3& expected) {
  EXPECT_EQ(found.x, expected.x);
  EXPECT_EQ(found.y, expected.y);
  EXPECT_EQ(found.z, expected.z);
}

/// Some operations, rounded; relative to `size`.
constexpr double rounding = 1e-13;
void expect_near(const Vector3& found, const Vector3& expected, double size,
                 const std::string& of) {
  EXPECT_LE(norm(found - expected), rounding * size) << of;
}

ContactLaws laws(const std::string& normal, const std::string& tangential,
                 const std::string& cohesion = "", const std::string& rolling = "") {
  ContactLaws laws;
  laws[LawKind::normal] = find_batched_law(LawKind::normal, normal);
  laws[LawKind::tangential] = find_batched_law(LawKind::tangential, tangential);
  laws[LawKind::cohesion] = find_batched_law(LawKind::cohesion, cohesion);
  laws[LawKind::rolling] = find_batched_law(LawKind::rolling, rolling);
  return laws;
}

/// Sizes of the parameters: normal law, cohesion, tangential law, rolling friction.
std::vector<double> parameter_sizes(const std::string& normal) {
  std::vector<double> sizes = normal == "hertz"             ? std::vector{2e8, 1e8, -1.0, 0.0}
                              : normal == "hooke"           ? std::vector{2e8, 1.0, -1.0, 0.0}
                              : normal == "hertz/stiffness" ? std::vector{2e8, 1e8, 1e6, 1e6}
                              : normal == "hooke/stiffness" ? std::vector{1e4, 1e4, 1e3, 1e3}
                              : normal == "hooke/stiffness absolute"
                                  ? std::vector{1e4, 1e4, 1e-3, 1e-3}
                              : normal == "hooke/viscous" ? std::vector{1e4, 1e4, 1e3, 0.0}
                                                          : std::vector{2e8, 1e8, 1e3, 0.0};
  sizes.insert(sizes.end(), {1e5, 1.0, 1e3, 0.5});
  return sizes;
}

void add(ContactLawBatch& batch, const Contact& c) {
  const int k = batch.size();
  batch.add(c.frame);
  batch.set_motion(k, c.motion, c.masses);
  batch.set_parameters(k, c.parameters);
  batch.set_spring(k, c.spring);
  batch.set_rolling_torque(k, c.rolling_torque);
}

} // namespace

class LawBatchTest : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Motion, LawBatchTest, testing::Values(false, true),
                         [](const auto& info) { return info.param ? "in_plane" : "in_space"; });

TEST_P(LawBatchTest, PaperLawBitByBit) {
  RandomContacts random(GetParam());
  int slipping = 0, sticking = 0;
  for (const char* direction : {"history/viscous", "history/viscous velocity"})
    for (const int variant : {0, 1, 2}) {
      LawSettings pass;
      pass.time_step = 5e-6;
      pass.is_time_step = variant != 2;
      pass.no_attraction = variant == 1;
      const ContactLaws paper = laws("hertz/viscous", direction);
      for (const int count : {1, 7, 16, ContactLawBatch::capacity}) {
        ContactLawBatch batch;
        std::vector<Contact> contacts;
        for (int k = 0; k < count; ++k) {
          contacts.push_back(random.next(parameter_sizes("hertz/viscous")));
          add(batch, contacts.back());
        }
        batch.solve(paper, pass);
        EXPECT_EQ(batch.are_in_plane(), GetParam());
        for (int k = 0; k < count; ++k) {
          Contact& c = contacts[static_cast<std::size_t>(k)];
          const ContactAction expected = expected_action(paper, pass, c), found = batch.action(k);
          expect_same(found.force, expected.force);
          expect_same(found.torque_i, expected.torque_i);
          expect_same(found.torque_j, expected.torque_j);
          EXPECT_EQ(found.normal_force, expected.normal_force);
          expect_same(batch.spring(k), c.spring);
          const double friction = norm(expected.force - expected.normal_force * c.frame.normal),
                       limit = c.parameters.values[LawParameters::of_tangential] *
                               std::fabs(expected.normal_force);
          ++(friction > (1.0 - 1e-12) * limit ? slipping : sticking);
        }
      }
    }
  EXPECT_GT(slipping, 50);
  EXPECT_GT(sticking, 50);
}

TEST_P(LawBatchTest, EveryLawAgainstItsFormula) {
  RandomContacts random(GetParam());
  std::vector<ContactLaws> combinations;
  for (const BatchedLaw& law : batched_laws())
    if (law.kind == LawKind::normal)
      for (const char* tangential :
           {"off", "no_history", "history", "history/viscous", "history/viscous velocity"})
        for (const char* cohesion : {"", "sjkr", "sjkr2"})
          for (const char* rolling : {"", "cdt", "epsd2"})
            combinations.push_back(laws(law.style, tangential, cohesion, rolling));
  ASSERT_EQ(combinations.size(), 7U * 5U * 9U);
  for (std::size_t which = 0; which < combinations.size(); ++which) {
    const ContactLaws& chosen = combinations[which];
    LawSettings pass;
    pass.time_step = 5e-6;
    pass.is_time_step = which % 3 != 0;
    pass.no_attraction = which % 2 == 0;
    pass.tangential_damping = which % 5 != 0;
    pass.tangential_stiffness_factor = which % 4 == 0 ? 2.0 / 7.0 : 1.0;
    pass.cohesion_lessens_friction = which % 7 < 3;
    pass.resists_torsion = which % 11 < 4;
    ContactLawBatch batch;
    std::vector<Contact> contacts;
    std::string of;
    for (const BatchedLaw* law : chosen.of_kind)
      of += law ? law->style + " " : "";
    for (int k = 0; k < 17; ++k) {
      contacts.push_back(random.next(parameter_sizes(chosen[LawKind::normal]->style)));
      add(batch, contacts.back());
    }
    batch.solve(chosen, pass);
    for (int k = 0; k < batch.size(); ++k) {
      Contact& c = contacts[static_cast<std::size_t>(k)];
      const Vector3 spring_before = c.spring;
      const ContactAction expected = expected_action(chosen, pass, c), found = batch.action(k);
      // what is summed up, before it may cancel
      const double kn = expected_normal(chosen[LawKind::normal]->style, c, 0.0).kn;
      const BatchedLaw* cohesion = chosen[LawKind::cohesion];
      const double kt = expected_normal(chosen[LawKind::normal]->style, c, 0.0).kt;
      const double force =
          norm(expected.force) + std::fabs(expected.normal_force) + kn * c.frame.overlap +
          kt * norm(spring_before) +
          (cohesion ? expected_pull(cohesion->style, c) + rounding_of_pull(c) : 0.0);
      const double arm = norm(c.frame.lever_i) + norm(c.frame.lever_j) + c.frame.reduced_radius;
      expect_near(found.force, expected.force, force, of);
      expect_near(found.torque_i, expected.torque_i, arm * force + norm(c.rolling_torque), of);
      expect_near(found.torque_j, expected.torque_j, arm * force + norm(c.rolling_torque), of);
      expect_near(batch.spring(k), c.spring,
                  norm(spring_before) + norm(c.spring) + (kt > 0.0 ? force / kt : 0.0), of);
      if (chosen[LawKind::rolling] && !chosen[LawKind::rolling]->memory.empty())
        expect_near(batch.rolling_torque(k), c.rolling_torque, norm(c.rolling_torque) + arm * force,
                    of);
    }
  }
}

TEST(ContactLawBatch, ActionIsReaction) {
  RandomContacts random;
  ContactLawBatch forth, back;
  for (int k = 0; k < ContactLawBatch::capacity; ++k) {
    const Contact c = random.next(parameter_sizes("hertz/viscous"));
    add(forth, c);
    Contact seen_from_j = c;
    seen_from_j.frame = {-c.frame.normal,        c.frame.lever_j,  c.frame.lever_i, c.frame.overlap,
                         c.frame.reduced_radius, c.frame.radius_j, c.frame.radius_i};
    seen_from_j.motion = {-c.motion.velocity, c.motion.omega_j, c.motion.omega_i};
    seen_from_j.masses = {c.masses.j, c.masses.i};
    seen_from_j.spring = -c.spring;
    seen_from_j.rolling_torque = -c.rolling_torque;
    add(back, seen_from_j);
  }
  LawSettings pass;
  pass.time_step = 5e-6;
  const ContactLaws chosen = laws("hertz/viscous", "history/viscous", "sjkr2", "epsd2");
  forth.solve(chosen, pass);
  back.solve(chosen, pass);
  for (int k = 0; k < ContactLawBatch::capacity; ++k) {
    const ContactAction there = forth.action(k), here = back.action(k);
    expect_same(here.force, -there.force);
    expect_same(here.torque_i, there.torque_j);
    expect_same(here.torque_j, there.torque_i);
    expect_same(back.spring(k), -forth.spring(k));
  }
}

TEST(ContactLawBatch, UnknownLawsAreNotFound) {
  EXPECT_EQ(find_batched_law(LawKind::normal, "luding"), nullptr);
  EXPECT_EQ(find_batched_law(LawKind::rolling, "hertz"), nullptr);
}
