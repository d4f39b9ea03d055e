// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "law/contact_laws.h"

#include "law/cohesion_laws.h"
#include "law/law_columns.h"
#include "law/normal_laws.h"
#include "law/rolling_laws.h"
#include "law/tangential_laws.h"
#include "vectorised/batch_columns.h"
#include "vectorised/vector_versions.h"

#include <iterator>
#include <limits>

namespace ellipsoid {

namespace {

using C = LawColumns;

/// Of contact k.
struct Parameters {
  const LawColumns& c;
  int first, k;
  double operator()(int parameter) const { return c.in[C::parameters + first + parameter][k]; }
};

/// A step does its part of the work for all contacts: run<InSpace or InPlane>(columns, settings,
/// size). Steps are short, one loop each (see batch_columns.h).
template <class... Steps> inline void steps_loop(LawColumns& c, int size) {
  const LawSettings settings = c.settings; // a copy: no store into a column can change it
  if (c.are_in_plane)
    (Steps::template run<InPlane>(c, settings, size), ...);
  else
    (Steps::template run<InSpace>(c, settings, size), ...);
}

/// A step whose apply() does one contact.
template <class Step> struct StepOfContacts {
  template <class Space> static void run(LawColumns& c, const LawSettings& settings, int size) {
    for_items(0, size, [&c, &settings](int k) { Step::apply(c, settings, Space{k}); });
  }
};

/// Motion at the contact, and the force along the normal.
template <class Law> struct NormalStep : StepOfContacts<NormalStep<Law>> {
  template <class Space> static void apply(LawColumns& c, const LawSettings& settings, Space at) {
    const auto in = [&](int column) { return c.in[column][at.k]; };
    const auto put = [&](int column, double value) { c.out[column][at.k] = value; };
    using Vector = typename Space::Vector;
    const Vector normal = at.vector(c.in, C::nx);
    const Vector velocity =
        at.vector(c.in, C::vx) + (cross(at.axial_vector(c.in, C::wix), at.vector(c.in, C::lix)) -
                                  cross(at.axial_vector(c.in, C::wjx), at.vector(c.in, C::ljx)));
    const double normal_velocity = dot(velocity, normal);
    at.put(c.out, C::slip_x, velocity - normal_velocity * normal);

    const double mass = in(C::mass_i)*in(C::mass_j) / (in(C::mass_i) + in(C::mass_j));
    const NormalResponse response =
        Law::response({in(C::overlap), in(C::radius), mass, normal_velocity},
                      Parameters{c, LawParameters::of_normal, at.k});
    const double least = settings.no_attraction ? 0.0 : -std::numeric_limits<double>::infinity();
    const double limited = response.force < least ? least : response.force;
    put(C::normal_force, limited);
    put(C::along_normal, limited);
    put(C::normal_stiffness, response.stiffness);
    put(C::tangential_stiffness,
        settings.tangential_stiffness_factor * response.tangential_stiffness);
    put(C::tangential_damping, settings.tangential_damping ? response.tangential_damping : 0.0);
    put(C::reduced_mass, mass);
  }
};

template <class Law> struct CohesionStep : StepOfContacts<CohesionStep<Law>> {
  template <class Space> static void apply(LawColumns& c, const LawSettings& settings, Space at) {
    const auto in = [&](int column) { return c.in[column][at.k]; };
    const double pull = Law::pull(
        {in(C::overlap), in(C::radius), in(C::radius_i), in(C::radius_j), settings.with_wall},
        Parameters{c, LawParameters::of_cohesion, at.k});
    const double along = c.out[C::along_normal][at.k] - pull;
    c.out[C::along_normal][at.k] = along;
    if (settings.cohesion_lessens_friction)
      c.out[C::normal_force][at.k] = along;
  }
};

/// The spring of a law without memory is 0 and stays so.
template <class Law> struct SpringStep {
  template <class Space> static void run(LawColumns& c, const LawSettings& settings, int size) {
    if (Law::memory[0] != '\0' && settings.is_time_step)
      for_items(0, size, [&c, &settings](int k) { advance(c, settings, Space{k}); });
    else
      for_items(0, size, [&c](int k) { keep(c, Space{k}); });
  }
  template <class Space> static void advance(LawColumns& c, const LawSettings& settings, Space at) {
    auto spring = at.vector(c.in, C::sx);
    if constexpr (Law::memory[0] != '\0')
      Law::advance(spring, at.vector(c.out, C::slip_x), settings.time_step, at.vector(c.in, C::nx));
    at.put(c.out, C::new_sx, spring);
  }
  template <class Space> static void keep(LawColumns& c, Space at) {
    at.put(c.out, C::new_sx, at.vector(c.in, C::sx));
  }
};

/// The tangential force, and what the whole force does.
template <class Law> struct TangentialStep : StepOfContacts<TangentialStep<Law>> {
  template <class Space> static void apply(LawColumns& c, const LawSettings&, Space at) {
    const auto out = [&](int column) { return c.out[column][at.k]; };
    using Vector = typename Space::Vector;
    const NormalResponse normal{out(C::normal_force), out(C::normal_stiffness), 0.0,
                                out(C::tangential_stiffness), out(C::tangential_damping)};
    Vector spring = at.vector(c.out, C::new_sx);
    const Vector tangential =
        Law::template force<Vector>({normal, out(C::reduced_mass), at.vector(c.out, C::slip_x)},
                                    Parameters{c, LawParameters::of_tangential, at.k}, spring);
    at.put(c.out, C::new_sx, spring);

    const Vector force = out(C::along_normal) * at.vector(c.in, C::nx) + tangential;
    at.put(c.out, C::fx, force);
    at.put(c.out, C::tix, cross(at.vector(c.in, C::lix), force));
    at.put(c.out, C::tjx, cross(force, at.vector(c.in, C::ljx)));
  }
};

template <class Law> struct RollingStep : StepOfContacts<RollingStep<Law>> {
  template <class Space> static void apply(LawColumns& c, const LawSettings& settings, Space at) {
    const auto in = [&](int column) { return c.in[column][at.k]; };
    using Axial = typename Space::AxialVector;
    const RollingContact<Axial, typename Space::Vector> contact{
        c.out[C::normal_stiffness][at.k] * in(C::overlap),
        c.out[C::normal_force][at.k],
        in(C::radius),
        c.out[C::tangential_stiffness][at.k],
        settings.time_step,
        settings.resists_torsion ? 1.0 : 0.0,
        at.vector(c.in, C::nx),
        at.axial_vector(c.in, C::wix) - at.axial_vector(c.in, C::wjx)};
    Axial remembered = at.axial_vector(c.in, C::rx);
    const Axial torque =
        Law::torque(contact, Parameters{c, LawParameters::of_rolling, at.k}, remembered);
    at.put(c.out, C::new_rx, remembered);
    at.put(c.out, C::tix, at.axial_vector(c.out, C::tix) - torque);
    at.put(c.out, C::tjx, at.axial_vector(c.out, C::tjx) + torque);
  }
};

template <class Law> std::vector<std::string> names_of_parameters() {
  return {std::begin(Law::parameters), std::end(Law::parameters)};
}
template <> std::vector<std::string> names_of_parameters<NoFriction>() { return {}; }

template <class Law> BatchedLaw normal() {
  return {LawKind::normal, Law::style, names_of_parameters<Law>(), "",
          &WidestVersion<&steps_loop<NormalStep<Law>>>::run};
}
template <class Law> BatchedLaw cohesion() {
  return {LawKind::cohesion, Law::style, names_of_parameters<Law>(), "",
          &WidestVersion<&steps_loop<CohesionStep<Law>>>::run};
}
template <class Law> BatchedLaw tangential() {
  return {LawKind::tangential, Law::style, names_of_parameters<Law>(), Law::memory,
          &WidestVersion<&steps_loop<SpringStep<Law>, TangentialStep<Law>>>::run};
}
template <class Law> BatchedLaw rolling() {
  return {LawKind::rolling, Law::style, names_of_parameters<Law>(), Law::memory,
          &WidestVersion<&steps_loop<RollingStep<Law>>>::run};
}

} // namespace

/// The register: a row per law.
const std::vector<BatchedLaw>& batched_laws() {
  static const std::vector<BatchedLaw> laws{
      normal<HertzViscous>(),
      normal<HookeViscous>(),
      normal<Hertz>(),
      normal<HertzStiffness>(),
      normal<Hooke>(),
      normal<HookeStiffness>(),
      normal<HookeStiffnessAbsolute>(),
      cohesion<Sjkr>(),
      cohesion<Sjkr2>(),
      tangential<HistoryViscous<SlipDirection::displacement>>(),
      tangential<HistoryViscous<SlipDirection::velocity>>(),
      tangential<History>(),
      tangential<NoHistory>(),
      tangential<NoFriction>(),
      rolling<ConstantTorque>(),
      rolling<ElasticPlastic>(),
  };
  return laws;
}

const BatchedLaw* find_batched_law(LawKind kind, const std::string& style) {
  for (const BatchedLaw& law : batched_laws())
    if (law.kind == kind && law.style == style)
      return &law;
  return nullptr;
}

} // namespace ellipsoid
