// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "batch_notice.h"

#include "comm.h"

#include <cstdio>

namespace LIGGGHTS {
namespace ContactModels {

void BatchNotice::tell(const LAMMPS_NS::LAMMPS& lmp, const std::string& who,
                       const std::string& obstacle) {
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
