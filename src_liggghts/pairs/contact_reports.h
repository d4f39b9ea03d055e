// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// What other commands of the host want to know of each contact of a pair style: forces and their
// moments for lists, stresses, and sums.
#pragma once

#include "host_contact.h"
#include "pointers.h"

namespace LAMMPS_NS {
class FixContactPropertyAtom;
class PairGranEllipsoid;
} // namespace LAMMPS_NS

namespace ellipsoid_host {

class ContactReports : private LAMMPS_NS::Pointers {
 public:
  ContactReports(LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::PairGranEllipsoid& pair)
      : Pointers(lmp), pair_(pair) {}

  /// @param[in] for_list a command of the host lists the contacts of this step
  void begin_step(bool for_list);
  void end_step();
  /// Whether a command needs each contact of this step.
  bool are_wanted() const { return are_wanted_; }

  /// @param[in] force_i, force_j what the contact adds to both
  /// @param[in] owns_j this rank sums up the forces on j
  void add(LIGGGHTS::ContactModels::SurfacesIntersectData contact,
           const LIGGGHTS::ContactModels::ForceData& force_i,
           const LIGGGHTS::ContactModels::ForceData& force_j, bool owns_j);

 private:
  LAMMPS_NS::PairGranEllipsoid& pair_;
  bool for_list_ = false, are_wanted_ = false;

  void store_partner(LAMMPS_NS::FixContactPropertyAtom* fix, int i, int j,
                     const LIGGGHTS::ContactModels::ForceData& force);
};

} // namespace ellipsoid_host
