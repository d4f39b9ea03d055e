// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// fix particletemplate/ellipsoid: size, mass and orientation of the ellipsoids to insert.
#ifdef FIX_CLASS
// clang-format off
FixStyle(particletemplate/ellipsoid,FixParticletemplateEllipsoid)
// clang-format on
#else
#ifndef LMP_FIX_PARTICLETEMPLATE_ELLIPSOID_H
#define LMP_FIX_PARTICLETEMPLATE_ELLIPSOID_H

#include "host_template.h"
#include "math/vector3.h"
#include "multisphere/multisphere_template.h"
#include "particle_to_insert_ellipsoid.h"
#include "template_body.h"
#include "template_variations.h"

#include <functional>
#include <optional>
#include <string>

namespace ellipsoid_host {
class ArgumentReader;
}

namespace LAMMPS_NS {

class FixParticletemplateEllipsoid : public ellipsoid_host::HostTemplate {
 public:
  FixParticletemplateEllipsoid(class LAMMPS* lmp, int narg, char** arg);
  ~FixParticletemplateEllipsoid() override;

  void post_create() override;
  double min_rad() override { return smallest_bounding_radius_; }
  double max_rad() override { return largest_bounding_radius_; }
  double max_r_bound() override { return largest_bounding_radius_; }
  void randomize_single() override;
  void init_ptilist(int n_random_max, const bool enforce_single = false,
                    FixPropertyAtom* const fix_release = nullptr) override;
  void randomize_ptilist(int n_random, int distribution_groupbit, int distorder) override;
  void direct_set_ptlist(const int i, const void* const data, const int distribution_groupbit,
                         const int distorder) override;
  unsigned int generate_hash() override;

  bool planar() const { return planar_; }
  /// Number of sub-spheres and their spacing, or number of the clump, in words.
  std::string sphere_chain() const;
  /// Shape, mass and moments; neither position nor orientation.
  /// @param[in] uniform source of numbers in [0, 1), one is taken for each `vary`
  void fill(ParticleToInsertEllipsoid& particle, const std::function<double()>& uniform) const;

 private:
  ellipsoid_host::TemplateVariations variations_;
  ellipsoid::Vector3 semiaxes_;          // without the random factors (length)
  ellipsoid::Vector3 principal_moments_; // about the body's x, y, z (mass length^2)
  double mass_ = 0.0;
  double density_ = 0.0; // mass over the volume of the smooth ellipsoid, or of the clump
  double smallest_bounding_radius_ = 0.0, largest_bounding_radius_ = 0.0;
  bool planar_ = false; // random angle in the xy plane
  int subspheres_ = 0;  // N of multi-sphere particles, 0: smooth
  bool stores_subspheres_ = false;
  ellipsoid::SphereSpacing spacing_ = ellipsoid::SphereSpacing::paper;
  ellipsoid_host::TemplateBody body_;
  std::string clump_file_, written_file_; // empty: none
  std::optional<double> clump_scale_;
  bool has_spacing_ = false;
  int clump_number_ = 0; // from 1; 0: no clump

  void parse(int narg, char** arg);
  bool parse_spheres(const std::string& keyword, ellipsoid_host::ArgumentReader& reader);
  void complete(bool has_semiaxes, bool has_moments);
  void check_combination(bool has_semiaxes, bool has_moments);
  void derive_sizes_and_masses(bool has_moments);
  void check_surface();
  void check_volume();
  void check_moments();
  void check_spheres();
  void make_clump(bool has_semiaxes, bool has_moments);
  int spacing_number() const;
  void randomize(ParticleToInsertEllipsoid& particle);
};

} // namespace LAMMPS_NS

#endif
#endif
