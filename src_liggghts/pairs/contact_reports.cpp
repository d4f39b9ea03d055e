// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "contact_reports.h"

#include "atom.h"
#include "fix_contact_property_atom.h"
#include "force.h"
#include "pair_gran_ellipsoid.h"
#include "update.h"
#include "vector_liggghts.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace ellipsoid_host;
using LIGGGHTS::ContactModels::ForceData;
using LIGGGHTS::ContactModels::SurfacesIntersectData;

void ContactReports::begin_step(bool for_list) {
  for_list_ = for_list;
  if (for_list_)
    pair_.begin_list();
  are_wanted_ =
      for_list_ || pair_.evflag || pair_.store_sum_normal_force() || pair_.storeContactForces();
}

void ContactReports::end_step() {
  if (for_list_)
    pair_.end_list();
  if (pair_.storeContactForces())
    pair_.fix_contact_forces()->do_forward_comm();
}

void ContactReports::add(SurfacesIntersectData contact, const ForceData& force_i,
                         const ForceData& force_j, bool owns_j) {
  const int i = contact.i, j = contact.j;
  const double* f = force_i.delta_F;
  if (contact.computeflag && pair_.store_sum_normal_force()) {
    const double normal_force = vectorDot3D(f, contact.en);
    *pair_.get_sum_normal_force_ptr(i) += normal_force;
    if (owns_j)
      *pair_.get_sum_normal_force_ptr(j) += normal_force;
  }
  if (for_list_)
    pair_.add_to_list(contact, force_i, force_j);
  if (pair_.evflag)
    pair_.ev_tally_xyz(i, j, atom->nlocal, force->newton_pair, 0.0, 0.0, f[0], f[1], f[2],
                       contact.delta[0], contact.delta[1], contact.delta[2]);
  if (pair_.storeContactForces() && 0 == update->ntimestep % pair_.storeContactForcesEvery()) {
    store_partner(pair_.fix_contact_forces(), i, j, force_i);
    store_partner(pair_.fix_contact_forces(), j, i, force_j);
  }
}

void ContactReports::store_partner(FixContactPropertyAtom* fix, int i, int j,
                                   const ForceData& force) {
  if (fix->has_partner(i, atom->tag[j]) != -1)
    return;
  double values[6];
  std::copy(force.delta_F, force.delta_F + 3, values);
  std::copy(force.delta_torque, force.delta_torque + 3, values + 3);
  fix->add_partner(i, atom->tag[j], values);
}
