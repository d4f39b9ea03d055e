// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// compute continuum/weighted/ellipsoid: coarse-grained stress and strain at each particle.
#ifdef COMPUTE_CLASS
// clang-format off
ComputeStyle(continuum/weighted/ellipsoid,ComputeContinuumWeightedEllipsoid)
// clang-format on
#else
#ifndef LMP_COMPUTE_CONTINUUM_WEIGHTED_ELLIPSOID_H
#define LMP_COMPUTE_CONTINUUM_WEIGHTED_ELLIPSOID_H

#include "averages/fields_at_particles.h"
#include "host_compute.h"

#include <optional>
#include <vector>

namespace LIGGGHTS {
namespace ContactModels {
class EllipsoidContactCaller;
}
} // namespace LIGGGHTS

namespace LAMMPS_NS {

/// Per particle: nine columns of the stress, nine of the strain in a time step, or both; xx xy xz
/// yx yy yz zx zy zz.
class ComputeContinuumWeightedEllipsoid : public ellipsoid_host::HostCompute {
 public:
  ComputeContinuumWeightedEllipsoid(ELLIPSOID_COMPUTE_PARAMETERS);
  void init() override;
  void compute_peratom() override;
  double memory_usage() override;

 private:
  using EllipsoidContactCaller = LIGGGHTS::ContactModels::EllipsoidContactCaller;

  std::optional<ellipsoid::CoarseGrainingFunction> function_;
  bool has_stress_ = false, has_strain_ = false;
  EllipsoidContactCaller* pair_ = nullptr;
  std::vector<EllipsoidContactCaller*> walls_;
  std::vector<double> values_;
  std::vector<double*> rows_;

  std::vector<ellipsoid::MovingMass> own_masses() const;
  std::vector<ellipsoid::ForceLine> own_lines() const;
  void spread_masses(ellipsoid::FieldsAtParticles& fields,
                     const std::vector<ellipsoid::MovingMass>& own) const;
  void spread_lines(ellipsoid::FieldsAtParticles& fields,
                    const std::vector<ellipsoid::ForceLine>& own) const;
  void store(const ellipsoid::FieldsAtParticles& fields);
};

} // namespace LAMMPS_NS

#endif
#endif
