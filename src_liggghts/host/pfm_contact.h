// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The record of a contact of LIGGGHTS-PFM under the names of later hosts.
#pragma once

#include "contact_interface.h"

namespace LIGGGHTS {
namespace ContactModels {

struct SurfacesIntersectData : CollisionData {
  int* contact_flags = nullptr;
};

/// Bits of contact_flags: which kinds of models act. The host's neighbour lists ask only whether
/// there is any.
constexpr int CONTACT_NORMAL_MODEL = 1 << 0;
constexpr int CONTACT_COHESION_MODEL = 1 << 1;
constexpr int CONTACT_TANGENTIAL_MODEL = 1 << 2;
constexpr int CONTACT_ROLLING_MODEL = 1 << 3;
constexpr int CONTACT_SURFACE_MODEL = 1 << 4;

} // namespace ContactModels
} // namespace LIGGGHTS
