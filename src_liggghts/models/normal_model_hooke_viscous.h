// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Normal contact model hooke/viscous: linear spring and dashpot on any surface.
#ifdef NORMAL_MODEL
// clang-format off
NORMAL_MODEL(HOOKE_VISCOUS,hooke/viscous,41)
// clang-format on
#else
#ifndef LMP_NORMAL_MODEL_HOOKE_VISCOUS_H
#define LMP_NORMAL_MODEL_HOOKE_VISCOUS_H

#include "kernel_normal_model.h"

namespace LIGGGHTS {
namespace ContactModels {

template <> class NormalModel<HOOKE_VISCOUS> : public KernelNormalModel<ellipsoid::HookeViscous> {
 public:
  NormalModel(LAMMPS* lmp, IContactHistorySetup* setup, class ContactModelBase* base)
      : KernelNormalModel(lmp, setup, base,
                          {&ellipsoid_host::spring_stiffness_normal,
                           &ellipsoid_host::spring_stiffness_tangential,
                           &ellipsoid_host::viscous_damping_normal}) {}

  /// Force ~ overlap.
  double stressStrainExponent() { return 1.0; }
};

} // namespace ContactModels
} // namespace LIGGGHTS

#endif
#endif
