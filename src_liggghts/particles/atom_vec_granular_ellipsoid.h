// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// atom_style granular/ellipsoid: one ellipsoid, smooth or multi-sphere, is one atom.
#ifdef ATOM_CLASS
// clang-format off
AtomStyle(granular/ellipsoid,AtomVecGranularEllipsoid)
// clang-format on
#else
#ifndef LMP_ATOM_VEC_GRANULAR_ELLIPSOID_H
#define LMP_ATOM_VEC_GRANULAR_ELLIPSOID_H

#include "atom_vec_superquadric.h"

#include <array>
#include <map>

namespace LAMMPS_NS {

/// An ellipsoid is a superquadric of blockiness 2: all arrays, their exchange between ranks and
/// their restart are the host's (`shape` holds the semi-axes, `quaternion`, `inertia`, `angmom`,
/// `volume`, `radius` of the bounding sphere). Data files have columns of their own.
class AtomVecGranularEllipsoid : public AtomVecSuperquadric {
 public:
  explicit AtomVecGranularEllipsoid(class LAMMPS* lmp);
  void init() override;

  /// Atoms section: id type x y z a b c q0 q1 q2 q3 mass I1 I2 I3 [N spacing] [image flags].
  void data_atom(double* position, tagint image, char** values) override;
  /// Velocities section: id vx vy vz omegax omegay omegaz.
  void data_vel(int atom, char** values) override;
  void pack_data(double** buffer) override;
  void pack_data(double** buffer, int tag_offset) override;
  void write_data(FILE* file, int count, double** buffer) override;

  /// How many columns the Atoms section has, from the words of its first line. For read_data.
  void expect_data_words(int words);
  /// Stores what the read rows say of sub-spheres. For read_data, on all ranks, after the last row.
  void finish_data();

 private:
  std::map<int, std::array<int, 2>> subspheres_; // of the rows read: atom -> N, spacing

  void read_subspheres(int atom, char** values);
  void check_chain(const std::array<int, 2>& chain, const double* axes, const char* id) const;
};

} // namespace LAMMPS_NS

#endif
#endif
