// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "balance_settings.h"

#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "host_variants.h"
#include "lammps.h"
#include "modify.h"

#include <cmath>
#include <cstring>

namespace ellipsoid_host {

const char* const balance_keywords = "'directions', 'width'";

bool read_balance_setting(ArgumentReader& reader, const std::string& keyword,
                          BalanceSettings& settings) {
  if (keyword == "width") {
    settings.least_width = reader.positive(keyword);
    return true;
  }
  if (keyword != "directions")
    return false;
  const std::string word = reader.word(keyword);
  settings.shifts = {false, false, false};
  for (const char letter : word) {
    if (letter < 'x' || letter > 'z' || settings.shifts[static_cast<std::size_t>(letter - 'x')])
      reader.complain("keyword 'directions' has the value '" + word +
                      "', allowed are the letters x, y, z, each once at most");
    settings.shifts[static_cast<std::size_t>(letter - 'x')] = true;
  }
  return true;
}

void check_shifts_are_possible(LAMMPS_NS::LAMMPS* lmp, const std::string& command) {
  const auto refuse = [&](const std::string& reason) {
    lmp->error->all(FLERR, (command + ": " + reason).c_str());
  };
  if (lmp->domain->is_wedge)
    refuse("a wedge of a box is cut by equal planes only; remove the command");
  for (int i = 0; i < lmp->modify->nfix; ++i) {
    const char* style = lmp->modify->fix[i]->style;
    if (std::strncmp(style, "multisphere", 11) == 0 || std::strncmp(style, "rigid", 5) == 0)
      refuse(std::string("does not hand the bodies of 'fix ") + style +
             "' from rank to rank; remove one of the two");
  }
  if (ellipsoid_host::follows_exchange(*lmp->comm))
    refuse("a fix follows which particles go from rank to rank; remove one of the two");
}

} // namespace ellipsoid_host
