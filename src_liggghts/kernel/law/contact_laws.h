// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The contact laws that run in batches: a row of the table in contact_laws.cpp each.
#pragma once

#include <string>
#include <vector>

namespace ellipsoid {

/// In the order in which the laws of a contact are evaluated.
enum class LawKind { normal, cohesion, tangential, rolling };

/// Material parameters of a contact, those of each kind of law behind each other.
struct LawParameters {
  enum { of_normal = 0, of_cohesion = 4, of_tangential = 5, of_rolling = 7, count = 8 };
  double values[count] = {};
  static int first(LawKind kind) {
    constexpr int firsts[] = {of_normal, of_cohesion, of_tangential, of_rolling};
    return firsts[static_cast<int>(kind)];
  }
};

/// What all contacts of a time step have in common.
struct LawSettings {
  double time_step = 0.0;         ///< by which springs grow (time)
  bool is_time_step = true;       ///< false: springs stay as they are unless friction shortens them
  bool no_attraction = false;     ///< a normal force that pulls counts as 0
  bool tangential_damping = true; ///< of normal laws that bring one
  double tangential_stiffness_factor = 1.0; ///< of that of the normal law
  bool cohesion_lessens_friction = false;   ///< friction is limited by the sum of push and pull
  bool resists_torsion = false;             ///< rolling friction also resists spin about the normal
  bool with_wall = false;                   ///< contacts of one body each with a wall
};

struct LawColumns;

/// A law as the batch runs it.
struct BatchedLaw {
  LawKind kind;
  std::string style; ///< as the commands have it, and a setting that makes it another law
  std::vector<std::string> parameters; ///< names of the host's properties
  std::string memory; ///< first of three values of a contact's history; empty: it has none
  void (*loop)(LawColumns&, int);
};

const std::vector<BatchedLaw>& batched_laws();
/// Null where there is no such law.
const BatchedLaw* find_batched_law(LawKind kind, const std::string& style);

/// The chosen laws; null where there is none of the kind. A batch needs a normal and a tangential
/// one.
struct ContactLaws {
  const BatchedLaw* of_kind[4] = {};
  const BatchedLaw*& operator[](LawKind kind) { return of_kind[static_cast<int>(kind)]; }
  const BatchedLaw* operator[](LawKind kind) const { return of_kind[static_cast<int>(kind)]; }
};

} // namespace ellipsoid
