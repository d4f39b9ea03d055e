// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// compute coordination/ellipsoid: numbers of contacts of each particle.
#ifdef COMPUTE_CLASS
// clang-format off
ComputeStyle(coordination/ellipsoid,ComputeCoordinationEllipsoid)
// clang-format on
#else
#ifndef LMP_COMPUTE_COORDINATION_ELLIPSOID_H
#define LMP_COMPUTE_COORDINATION_ELLIPSOID_H

#include "host_compute.h"

#include <utility>
#include <vector>

namespace LIGGGHTS {
namespace ContactModels {
class EllipsoidContactCaller;
}
} // namespace LIGGGHTS

namespace LAMMPS_NS {

/// Per particle: [1] particles that it touches, [2] contacts with these (more than [1] for
/// multi-spheres), [3] contacts with walls.
class ComputeCoordinationEllipsoid : public ellipsoid_host::HostCompute {
 public:
  ComputeCoordinationEllipsoid(ELLIPSOID_COMPUTE_PARAMETERS);
  void init() override;
  void compute_peratom() override;
  double memory_usage() override;

 private:
  using EllipsoidContactCaller = LIGGGHTS::ContactModels::EllipsoidContactCaller;

  enum Column { touching_particles, pair_contacts, wall_contacts, column_count };

  EllipsoidContactCaller* pair_ = nullptr;
  std::vector<EllipsoidContactCaller*> walls_;
  std::vector<std::pair<int, int>> touching_; // (particle, partner), local indices
  std::vector<double> counts_;
  std::vector<double*> rows_;

  void count_pairs();
  void count(int particle, Column column);
};

} // namespace LAMMPS_NS

#endif
#endif
