// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "compute_coordination_ellipsoid.h"

#include "atom.h"
#include "ellipsoid_contact_caller.h"
#include "error.h"
#include "force.h"
#include "update.h"

#include <algorithm>

using namespace LAMMPS_NS;
using LIGGGHTS::ContactModels::ContactRecord;

ComputeCoordinationEllipsoid::ComputeCoordinationEllipsoid(ELLIPSOID_COMPUTE_PARAMETERS)
    : HostCompute(ELLIPSOID_COMPUTE_ARGUMENTS) {
  if (narg > iarg)
    error->compute_error(FLERR, this, "takes no arguments after its style; remove them");
  peratom_flag = 1;
  size_peratom_cols = column_count;
}

void ComputeCoordinationEllipsoid::init() {
  pair_ = EllipsoidContactCaller::pair_of(*force);
  if (!pair_)
    error->compute_error(FLERR, this,
                         "counts contacts of pair_style gran/ellipsoid; use that style");
  walls_ = EllipsoidContactCaller::walls_of(*modify);
  pair_->keep_records();
  for (EllipsoidContactCaller* wall : walls_)
    wall->keep_records();
}

void ComputeCoordinationEllipsoid::compute_peratom() {
  invoked_peratom = update->ntimestep;
  const std::size_t size = static_cast<std::size_t>(atom->nmax);
  counts_.assign(size * column_count, 0.0);
  rows_.resize(size);
  for (std::size_t i = 0; i < size; ++i)
    rows_[i] = &counts_[i * column_count];
  array_atom = rows_.data();
  count_pairs();
  for (EllipsoidContactCaller* wall : walls_)
    for (const ContactRecord& contact : wall->records_of(*this, *update, *error))
      count(contact.index_i, wall_contacts);
}

void ComputeCoordinationEllipsoid::count_pairs() {
  touching_.clear();
  for (const ContactRecord& contact : pair_->records_of(*this, *update, *error)) {
    const int i = contact.index_i, j = contact.index_j;
    count(i, pair_contacts);
    count(j, pair_contacts);
    touching_.push_back({i, j});
    touching_.push_back({j, i});
  }
  std::sort(touching_.begin(), touching_.end());
  const auto end = std::unique(touching_.begin(), touching_.end());
  for (auto contact = touching_.begin(); contact != end; ++contact)
    count(contact->first, touching_particles);
}

/// The rank that owns a ghost counts for it.
void ComputeCoordinationEllipsoid::count(int particle, Column column) {
  if (particle < atom->nlocal && (atom->mask[particle] & groupbit))
    rows_[static_cast<std::size_t>(particle)][column] += 1.0;
}

double ComputeCoordinationEllipsoid::memory_usage() {
  return static_cast<double>(counts_.capacity() * sizeof(double) +
                             rows_.capacity() * sizeof(double*) +
                             touching_.capacity() * sizeof(touching_[0]));
}
