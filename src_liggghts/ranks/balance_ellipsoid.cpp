// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "balance_ellipsoid.h"

#include "atom.h"
#include "balance_settings.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "lammps.h"
#include "modify.h"

#include <cstdio>
#include <string>

using namespace LAMMPS_NS;
using namespace ellipsoid_host;

/// As command write_restart: particles may have left their sub-domains since lists were built, and
/// the map from numbers to particles is whole again afterwards.
void BalanceEllipsoid::command(int narg, char** arg) {
  if (domain->box_exist == 0)
    error->all(FLERR, "balance/ellipsoid: there is no simulation box yet; give it after "
                      "create_box, read_data or read_restart");
  BalanceSettings settings;
  ArgumentReader reader(error, CommandName{"Command", "balance/ellipsoid", "-"}, narg, arg, 0);
  while (!reader.done()) {
    const std::string keyword = reader.keyword();
    if (!read_balance_setting(reader, keyword, settings))
      reader.complain("unknown keyword '" + keyword + "', allowed are " + balance_keywords);
  }
  check_shifts_are_possible(lmp, "balance/ellipsoid");
  lmp->init();
  modify->setup_pre_exchange();
  if (domain->triclinic)
    domain->x2lamda(atom->nlocal);
  exchange_particles(lmp);
  const double before = imbalance(lmp, atom->nlocal);
  const BalancePlan plan = balanced_planes(lmp, settings, 1.0);
  if (plan.imbalance < before)
    shift_planes(lmp, plan.planes);
  comm->setup();
  comm->borders();
  if (domain->triclinic)
    domain->lamda2x(atom->nlocal + atom->nghost);
  const double after = imbalance(lmp, atom->nlocal);
  if (comm->me == 0)
    for (std::FILE* to : {screen, logfile})
      if (to)
        std::fprintf(to, "balance/ellipsoid: imbalance %.4g before, %.4g after\n", before, after);
}
