// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "fix_check_timestep_ellipsoid.h"

#include "atom.h"
#include "comm.h"
#include "ellipsoid/ellipsoid_properties.h"
#include "ellipsoid_host.h"
#include "error.h"
#include "fix_property_atom.h"
#include "fix_property_global.h"
#include "force.h"
#include "law/time_scales.h"
#include "modify.h"
#include "multisphere_particles.h"
#include "neighbor.h"
#include "pair.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

using namespace LAMMPS_NS;
using namespace FixConst;
using ellipsoid_host::vector;

namespace {
constexpr int default_interval = 1000; // steps between two checks of the fix of make_sure()
}

FixCheckTimestepEllipsoid::FixCheckTimestepEllipsoid(LAMMPS* lmp, int narg, char** arg)
    : Fix(lmp, narg, arg) {
  if (!atom->superquadric_flag)
    error->fix_error(FLERR, this, "needs particles with shape: use atom_style granular/ellipsoid");
  parse(narg, arg);
  vector_flag = 1;
  size_vector = 3;
  global_freq = nevery;
  extvector = 0;
}

FixCheckTimestepEllipsoid::~FixCheckTimestepEllipsoid() = default;

void FixCheckTimestepEllipsoid::parse(int narg, char** arg) {
  ellipsoid_host::ArgumentReader reader(error, this, narg, arg, 3);
  nevery = reader.integer("every", 1, MAXSMALLINT - 1);
  limits_[0] = reader.positive("rayleigh");
  limits_[1] = reader.positive("hertz");
  while (!reader.done()) {
    const std::string keyword = reader.keyword();
    if (keyword == "warn")
      warns_ = reader.yes_no(keyword);
    else if (keyword == "error")
      stops_ = reader.yes_no(keyword);
    else if (keyword == "vmax")
      largest_speed_ = reader.positive(keyword);
    else
      reader.complain("unknown keyword '" + keyword + "', allowed are 'warn', 'error', 'vmax'");
  }
}

int FixCheckTimestepEllipsoid::setmask() { return END_OF_STEP; }

void FixCheckTimestepEllipsoid::setup(int) {
  fractions_[rayleigh] = 0.0; // not measured in this run
  end_of_step();
}

void FixCheckTimestepEllipsoid::init() {
  const auto find = [this](const char* name) {
    return static_cast<FixPropertyGlobal*>(modify->find_fix_property(
        name, "property/global", "peratomtype", atom->ntypes, 0, style, !is_default_));
  };
  youngs_modulus_ = find("youngsModulus");
  poissons_ratio_ = find("poissonsRatio");
  is_superfluous_ =
      is_default_ && (modify->n_fixes_style(style) > 1 || !youngs_modulus_ || !poissons_ratio_);
  if (is_superfluous_)
    return;
  check_material();
  chains_.reset(new ellipsoid_host::MultisphereParticles(lmp));
}

void FixCheckTimestepEllipsoid::check_material() const {
  for (int type = 0; type < atom->ntypes; ++type) {
    const double modulus = youngs_modulus_->get_values()[type],
                 ratio = poissons_ratio_->get_values()[type];
    if (modulus > 0.0 && ratio > -1.0 && ratio <= 0.5)
      continue;
    error->fix_error(FLERR, const_cast<FixCheckTimestepEllipsoid*>(this),
                     ("type " + std::to_string(type + 1) + " has youngsModulus " +
                      std::to_string(modulus) + " and poissonsRatio " + std::to_string(ratio) +
                      ", allowed are > 0 and > -1 to 0.5; correct the fix property/global")
                         .c_str());
  }
}

double FixCheckTimestepEllipsoid::effective_modulus(int type) const {
  const double *modulus = youngs_modulus_->get_values(), *ratio = poissons_ratio_->get_values();
  const auto compliance = [&](int t) { return (1.0 - ratio[t] * ratio[t]) / modulus[t]; };
  double stiffest = HUGE_VAL;
  for (int other = 0; other < atom->ntypes; ++other)
    stiffest = std::min(stiffest, compliance(other));
  return 1.0 / (compliance(type - 1) + stiffest);
}

double FixCheckTimestepEllipsoid::smallest_mass2_over_radius(int i, bool multisphere) {
  const double mass = atom->rmass[i];
  const ellipsoid::Vector3 inertia = vector(atom->inertia[i]);
  if (!multisphere)
    return ellipsoid::smallest_mass2_over_radius(vector(atom->shape[i]), mass, inertia);
  const ellipsoid::MultispherePose pose = chains_->make_pose(i);
  return ellipsoid::smallest_mass2_over_radius(*pose.body, pose.scale, mass, inertia);
}

/// Of the shortest semi-axis; of sets of spheres that are no chain, of the smallest sphere (time).
double FixCheckTimestepEllipsoid::rayleigh_time(int i, bool multisphere, double shear_modulus,
                                                double ratio) {
  const ellipsoid::Vector3 axes = vector(atom->shape[i]);
  double radius = std::min({axes.x, axes.y, axes.z}), volume = ellipsoid::volume(axes);
  if (multisphere) {
    const ellipsoid::MultispherePose pose = chains_->make_pose(i);
    if (!pose.body->is_chain()) {
      radius = pose.scale * pose.body->smallest_radius();
      volume = atom->volume[i];
    }
  }
  return ellipsoid::rayleigh_time(radius, atom->rmass[i] / volume, shear_modulus, ratio);
}

void FixCheckTimestepEllipsoid::measure() {
  const FixPropertyAtom* subspheres = ellipsoid_host::subsphere_properties(modify)[0];
  if (subspheres)
    chains_->find_properties();
  // smallest Rayleigh time; smallest m*^2/(R E*^2) and minus the largest speed
  double mine[3] = {HUGE_VAL, HUGE_VAL, -largest_speed_}, all[3];
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!(atom->mask[i] & groupbit))
      continue;
    const int type = atom->type[i];
    const double ratio = poissons_ratio_->get_values()[type - 1];
    const double shear_modulus = youngs_modulus_->get_values()[type - 1] / (2.0 * (1.0 + ratio));
    const bool multisphere = subspheres && subspheres->vector_atom[i] > 0.0;
    mine[0] = std::min(mine[0], rayleigh_time(i, multisphere, shear_modulus, ratio));
    const double modulus = effective_modulus(type);
    mine[1] = std::min(mine[1], smallest_mass2_over_radius(i, multisphere) / (modulus * modulus));
    mine[2] = std::min(
        mine[2], -(norm(vector(atom->v[i])) + norm(vector(atom->omega[i])) * atom->radius[i]));
  }
  MPI_Allreduce(mine, all, 3, MPI_DOUBLE, MPI_MIN, world);
  const double relative_speed = -2.0 * all[2];
  fractions_[0] = update->dt / all[0];
  fractions_[1] =
      relative_speed > 0.0 ? update->dt / ellipsoid::hertz_time(all[1], 1.0, relative_speed) : 0.0;
  fractions_[2] = neighbor->skin > 0.0 ? relative_speed * update->dt / neighbor->skin : 0.0;
}

/// Between particles, at present, on all ranks.
double FixCheckTimestepEllipsoid::contacts() const {
  int dimension = 0;
  const void* count = force->pair ? force->pair->extract("contacts", dimension) : nullptr;
  double mine = count ? *static_cast<const double*>(count) : 0.0, all = 0.0;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

void FixCheckTimestepEllipsoid::report(int which, const std::string& of_what) {
  if (fractions_[which] <= limits_[which])
    return;
  char numbers[80];
  std::snprintf(numbers, sizeof numbers, "%.3g, allowed is up to %.3g", fractions_[which],
                limits_[which]);
  const std::string name = is_default_
                               ? "The check of the time step"
                               : "Fix check/timestep/ellipsoid (id " + std::string(id) + ")";
  const std::string message =
      name + ": the time step over " + of_what + " is " + numbers + "; use a smaller time step" +
      (is_default_ ? ", or 'fix ID all check/timestep/ellipsoid' with limits of your own" : "");
  if (stops_ || (is_default_ && which == hertz && fractions_[hertz] > 1.0 && contacts() > 0.0))
    error->all(FLERR, message.c_str());
  if (warns_ && comm->me == 0)
    error->warning(FLERR, message.c_str());
  if (is_default_)
    warns_ = false;
}

void FixCheckTimestepEllipsoid::make_sure(LAMMPS* lmp) {
  static char id[] = "check_timestep_ellipsoid", all[] = "all",
              style[] = "check/timestep/ellipsoid", every[] = "1", limit[] = "0.5";
  char* arguments[] = {id, all, style, every, limit, limit};
  Modify& modify = *lmp->modify;
  if (modify.n_fixes_style(style) > 0)
    return;
  modify.add_fix(6, arguments);
  static_cast<FixCheckTimestepEllipsoid*>(modify.fix[modify.find_fix(id)])->is_default_ = true;
}

void FixCheckTimestepEllipsoid::end_of_step() {
  if (is_superfluous_)
    return;
  if (!is_default_ || update->ntimestep % default_interval == 0 || fractions_[rayleigh] == 0.0)
    measure();
  else if (fractions_[hertz] <= 1.0)
    return;
  report(rayleigh, "the smallest Rayleigh time");
  report(hertz, "the shortest duration of a collision (Hertz)");
  report(skin, "the time in which two particles can cross the skin");
}
