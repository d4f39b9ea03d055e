// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "particle_check.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "fix_property_atom.h"
#include "force.h"
#include "host_pair.h"
#include "lammps.h"
#include "modify.h"
#include "multisphere/clump_template.h"
#include "multisphere_particles.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

using namespace LAMMPS_NS;

namespace {

constexpr double unit_length_tolerance = 1e-6; // of the quaternion's square; as for data files
constexpr double moments_tolerance = 1e-6;     // relative; those of a thin plate reach the bound
constexpr double rounding = 1e-12;
constexpr double radius_tolerance = 1e-3; // relative; `set ... shape` takes 1e-4 more
// What create_atoms makes of every particle.
constexpr double created_radius = 0.5, created_density = 1.0;

bool all_finite(const double* values, int count) {
  return std::all_of(values, values + count, [](double v) { return std::isfinite(v); });
}

bool all_positive(const double* values, int count) {
  return all_finite(values, count) &&
         std::all_of(values, values + count, [](double v) { return v > 0.0; });
}

bool is_unit(const double* q) {
  const double square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  return std::fabs(square - 1.0) <= unit_length_tolerance;
}

/// No moment of a rigid body is larger than the sum of the two others.
bool are_moments(const double* m) {
  const double largest = std::max({m[0], m[1], m[2]}), sum = m[0] + m[1] + m[2];
  return all_positive(m, 3) && largest <= (sum - largest) * (1.0 + moments_tolerance);
}

/// Whether a bounding radius fits the semi-axes. That of a clump, which fix clumps/ellipsoid sets,
/// lies between the longest semi-axis and half the diagonal of their box.
bool bounds(double radius, const double* axes, bool is_clump) {
  const double longest = std::max({axes[0], axes[1], axes[2]});
  const double largest = is_clump ? std::hypot(axes[0], axes[1], axes[2]) : longest;
  return radius >= longest * (1.0 - rounding) && radius <= largest * (1.0 + radius_tolerance);
}

bool is_clump(const LAMMPS& lmp, int i) {
  const FixPropertyAtom* spacing = ellipsoid_host::subsphere_properties(lmp.modify)[1];
  return spacing && spacing->vector_atom[i] > ellipsoid::clump_spacing;
}

/// Of a restart file, perhaps, whose numbers of sub-spheres nothing in the script has taken up.
bool may_be_clump(const LAMMPS& lmp, int i) {
  const Atom& atom = *lmp.atom;
  return ellipsoid_host::has_surface(*lmp.force, "multisphere") &&
         !ellipsoid_host::subsphere_properties(lmp.modify)[1] &&
         !bounds(atom.radius[i], atom.shape[i], false) &&
         bounds(atom.radius[i], atom.shape[i], true);
}

/// A particle as create_atoms makes it, in a box too small for it.
bool is_unshaped(const Atom& atom, const Domain& domain, int i) {
  return atom.radius[i] == created_radius && atom.density[i] == created_density &&
         std::max({domain.xprd, domain.yprd, domain.zprd}) < 2.0 * created_radius;
}

/// What a particle must be, and what it is.
struct Demand {
  bool is_met;
  const char *what, *needed;
  const double* values;
  int count;
};

void check(const LAMMPS& lmp, const char* caller, int i, const Demand& demand) {
  if (demand.is_met)
    return;
  std::ostringstream text;
  text << caller << ": atom " << lmp.atom->tag[i] << " has " << demand.what;
  for (int k = 0; k < demand.count; ++k)
    text << " " << demand.values[k];
  text << ", " << demand.needed;
  lmp.error->one(FLERR, text.str().c_str());
}

/// The quick check, which all particles pass through.
bool is_sound(const LAMMPS& lmp, int i) {
  const Atom& atom = *lmp.atom;
  return all_positive(atom.shape[i], 3) && atom.rmass[i] > 0.0 && std::isfinite(atom.rmass[i]) &&
         are_moments(atom.inertia[i]) && is_unit(atom.quaternion[i]) &&
         atom.blockiness[i][0] == 2.0 && atom.blockiness[i][1] == 2.0 &&
         (bounds(atom.radius[i], atom.shape[i], false) ||
          bounds(atom.radius[i], atom.shape[i], is_clump(lmp, i)));
}

bool moves_finitely(const Atom& atom, int i) {
  return all_finite(atom.x[i], 3) && all_finite(atom.v[i], 3) && all_finite(atom.angmom[i], 3) &&
         all_finite(atom.omega[i], 3) && all_finite(atom.quaternion[i], 4);
}

/// Says what is wrong with a particle that is not sound.
void complain_of_body(const LAMMPS& lmp, const char* caller, int i) {
  const Atom& atom = *lmp.atom;
  check(lmp, caller, i,
        {all_positive(atom.shape[i], 3), "the semi-axes",
         "allowed are finite values > 0; correct 'set ... shape a b c'", atom.shape[i], 3});
  check(lmp, caller, i,
        {all_positive(&atom.rmass[i], 1), "the mass",
         "allowed is a finite value > 0; correct 'set ... density' or 'mass'", &atom.rmass[i], 1});
  check(lmp, caller, i,
        {all_positive(atom.inertia[i], 3), "the principal moments",
         "allowed are finite values > 0; give 'set ... density' after 'set ... shape'",
         atom.inertia[i], 3});
  check(lmp, caller, i,
        {are_moments(atom.inertia[i]), "the principal moments",
         "allowed is none larger than the sum of the two others; correct them, or give 'set ... "
         "density' after 'set ... shape'",
         atom.inertia[i], 3});
  check(lmp, caller, i,
        {is_unit(atom.quaternion[i]), "the quaternion",
         "allowed is one of length 1; give 'set ... quat' an axis that is not zero",
         atom.quaternion[i], 4});
  check(lmp, caller, i,
        {atom.blockiness[i][0] == 2.0 && atom.blockiness[i][1] == 2.0, "the blockiness",
         "allowed is 2 2, that of ellipsoids; use 'fix particletemplate/ellipsoid'",
         atom.blockiness[i], 2});
  check(lmp, caller, i,
        {!may_be_clump(lmp, i), "the bounding radius",
         (std::string("as clumps have; after read_restart ") + ellipsoid_host::repeat_after_restart)
             .c_str(),
         &atom.radius[i], 1});
  check(lmp, caller, i,
        {bounds(atom.radius[i], atom.shape[i], is_clump(lmp, i)), "the bounding radius",
         "allowed is the largest of its semi-axes; give 'set ... shape a b c', or use 'fix "
         "particletemplate/ellipsoid'",
         &atom.radius[i], 1});
}

} // namespace

namespace ellipsoid_host {

void check_particles(LAMMPS* lmp, const char* caller) {
  const Atom& atom = *lmp->atom;
  for (int i = 0; i < atom.nlocal; ++i) {
    if (!is_sound(*lmp, i))
      complain_of_body(*lmp, caller, i);
    if (is_unshaped(atom, *lmp->domain, i))
      check(*lmp, caller, i,
            {false, "the bounding radius",
             "which create_atoms gives, and is larger than the box; add 'set ... shape a b c' and "
             "'set ... density'",
             &atom.radius[i], 1});
  }
  check_finite(lmp, caller);
}

void check_finite(LAMMPS* lmp, const char* caller) {
  static const char* const remedy =
      "allowed are finite values; correct what set it, or shorten the time step and look with 'fix "
      "check/timestep/ellipsoid', and for bodies that overlap deeply at the start";
  const Atom& atom = *lmp->atom;
  for (int i = 0; i < atom.nlocal; ++i) {
    if (moves_finitely(atom, i))
      continue;
    check(*lmp, caller, i, {all_finite(atom.x[i], 3), "the position", remedy, atom.x[i], 3});
    check(*lmp, caller, i, {all_finite(atom.v[i], 3), "the velocity", remedy, atom.v[i], 3});
    check(*lmp, caller, i,
          {all_finite(atom.angmom[i], 3), "the angular momentum", remedy, atom.angmom[i], 3});
    check(*lmp, caller, i,
          {all_finite(atom.omega[i], 3), "the angular velocity", remedy, atom.omega[i], 3});
    check(*lmp, caller, i,
          {all_finite(atom.quaternion[i], 4), "the quaternion", remedy, atom.quaternion[i], 4});
  }
}

} // namespace ellipsoid_host
