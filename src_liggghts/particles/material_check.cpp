// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "material_check.h"

#include "error.h"
#include "fix_property_global.h"
#include "lammps.h"
#include "modify.h"
#include "update.h"

#include <cmath>
#include <sstream>
#include <string>

using namespace LAMMPS_NS;

namespace ellipsoid_host {

namespace {

/// Properties of the host's contact, heat and wear models: those that have to be > 0, and those
/// that have to be >= 0.
constexpr const char* positive[] = {"youngsModulus", "characteristicVelocity", "kn", "kt"};
constexpr const char* not_negative[] = {"coefficientFriction",
                                        "coefficientRollingFriction",
                                        "coefficientRollingViscousDamping",
                                        "coeffRollingStiffness",
                                        "rollingStiffness",
                                        "cohesionEnergyDensity",
                                        "cohesionStrength",
                                        "surfaceEnergy",
                                        "surfaceTension",
                                        "liquidVolume",
                                        "FluidViscosity",
                                        "FrictionViscosity",
                                        "gamman",
                                        "gamman_abs",
                                        "gammat",
                                        "LoadingStiffness",
                                        "UnloadingStiffness",
                                        "coefficientAdhesionStiffness",
                                        "normalDampingCoefficient",
                                        "thermalConductivity",
                                        "thermalCapacity",
                                        "k_finnie"};

std::string readable(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

int count_of(const Fix& property) {
  if (property.vector_flag)
    return property.size_vector;
  return property.array_flag ? property.size_array_rows * property.size_array_cols : 1;
}

void check_property(Error& error, FixPropertyGlobal& property, const std::string& name,
                    bool may_be_zero) {
  const bool is_of_that_name =
      property.check_fix(name.c_str(), "of any style", 0, 0, "the check of materials", false);
  const double* const values = property.get_values();
  for (int k = 0; is_of_that_name && k < count_of(property); ++k) {
    if (std::isfinite(values[k]) && (values[k] > 0.0 || (may_be_zero && values[k] == 0.0)))
      continue;
    error.all(FLERR, ("property/global " + name + " has the value " + readable(values[k]) +
                      ", allowed is " + (may_be_zero ? ">= 0" : "> 0") + "; correct the fix (id " +
                      property.id + ")")
                         .c_str());
  }
}

} // namespace

void check_materials(LAMMPS* lmp) {
  const double step = lmp->update->dt;
  if (!(std::isfinite(step) && step > 0.0))
    lmp->error->all(FLERR, ("the time step is " + readable(step) +
                            ", allowed is > 0; give 'timestep DT' with the unit of time in use")
                               .c_str());
  for (int k = 0; k < lmp->modify->nfix; ++k)
    if (auto* property = dynamic_cast<FixPropertyGlobal*>(lmp->modify->fix[k])) {
      for (const char* name : positive)
        check_property(*lmp->error, *property, name, false);
      for (const char* name : not_negative)
        check_property(*lmp->error, *property, name, true);
    }
}

} // namespace ellipsoid_host
