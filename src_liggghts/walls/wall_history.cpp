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

/// Sorts the numbers of contacts or slots by their spheres; those of one sphere keep their order.
template <class SphereOf> void order_by_sphere(std::vector<int>& numbers, const SphereOf& sphere) {
  const auto before = [&](int k, int l) { return sphere(k) < sphere(l); };
  if (!std::is_sorted(numbers.begin(), numbers.end(), before))
    std::stable_sort(numbers.begin(), numbers.end(), before);
}

} // namespace

void WallHistory::assign(const std::vector<WallContact>& contacts, const Rows& rows,
                         const WallMeshes& meshes) {
  if (contacts.empty()) {
    forget(rows);
    return;
  }
  remember(rows);
  begin_slots(contacts, rows, meshes);
  const auto same_place = [&](const WallContact& c, const double* slot) {
    return slot[1] == meshes.code(c.triangle);
  };
  const auto came_over = [&](const WallContact& c, const double* slot) {
    return c.triangle >= 0 && dot(c.normal, vector(&slot[2])) >= smallest_cosine &&
           meshes.adjoining(slot[1], c.triangle);
  };
  // first what touched the same triangle before, then what may have come over from another
  for_each_sphere(contacts, [&](const OfSphere& range) {
    hand_over(contacts, rows, range, same_place);
    hand_over(contacts, rows, range, came_over);
  });
}

void WallHistory::forget(const Rows& rows) const {
  if (rows.first[0] != 0.0) // slots are used from the first on
    std::fill_n(rows.first, size(), 0.0);
  rows.more->clear();
}

void WallHistory::remember(const Rows& rows) {
  before_.assign(rows.first, rows.first + size());
  before_.insert(before_.end(), rows.more->begin(), rows.more->end());
  slots_before_.clear();
  const int slots = static_cast<int>(before_.size()) / slot_size();
  for (int s = 0; s < slots && former(s)[0] != 0.0; ++s)
    slots_before_.push_back(s);
  order_by_sphere(slots_before_, [this](int s) { return former(s)[0]; });
  is_taken_.assign(static_cast<std::size_t>(slots), 0);
}

/// Slots of the present contacts, without values.
void WallHistory::begin_slots(const std::vector<WallContact>& contacts, const Rows& rows,
                              const WallMeshes& meshes) {
  const int count = static_cast<int>(contacts.size());
  std::fill_n(rows.first, size(), 0.0);
  rows.more->assign(at(std::max(0, count - slots_)), 0.0);
  has_values_.assign(contacts.size(), 0);
  contacts_.resize(contacts.size());
  for (int k = 0; k < count; ++k) {
    const WallContact& contact = contacts[static_cast<std::size_t>(k)];
    contacts_[static_cast<std::size_t>(k)] = k;
    double* slot = values(rows, static_cast<std::size_t>(k)) - header;
    slot[0] = sphere_from_one(contact);
    slot[1] = meshes.code(contact.triangle);
    store(contact.normal, &slot[2]);
  }
  order_by_sphere(contacts_, [&](int k) { return contacts[static_cast<std::size_t>(k)].sphere; });
}

template <class Visit>
void WallHistory::for_each_sphere(const std::vector<WallContact>& contacts, const Visit& visit) {
  const auto sphere = [&](std::size_t k) {
    return sphere_from_one(contacts[static_cast<std::size_t>(contacts_[k])]);
  };
  const auto former_sphere = [&](std::size_t s) { return former(slots_before_[s])[0]; };
  OfSphere range{0, 0, 0, 0};
  while (range.contact < contacts_.size()) {
    const double present = sphere(range.contact);
    while (range.last_contact < contacts_.size() && sphere(range.last_contact) == present)
      ++range.last_contact;
    while (range.slot < slots_before_.size() && former_sphere(range.slot) < present)
      ++range.slot;
    range.last_slot = range.slot;
    while (range.last_slot < slots_before_.size() && former_sphere(range.last_slot) == present)
      ++range.last_slot;
    visit(range);
    range.contact = range.last_contact;
    range.slot = range.last_slot;
  }
}

/// Of all possible pairs of a contact of a sphere and a former one, those with the least turn of
/// the normal first.
template <class MayGoOn>
void WallHistory::hand_over(const std::vector<WallContact>& contacts, const Rows& rows,
                            const OfSphere& range, const MayGoOn& may_go_on) {
  for (;;) {
    double best = -2.0;
    std::size_t best_contact = 0, best_slot = 0;
    for (std::size_t n = range.contact; n < range.last_contact; ++n)
      for (std::size_t m = range.slot; m < range.last_slot; ++m) {
        const auto k = static_cast<std::size_t>(contacts_[n]);
        const auto s = static_cast<std::size_t>(slots_before_[m]);
        const double* slot = former(slots_before_[m]);
        const double cosine = dot(contacts[k].normal, vector(&slot[2]));
        if (has_values_[k] || is_taken_[s] || !(cosine > best) || !may_go_on(contacts[k], slot))
          continue;
        best = cosine;
        best_contact = k;
        best_slot = s;
      }
    if (best < -1.5)
      return;
    has_values_[best_contact] = is_taken_[best_slot] = 1;
    const double* from = former(static_cast<int>(best_slot)) + header;
    std::copy(from, from + values_, values(rows, best_contact));
  }
}

} // namespace ellipsoid_host
