// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Which of the host's contact models give wrong results for ellipsoids, and why
// (doc/contact_models.md has the whole table).
#pragma once

#include "host_variants.h"

#include <cstddef>
#include <string>
#include <vector>

namespace LIGGGHTS {
namespace ContactModels {

/// Of a kind ("normal", "tangential", ...) as contact_match() has it.
struct UnsuitableModel {
  const char* kind;
  const char* keyword; ///< as the commands have it
  const char* name;
  const char* reason_and_remedy;
};

constexpr UnsuitableModel unsuitable_models[] = {
    {"normal", "model", "edinburgh",
     "pushes at the centres, which turns no ellipsoid; use 'model luding' or 'hooke/hysteresis'"},
    {"normal", "model", "edinburgh/stiffness",
     "pushes at the centres, which turns no ellipsoid; use 'model luding' or 'hooke/hysteresis'"},
    {"normal", "model", "thornton_ning",
     "pushes at the centres, which turns no ellipsoid; use 'model luding' or 'hooke/hysteresis'"},
    {"cohesion", "cohesion", "easo/capillary/viscous",
     "acts across a gap, which is not known for ellipsoids; use 'cohesion sjkr' or 'sjkr2'"},
    {"cohesion", "cohesion", "washino/capillary/viscous",
     "acts across a gap, which is not known for ellipsoids; use 'cohesion sjkr' or 'sjkr2'"},
#ifdef ELLIPSOID_HOST_INL
    {"cohesion", "cohesion", "bond",
     "acts across a gap, which is not known for ellipsoids; use 'cohesion sjkr' or 'sjkr2'"},
    {"cohesion", "cohesion", "bond/nonlinear",
     "acts across a gap, which is not known for ellipsoids; use 'cohesion sjkr' or 'sjkr2'"},
#endif
#ifdef ELLIPSOID_HOST_PICI
    {"normal", "model", "jkr",
     "acts across a gap, which is not known for ellipsoids; use 'cohesion sjkr' or 'sjkr2'"},
    {"tangential", "tangential", "jkr_tan", "is for 'model jkr'; use 'tangential history'"},
    {"rolling_friction", "rolling_friction", "cdt_jkr",
     "is for 'model jkr'; use 'rolling_friction cdt'"},
#endif
    {"rolling_friction", "rolling_friction", "epsd3",
     "damps by the moment of inertia of spheres; use 'rolling_friction epsd'"},
};

/// These read what another model finds of a contact, without looking whether it is there.
struct DependentModel {
  const char *kind, *keyword, *name;
  const char *model, *or_model; ///< normal models, one of which is needed
};

constexpr DependentModel dependent_models[] = {
    {"tangential", "tangential", "tan_luding", "luding", nullptr},
    {"rolling_friction", "rolling_friction", "luding", "luding", nullptr},
#ifdef ELLIPSOID_HOST_INL
    {"tangential", "tangential", "hysteretic/nonlinear", "hysteretic/nonlinear1",
     "hysteretic/nonlinear2"},
#endif
};

/// The names of models in the arguments of a command: some of the host's models stop with words of
/// their own as soon as they are made, for other surfaces than spheres.
class NamedModels {
 public:
  NamedModels(int count, char** arguments) : words_(arguments, arguments + count) {}
  bool contact_match(const std::string& kind, const std::string& name) const {
    const std::string keyword = kind == "normal" ? "model" : kind;
    for (std::size_t k = 0; k + 1 < words_.size(); ++k)
      if (words_[k] == keyword && words_[k + 1] == name)
        return true;
    return false;
  }

 private:
  std::vector<std::string> words_;
};

/// What is wrong with one of the chosen models, or an empty string.
/// @param[in] models has contact_match(kind, name)
template <typename Models> std::string unsuitable_model(Models& models) {
  for (const UnsuitableModel& m : unsuitable_models)
    if (models.contact_match(m.kind, m.name))
      return std::string(m.keyword) + " " + m.name + " does not work with ellipsoids: it " +
             m.reason_and_remedy;
  for (const DependentModel& m : dependent_models)
    if (models.contact_match(m.kind, m.name) && !models.contact_match("normal", m.model) &&
        !(m.or_model && models.contact_match("normal", m.or_model)))
      return std::string(m.keyword) + " " + m.name + " needs 'model " + m.model + "'" +
             (m.or_model ? std::string(" or 'model ") + m.or_model + "'" : std::string());
  return {};
}

/// A setting that must not be `on`, and why.
struct UnsuitableSetting {
  const char *keyword, *reason;
};

constexpr UnsuitableSetting unsuitable_settings[] = {
    {"computeElasticPotential", "leaves out the energy of rotation of ellipsoids"},
    {"computeDissipatedEnergy", "leaves out the energy of rotation of ellipsoids"},
    {"torsion", "puts the spring of torsion in the place of that of rolling"},
    {"heating_normal_hertz", "makes heat that no particle is given"},
    {"heating_normal_hooke", "makes heat that no particle is given"},
    {"heating_tangential_history", "makes heat that no particle is given"},
    {"disableNormalWhenBonded", "is for bonds, which ellipsoids do not have"},
    {"disableTangentialWhenBonded", "is for bonds, which ellipsoids do not have"},
};

/// What is wrong with one of the settings, or an empty string.
inline std::string unsuitable_setting(int count, char** arguments) {
  for (int k = 0; k + 1 < count; ++k)
    for (const UnsuitableSetting& setting : unsuitable_settings)
      if (std::string(arguments[k]) == setting.keyword && std::string(arguments[k + 1]) == "on")
        return std::string("keyword '") + setting.keyword + "' has the value 'on', which " +
               setting.reason + "; allowed is 'off'";
  return {};
}

} // namespace ContactModels
} // namespace LIGGGHTS
