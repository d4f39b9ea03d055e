// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Normal contact model hertz/viscous: eq. (23) of Markauskas et al. 2010 on any surface.
#ifdef NORMAL_MODEL
// clang-format off
NORMAL_MODEL(HERTZ_VISCOUS,hertz/viscous,40)
// clang-format on
#else
#ifndef LMP_NORMAL_MODEL_HERTZ_VISCOUS_H
#define LMP_NORMAL_MODEL_HERTZ_VISCOUS_H

#include "global_properties.h"
#include "kernel_normal_model.h"

namespace LIGGGHTS {
namespace ContactModels {

template <> class NormalModel<HERTZ_VISCOUS> : public KernelNormalModel<ellipsoid::HertzViscous> {
 public:
  NormalModel(LAMMPS* lmp, IContactHistorySetup* setup, class ContactModelBase* base)
      : KernelNormalModel(lmp, setup, base,
                          {&MODEL_PARAMS::createYeff, &MODEL_PARAMS::createGeff,
                           &ellipsoid_host::viscous_damping_normal}) {}

  /// Force ~ overlap^1.5.
  double stressStrainExponent() { return 1.5; }
};

} // namespace ContactModels
} // namespace LIGGGHTS

#endif
#endif
