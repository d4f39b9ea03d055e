// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The names of contact models in a command, as every host reads them.
#pragma once

#include "force.h"
#include "host_variants.h"

#ifdef ELLIPSOID_HOST_PFM
#include "own_models.h"
#else
#include "contact_models.h"
#endif

#include <cstdint>

namespace ellipsoid_host {

/// For messages.
#ifdef ELLIPSOID_HOST_PFM
constexpr const char* known_models = OwnModels::known_names;
#else
constexpr const char* known_models = "the host's and this package's";
#endif

/// Takes the names of contact models from the arguments; -1 if one is unknown.
inline std::int64_t select_models(int& narg, char**& arg, LAMMPS_NS::LAMMPS* lmp,
                                  LAMMPS_NS::Force* force) {
#if defined(ELLIPSOID_HOST_PFM)
  static_cast<void>(lmp);
  static_cast<void>(force);
  return OwnModels::select(narg, arg);
#elif defined(ELLIPSOID_HOST_INL)
  static_cast<void>(force);
  return LIGGGHTS::ContactModels::Factory::select(narg, arg, lmp);
#else
  static_cast<void>(lmp);
  return LIGGGHTS::ContactModels::Factory::select(narg, arg, force->custom_contact_models);
#endif
}

} // namespace ellipsoid_host
