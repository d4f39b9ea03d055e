// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Plain values of three-dimensional geometry: vector, symmetric matrix, quaternion.
// Host-free: nothing here knows of LIGGGHTS.
#pragma once

#include <cmath>

namespace ellipsoid {

struct Vector3 {
  double x = 0.0, y = 0.0, z = 0.0;

  Vector3& operator+=(const Vector3& b) {
    x += b.x;
    y += b.y;
    z += b.z;
    return *this;
  }
  Vector3& operator-=(const Vector3& b) {
    x -= b.x;
    y -= b.y;
    z -= b.z;
    return *this;
  }
  Vector3& operator*=(double s) {
    x *= s;
    y *= s;
    z *= s;
    return *this;
  }
};

inline Vector3 operator+(Vector3 a, const Vector3& b) { return a += b; }
inline Vector3 operator-(Vector3 a, const Vector3& b) { return a -= b; }
inline Vector3 operator-(const Vector3& a) { return {-a.x, -a.y, -a.z}; }
inline Vector3 operator*(double s, Vector3 a) { return a *= s; }
inline Vector3 operator*(Vector3 a, double s) { return a *= s; }

inline double dot(const Vector3& a, const Vector3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double norm(const Vector3& a) { return std::sqrt(dot(a, a)); }
inline Vector3 normalized(const Vector3& a) { return (1.0 / norm(a)) * a; }
/// Its part along a unit vector.
inline Vector3 part_along(const Vector3& a, const Vector3& unit) { return dot(a, unit) * unit; }
/// One of the two, without a branch.
inline Vector3 chosen(bool first, const Vector3& a, const Vector3& b) {
  return {first ? a.x : b.x, first ? a.y : b.y, first ? a.z : b.z};
}

/// Symmetric 3x3 matrix by its six independent entries.
struct SymmetricMatrix3 {
  double xx = 0.0, yy = 0.0, zz = 0.0, xy = 0.0, xz = 0.0, yz = 0.0;
};

inline Vector3 operator*(const SymmetricMatrix3& m, const Vector3& v) {
  return {m.xx * v.x + m.xy * v.y + m.xz * v.z, m.xy * v.x + m.yy * v.y + m.yz * v.z,
          m.xz * v.x + m.yz * v.y + m.zz * v.z};
}

inline SymmetricMatrix3 operator+(const SymmetricMatrix3& a, const SymmetricMatrix3& b) {
  return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.xz + b.xz, a.yz + b.yz};
}

inline SymmetricMatrix3 operator*(double s, const SymmetricMatrix3& a) {
  return {s * a.xx, s * a.yy, s * a.zz, s * a.xy, s * a.xz, s * a.yz};
}

inline double determinant(const SymmetricMatrix3& m) {
  return m.xx * (m.yy * m.zz - m.yz * m.yz) - m.xy * (m.xy * m.zz - m.yz * m.xz) +
         m.xz * (m.xy * m.yz - m.yy * m.xz);
}

/// Matrix of the cofactors: the inverse times the determinant.
inline SymmetricMatrix3 adjugate(const SymmetricMatrix3& m) {
  return {m.yy * m.zz - m.yz * m.yz, m.xx * m.zz - m.xz * m.xz, m.xx * m.yy - m.xy * m.xy,
          m.xz * m.yz - m.xy * m.zz, m.xy * m.yz - m.xz * m.yy, m.xy * m.xz - m.yz * m.xx};
}

/// Rotation matrix; its columns are the body's axes in the space frame.
struct Rotation3 {
  Vector3 column_x{1.0, 0.0, 0.0}, column_y{0.0, 1.0, 0.0}, column_z{0.0, 0.0, 1.0};

  /// Body frame to space frame.
  Vector3 to_space(const Vector3& b) const {
    return b.x * column_x + b.y * column_y + b.z * column_z;
  }
  /// Space frame to body frame.
  Vector3 to_body(const Vector3& s) const {
    return {dot(column_x, s), dot(column_y, s), dot(column_z, s)};
  }
};

/// Unit quaternion, scalar part first, that turns body vectors into space vectors
/// (LIGGGHTS: `quaternion[0..3]`, dump columns quat1..quat4).
struct Quaternion {
  double w = 1.0, x = 0.0, y = 0.0, z = 0.0;
};

inline Quaternion operator*(const Quaternion& p, const Quaternion& q) {
  return {
      p.w * q.w - p.x * q.x - p.y * q.y - p.z * q.z, p.w * q.x + p.x * q.w + p.y * q.z - p.z * q.y,
      p.w * q.y - p.x * q.z + p.y * q.w + p.z * q.x, p.w * q.z + p.x * q.y - p.y * q.x + p.z * q.w};
}

inline Quaternion normalized(const Quaternion& q) {
  const double s = 1.0 / std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {s * q.w, s * q.x, s * q.y, s * q.z};
}

/// Rotation matrix of a unit quaternion.
inline Rotation3 rotation(const Quaternion& q) {
  const double ww = q.w * q.w, xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
  const double wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
  const double xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z;
  return {{ww + xx - yy - zz, 2.0 * (xy + wz), 2.0 * (xz - wy)},
          {2.0 * (xy - wz), ww - xx + yy - zz, 2.0 * (yz + wx)},
          {2.0 * (xz + wy), 2.0 * (yz - wx), ww - xx - yy + zz}};
}

/// R diag(d) R^T.
inline SymmetricMatrix3 rotated_diagonal(const Rotation3& r, double dx, double dy, double dz) {
  const Vector3 &a = r.column_x, &b = r.column_y, &c = r.column_z;
  return {dx * a.x * a.x + dy * b.x * b.x + dz * c.x * c.x,
          dx * a.y * a.y + dy * b.y * b.y + dz * c.y * c.y,
          dx * a.z * a.z + dy * b.z * b.z + dz * c.z * c.z,
          dx * a.x * a.y + dy * b.x * b.y + dz * c.x * c.y,
          dx * a.x * a.z + dy * b.x * b.z + dz * c.x * c.z,
          dx * a.y * a.z + dy * b.y * b.z + dz * c.y * c.z};
}

} // namespace ellipsoid
