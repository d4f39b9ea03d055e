// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// What is remembered of the contacts of a particle with a wall.
#pragma once

#include "wall/wall_contact.h"

#include <vector>

namespace ellipsoid_host {

class WallMeshes;

/// The history of a particle's contacts with one wall: a row of equal slots. A slot starts with the
/// number of the sphere from 1 (1 for a smooth ellipsoid; 0: a free slot), the triangle's code
/// (WallMeshes; 0: a primitive wall) and the normal; the values of the contact models follow.
class WallHistory {
 public:
  enum { header = 5 };

  /// @param[in] values of the contact models per contact
  void set_size(int slots, int values) {
    slots_ = slots;
    values_ = values;
  }
  int slots() const { return slots_; }
  int size() const { return slots_ * (header + values_); }

  /// Gives the contacts slots 0, 1, ... in their order, with the values of the same contact of
  /// before or of the one that it goes on from; there must be no more contacts than slots.
  /// @param[in,out] row of one particle
  /// @param[in] meshes know the triangles that are near the particle
  void assign(const std::vector<ellipsoid::WallContact>& contacts, double* row,
              const WallMeshes& meshes);

  /// Clears the row of a particle without contacts.
  void forget(double* row) const;

  /// Values of the contact models.
  double* values(double* row, std::size_t contact) const {
    return row + static_cast<int>(contact) * (header + values_) + header;
  }

 private:
  int slots_ = 0, values_ = 0;
  std::vector<double> before_;
  std::vector<char> has_values_, is_taken_; // per contact, per slot

  template <class MayGoOn>
  void hand_over(const std::vector<ellipsoid::WallContact>& contacts, double* row,
                 const MayGoOn& may_go_on);
};

} // namespace ellipsoid_host
