// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "surface_contacts.h"

#include "atom.h"
#include "pair_gran_ellipsoid.h"

namespace ellipsoid_host {

void SurfaceContacts::begin_pairs() {
  pairs_.begin_step(pair_.list, pair_.listgranhistory, pair_.dnum());
}

bool SurfaceContacts::recall_histories() {
  begin_pairs();
  return pairs_.recall_rows(*pair_.contact_history(), atom->tag);
}

} // namespace ellipsoid_host
