// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "compute_erotate_ellipsoid.h"

#include "atom.h"
#include "ellipsoid_host.h"
#include "error.h"
#include "force.h"
#include "motion/rigid_body.h"
#include "update.h"

using namespace LAMMPS_NS;

ComputeERotateEllipsoid::ComputeERotateEllipsoid(ELLIPSOID_COMPUTE_PARAMETERS)
    : HostCompute(ELLIPSOID_COMPUTE_ARGUMENTS) {
  if (narg > iarg)
    error->compute_error(FLERR, this, "takes no arguments after its style; remove them");
  scalar_flag = 1;
  extscalar = 1;
}

void ComputeERotateEllipsoid::init() {
  if (!atom->superquadric_flag)
    error->compute_error(FLERR, this,
                         "needs particles with shape: use atom_style granular/ellipsoid");
}

double ComputeERotateEllipsoid::compute_scalar() {
  invoked_scalar = update->ntimestep;
  double energy = 0.0;
  for (int i = 0; i < atom->nlocal; ++i)
    if (atom->mask[i] & groupbit)
      energy += ellipsoid::rotational_energy(ellipsoid_host::vector(atom->angmom[i]),
                                             ellipsoid_host::vector(atom->inertia[i]),
                                             ellipsoid_host::quaternion(atom->quaternion[i]));
  MPI_Allreduce(&energy, &scalar, 1, MPI_DOUBLE, MPI_SUM, world);
  scalar *= force->mvv2e;
  return scalar;
}
