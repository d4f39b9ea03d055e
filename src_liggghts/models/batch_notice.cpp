// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "batch_notice.h"

#include "comm.h"
#include "error.h"
#include "host_variants.h"

#include <cstdio>

namespace LIGGGHTS {
namespace ContactModels {

namespace {

/// LIGGGHTS-PFM's contact models have the interface of an older LIGGGHTS.
void refuse_without_models(const LAMMPS_NS::LAMMPS& lmp, const std::string& who,
                           const std::string& obstacle) {
#ifdef ELLIPSOID_HOST_PFM
  if (!obstacle.empty())
    lmp.error->all(FLERR, (who + ": " + obstacle +
                           ", and with LIGGGHTS-PFM contacts run in batches only; leave it out")
                              .c_str());
#else
  static_cast<void>(lmp);
  static_cast<void>(who);
  static_cast<void>(obstacle);
#endif
}

} // namespace

void BatchNotice::tell(const LAMMPS_NS::LAMMPS& lmp, const std::string& who,
                       const std::string& obstacle) {
  refuse_without_models(lmp, who, obstacle);
  const std::string text =
      who + ": forces of contacts are computed " +
      (obstacle.empty() ? "in batches" : "one by one, which takes longer: " + obstacle);
  if (text == told_)
    return;
  told_ = text;
  for (FILE* out : {lmp.screen, lmp.logfile})
    if (lmp.comm->me == 0 && out)
      std::fprintf(out, "%s\n", text.c_str());
}

} // namespace ContactModels
} // namespace LIGGGHTS
