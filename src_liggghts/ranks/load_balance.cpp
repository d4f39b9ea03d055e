// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "load_balance.h"

#include "domain.h"
#include "fix_balance_ellipsoid.h"
#include "lammps.h"
#include "modify.h"

#include <cstring>

using LAMMPS_NS::FixBalanceEllipsoid;
using LAMMPS_NS::LAMMPS;

void ellipsoid_host::balance_ranks(LAMMPS* lmp) {
  for (int i = 0; i < lmp->modify->nfix; ++i)
    if (auto* fix = dynamic_cast<FixBalanceEllipsoid*>(lmp->modify->fix[i]))
      fix->balance();
}

void ellipsoid_host::restore_planes(LAMMPS* lmp, const char* fix_style, const char* state) {
  if (std::strcmp(fix_style, "balance/ellipsoid") != 0)
    return;
  const Planes planes = FixBalanceEllipsoid::planes_of(state);
  const Planes own = present_planes(lmp);
  bool same_grid = true;
  for (std::size_t k = 0; k < 3; ++k)
    same_grid = same_grid && planes[k].size() == own[k].size();
  if (same_grid)
    set_planes(lmp, planes);
}

ellipsoid_host::EvenPlanes::EvenPlanes(LAMMPS* lmp, const char* fix_style) {
  if (lmp->domain->box_exist == 0 || std::strncmp(fix_style, "insert/", 7) != 0)
    return;
  lmp_ = lmp;
  present_ = present_planes(lmp);
  set_planes(lmp, even_planes(lmp));
}

ellipsoid_host::EvenPlanes::~EvenPlanes() {
  if (lmp_)
    set_planes(lmp_, present_);
}
