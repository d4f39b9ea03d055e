// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "contact_counts.h"
#include "history_rows.h"
#include "neighbours/body_bounds.h"

namespace ellipsoid_host {

class PairForces;
class ModelSettings;

/// The contacts of all pairs of particles with one kind of surface: finds them, and hands them to
/// the forces.
class SurfaceContacts {
 public:
  virtual ~SurfaceContacts() = default;
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
  virtual const HistoryRows& history_rows() const = 0;
  /// When the lists are new: pairs that touched get back what the host's fix has kept.
  /// @return whether they did
  virtual bool recall_histories() = 0;
  /// @param[in] all the host's fix has what the histories are at present
  virtual void histories_are_kept(bool all) = 0;
};

} // namespace ellipsoid_host
