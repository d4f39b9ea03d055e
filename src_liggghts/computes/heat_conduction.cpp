// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "heat_conduction.h"

#include "atom.h"
#include "ellipsoid/ellipsoid_contact.h"
#include "ellipsoid/elliptic_hertz.h"
#include "ellipsoid_contact_caller.h"
#include "ellipsoid_host.h"
#include "force.h"
#include "lammps.h"
#include "spin.h"

#include <cmath>

using namespace LAMMPS_NS;
using ellipsoid::Vector3;
using LIGGGHTS::ContactModels::ContactRecord;
using LIGGGHTS::ContactModels::EllipsoidContactCaller;

namespace ellipsoid_host {

namespace {

ellipsoid::EllipsoidShape shape(const Atom& atom, int i) {
  return ellipsoid::make_shape(vector(atom.shape[i]), quaternion(atom.quaternion[i]));
}

/// Area in which the undeformed surfaces overlap by h: gap = A x^2 + B y^2 <= h is an ellipse of
/// the area pi h / sqrt(A B) = 2 pi R h. Spheres of a multi-sphere have their own R.
double overlap_area(const Atom& atom, const ContactRecord& contact, double overlap) {
  const bool of_spheres = contact.sphere_i > 0;
  const double radius =
      of_spheres ? contact.reduced_radius
                 : circle_radius(relative_curvature(shape(atom, contact.index_i),
                                                    shape(atom, contact.index_j), contact.normal));
  return 2.0 * M_PI * radius * overlap;
}

double contact_area(const Atom& atom, const HeatConduction& heat, const ContactRecord& contact,
                    int type_i, int type_j) {
  if (heat.fixed_area > 0.0)
    return heat.fixed_area;
  const double ratio = heat.overlap_ratio ? heat.overlap_ratio[type_i][type_j] : 1.0;
  return overlap_area(atom, contact, ratio * contact.overlap);
}

/// Batchelor & O'Brien 1977, Proc. R. Soc. A 355, 313: H = 2 k a, here with the harmonic mean
/// conductivity and, as in the host, with sqrt(area) in the place of the contact's radius a.
double conductance(double k_i, double k_j, double area) {
  return k_i > 0.0 && k_j > 0.0 ? 4.0 * k_i * k_j / (k_i + k_j) * std::sqrt(area) : 0.0;
}

/// Half of the directional flux is each particle's, as in the host.
void add(const HeatConduction& heat, int i, double flux, double sign, const Vector3& path,
         double area) {
  heat.flux[i] += sign * flux;
  store(vector(heat.directional_flux[i]) + 0.5 * flux * path, heat.directional_flux[i]);
  if (!heat.area)
    return;
  heat.area[i] += area;
  heat.contact_count[i] += 1.0;
}

} // namespace

void keep_contacts_for_heat(LAMMPS* lmp) {
  if (EllipsoidContactCaller* pair = EllipsoidContactCaller::pair_of(*lmp->force))
    pair->keep_records();
}

bool conduct_heat(LAMMPS* lmp, const HeatConduction& heat) {
  const EllipsoidContactCaller* pair = EllipsoidContactCaller::pair_of(*lmp->force);
  if (!pair || !are_ellipsoids(lmp))
    return false;
  refuse_unknown_area(lmp, heat);
  const Atom& atom = *lmp->atom;
  for (const ContactRecord& contact : pair->records()) {
    const int i = contact.index_i, j = contact.index_j;
    if (!((atom.mask[i] | atom.mask[j]) & heat.groupbit))
      continue;
    const int type_i = atom.type[i] - 1, type_j = atom.type[j] - 1;
    const double area = contact_area(atom, heat, contact, type_i, type_j);
    const double flux = contact.weight *
                        conductance(heat.conductivity[type_i], heat.conductivity[type_j],
                                    heat.by_radius ? area / M_PI : area) *
                        (heat.temperature[j] - heat.temperature[i]);
    const Vector3 path = contact.position_i - contact.position_j;
    add(heat, i, flux, 1.0, path, area);
    if (j < atom.nlocal) // the rank of a ghost does the same
      add(heat, j, flux, -1.0, path, area);
  }
  return true;
}

} // namespace ellipsoid_host
