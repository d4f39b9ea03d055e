// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Contacts of smooth ellipsoids: at most one per pair.
//
// The history of a pair starts with what the search remembers: the unit normal from j to i (it flips
// with the order of the pair, as the host's flag 1 says) and whether the pair touched.
#ifndef SMOOTH_CONTACT_LOOP_H_
#define SMOOTH_CONTACT_LOOP_H_

#include "ellipsoid_contact.h"
#include "ellipsoid_contact_loop.h"

namespace LIGGGHTS {

template <typename Model>
class SmoothContactLoop : public EllipsoidContactLoop<SmoothContactLoop<Model>, Model> {
  using Base = EllipsoidContactLoop<SmoothContactLoop<Model>, Model>;
  friend Base;
  using Base::contact_;
  using Base::counts_;
  using Base::pair_;

public:
  SmoothContactLoop(LAMMPS* lmp, PairGranEllipsoid* pair, int64_t hash)
      : Base(lmp, pair, hash,
             {{"normalx", true}, {"normaly", true}, {"normalz", true}, {"touching", false}}) {}

private:
  enum { normal_x, normal_y, normal_z, was_touching }; // offsets in the history

  const std::vector<ellipsoid::EllipsoidShape>* shapes_ = nullptr;

  void prepare() { shapes_ = &pair_->update_shapes(); }

  void treat_pair(int i, int j, int& flag, double* history) {
    ellipsoid::Vector3 distance;
    if (this->is_near(i, j, distance)) {
      const ellipsoid::ContactGeometry geometry = search(i, j, distance, history);
      if (geometry.status != ellipsoid::ContactStatus::separated) {
        treat_contact(i, j, distance, geometry, flag, history);
        return;
      }
    }
    if (flag || history[was_touching] != 0.0) {
      this->forget_contact(i, j, flag, history);
      history[was_touching] = 0.0;
      flag = 0;
    }
  }

  /// A touching pair starts from its last normal. All others start from scratch once a remembered
  /// separating normal fails: what a new contact is does not depend on what happened before it, nor
  /// on whether the run was interrupted.
  ellipsoid::ContactGeometry search(int i, int j, const ellipsoid::Vector3& distance,
                                    double* history) {
    using namespace ellipsoid;
    const EllipsoidShape& shape_i = (*shapes_)[static_cast<std::size_t>(i)];
    const EllipsoidShape& shape_j = (*shapes_)[static_cast<std::size_t>(j)];
    const Vector3 remembered = -ellipsoid_host::vector(&history[normal_x]);
    const bool has_normal = dot(remembered, remembered) > 0.5; // unit vector, or zero
    ContactGeometry geometry;
    if (has_normal && history[was_touching] != 0.0) {
      geometry = find_contact_from(remembered, shape_i, shape_j, distance);
    } else {
      if (has_normal && overlap_along(shape_i, shape_j, distance, remembered) < 0.0)
        return geometry;
      geometry = find_contact(shape_i, shape_j, distance);
    }
    count(geometry, this->share(j));
    if (contact_.computeflag)
      ellipsoid_host::store(-geometry.normal, &history[normal_x]);
    return geometry;
  }

  void count(const ellipsoid::ContactGeometry& geometry, double share) {
    counts_.values[ContactCounts::tested] += share;
    counts_.values[ContactCounts::newton_steps] += share * geometry.iterations;
    if (geometry.status == ellipsoid::ContactStatus::not_converged)
      counts_.values[ContactCounts::not_converged] += share;
    if (geometry.status != ellipsoid::ContactStatus::separated) {
      counts_.values[ContactCounts::touching_pairs] += share;
      counts_.values[ContactCounts::contacts] += share;
    }
  }

  void treat_contact(int i, int j, const ellipsoid::Vector3& distance,
                     const ellipsoid::ContactGeometry& geometry, int& flag, double* history) {
    // local spheres with the Gaussian radii of curvature, scaled so that their R is that of (19)
    const double r_i = geometry.curvature_radius_i, r_j = geometry.curvature_radius_j;
    const double scale = geometry.reduced_radius * (r_i + r_j) / (r_i * r_j);
    this->fill_pair(i, j, distance, flag);
    this->fill_contact(geometry.normal, geometry.point, geometry.overlap, geometry.reduced_radius,
                       scale * r_i, scale * r_j, history);
    if (contact_.computeflag)
      history[was_touching] = 1.0;
    flag |= CONTACT_SURFACE_MODEL;
    this->apply_contact();
  }
};

} // namespace LIGGGHTS

#endif
