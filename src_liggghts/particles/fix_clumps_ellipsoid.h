// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// fix clumps/ellipsoid: the clumps of a simulation by number. Made by fix
// particletemplate/ellipsoid with keyword 'clump'; users never write it.
#ifdef FIX_CLASS
// clang-format off
FixStyle(clumps/ellipsoid,FixClumpsEllipsoid)
// clang-format on
#else
#ifndef LMP_FIX_CLUMPS_ELLIPSOID_H
#define LMP_FIX_CLUMPS_ELLIPSOID_H

#include "fix.h"
#include "host_variants.h"
#include "multisphere/clump_template.h"
#include "multisphere/multisphere_body.h"

#include <memory>
#include <string>
#include <vector>

namespace LAMMPS_NS {

/// A particle is clump n, from 1, where its property/atom `spacing` is clump_spacing + n. The table
/// goes into restart files, spheres and all; a template of a known name must have the same ones.
class FixClumpsEllipsoid : public Fix {
 public:
  FixClumpsEllipsoid(class LAMMPS* lmp, int narg, char** arg);
  int setmask() override;
  void init() override;
  void setup_pre_exchange() override { settle(); }
  void pre_exchange() override { settle(); }
  void write_restart(FILE* file) override;
  void restart(ELLIPSOID_RESTART_PARAMETERS) override;

  /// The table; null where there is none.
  static FixClumpsEllipsoid* find(class Modify* modify);
  /// The same, made where missing: the restart file's then, if it has one.
  static FixClumpsEllipsoid* find_or_make(class Modify* modify);
  /// To be called when a run begins: makes the table if particles are clumps.
  static void make_sure(class LAMMPS* lmp);

  /// Stops with one line if a clump of this name has other spheres or moments.
  /// @param[in] moments_per_mass of the clump in the size of its file (length^2)
  /// @return its number, from 1; the one it has if it is there already
  int add(const std::string& name, const ellipsoid::ClumpTemplate& clump,
          const ellipsoid::Vector3& moments_per_mass);
  /// The spheres of a particle.
  /// @throws std::invalid_argument no such clump, or one of other spheres or another shape
  const ellipsoid::MultisphereBody* body(int spacing, int count, const double* semiaxes) const;
  /// @throws std::invalid_argument no such clump
  const ellipsoid::ClumpTemplate& clump(int spacing) const;

 private:
  struct Entry {
    std::string name;
    ellipsoid::ClumpTemplate clump;
    ellipsoid::Vector3 moments_per_mass;
    std::unique_ptr<ellipsoid::MultisphereBody> body;
  };
  std::vector<Entry> entries_;

  const Entry& entry(int spacing) const;
  void settle();
  void settle(int i, int count, int spacing);
};

} // namespace LAMMPS_NS

#endif
#endif
