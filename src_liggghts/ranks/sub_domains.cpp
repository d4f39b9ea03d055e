// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "sub_domains.h"

#include "atom.h"
#include "balance/plane_planning.h"
#include "comm.h"
#include "domain.h"
#include "fix_mesh.h"
#include "host_variants.h"
#include "lammps.h"
#include "modify.h"
#include "tri_mesh.h"

#include <algorithm>
#include <cmath>
#include <mpi.h>
#include <numeric>

using LAMMPS_NS::LAMMPS;

namespace ellipsoid_host {

namespace {

/// Tells the host whether its formulas for equal sub-domains hold.
void note_layout(LAMMPS_NS::Comm* comm, bool is_even) {
#ifdef ELLIPSOID_HOST_INL
  comm->set_layout(is_even ? LAMMPS_NS::LAYOUT_UNIFORM : LAMMPS_NS::LAYOUT_NONUNIFORM);
#else
  comm->uniform = is_even ? 1 : 0;
#endif
}

/// Slabs of equal thickness that the box is divided into to weigh it: as many as can be summed over
/// the ranks and planned with in milliseconds.
constexpr int least_slabs = 1024, most_slabs = 65536, most_sums = 1 << 18, most_states = 1 << 22;

/// Rounds over the directions: what is planned in one changes what is best in the others.
constexpr int rounds = 3;

double* splits(LAMMPS* lmp, int k) {
  return k == 0 ? lmp->comm->xsplit : k == 1 ? lmp->comm->ysplit : lmp->comm->zsplit;
}

int number_of_slabs(int columns, int parts) {
  return std::clamp(std::min(most_sums / columns, most_states / parts), least_slabs, most_slabs);
}

/// Places of this rank's particles as fractions of the box.
std::vector<std::array<double, 3>> fractions(LAMMPS* lmp) {
  std::vector<std::array<double, 3>> result(static_cast<std::size_t>(lmp->atom->nlocal));
  for (std::size_t i = 0; i < result.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const double x = lmp->atom->x[i][k];
      result[i][static_cast<std::size_t>(k)] =
          lmp->domain->triclinic ? x : (x - lmp->domain->boxlo[k]) / lmp->domain->prd[k];
    }
  return result;
}

int part_of(double fraction, const std::vector<double>& planes) {
  const auto above = std::upper_bound(planes.begin() + 1, planes.end() - 1, fraction);
  return static_cast<int>(above - planes.begin()) - 1;
}

/// Distance of the faces of the box across direction k (length).
double thickness(LAMMPS* lmp, int k) {
  const LAMMPS_NS::Domain& domain = *lmp->domain;
  if (!domain.triclinic)
    return domain.prd[k];
  const double* h = domain.h_inv; // xx, yy, zz, yz, xz, xy
  const double rows[3] = {std::hypot(h[0], std::hypot(h[5], h[4])), std::hypot(h[1], h[3]), h[2]};
  return 1.0 / rows[k];
}

/// Least thickness of a sub-domain as a fraction of the box: room for all particles that touch
/// those of the next one, so that ghosts come from neighbouring ranks only; half an even share
/// where there is no such room.
double least_fraction(LAMMPS* lmp, const BalanceSettings& settings, int k, int parts) {
  if (settings.least_width > 0.0)
    return std::min(settings.least_width / thickness(lmp, k), 1.0 / parts);
  const double cut = lmp->comm->cutghost[k]; // a fraction where the box is tilted
  return std::min(lmp->domain->triclinic ? cut : cut / thickness(lmp, k), 0.5 / parts);
}

class PlanesPlanner {
 public:
  PlanesPlanner(LAMMPS* lmp, const BalanceSettings& settings, double weight)
      : lmp_(lmp), settings_(settings), weight_(weight), fractions_(fractions(lmp)),
        planes_(present_planes(lmp)) {}

  BalancePlan plan() {
    std::vector<int> directions;
    for (int k = 0; k < 3; ++k)
      if (settings_.shifts[static_cast<std::size_t>(k)] && lmp_->comm->procgrid[k] > 1)
        directions.push_back(k);
    const int repeats = directions.size() > 1 ? rounds : 1;
    for (int round = 0; round < repeats; ++round)
      for (const int k : directions)
        plan_direction(k);
    return {planes_, imbalance_};
  }

 private:
  LAMMPS* lmp_;
  const BalanceSettings& settings_;
  double weight_;
  std::vector<std::array<double, 3>> fractions_;
  Planes planes_;
  double imbalance_ = HUGE_VAL; // of these planes; infinite where none were planned

  const std::vector<double>& planes(int k) const { return planes_[static_cast<std::size_t>(k)]; }

  void plan_direction(int k) {
    const int parts = lmp_->comm->procgrid[k];
    const int u = (k + 1) % 3, v = (k + 2) % 3, columns = lmp_->comm->nprocs / parts;
    ellipsoid::SlabWeights weights(columns, number_of_slabs(columns, parts));
    for (const auto& fraction : fractions_) {
      const auto part = [&](int d) {
        return part_of(fraction[static_cast<std::size_t>(d)], planes(d));
      };
      weights.add(part(u) * lmp_->comm->procgrid[v] + part(v),
                  fraction[static_cast<std::size_t>(k)], weight_);
    }
    std::vector<double>& sums = weights.values();
    MPI_Allreduce(MPI_IN_PLACE, sums.data(), static_cast<int>(sums.size()), MPI_DOUBLE, MPI_SUM,
                  lmp_->world);
    if (std::all_of(sums.begin(), sums.end(), [](double sum) { return sum == 0.0; }))
      return;
    const double least = least_fraction(lmp_, settings_, k, parts) * weights.slabs();
    const int thinnest = std::clamp(static_cast<int>(std::ceil(least)), 1, weights.slabs() / parts);
    std::vector<double>& result = planes_[static_cast<std::size_t>(k)];
    const std::vector<int> slabs_below = ellipsoid::plan_planes(weights, parts, thinnest);
    for (std::size_t plane = 0; plane < result.size(); ++plane)
      result[plane] = static_cast<double>(slabs_below[plane]) / weights.slabs();
    const double total = std::accumulate(sums.begin(), sums.end(), 0.0);
    imbalance_ = ellipsoid::heaviest_part(weights, slabs_below) * lmp_->comm->nprocs / total;
  }
};

/// Hands triangles to the ranks whose sub-domains they are in.
void exchange_triangles(LAMMPS* lmp) {
  for (int i = 0; i < lmp->modify->nfix; ++i)
    if (auto* fix = dynamic_cast<LAMMPS_NS::FixMesh*>(lmp->modify->fix[i]))
      if (auto* mesh = dynamic_cast<LAMMPS_NS::TriMesh*>(fix->mesh()); mesh && mesh->isParallel())
        mesh->pbcExchangeBorders(0);
}

} // namespace

Planes present_planes(LAMMPS* lmp) {
  Planes planes;
  for (int k = 0; k < 3; ++k)
    planes[static_cast<std::size_t>(k)].assign(splits(lmp, k),
                                               splits(lmp, k) + lmp->comm->procgrid[k] + 1);
  return planes;
}

Planes even_planes(LAMMPS* lmp) {
  Planes planes = present_planes(lmp);
  for (std::vector<double>& direction : planes) {
    const int parts = static_cast<int>(direction.size()) - 1;
    for (int i = 0; i < parts; ++i)
      direction[static_cast<std::size_t>(i)] = i * 1.0 / parts; // as the host computes them
    direction.back() = 1.0;
  }
  return planes;
}

void set_planes(LAMMPS* lmp, const Planes& planes) {
  for (int k = 0; k < 3; ++k)
    std::copy(planes[static_cast<std::size_t>(k)].begin(),
              planes[static_cast<std::size_t>(k)].end(), splits(lmp, k));
  note_layout(lmp->comm, planes == even_planes(lmp));
  if (lmp->domain->triclinic)
    lmp->domain->set_lamda_box();
  lmp->domain->set_local_box();
}

void exchange_particles(LAMMPS* lmp) {
  lmp->domain->pbc();
  lmp->domain->reset_box();
  lmp->comm->setup();
  lmp->comm->exchange();
}

void shift_planes(LAMMPS* lmp, const Planes& planes) {
  const int box_change = lmp->domain->box_change;
  lmp->domain->box_change = 1; // without it meshes that do not move stay where they are
  exchange_triangles(lmp);
  Planes present = present_planes(lmp);
  while (present != planes) {
    for (std::size_t k = 0; k < 3; ++k)
      present[k] = ellipsoid::planes_of_next_stage(present[k], planes[k]);
    set_planes(lmp, present);
    lmp->comm->exchange();
    exchange_triangles(lmp);
  }
  lmp->domain->box_change = box_change;
  lmp->atom->setup(); // cells in which particles are sorted
}

BalancePlan balanced_planes(LAMMPS* lmp, const BalanceSettings& settings, double weight) {
  return PlanesPlanner(lmp, settings, weight).plan();
}

double imbalance(LAMMPS* lmp, double of_this_rank) {
  double largest = 0.0, sum = 0.0;
  MPI_Allreduce(&of_this_rank, &largest, 1, MPI_DOUBLE, MPI_MAX, lmp->world);
  MPI_Allreduce(&of_this_rank, &sum, 1, MPI_DOUBLE, MPI_SUM, lmp->world);
  return sum > 0.0 ? largest * lmp->comm->nprocs / sum : 1.0;
}

} // namespace ellipsoid_host
