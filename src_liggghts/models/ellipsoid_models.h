// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Which of the host's contact models give wrong results for ellipsoids, and why
// (doc/contact_models.md has the whole table).
#pragma once

#include "host_variants.h"

#include <string>

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
    {"cohesion", "cohesion", "sjkr",
     "has another torque in LIGGGHTS-INL than in other LIGGGHTS; use no cohesion with this host"},
#endif
    {"rolling_friction", "rolling_friction", "epsd3",
     "damps by the moment of inertia of spheres; use 'rolling_friction epsd'"},
};

/// These read what `model luding` keeps of a contact, without looking whether it is there.
constexpr UnsuitableModel needs_model_luding[] = {
    {"tangential", "tangential", "tan_luding", "needs 'model luding'"},
    {"rolling_friction", "rolling_friction", "luding", "needs 'model luding'"},
};

/// What is wrong with one of the chosen models, or an empty string.
/// @param[in] models has contact_match(kind, name)
template <typename Models> std::string unsuitable_model(Models& models) {
  for (const UnsuitableModel& m : unsuitable_models)
    if (models.contact_match(m.kind, m.name))
      return std::string(m.keyword) + " " + m.name + " does not work with ellipsoids: it " +
             m.reason_and_remedy;
  for (const UnsuitableModel& m : needs_model_luding)
    if (models.contact_match(m.kind, m.name) && !models.contact_match("normal", "luding"))
      return std::string(m.keyword) + " " + m.name + " " + m.reason_and_remedy;
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
