// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Contacts of multi-sphere ellipsoids: every touching pair of sub-spheres is a contact of its own
// (Markauskas et al. 2010, section 3.4).
//
// The history of a pair that touches is a row of equal slots, one per contact: `contacts` of them,
// those beyond, which few pairs have, in more_history.h. A slot starts with
// its key: the sum of the two sphere numbers + 1 (0: free) and their difference, which changes sign
// when the pair is seen from j; the values of the contact models follow.
#pragma once

#include "multisphere/near_spheres.h"
#include "multisphere_particles.h"
#include "pair_forces.h"
#include "particle_arrays.h"
#include "surface_contacts.h"

#include <limits>
#include <vector>

namespace ellipsoid_host {

class MultisphereContacts : public SurfaceContacts {
 public:
  MultisphereContacts(LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::PairGranEllipsoid& pair);
  void read_settings(const ModelSettings& settings) override;
  ContactCounts compute(PairForces& forces, bool is_time_step) override;
  void ghosts_are_new() override { chains_.ghosts_are_new(); }
  ellipsoid::BodyBounds bounds(int i) override { return chains_.bounds(i); }

 private:
  enum { key_sum, key_difference }; // offsets in a slot
  using SpherePair = ellipsoid::NearSpheres::SpherePair;

  /// A search finds the spheres that may touch within so many time steps if motions change as
  /// usual; fewer steps for chains of many spheres, of which a wide gap would take in too many. The
  /// gap is bounded by these shares of b_i + b_j, the second semi-axes of the bodies.
  static constexpr double steps_ahead = 50.0, steps_ahead_of_chain = 500.0;
  static constexpr int largest_slot = std::numeric_limits<short>::max();
  static constexpr double smallest_gap_share = 1e-3, largest_gap_share = 0.1;

  ParticleArrays particles_;
  MultisphereParticles chains_;
  double listed_pairs_ = 0.0, near_pairs_ = 0.0;
  ContactCounts counts_;
  ellipsoid::NearSpheres near_spheres_;
  std::vector<ellipsoid::NearSpheres::Touching> touching_; // room for all spheres of a pair
  int found_ = 0;                                          // touching spheres of the pair at hand
  int slot_values_ = 0, slots_ = 0;
  ellipsoid::MulticontactRule rule_ = ellipsoid::MulticontactRule::sum;

  void begin_lists();
  bool update_contacts(NearPair& pair, PairForces& forces);
  bool search(NearPair& pair, const ellipsoid::Vector3& distance, PairForces& forces);
  double search_gap(int i, int j, double approach);
  void find_touching(const NearPair& pair, const ellipsoid::Vector3& distance);
  void recall_slots(const NearPair& pair, PairForces& forces);
  void update_slots(NearPair& pair, PairForces& forces);
  int find_free_slot(const NearPair& pair, int first);
  void close_slot(const NearPair& pair, int number, PairForces& forces);
  void add_contacts(const NearPair& pair, const ellipsoid::Vector3& distance, PairForces& forces);
  [[noreturn]] void complain_of_slots(const NearPair& pair) const;

  int slots(const NearPair& pair) const;
  double* slot(const NearPair& pair, int number) const;

  ellipsoid::MotionClocks& clocks() { return chains_.clocks(); }
  double share(int j) const { return j < particles_.owned ? 1.0 : 0.5; }
};

} // namespace ellipsoid_host
