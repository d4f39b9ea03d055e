// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "multisphere/arc_integrals.h"

namespace ellipsoid {
namespace {

constexpr double pi = 3.141592653589793238462643;

/// Integrals of products of up to three of the functions 1, cos, sin (index 0, 1, 2) over an arc.
using Products = std::array<std::array<std::array<double, 3>, 3>, 3>;

/// Antiderivatives of cos^p sin^q, p + q <= 3, at an angle.
struct Antiderivatives {
  explicit Antiderivatives(double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    of[0][0] = angle;
    of[1][0] = s;
    of[0][1] = -c;
    of[2][0] = 0.5 * (angle + s * c);
    of[1][1] = 0.5 * s * s;
    of[0][2] = 0.5 * (angle - s * c);
    of[3][0] = s - s * s * s / 3.0;
    of[2][1] = -c * c * c / 3.0;
    of[1][2] = s * s * s / 3.0;
    of[0][3] = c * c * c / 3.0 - c;
  }
  double of[4][4] = {};
};

Products products_over(const AngleInterval& arc) {
  const Antiderivatives begin(arc.from), end(arc.to);
  Products products{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) {
        const int p = (i == 1) + (j == 1) + (k == 1), q = (i == 2) + (j == 2) + (k == 2);
        products[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]
                [static_cast<std::size_t>(k)] = end.of[p][q] - begin.of[p][q];
      }
  return products;
}

/// a b + b a.
SymmetricMatrix3 symmetric_product(const Vector3& a, const Vector3& b) {
  return {2.0 * a.x * b.x,       2.0 * a.y * b.y,       2.0 * a.z * b.z,
          a.x * b.y + a.y * b.x, a.x * b.z + a.z * b.x, a.y * b.z + a.z * b.y};
}

/// Of (1 - cos t) df = p.(x x dx) / (1 + p.x), pole p, along an arc of angles y from the pole's
/// side: -h dy + (q + h) dy / (A + B cos y) with A = 1 + h q, A^2 - B^2 = (h + q)^2, whose
/// antiderivative is that of the half angle's tangent, here without its jumps.
double pole_form_over(const CapCircle& circle, const AngleInterval& arc) {
  const double h = circle.cap.height, sum = h + circle.pole_cosine;
  const double ratio =
      std::fabs(sum) / (1.0 + h * circle.pole_cosine + circle.radius * circle.pole_sine);
  const auto beyond_half_angle = [ratio](double angle) {
    const double c = std::cos(0.5 * angle), s = std::sin(0.5 * angle);
    return std::atan2((ratio - 1.0) * s * c, c * c + ratio * s * s);
  };
  const double turn = arc.to - arc.from;
  const double winding = turn + 2.0 * (beyond_half_angle(arc.to) - beyond_half_angle(arc.from));
  return (sum < 0.0 ? -winding : winding) - h * turn;
}

double component(const Vector3& a, std::size_t k) { return k == 0 ? a.x : k == 1 ? a.y : a.z; }

} // namespace

CapCircle::CapCircle(const SphereCap& of_cap, const Vector3& pole_direction)
    : cap(of_cap), radius(std::sqrt((1.0 - cap.height) * (1.0 + cap.height))),
      pole_cosine(dot(cap.normal, pole_direction)) {
  Vector3 side = pole_direction - pole_cosine * cap.normal;
  pole_sine = norm(side);
  if (pole_sine < 1e-8) // the direction does not matter then
    side = cross(cap.normal,
                 std::fabs(cap.normal.x) < 0.8 ? Vector3{1.0, 0.0, 0.0} : Vector3{0.0, 1.0, 0.0});
  first = normalized(side);
  second = cross(cap.normal, first);
}

/// On the circle x = h n + r (cos first + sin second), and the conormal times the element of length
/// is (n - h x) dy.
void add_arc(BoundaryIntegrals& sum, const CapCircle& circle, const AngleInterval& arc) {
  const double h = circle.cap.height, r = circle.radius;
  const Vector3 position[3] = {h * circle.cap.normal, r * circle.first, r * circle.second};
  const Vector3 conormal[3] = {circle.cap.normal - h * position[0], -h * position[1],
                               -h * position[2]};
  const Products products = products_over(arc);
  sum.pole_form += pole_form_over(circle, arc);
  for (std::size_t i = 0; i < 3; ++i) {
    sum.flow += products[i][0][0] * conormal[i];
    for (std::size_t j = 0; j < 3; ++j) {
      const SymmetricMatrix3 vx = symmetric_product(conormal[i], position[j]);
      sum.flow1 = sum.flow1 + products[i][j][0] * vx;
      for (std::size_t k = 0; k < 3; ++k) {
        const SymmetricMatrix3 xx = 0.5 * symmetric_product(position[j], position[k]);
        for (std::size_t m = 0; m < 3; ++m)
          sum.flow2[m] = sum.flow2[m] + products[i][j][k] * (component(position[k], m) * vx +
                                                             component(conormal[i], m) * xx);
      }
    }
  }
}

PatchIntegrals patch_of(const BoundaryIntegrals& boundary, bool has_opposite_point) {
  PatchIntegrals patch;
  patch.solid_angle = (has_opposite_point ? 4.0 * pi : 0.0) - boundary.pole_form;
  patch.first = -0.5 * boundary.flow;
  const double third = patch.solid_angle / 3.0;
  patch.second = (-1.0 / 6.0) * boundary.flow1 + SymmetricMatrix3{third, third, third, 0., 0., 0.};
  // d_kl f_m + d_km f_l + d_lm f_k, f the first integral
  const Vector3 axes[3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  for (std::size_t m = 0; m < 3; ++m) {
    const double f = component(patch.first, m);
    const SymmetricMatrix3 traces =
        SymmetricMatrix3{f, f, f, 0., 0., 0.} + symmetric_product(axes[m], patch.first);
    patch.third[m] = (-1.0 / 12.0) * boundary.flow2[m] + (1.0 / 6.0) * traces;
  }
  return patch;
}

} // namespace ellipsoid
