// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The contacts of two bodies of spheres as a list.
#pragma once

#include "multisphere/multisphere_contact.h"

#include <vector>

namespace ellipsoid {

/// @param[in] centre_distance x_j - x_i (length), @param[out] contacts cleared first
inline ContactCount find_contacts(const MultispherePose& i, const MultispherePose& j,
                                  const Vector3& centre_distance,
                                  std::vector<SphereContact>& contacts) {
  contacts.clear();
  return for_each_contact(i, j, centre_distance,
                          [&](const SphereContact& contact) { contacts.push_back(contact); });
}

} // namespace ellipsoid
