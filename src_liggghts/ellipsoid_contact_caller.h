// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#ifndef ELLIPSOID_CONTACT_CALLER_H_
#define ELLIPSOID_CONTACT_CALLER_H_

namespace LIGGGHTS {
namespace ContactModels {

/// Told apart from the host's own pair styles and walls by this base class: only callers that
/// have it fill in the contact geometry which the surface models of ellipsoids expect.
class EllipsoidContactCaller {
public:
  virtual ~EllipsoidContactCaller() {}
  /// Curvature radii (length) of the contact in work: of i, and of j (not used at walls).
  double curvature_radius_i = 0.0, curvature_radius_j = 0.0;
};

} // namespace ContactModels
} // namespace LIGGGHTS

#endif
