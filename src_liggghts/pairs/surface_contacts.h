// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#ifndef SURFACE_CONTACTS_H_
#define SURFACE_CONTACTS_H_

#include "contact_counts.h"

namespace LIGGGHTS {

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
};

} // namespace LIGGGHTS

#endif
