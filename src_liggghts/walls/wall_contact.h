// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// One contact of a particle with a wall of any kind, and what is remembered of it.
#ifndef ELLIPSOID_WALL_CONTACT_H
#define ELLIPSOID_WALL_CONTACT_H

#include "math/vector3.h"

#include <functional>
#include <vector>

namespace ellipsoid_host {

/// Lengths are relative to the particle's centre.
struct WallContact {
  ellipsoid::Vector3 normal;        ///< unit, from the particle into the wall
  ellipsoid::Vector3 point;         ///< middle of the overlap (length)
  double overlap = 0.0;             ///< (length)
  double reduced_radius = 0.0;      ///< R of (19) (length)
  ellipsoid::Vector3 wall_velocity; ///< of the wall's surface at the contact (length/time)
  int part = 0;                     ///< number of the sub-sphere; 0 for a smooth ellipsoid
  int place = -1;                   ///< in the list of near triangles; -1 for a primitive wall
  double triangle = 0.0;            ///< tells triangles of all meshes apart; 0 for a primitive wall
};

/// The history of a particle's contacts with one wall: a row of equal slots. A slot starts with the
/// part
/// + 1 (0: free), the triangle and the normal; the values of the contact models follow.
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

  /// Whether a contact that slides off the one triangle (a former contact's) goes on at the other
  /// (by its place in the list of near triangles).
  using Adjoining = std::function<bool(double, int)>;

  /// Gives the contacts slots 0, 1, ... in their order, with the values of the same contact of
  /// before or of the one that it goes on from; there must be no more contacts than slots.
  /// @param[in,out] row of one particle
  void assign(const std::vector<WallContact>& contacts, double* row, const Adjoining& adjoining);

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
  void hand_over(const std::vector<WallContact>& contacts, double* row, const MayGoOn& may_go_on);
};

} // namespace ellipsoid_host

#endif
