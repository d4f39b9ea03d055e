// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Contacts of smooth ellipsoids: at most one per pair.
//
// The history of a pair that touches starts with what the search remembers: the unit normal from j
// to i (it flips with the order of the pair, as the host's flag 1 says) and whether the pair
// touched in a time step. Pairs that are apart have no history, but the last normal that separated
// them.
#pragma once

#include "ellipsoid/contact_batch.h"
#include "ellipsoid/first_gaps.h"
#include "ellipsoid_shapes.h"
#include "pair_forces.h"
#include "particle_arrays.h"
#include "surface_contacts.h"
#include "surface_motions.h"

#include <vector>

namespace ellipsoid_host {

class SmoothContacts : public SurfaceContacts {
 public:
  SmoothContacts(LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::PairGranEllipsoid& pair);
  void read_settings(const ModelSettings&) override {}
  ContactCounts compute(PairForces& forces, bool is_time_step) override;
  ellipsoid::BodyBounds bounds(int i) override;

 private:
  enum { normal_x, normal_y, normal_z, was_touching }; // offsets in the history

  ParticleArrays particles_;
  EllipsoidShapes shapes_;
  SurfaceMotions motions_;
  std::vector<ellipsoid::Vector3> normals_; ///< by near pair, from i to j; 0: none
  double listed_pairs_ = 0.0, near_pairs_ = 0.0;
  bool is_time_step_ = false;
  bool flags_are_set_ = false; // of all pairs that touched in the last step
  ContactCounts counts_;

  /// Pairs whose gaps are found together, and those in the batch at present.
  static constexpr std::size_t checked_together = 4096; // or a few more
  std::vector<NearPair> to_check_;
  NearPair in_check_[ellipsoid::ContactBatch::capacity];
  ellipsoid::FirstGaps first_gaps_; // of candidates
  /// Pairs that touched in the last step, searched together.
  Contact in_search_[ellipsoid::ContactBatch::capacity];
  ellipsoid::ContactBatch batch_;

  /// Most pairs touch and take one Newton step: further steps and other results are counted apart.
  struct SearchCounts {
    double tested = 0.0, more_steps = 0.0, apart = 0.0, not_converged = 0.0;
  };
  /// What a search says of a pair, besides where the contact is.
  struct Finding {
    ellipsoid::Vector3 normal; ///< unit, from i to j
    double steps;
    bool is_apart, has_converged;
  };

  void choose_pairs();
  void choose(const NeighbourPairs::Candidate* candidates, int count, bool* keep);
  void check_new_pairs(PairForces& forces);
  void check_due_pairs(PairForces& forces);
  void check_gaps(PairForces& forces);
  void find_gaps(PairForces& forces);
  void search_active_pairs(PairForces& forces);
  void search_together(PairForces& forces);
  bool search_alone(NearPair& pair, PairForces& forces);
  bool defer_without_search(NearPair& pair, const ellipsoid::Vector3& distance, PairForces& forces);
  void record_search(const Contact& pair, const Finding& finding, SearchCounts& counts) const;
  void close(const Contact& pair, PairForces& forces) const;
  void count(const SearchCounts& counts);

  ellipsoid::Vector3 centre_distance(int i, int j) const;
  double bounding_gap(int i, int j, const ellipsoid::Vector3& distance) const;
  void defer(const NearPair& pair, double gap, const ellipsoid::Vector3& normal);
  void close_and_defer(NearPair& pair, double gap, const ellipsoid::Vector3& normal,
                       PairForces& forces);
  ellipsoid::Vector3 last_normal(const NearPair& pair) const;
  void remember_normal(const NearPair& pair, const ellipsoid::Vector3& normal);
  /// Farther apart than this, a pair may be left out (length).
  double margins(int i, int j) { return motions_.clocks().margin(i) + motions_.clocks().margin(j); }
  double share(int j) const { return j < particles_.owned ? 1.0 : 0.5; }
};

} // namespace ellipsoid_host
