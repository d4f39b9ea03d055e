// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "compute_continuum_weighted_ellipsoid.h"

#include "atom.h"
#include "averages/images_in_reach.h"
#include "comm.h"
#include "domain.h"
#include "ellipsoid_contact_caller.h"
#include "ellipsoid_host.h"
#include "error.h"
#include "force.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <mpi.h>

using namespace LAMMPS_NS;
using ellipsoid::CoarseGrainingFunction;
using ellipsoid::CoarseGrainingShape;
using ellipsoid::FieldsAtParticles;
using ellipsoid::ForceLine;
using ellipsoid::MovingMass;
using ellipsoid::PeriodicEdges;
using ellipsoid::SpaceBlock;
using ellipsoid::Tensor;
using ellipsoid::Vector3;
using LIGGGHTS::ContactModels::ContactRecord;

namespace {

/// The host's kernels of this radius: a Gaussian of standard deviation R / sqrt(18).
CoarseGrainingFunction function_of(int word, double radius) {
  if (word == 1)
    return CoarseGrainingFunction::cut_gaussian(radius / std::sqrt(18.0), radius);
  if (word == 2)
    return {CoarseGrainingShape::wendland, 0.5 * radius};
  return {CoarseGrainingShape::heaviside, radius};
}

PeriodicEdges edges_of(const Domain& domain) {
  PeriodicEdges cell;
  const bool tilted = domain.triclinic != 0;
  cell.edges = {Vector3{domain.xprd, 0.0, 0.0}, Vector3{tilted ? domain.xy : 0.0, domain.yprd, 0.0},
                Vector3{tilted ? domain.xz : 0.0, tilted ? domain.yz : 0.0, domain.zprd}};
  for (std::size_t k = 0; k < 3; ++k)
    cell.is_periodic[k] = domain.periodicity[k] != 0;
  if (const double* rate = domain.h_rate; domain.deform_vremap)
    cell.edge_speed = {Vector3{rate[0], 0.0, 0.0}, Vector3{rate[5], rate[1], 0.0},
                       Vector3{rate[4], rate[3], rate[2]}};
  return cell;
}

SpaceBlock block_of(const Vector3& a, const Vector3& b) {
  return {{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
          {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}};
}

/// The elements of each rank in turn, on all ranks: action(element).
template <class Element, class Action>
void for_each_of_all_ranks(const std::vector<Element>& own, const Comm& comm, MPI_Comm world,
                           const Action& action) {
  for (int rank = 0; rank < comm.nprocs; ++rank) {
    int count = static_cast<int>(own.size());
    MPI_Bcast(&count, 1, MPI_INT, rank, world);
    std::vector<Element> received =
        rank == comm.me ? own : std::vector<Element>(static_cast<std::size_t>(count));
    MPI_Datatype type;
    MPI_Type_contiguous(static_cast<int>(sizeof(Element)), MPI_BYTE, &type);
    MPI_Type_commit(&type);
    MPI_Bcast(received.data(), count, type, rank, world);
    MPI_Type_free(&type);
    for (const Element& element : received)
      action(element);
  }
}

} // namespace

ComputeContinuumWeightedEllipsoid::ComputeContinuumWeightedEllipsoid(ELLIPSOID_COMPUTE_PARAMETERS)
    : HostCompute(ELLIPSOID_COMPUTE_ARGUMENTS) {
  const ellipsoid_host::CommandName name{"Compute", style, id};
  ellipsoid_host::ArgumentReader reader(error, name, narg, arg, iarg);
  double radius = 0.0;
  int kernel = 0, target = -1;
  while (!reader.done()) {
    const std::string keyword = reader.keyword();
    if (keyword == "kernel_radius")
      radius = reader.positive(keyword);
    else if (keyword == "kernel_type")
      kernel = reader.choice(keyword, {"Top_Hat", "Gaussian", "Wendland"});
    else if (keyword == "compute")
      target = reader.choice(keyword, {"stress", "strain", "stress_strain"});
    else
      reader.complain("unknown keyword '" + keyword +
                      "'; use kernel_radius, kernel_type or compute");
  }
  if (!(radius > 0.0))
    reader.complain("has no kernel_radius; give one, as 'kernel_radius 0.01'");
  if (target < 0)
    reader.complain("does not say what to compute; give 'compute stress', 'compute strain' or "
                    "'compute stress_strain'");
  has_stress_ = target != 1;
  has_strain_ = target != 0;
  if (has_strain_ && kernel == 0)
    reader.complain("the gradient of kernel_type Top_Hat is 0 and gives no strain; use "
                    "'kernel_type Wendland' or 'kernel_type Gaussian'");
  function_.emplace(function_of(kernel, radius));
  peratom_flag = 1;
  size_peratom_cols = 9 * (has_stress_ + has_strain_);
}

void ComputeContinuumWeightedEllipsoid::init() {
  pair_ = EllipsoidContactCaller::pair_of(*force);
  if (!pair_)
    error->compute_error(FLERR, this,
                         "takes the contacts of pair_style gran/ellipsoid; use that style");
  walls_ = EllipsoidContactCaller::walls_of(*modify);
  if (!has_stress_)
    return;
  pair_->keep_records();
  for (EllipsoidContactCaller* wall : walls_)
    wall->keep_records();
}

void ComputeContinuumWeightedEllipsoid::compute_peratom() {
  invoked_peratom = update->ntimestep;
  const std::vector<MovingMass> masses = own_masses();
  std::vector<ForceLine> lines;
  if (has_stress_)
    lines = own_lines();
  double longest = 0.0, own_longest = 0.0;
  for (const ForceLine& line : lines)
    own_longest = std::max(own_longest, norm(line.end - line.begin));
  MPI_Allreduce(&own_longest, &longest, 1, MPI_DOUBLE, MPI_MAX, world);
  FieldsAtParticles fields(*function_, masses, longest);
  spread_masses(fields, masses);
  spread_lines(fields, lines);
  store(fields);
}

std::vector<MovingMass> ComputeContinuumWeightedEllipsoid::own_masses() const {
  std::vector<MovingMass> found;
  for (int i = 0; i < atom->nlocal; ++i)
    if (atom->mask[i] & groupbit)
      found.push_back(
          {ellipsoid_host::vector(atom->x[i]), ellipsoid_host::vector(atom->v[i]), atom->rmass[i]});
  return found;
}

/// Of contacts within the group.
std::vector<ForceLine> ComputeContinuumWeightedEllipsoid::own_lines() const {
  std::vector<ForceLine> found;
  auto& self = const_cast<ComputeContinuumWeightedEllipsoid&>(*this);
  for (const ContactRecord& contact : pair_->records_of(self, *update, *error))
    if ((contact.group_mask & groupbit) && contact.counts())
      found.push_back({contact.position_i, contact.position_j, contact.force});
  for (const EllipsoidContactCaller* wall : walls_)
    for (const ContactRecord& contact : wall->records_of(self, *update, *error))
      if (contact.group_mask & groupbit)
        found.push_back({contact.position_i, contact.point, contact.force});
  return found;
}

void ComputeContinuumWeightedEllipsoid::spread_masses(FieldsAtParticles& fields,
                                                      const std::vector<MovingMass>& own) const {
  const PeriodicEdges cell = edges_of(*domain);
  for_each_of_all_ranks(own, *comm, world, [&](const MovingMass& mass) {
    for (const auto& image :
         images_that_reach(cell, {mass.position, mass.position}, fields.reached()))
      fields.add(MovingMass{mass.position + cell.shift(image), mass.velocity + cell.speed(image),
                            mass.mass});
  });
}

void ComputeContinuumWeightedEllipsoid::spread_lines(FieldsAtParticles& fields,
                                                     const std::vector<ForceLine>& own) const {
  const PeriodicEdges cell = edges_of(*domain);
  for_each_of_all_ranks(own, *comm, world, [&](const ForceLine& line) {
    for (const auto& image :
         images_that_reach(cell, block_of(line.begin, line.end), fields.reached())) {
      const Vector3 shift = cell.shift(image);
      fields.add(ForceLine{line.begin + shift, line.end + shift, line.force});
    }
  });
}

void ComputeContinuumWeightedEllipsoid::store(const FieldsAtParticles& fields) {
  const std::size_t size = static_cast<std::size_t>(atom->nmax),
                    columns = static_cast<std::size_t>(size_peratom_cols);
  values_.assign(size * columns, 0.0);
  rows_.resize(size);
  for (std::size_t i = 0; i < size; ++i)
    rows_[i] = &values_[i * columns];
  array_atom = rows_.data();
  std::size_t place = 0;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!(atom->mask[i] & groupbit))
      continue;
    double* row = rows_[static_cast<std::size_t>(i)];
    if (has_stress_) {
      const Tensor stress = fields.stress(place);
      row = std::copy(stress.begin(), stress.end(), row);
    }
    if (has_strain_)
      for (const double rate : fields.strain_rate(place))
        *row++ = update->dt * rate;
    ++place;
  }
}

double ComputeContinuumWeightedEllipsoid::memory_usage() {
  return static_cast<double>(values_.capacity() * sizeof(double) +
                             rows_.capacity() * sizeof(double*));
}
