// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "contact_counts.h"
#include "neighbour_pairs.h"
#include "neighbours/body_bounds.h"
#include "pointers.h"

namespace LAMMPS_NS {
class PairGranEllipsoid;
}

namespace ellipsoid_host {

class PairForces;
class ModelSettings;

/// The contacts of all pairs of particles with one kind of surface: finds them, and hands them to
/// the forces.
class SurfaceContacts : protected LAMMPS_NS::Pointers {
 public:
  SurfaceContacts(LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::PairGranEllipsoid& pair)
      : Pointers(lmp), pair_(pair) {}
  ~SurfaceContacts() override = default;
  /// After the contact models have added their values to the history.
  virtual void read_settings(const ModelSettings& settings) = 0;
  /// @param[in] is_time_step false: forces are computed for the same moment again, as when a run is
  ///            set up, which leaves no trace in what is remembered
  virtual ContactCounts compute(PairForces& forces, bool is_time_step) = 0;
  /// When ghosts are new, on all ranks together: gets what bounds() asks of them.
  virtual void ghosts_are_new() {}
  /// What an owned or ghost particle lies within: no contact is possible outside.
  virtual ellipsoid::BodyBounds bounds(int i) = 0;
  /// The rows of histories whose numbers the host's lists hold.
  const HistoryRows& history_rows() const { return pairs_.rows(); }
  /// When the lists are new: pairs that touched get back what the host's fix has kept.
  /// @return whether they did
  bool recall_histories();
  /// @param[in] all the host's fix has what the histories are at present
  void histories_are_kept(bool all) { pairs_.histories_are_kept(all); }

 protected:
  LAMMPS_NS::PairGranEllipsoid& pair_;
  NeighbourPairs pairs_;

  /// The host's lists are those of this step.
  void begin_pairs();
};

} // namespace ellipsoid_host
