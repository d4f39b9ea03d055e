// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Contact laws (23), (24) of Markauskas et al. 2010, and others, for many contacts at once: the
// laws of normal_laws.h, tangential_laws.h ... in loops that the compiler turns into vector
// instructions. Every contact gets the same operations in the same order whatever the width of the
// vectors.
//
// Sign conventions are those of contact_law.h: the unit normal points from j to i, forces act on i.
#pragma once

#include "ellipsoid/contact_batch.h"
#include "law/law_columns.h"

namespace ellipsoid {

/// Where two bodies touch, seen from both centres.
struct ContactFrame {
  Vector3 normal;            ///< unit, from j to i
  Vector3 lever_i, lever_j;  ///< contact point relative to the centres of i and j (length)
  double overlap;            ///< h >= 0 (length)
  double reduced_radius;     ///< R of (19), (20) (length)
  double radius_i, radius_j; ///< Gaussian radii of curvature (length)
};

/// How the two bodies move.
struct PairMotion {
  Vector3 velocity;         ///< of the centre of i relative to that of j (length/time)
  Vector3 omega_i, omega_j; ///< angular velocities (rad/time)
};

/// Masses of the two bodies; m_ij = m_i m_j / (m_i + m_j).
struct PairMasses {
  double i, j;
  /// One body of this mass, the other cannot move (a wall, a held body): m_ij = mass.
  static PairMasses one_held(double mass) { return {2.0 * mass, 2.0 * mass}; }
  double effective() const { return i * j / (i + j); }
};

/// What a contact does to the two bodies.
struct ContactAction {
  Vector3 force;              ///< on i; the reaction acts on j (force)
  Vector3 torque_i, torque_j; ///< about the centres (force length)
  double normal_force;        ///< F_n (23) (force)
};

class ContactLawBatch : public Batch {
 public:
  void add(const ContactFrame& frame);
  /// Instead of add(): as many contacts as the batch has pairs, where it found them.
  void set_frames(const ContactBatch& pairs);
  /// Of contact k, which without it means nothing. Numbers that the laws do not need are left out.
  void set_motion(int k, const PairMotion& motion, const PairMasses& masses);
  void set_parameters(int k, const LawParameters& parameters);
  /// @param[in] spring accumulated tangential displacement of the last step (length)
  void set_spring(int k, const Vector3& spring);
  /// @param[in] torque of rolling friction in the last step
  void set_rolling_torque(int k, const Vector3& torque);
  /// The same for all contacts, also those to come.
  void set_parameters_of_all(const LawParameters& parameters);

  void solve(const ContactLaws& laws, const LawSettings& settings);

  /// Whether all forces, after solve(), lie along x and y and all torques along z.
  bool are_in_plane() const { return columns_.are_in_plane; }
  /// As it was added.
  ContactFrame frame(int k) const;
  /// Of contact k, after solve().
  ContactAction action(int k) const;
  /// Its spring, grown by (18) and shortened to what friction bears (length).
  Vector3 spring(int k) const;
  /// What its law of rolling friction remembers.
  Vector3 rolling_torque(int k) const;

 private:
  LawColumns columns_{};
};

// Inline, and number by number, as in contact_batch.h.

inline void ContactLawBatch::add(const ContactFrame& frame) {
  using C = LawColumns;
  const int k = next();
  const InSpace at{k};
  at.put(columns_.in, C::nx, frame.normal);
  at.put(columns_.in, C::lix, frame.lever_i);
  at.put(columns_.in, C::ljx, frame.lever_j);
  columns_.in[C::overlap][k] = frame.overlap;
  columns_.in[C::radius][k] = frame.reduced_radius;
  columns_.in[C::radius_i][k] = frame.radius_i;
  columns_.in[C::radius_j][k] = frame.radius_j;
}

inline void ContactLawBatch::set_motion(int k, const PairMotion& motion, const PairMasses& masses) {
  using C = LawColumns;
  const InSpace at{k};
  at.put(columns_.in, C::vx, motion.velocity);
  at.put(columns_.in, C::wix, motion.omega_i);
  at.put(columns_.in, C::wjx, motion.omega_j);
  columns_.in[C::mass_i][k] = masses.i;
  columns_.in[C::mass_j][k] = masses.j;
}

inline void ContactLawBatch::set_parameters(int k, const LawParameters& parameters) {
  for (int p = 0; p < LawParameters::count; ++p)
    columns_.in[LawColumns::parameters + p][k] = parameters.values[p];
}

inline void ContactLawBatch::set_spring(int k, const Vector3& spring) {
  InSpace{k}.put(columns_.in, LawColumns::sx, spring);
}

inline void ContactLawBatch::set_rolling_torque(int k, const Vector3& torque) {
  InSpace{k}.put(columns_.in, LawColumns::rx, torque);
}

inline ContactFrame ContactLawBatch::frame(int k) const {
  using C = LawColumns;
  const auto vector = [this, k](int first) { return InSpace{k}.vector(columns_.in, first); };
  const auto in = [this, k](int column) { return columns_.in[column][k]; };
  return {vector(C::nx), vector(C::lix),  vector(C::ljx), in(C::overlap),
          in(C::radius), in(C::radius_i), in(C::radius_j)};
}

inline ContactAction ContactLawBatch::action(int k) const {
  using C = LawColumns;
  const auto out = [this, k](int first) { return InSpace{k}.vector(columns_.out, first); };
  return {out(C::fx), out(C::tix), out(C::tjx), columns_.out[C::normal_force][k]};
}

inline Vector3 ContactLawBatch::spring(int k) const {
  return InSpace{k}.vector(columns_.out, LawColumns::new_sx);
}

inline Vector3 ContactLawBatch::rolling_torque(int k) const {
  return InSpace{k}.vector(columns_.out, LawColumns::new_rx);
}

} // namespace ellipsoid
