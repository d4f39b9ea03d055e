// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "wall_history.h"

#include "ellipsoid_host.h"
#include "wall_meshes.h"

#include <algorithm>
#include <cmath>

using ellipsoid::WallContact;

namespace ellipsoid_host {

namespace {

/// A contact that moves on to the next triangle keeps its history if its normal turns by no more
/// than 45 degrees: that of the facets of a curved wall.
const double smallest_cosine = std::sqrt(0.5);

/// A smooth ellipsoid counts as its first and only sphere.
double sphere_from_one(const WallContact& c) { return std::max(0, c.sphere) + 1; }

} // namespace

void WallHistory::assign(const std::vector<WallContact>& contacts, double* row,
                         const WallMeshes& meshes) {
  const auto code = [&](const WallContact& c) { return meshes.code(c.triangle); };
  if (contacts.empty()) {
    forget(row);
    return;
  }
  before_.assign(row, row + size());
  std::fill_n(row, size(), 0.0);
  has_values_.assign(contacts.size(), 0);
  is_taken_.assign(static_cast<std::size_t>(slots_), 0);
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    double* slot = values(row, k) - header;
    slot[0] = sphere_from_one(contacts[k]);
    slot[1] = code(contacts[k]);
    store(contacts[k].normal, &slot[2]);
  }
  // first what touched the same triangle before, then what may have come over from another
  hand_over(contacts, row,
            [&](const WallContact& c, const double* slot) { return slot[1] == code(c); });
  hand_over(contacts, row, [&](const WallContact& c, const double* slot) {
    return c.triangle >= 0 && dot(c.normal, vector(&slot[2])) >= smallest_cosine &&
           meshes.adjoining(slot[1], c.triangle);
  });
}

void WallHistory::forget(double* row) const {
  if (row[0] != 0.0) // slots are used from the first on
    std::fill_n(row, size(), 0.0);
}

/// Of all possible pairs of a contact and a former one, those with the least turn of the normal
/// first.
template <class MayGoOn>
void WallHistory::hand_over(const std::vector<WallContact>& contacts, double* row,
                            const MayGoOn& may_go_on) {
  for (;;) {
    double best = -2.0;
    std::size_t best_contact = 0, best_slot = 0;
    for (std::size_t k = 0; k < contacts.size(); ++k)
      for (std::size_t s = 0; s < is_taken_.size() && !has_values_[k]; ++s) {
        const double* slot = &before_[s * static_cast<std::size_t>(header + values_)];
        const double cosine = dot(contacts[k].normal, vector(&slot[2]));
        if (is_taken_[s] || slot[0] != sphere_from_one(contacts[k]) || !(cosine > best) ||
            !may_go_on(contacts[k], slot))
          continue;
        best = cosine;
        best_contact = k;
        best_slot = s;
      }
    if (best < -1.5)
      return;
    has_values_[best_contact] = is_taken_[best_slot] = 1;
    const double* from = &before_[best_slot * static_cast<std::size_t>(header + values_) + header];
    std::copy(from, from + values_, values(row, best_contact));
  }
}

} // namespace ellipsoid_host
