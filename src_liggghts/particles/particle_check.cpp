// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "particle_check.h"

#include "atom.h"
#include "error.h"
#include "lammps.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

using namespace LAMMPS_NS;

namespace {

constexpr double unit_length_tolerance = 1e-6; // of the quaternion's square; as for data files

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

/// What a particle must be, and what it is.
struct Demand {
  bool is_met;
  const char *what, *needed;
  const double* values;
  int count;
};

std::string complaint(const Demand& demand) {
  std::ostringstream text;
  text << demand.what << " ";
  for (int k = 0; k < demand.count; ++k)
    text << (k > 0 ? " " : "") << demand.values[k];
  text << ", " << demand.needed;
  return text.str();
}

} // namespace

namespace ellipsoid_host {

void check_particles(LAMMPS* lmp, const char* caller) {
  const Atom* const atom = lmp->atom;
  for (int i = 0; i < atom->nlocal; ++i) {
    const Demand demands[] = {
        {all_positive(atom->shape[i], 3), "the semi-axes",
         "allowed are finite values > 0; correct 'set ... shape a b c'", atom->shape[i], 3},
        {all_positive(&atom->rmass[i], 1), "the mass",
         "allowed is a finite value > 0; correct 'set ... density' or 'mass'", &atom->rmass[i], 1},
        {all_positive(atom->inertia[i], 3), "the principal moments",
         "allowed are finite values > 0; give 'set ... density' after 'set ... shape'",
         atom->inertia[i], 3},
        {is_unit(atom->quaternion[i]), "the quaternion",
         "allowed is one of length 1; give 'set ... quat' an axis that is not zero",
         atom->quaternion[i], 4},
        {all_finite(atom->x[i], 3), "the position", "allowed are finite values; correct it",
         atom->x[i], 3},
        {all_finite(atom->v[i], 3), "the velocity", "allowed are finite values; correct it",
         atom->v[i], 3},
        {all_finite(atom->angmom[i], 3), "the angular momentum",
         "allowed are finite values; correct 'set ... omegax' and so on", atom->angmom[i], 3}};
    for (const Demand& demand : demands)
      if (!demand.is_met)
        lmp->error->one(FLERR, (std::string(caller) + ": atom " + std::to_string(atom->tag[i]) +
                                " has " + complaint(demand))
                                   .c_str());
  }
}

} // namespace ellipsoid_host
