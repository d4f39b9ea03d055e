// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "plane_outline.h"

#include <vector>

namespace ellipsoid::post {

/// The free surface of a set of outlines over a floor: y_max(x), the largest ordinate of any
/// outline at abscissa x, or the floor where there is none. Exact: a chain of upper arcs whose
/// ends are computed crossings.
class UpperEnvelope {
 public:
  UpperEnvelope(const std::vector<PlaneEllipse>& outlines, double floor);

  /// y_max(x) (length).
  double height(double x) const;
  /// The same at many abscissas, ascending.
  std::vector<double> heights(const std::vector<double>& abscissas) const;
  /// Area between floor and envelope from x0 to x1, closed form arc by arc (length^2).
  double area(double x0, double x1) const;
  /// Largest ordinate, and its abscissa (length).
  Point summit() const { return summit_; }
  /// Particles that own a part of the surface, ascending.
  std::vector<std::size_t> owners() const;

 private:
  struct Piece {
    double begin = 0.0, end = 0.0; ///< abscissas
    std::size_t arc = 0;           ///< index into arcs_, or no_arc
  };
  static constexpr std::size_t no_arc = static_cast<std::size_t>(-1);

  class CrossingPoints;
  class SurfaceBound;

  void keep_surface_arcs(const std::vector<PlaneEllipse>& outlines);
  std::vector<double> breakpoints() const;
  void build();

  std::vector<PlaneEllipse> arcs_;
  std::vector<Piece> pieces_;
  double floor_ = 0.0;
  Point summit_{0.0, 0.0};
};

} // namespace ellipsoid::post
