// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// balance/ellipsoid: shifts the planes between sub-domains once (doc/fix_balance_ellipsoid.md).
#ifdef COMMAND_CLASS
// clang-format off
CommandStyle(balance/ellipsoid,BalanceEllipsoid)
// clang-format on
#else
#ifndef LMP_BALANCE_ELLIPSOID_H
#define LMP_BALANCE_ELLIPSOID_H

#include "pointers.h"

namespace LAMMPS_NS {

class BalanceEllipsoid : protected Pointers {
 public:
  explicit BalanceEllipsoid(class LAMMPS* lmp) : Pointers(lmp) {}
  void command(int narg, char** arg);
};

} // namespace LAMMPS_NS

#endif
#endif
