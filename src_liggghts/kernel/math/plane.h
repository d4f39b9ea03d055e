// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Values for bodies in the plane: all centres at the same height, and every body its own mirror
// image in that plane. Normals, contacts and forces then have no part along z, and what the kernel
// computes from vectors of three numbers comes out, bit for bit, from two. A loop that is a
// template over its vectors (contact_batch.cpp, law_batch.cpp) is compiled for both.
#pragma once

#include "math/vector3.h"

namespace ellipsoid {

struct PlaneVector {
  double x = 0.0, y = 0.0;
};

inline PlaneVector operator+(const PlaneVector& a, const PlaneVector& b) {
  return {a.x + b.x, a.y + b.y};
}
inline PlaneVector operator-(const PlaneVector& a, const PlaneVector& b) {
  return {a.x - b.x, a.y - b.y};
}
inline PlaneVector operator*(double s, const PlaneVector& a) { return {s * a.x, s * a.y}; }
inline double dot(const PlaneVector& a, const PlaneVector& b) { return a.x * b.x + a.y * b.y; }
inline double norm(const PlaneVector& a) { return std::sqrt(dot(a, a)); }
inline PlaneVector normalized(const PlaneVector& a) { return (1.0 / norm(a)) * a; }
inline PlaneVector chosen(bool first, const PlaneVector& a, const PlaneVector& b) {
  return {first ? a.x : b.x, first ? a.y : b.y};
}

/// The part along z.
inline double cross(const PlaneVector& a, const PlaneVector& b) { return a.x * b.y - a.y * b.x; }
/// Of a vector along z with a vector in the plane.
inline PlaneVector cross(double z, const PlaneVector& b) { return {-(z * b.y), z * b.x}; }

/// Of a vector along z, which lies across every vector in the plane.
inline double norm(double z) { return std::fabs(z); }
inline double part_along(double, const PlaneVector&) { return 0.0; }

/// Symmetric 3x3 matrix with z as one of its principal axes.
struct PlaneMatrix {
  double xx = 0.0, yy = 0.0, zz = 0.0, xy = 0.0;
};

inline PlaneVector operator*(const PlaneMatrix& m, const PlaneVector& v) {
  return {m.xx * v.x + m.xy * v.y, m.xy * v.x + m.yy * v.y};
}

} // namespace ellipsoid
