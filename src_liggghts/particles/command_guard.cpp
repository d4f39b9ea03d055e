// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "command_guard.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "ellipsoid_host.h"
#include "error.h"
#include "fix.h"
#include "force.h"
#include "group.h"
#include "host_styles.h"
#include "host_variants.h"
#include "lammps.h"
#include "material_check.h"
#include "mesh_motion_check.h"
#include "modify.h"
#include "region.h"
#include "spin.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <sstream>

using namespace LAMMPS_NS;
using ellipsoid::Quaternion;

namespace ellipsoid_host {

namespace {

using Words = std::vector<std::string>;

[[noreturn]] void refuse(LAMMPS* lmp, const std::string& what, const std::string& why) {
  lmp->error->all(FLERR,
                  (what + " does not work with atom_style granular/ellipsoid: it " + why).c_str());
  std::abort(); // not reached: the call above ends the program
}

/// @param[in] line to write instead, or an empty string
void refuse_style(LAMMPS* lmp, const std::string& kind, const std::string& style,
                  const std::string& id = "", const std::string& line = "") {
  const std::string why = why_unsuited(kind, style);
  if (!why.empty())
    refuse(lmp, kind + " " + style + (id.empty() ? "" : " (id " + id + ")"),
           why + (line.empty() ? "" : "; write '" + line + "'"));
}

/// `words` of a `pair_style gran` or `fix wall/gran`, as they are written for ellipsoids.
/// @param[in] at index of the style among them
std::string converted(const std::string& command, const Words& words, std::size_t at) {
  static const Words models{"model", "tangential", "cohesion", "rolling_friction", "surface"};
  Words line(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(at));
  line.push_back(words[at] + "/ellipsoid");
  std::size_t k = at + 1;
  for (; k + 1 < words.size() && std::count(models.begin(), models.end(), words[k]); k += 2)
    if (words[k] != "surface")
      line.insert(line.end(), {words[k], words[k + 1]});
  line.insert(line.end(), {"surface", "smooth"});
  line.insert(line.end(), words.begin() + static_cast<std::ptrdiff_t>(k), words.end());
  return std::accumulate(
      line.begin(), line.end(), command,
      [](const std::string& text, const std::string& word) { return text + " " + word; });
}

/// A word that a command must not have with ellipsoids, and why.
struct UnsuitedWord {
  const char *command, *word, *reason_and_remedy;
};

constexpr UnsuitedWord unsuited_words[] = {
    {"set", "diameter",
     "changes the bounding sphere and not the semi-axes; use 'set ... shape a b c'"},
    {"set", "volume", "changes neither semi-axes nor mass; use 'set ... shape a b c'"},
    {"set", "aspect_ratio", "leaves the mass as it was; use 'set ... shape a b c'"},
    {"set", "blockiness", "makes other bodies than ellipsoids; use 'set ... shape a b c'"},
    {"set", "roundness", "makes other bodies than ellipsoids; use 'set ... shape a b c'"},
    {"fix", "projection",
     "takes the projection of bounding spheres for the area of contacts; use 'contact_area "
     "overlap' or 'constant A'"},
    {"fix", "transfer_virtualMass",
     "exchanges what a solver computes for spheres; use 'fix couple/cfd/force' without it"},
    {"fix", "transfer_stochastic",
     "exchanges what a solver computes for spheres; use 'fix couple/cfd/force' without it"},
    {"fix", "transfer_fiber_topology", "joins spheres; use 'fix couple/cfd/force' without it"},
    {"thermo_style", "erotate",
     "does not know ellipsoids; use 'c_ID' of 'compute ID all erotate/ellipsoid'"},
    {"atom_modify", "no", "hides the ids by which contacts are known; use 'atom_modify map array'"},
};

/// Fixes of the host whose ID a second command may use again: it replaces the first. Others look at
/// the list of fixes when they are made, in which the one to be replaced is missing then.
constexpr const char* replaceable_fixes[] = {"addforce", "aveforce",  "deform",   "freeze",
                                             "gravity",  "lineforce", "momentum", "planeforce",
                                             "print",    "setforce",  "viscous"};

/// A flow solver that takes particles for spheres of the bounding radius has too little room for
/// the fluid.
void warn_of_radius(LAMMPS* lmp, const Words& words) {
  if (words[2] == "couple/cfd/force" && lmp->comm->me == 0 &&
      std::find(words.begin(), words.end(), "transfer_superquadric") == words.end())
    lmp->error->warning(FLERR, ("Fix couple/cfd/force (id " + words[0] +
                                "): the solver is told the bounding radius of each ellipsoid, and "
                                "must not make volumes of it; add 'transfer_superquadric yes' for "
                                "the volumes, if it can take them")
                                   .c_str());
}

/// What LIGGGHTS-INL's fix couple/cfd/force would leave to its fix nve/cfd_cn.
void check_drag(LAMMPS* lmp, const Words& words) {
  if (!integrators_have_drag || words[2] != "couple/cfd/force")
    return;
  const std::string title = "fix couple/cfd/force (id " + words[0] + ")";
  const auto options = words.begin() + 3;
  for (const char* word : {"implicit", "CAddRhoFluid", "transfer_ellipsoid"})
    if (std::find(options, words.end(), word) != words.end())
      refuse(lmp, title + " with '" + word + "'",
             "leaves that to an integrator of spheres; use 'force explicit' and 'torque explicit'");
  const auto force = std::find(options, words.end(), "force");
  if (words.end() - force < 2 || *(force + 1) != "explicit")
    refuse(lmp, title + " without 'force explicit'",
           "leaves the drag to an integrator of spheres; add 'force explicit'");
}

/// A fix insert/... takes bounds and volume of its region once, when the fix is made.
void check_region_of_insertion(LAMMPS* lmp, const Words& words) {
  const auto keyword = std::find(words.begin(), words.end(), "region");
  if (words[2].rfind("insert/", 0) != 0 || words.end() - keyword < 2)
    return;
  const int region = lmp->domain->find_region(const_cast<char*>((keyword + 1)->c_str()));
  if (region >= 0 && has_variable_shape(*lmp->domain->regions[region]))
    refuse(lmp, "fix " + words[2] + " (id " + words[0] + ") in region '" + *(keyword + 1) + "'",
           "fills a region of one shape, and this one's radius is a variable; use one region for "
           "each run");
}

/// What can be asked of a fix ave/euler are the cells of the first rank; points of its base volume
/// are drawn in an upright box.
void check_cells(LAMMPS* lmp, const Words& words) {
  if (words[2] != "ave/euler")
    return;
  const auto has = [&words](const std::string& word, const std::string& value) {
    const auto at = std::find(words.begin(), words.end(), word);
    return words.end() - at > 1 && (value.empty() || *(at + 1) == value);
  };
  const std::string title = "fix ave/euler (id " + words[0] + ")";
  if (lmp->comm->nprocs > 1 && has("parallel", "yes"))
    refuse(
        lmp, title + " with 'parallel yes' on several ranks",
        "tells the cells of the first rank only; use 'parallel no', or one rank in a tilted box");
  if (lmp->domain->triclinic && has("basevolume_region", ""))
    refuse(lmp, title + " with 'basevolume_region' in a tilted box",
           "takes its points from an upright one; leave 'basevolume_region' out");
}

/// The style of a mesh lists its modules with a '/' between two: each is looked at.
void check_mesh_modules(LAMMPS* lmp, const Words& words) {
  const std::string mesh = "mesh/surface/";
  if (words[2].rfind(mesh, 0) != 0)
    return;
  std::istringstream modules(words[2].substr(mesh.size()));
  for (std::string module; std::getline(modules, module, '/');)
    refuse_style(lmp, "fix", mesh + module, words[0]);
}

void check_fix(LAMMPS* lmp, const Words& words) {
  if (words.size() < 3)
    return;
  check_drag(lmp, words);
  warn_of_radius(lmp, words);
  check_region_of_insertion(lmp, words);
  check_cells(lmp, words);
  if (words[2] == "move/mesh")
    if (const std::string complaint = wrong_mesh_motion(words); !complaint.empty())
      lmp->error->all(FLERR, ("fix move/mesh (id " + words[0] + "): " + complaint).c_str());
  refuse_style(lmp, "fix", words[2], words[0],
               words[2] == "wall/gran" ? converted("fix", words, 2) : "");
  check_mesh_modules(lmp, words);
  if (lmp->modify->find_fix(words[0].c_str()) < 0)
    return;
  for (const char* style : replaceable_fixes)
    if (words[2] == style)
      return;
  std::string message = "fix " + words[2] + " (id " + words[0] +
                        "): a fix of this ID exists; give another ID, or 'unfix " + words[0] +
                        "' before";
  if (words[2].rfind("mesh/surface", 0) == 0)
    message += "; where a wall uses it, unfix fix wall/gran first";
  lmp->error->all(FLERR, message.c_str());
}

/// `fix move` counts time in steps: with another number or length of steps its particles jump.
void check_time(LAMMPS* lmp, const std::string& command) {
  const Modify& modify = *lmp->modify;
  for (int k = 0; k < modify.nfix; ++k)
    if (std::string(modify.fix[k]->style) == "move")
      lmp->error->all(FLERR, ("command " + command + ": fix move (id " + modify.fix[k]->id +
                              ") counts its time in steps, its particles would jump; 'unfix' it "
                              "before, and give it again after")
                                 .c_str());
}

void check_command(LAMMPS* lmp, const std::string& command, const Words& words) {
  refuse_style(lmp, "command", command);
  if (command == "fix")
    check_fix(lmp, words);
  else if ((command == "compute" || command == "dump") && words.size() > 2)
    refuse_style(lmp, command, words[2], words[0]);
  else if (command == "region" && words.size() > 1)
    refuse_style(lmp, command, words[1], words[0]);
  else if (command == "pair_style" && !words.empty())
    refuse_style(lmp, command, words[0], "",
                 words[0] == "gran" ? converted(command, words, 0) : "");
  else if (command == "run_style" && !words.empty())
    refuse_style(lmp, command, words[0]);
  else if (command == "reset_timestep" || command == "timestep")
    check_time(lmp, command);
  for (const UnsuitedWord& unsuited : unsuited_words)
    if (command == unsuited.command &&
        std::find(words.begin(), words.end(), unsuited.word) != words.end())
      refuse(lmp, command + " ... " + unsuited.word, unsuited.reason_and_remedy);
}

/// Commands that act on what only the set-up of a run looks at: a run without one would go on with
/// old lists, shapes and fixes.
constexpr const char* needs_set_up[] = {
    "set",        "displace_atoms", "delete_atoms", "create_atoms",     "change_box",
    "fix",        "unfix",          "fix_modify",   "compute",          "uncompute",
    "pair_style", "pair_coeff",     "neigh_modify", "neighbor",         "compute_modify",
    "region",     "communicate",    "run_style",    "balance/ellipsoid"};

/// The last of these commands since the last set-up, or an empty string; of the one simulation at
/// hand.
std::string& waits_for_set_up() {
  static std::string command;
  return command;
}

/// Whether a `run ... every` without set-up is at work, between whose parts commands are executed.
bool& runs_without_set_up() {
  static bool runs = false;
  return runs;
}

[[noreturn]] void refuse_without_set_up(LAMMPS* lmp, const std::string& command) {
  lmp->error->all(FLERR, ("run ... pre no: '" + command +
                          "' acts where a run is set up, and this one would not be; leave 'pre no' "
                          "out")
                             .c_str());
  std::abort(); // not reached
}

/// @param[in] has_pre_no the command is a run with 'pre no'
void check_set_up(LAMMPS* lmp, const std::string& command, bool has_pre_no) {
  if (command == "run") {
    if (has_pre_no && !lmp->update->first_update) // the host sets up the first run all the same
      waits_for_set_up().clear();
    if (has_pre_no && !waits_for_set_up().empty())
      refuse_without_set_up(lmp, waits_for_set_up());
    return;
  }
  if (std::find(std::begin(needs_set_up), std::end(needs_set_up), command) ==
      std::end(needs_set_up))
    return;
  if (runs_without_set_up())
    refuse_without_set_up(lmp, command);
  waits_for_set_up() = command;
}

/// What was given before the atom style, or comes from a restart file.
void check_present_styles(LAMMPS* lmp) {
  if (lmp->force->pair_style)
    refuse_style(lmp, "pair_style", lmp->force->pair_style);
  if (!has_brick_domains(lmp->comm))
    refuse_style(lmp, "command", "comm_style");
}

/// The host's superquadrics have other shapes, and nobody checks them. Contact laws are those of
/// units in which a force is mass times acceleration.
void check_atoms_and_units(LAMMPS* lmp) {
  const char* const pair = lmp->force->pair_style;
  if (!pair || std::string(pair) != "gran/ellipsoid")
    return;
  if (!are_ellipsoids(lmp))
    lmp->error->all(FLERR, "pair_style gran/ellipsoid needs particles with shape: use atom_style "
                           "granular/ellipsoid");
  if (lmp->force->ftm2v != 1.0)
    lmp->error->all(FLERR, ("pair_style gran/ellipsoid does not work with units " +
                            std::string(lmp->update->unit_style) +
                            ", in which a force is no mass times acceleration; use 'units si', "
                            "'cgs', 'lj', 'micro' or 'nano'")
                               .c_str());
}

} // namespace

CommandGuard::CommandGuard(LAMMPS* lmp, const char* command, int count, char** arguments)
    : lmp_(lmp), command_(command), arguments_(arguments, arguments + count) {
  if (command_ == "atom_style" && count > 1 && arguments_[0] == "hybrid" &&
      has_argument("granular/ellipsoid"))
    lmp->error->all(FLERR, "atom_style hybrid does not work with granular/ellipsoid, whose columns "
                           "it does not know; use 'atom_style granular/ellipsoid'");
  if (command_ == "run")
    check_atoms_and_units(lmp);
  if (!are_ellipsoids(lmp))
    return;
  check_command(lmp, command_, arguments_);
  check_set_up(lmp, command_, goes_on_without_set_up());
  if (command_ == "run") {
    waits_for_set_up().clear();
    runs_without_set_up() = goes_on_without_set_up() && has_argument("every");
  }
  if (command_ == "run" || command_ == "write_data" || command_ == "write_restart")
    check_present_styles(lmp);
  if (command_ == "run" || command_ == "run_time")
    check_materials(lmp);
  if (command_ == "delete_atoms")
    begin_deletion();
  if (command_ == "set")
    masses_.assign(lmp->atom->rmass, lmp->atom->rmass + lmp->atom->nlocal);
}

CommandGuard::~CommandGuard() {
  if (command_ == "run")
    runs_without_set_up() = false;
  if (!are_ellipsoids(lmp_))
    return;
  if (renumbering_)
    renumbering_->finish();
  else if (command_ == "set")
    complete_set();
  else if (command_ == "displace_atoms" && arguments_.size() > 8 && arguments_[1] == "rotate")
    turn_bodies();
  else if (command_ == "velocity") {
    const bool sets_momentum = arguments_[1] == "setAngular";
    for (int i = 0; i < lmp_->atom->nlocal; ++i)
      sets_momentum ? follow_angular_momentum(*lmp_->atom, i) : follow_omega(*lmp_->atom, i);
  }
}

/// Of `run ... pre no`.
bool CommandGuard::goes_on_without_set_up() const {
  const auto pre = std::find(arguments_.begin(), arguments_.end(), "pre");
  return command_ == "run" && arguments_.end() - pre > 1 && *(pre + 1) == "no";
}

bool CommandGuard::has_argument(const std::string& word) const {
  return std::find(arguments_.begin(), arguments_.end(), word) != arguments_.end();
}

void CommandGuard::begin_deletion() {
  const auto compress = std::find(arguments_.begin(), arguments_.end(), "compress");
  const bool keeps_numbers = arguments_.end() - compress > 1 && *(compress + 1) == "no";
  renumbering_ = std::make_unique<Renumbering>(lmp_, !keeps_numbers);
  if (has_argument("overlap") && renumbering_->is_needed())
    refuse(lmp_, "delete_atoms overlap",
           "numbers particles that have contacts anew while they change their ranks; add 'compress "
           "no'");
}

/// Omega is kept, whatever becomes of moments and orientation. (set changes no number of
/// particles.)
void CommandGuard::complete_set() {
  Atom& atom = *lmp_->atom;
  const bool scales = has_argument("mass") && !has_argument("inertiax") &&
                      !has_argument("inertiay") && !has_argument("inertiaz");
  for (int i = 0; i < atom.nlocal; ++i) {
    if (scales && atom.rmass[i] != masses_[static_cast<std::size_t>(i)]) {
      const double factor = atom.rmass[i] / masses_[static_cast<std::size_t>(i)];
      store(factor * vector(atom.inertia[i]), atom.inertia[i]);
      atom.density[i] = atom.rmass[i] / atom.volume[i];
    }
    follow_omega(atom, i);
  }
}

/// Of `displace_atoms GROUP rotate Px Py Pz Rx Ry Rz degrees`: the host has moved the centres.
void CommandGuard::turn_bodies() const {
  Atom& atom = *lmp_->atom;
  double numbers[7];
  for (std::size_t k = 0; k < 7; ++k)
    numbers[k] = std::strtod(arguments_[2 + k].c_str(), nullptr); // the host has checked them
  const Quaternion turn =
      turn_about({numbers[3], numbers[4], numbers[5]}, numbers[6] * M_PI / 180.0);
  const int group = lmp_->group->bitmask[lmp_->group->find(arguments_[0].c_str())];
  for (int i = 0; i < atom.nlocal; ++i)
    if (atom.mask[i] & group) {
      store(normalized(turn * quaternion(atom.quaternion[i])), atom.quaternion[i]);
      follow_omega(atom, i);
    }
}

} // namespace ellipsoid_host
