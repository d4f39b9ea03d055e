// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "fix_pair_settings_ellipsoid.h"

#include "comm.h"
#include "error.h"
#include "fix_particletemplate_ellipsoid.h"
#include "force.h"
#include "has_law.h"
#include "modify.h"
#include "pair_gran_ellipsoid.h"

#include <algorithm>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

using namespace LAMMPS_NS;
using ellipsoid_host::HasLaw;

namespace {

/// Models come first, in one order; the settings after them may have any.
std::vector<std::string> in_one_order(const std::string& arguments) {
  std::vector<std::string> pairs;
  std::istringstream stream(arguments);
  for (std::string keyword, value; stream >> keyword;) {
    stream >> value;
    pairs.push_back(keyword + " " + value);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// What the fixes of a restart file wrote, which the host keeps for itself until they are there.
struct RestartData : Modify {
  /// The text of fix pair_settings/ellipsoid; empty where the file has none.
  static std::string pair_settings(Modify& modify) {
    for (int k = 0; k < modify.nfix_restart_global; ++k)
      if (std::strcmp((modify.*(&RestartData::style_restart_global))[k],
                      "pair_settings/ellipsoid") == 0)
        return (modify.*(&RestartData::state_restart_global))[k];
    return {};
  }
};

bool begins_with(const std::string& text, const std::string& begin) {
  return text.compare(0, begin.size(), begin) == 0;
}

/// Meshes may come behind those that were there, or go from behind the others: contacts know their
/// mesh by its number.
bool is_same_kind(const std::string& former, const std::string& present) {
  return former == present ||
         (begins_with(former, "meshes ") && begins_with(present, "meshes ") &&
          (begins_with(present, former + " ") || begins_with(former, present + " ")));
}

} // namespace

void ellipsoid_host::compare_with_restart(LAMMPS* lmp, const std::string& id, const HasLaw& wall) {
  const auto refuse = [&](const std::string& former, const std::string& present,
                          const std::string& remedy) {
    lmp->error->all(
        FLERR, ("The restart file has contacts with the wall of fix wall/gran/ellipsoid '" + id +
                "' " + former + ", the script has " + present + "; repeat the former" + remedy +
                ", or give the wall another ID: its contacts then begin without history")
                   .c_str());
  };
  std::istringstream lines(RestartData::pair_settings(*lmp->modify));
  for (std::string line; std::getline(lines, line);) {
    if (begins_with(line, "wall " + id + " ")) {
      const std::string former = line.substr(6 + id.size());
      if (in_one_order(former) != in_one_order(wall.law()))
        refuse("by '" + former + "'", "'" + wall.law() + "'", "");
    }
    if (begins_with(line, "kind " + id + " ")) {
      const std::string former = line.substr(6 + id.size());
      if (!is_same_kind(former, wall.kind()))
        refuse("of kind '" + former + "'", "'" + wall.kind() + "'",
               begins_with(former, "meshes ") ? ", where meshes may come or go at the end" : "");
    }
  }
}

FixPairSettingsEllipsoid::FixPairSettingsEllipsoid(LAMMPS* lmp, int narg, char** arg)
    : Fix(lmp, narg, arg) {
  restart_global = 1;
}

std::string FixPairSettingsEllipsoid::present_arguments() const {
  const auto* pair = dynamic_cast<PairGranEllipsoid*>(force->pair_match("gran/ellipsoid", 1));
  return pair ? pair->arguments() : std::string();
}

/// One line with the arguments, two more for each wall, one for each template.
void FixPairSettingsEllipsoid::write_restart(FILE* file) {
  if (comm->me != 0)
    return;
  std::string state = present_arguments() + "\n";
  for (int k = 0; k < modify->nfix; ++k) {
    const std::string id = modify->fix[k]->id;
    if (const auto* wall = dynamic_cast<HasLaw*>(modify->fix[k]))
      state += "wall " + id + " " + wall->law() + "\nkind " + id + " " + wall->kind() + "\n";
    if (const auto* grain = dynamic_cast<FixParticletemplateEllipsoid*>(modify->fix[k]))
      state += "template " + id + " " + grain->sphere_chain() + "\n";
  }
  const int size = static_cast<int>(state.size()) + 1;
  fwrite(&size, sizeof(int), 1, file);
  fwrite(state.c_str(), 1, static_cast<std::size_t>(size), file);
}

void FixPairSettingsEllipsoid::restart(ELLIPSOID_RESTART_PARAMETERS) {
  std::istringstream lines(buffer);
  std::string line;
  std::getline(lines, line);
  compare_arguments(line);
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    std::string what, id, former;
    words >> what >> id;
    std::getline(words >> std::ws, former);
    if (what == "wall")
      look_for_wall(id);
    else if (what == "template")
      compare_template(id, former);
  }
}

void FixPairSettingsEllipsoid::compare_arguments(const std::string& former) const {
  const std::string present = present_arguments();
  if (former.empty() || in_one_order(former) == in_one_order(present))
    return;
  error->all(FLERR, ("The contact history of the restart file belongs to 'pair_style "
                     "gran/ellipsoid " +
                     former + "', the script has 'pair_style gran/ellipsoid " + present +
                     "'; repeat the former or leave the command out, or begin without contact "
                     "history by write_data and read_data")
                        .c_str());
}

void FixPairSettingsEllipsoid::look_for_wall(const std::string& id) const {
  const int index = modify->find_fix(id.c_str());
  if (comm->me != 0 || (index >= 0 && dynamic_cast<HasLaw*>(modify->fix[index])))
    return;
  error->warning(FLERR,
                 ("The restart file has contacts with the wall of fix wall/gran/ellipsoid '" + id +
                  "', which is not there; repeat the command with this ID if the wall still "
                  "stands, or its friction starts anew")
                     .c_str());
}

void FixPairSettingsEllipsoid::compare_template(const std::string& id,
                                                const std::string& former) const {
  const int index = modify->find_fix(id.c_str());
  const auto* grain =
      index < 0 ? nullptr : dynamic_cast<FixParticletemplateEllipsoid*>(modify->fix[index]);
  if (!grain || grain->sphere_chain() == former || comm->me != 0)
    return;
  error->warning(FLERR, ("Fix particletemplate/ellipsoid '" + id + "' has " +
                         grain->sphere_chain() + ", in the restart file it had " + former +
                         ": the particles of the file keep theirs")
                            .c_str());
}
