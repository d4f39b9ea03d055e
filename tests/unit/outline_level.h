// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "plane_outline.h"

namespace ellipsoid::post {

/// Less than 0 inside of an ellipse, 0 on it.
inline double level(const PlaneEllipse& e, const Point& p) {
  const double cosine = (p.x() - e.centre.x()) / e.ux;
  const double sine = (p.y() - e.centre.y() - e.uy * cosine) / e.vy;
  return cosine * cosine + sine * sine - 1.0;
}

} // namespace ellipsoid::post
