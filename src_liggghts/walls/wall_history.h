// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// What is remembered of the contacts of a particle with a wall.
#pragma once

#include "wall/wall_contact.h"

#include <cstddef>
#include <vector>

namespace ellipsoid_host {

class WallMeshes;

/// The history of a particle's contacts with one wall: equal slots, the first ones in a row of the
/// particle, those beyond it in another of any length. A slot starts with the number of the sphere
/// from 1 (1 for a smooth ellipsoid; 0: a free slot), the triangle's code (WallMeshes; 0: a
/// primitive wall) and the normal; the values of the contact models follow.
class WallHistory {
 public:
  enum { header = 5 };

  /// The slots of one particle.
  struct Rows {
    double* first = nullptr;             ///< slots() slots
    std::vector<double>* more = nullptr; ///< those beyond, none for most
  };

  /// @param[in] slots of the first row
  /// @param[in] values of the contact models per contact
  void set_size(int slots, int values) {
    slots_ = slots;
    values_ = values;
  }
  int slots() const { return slots_; }
  int size() const { return slots_ * slot_size(); } ///< of the first row

  /// Gives the contacts slots 0, 1, ... in their order, with the values of the same contact of
  /// before or of the one that it goes on from; slots beyond the first row are made as needed.
  /// @param[in] meshes know the triangles that are near the particle
  void assign(const std::vector<ellipsoid::WallContact>& contacts, const Rows& rows,
              const WallMeshes& meshes);

  /// Clears the slots of a particle without contacts.
  void forget(const Rows& rows) const;

  /// Values of the contact models.
  double* values(const Rows& rows, std::size_t contact) const {
    const int k = static_cast<int>(contact);
    double* const slot = k < slots_ ? rows.first + static_cast<std::ptrdiff_t>(k) * slot_size()
                                    : &(*rows.more)[at(k - slots_)];
    return slot + header;
  }

 private:
  int slots_ = 0, values_ = 0;
  std::vector<double> before_;               // slots, one after the other
  std::vector<int> contacts_, slots_before_; // numbers, in the order of their spheres
  std::vector<char> has_values_, is_taken_;  // per contact, per slot of before

  int slot_size() const { return header + values_; }
  std::size_t at(int slot) const {
    return static_cast<std::size_t>(slot) * static_cast<std::size_t>(slot_size());
  }
  const double* former(int slot) const { return &before_[at(slot)]; }
  void remember(const Rows& rows);
  void begin_slots(const std::vector<ellipsoid::WallContact>& contacts, const Rows& rows,
                   const WallMeshes& meshes);
  /// Contacts and slots of one sphere, by their places in contacts_ and slots_before_.
  struct OfSphere {
    std::size_t contact, last_contact, slot, last_slot;
  };
  template <class Visit>
  void for_each_sphere(const std::vector<ellipsoid::WallContact>& contacts, const Visit& visit);
  template <class MayGoOn>
  void hand_over(const std::vector<ellipsoid::WallContact>& contacts, const Rows& rows,
                 const OfSphere& range, const MayGoOn& may_go_on);
};

} // namespace ellipsoid_host
