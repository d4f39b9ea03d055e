// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "compute_contacts_ellipsoid.h"

#include "error.h"
#include "force.h"
#include "pair_gran_ellipsoid.h"
#include "update.h"

using namespace LAMMPS_NS;
using ellipsoid_host::ContactCounts;

ComputeContactsEllipsoid::ComputeContactsEllipsoid(ELLIPSOID_COMPUTE_PARAMETERS)
    : HostCompute(ELLIPSOID_COMPUTE_ARGUMENTS) {
  if (narg > iarg)
    error->compute_error(FLERR, this, "takes no arguments after its style; remove them");
  vector_flag = 1;
  size_vector = ContactCounts::item_count;
  extvector = 1;
  vector = new double[ContactCounts::item_count]();
}

ComputeContactsEllipsoid::~ComputeContactsEllipsoid() { delete[] vector; }

void ComputeContactsEllipsoid::init() {
  pair_ = dynamic_cast<PairGranEllipsoid*>(force->pair);
  if (!pair_)
    error->compute_error(FLERR, this,
                         "counts contacts of pair_style gran/ellipsoid; use that style");
}

void ComputeContactsEllipsoid::compute_vector() {
  invoked_vector = update->ntimestep;
  MPI_Allreduce(pair_->counts().values, vector, ContactCounts::item_count, MPI_DOUBLE, MPI_SUM,
                world);
}
