// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "multisphere/sphere_patch.h"

#include "multisphere/arc_integrals.h"

#include <algorithm>
#include <cmath>

namespace ellipsoid {
namespace {

constexpr double pi = 3.141592653589793238462643;

/// Circles closer than this in normal and height are one: what lies between them is less than the
/// rounding of what is computed.
constexpr double same_circle = 1e-12;

/// Angles of a circle that are covered, as disjoint intervals in [0, 2 pi] in ascending order.
class CoveredAngles {
 public:
  /// @param[in] from in [-pi, pi]
  /// @param[in] width in [0, 2 pi]
  void add(double from, double width) {
    if (from < 0.0)
      from += 2.0 * pi;
    if (from + width > 2.0 * pi)
      insert(0.0, from + width - 2.0 * pi);
    insert(from, std::min(from + width, 2.0 * pi));
  }
  void add_all() { insert(0.0, 2.0 * pi); }
  bool are_all() const {
    return intervals_.size() == 1 && intervals_[0].from <= 0.0 && intervals_[0].to >= 2.0 * pi;
  }
  std::vector<AngleInterval> left_over() const {
    std::vector<AngleInterval> left;
    double from = 0.0;
    for (const AngleInterval& covered : intervals_) {
      if (covered.from > from)
        left.push_back({from, covered.from});
      from = covered.to;
    }
    if (from < 2.0 * pi)
      left.push_back({from, 2.0 * pi});
    return left;
  }

 private:
  void insert(double from, double to) {
    const auto first = std::find_if(intervals_.begin(), intervals_.end(),
                                    [&](const AngleInterval& i) { return i.to >= from; });
    auto last = first;
    for (; last != intervals_.end() && last->from <= to; ++last) {
      from = std::min(from, last->from);
      to = std::max(to, last->to);
    }
    intervals_.insert(intervals_.erase(first, last), {from, to});
  }

  std::vector<AngleInterval> intervals_;
};

/// Covers the angles of the cap's circle that lie in another cap. The points in which the two
/// circles cut each other are the same numbers, whichever of the two asks, so that arcs fit
/// together where circles nearly touch.
void cover(CoveredAngles& covered, const CapCircle& circle, const SphereCap& other,
           bool other_is_later) {
  const double h = circle.cap.height, cosine = dot(circle.cap.normal, other.normal);
  const Vector3 across = other_is_later ? cross(circle.cap.normal, other.normal)
                                        : -cross(other.normal, circle.cap.normal);
  const double sine2 = dot(across, across);
  const double along = (h - cosine * other.height) / sine2,
               along_other = (other.height - cosine * h) / sine2;
  const double half_chord2 = 1.0 - (along * h + along_other * other.height);
  if (!(half_chord2 > 0.0)) { // they do not cut each other: the circle's centre decides
    if (cosine * h > other.height)
      covered.add_all();
    return;
  }
  const Vector3 middle = along * circle.cap.normal + along_other * other.normal,
                half_chord = std::sqrt(half_chord2 / sine2) * across;
  const double from = circle.angle_of(middle - half_chord),
               to = circle.angle_of(middle + half_chord);
  double width = to - from;
  if (width < 0.0)
    width += 2.0 * pi;
  const bool is_less_than_half = along_other > 0.0;
  if (is_less_than_half && width > 1.5 * pi) // rounding of a width of nearly 0
    return;
  if (!is_less_than_half && width < 0.5 * pi) // or of nearly 2 pi
    width = 2.0 * pi;
  covered.add(from, width);
}

/// Whether a cap lies in one that is as large or larger, and does not touch its circle: the angle
/// between their normals and its own half angle are less than the half angle of the larger one.
bool is_inside(const SphereCap& cap, const SphereCap& larger, double cosine) {
  const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine)),
               half_sine = std::sqrt((1.0 - cap.height) * (1.0 + cap.height));
  return cosine * cap.height - sine * half_sine > larger.height + same_circle &&
         sine * cap.height + cosine * half_sine >= 0.0; // the sum is no more than pi
}

/// Leaves one of caps that are the same, and none that lies within another; the largest first.
/// @return false if two of them cover the whole sphere and touch along their circle
bool make_unique(std::vector<SphereCap>& caps) {
  std::stable_sort(caps.begin(), caps.end(),
                   [](const SphereCap& a, const SphereCap& b) { return a.height < b.height; });
  std::vector<SphereCap> kept;
  for (const SphereCap& cap : caps) {
    bool is_new = true;
    for (const SphereCap& other : kept) {
      const double cosine = dot(cap.normal, other.normal), side = cosine > 0.0 ? 1.0 : -1.0;
      const bool is_same_circle = std::fabs(cosine) >= 1.0 - 1e-9 &&
                                  norm(cap.normal - side * other.normal) < same_circle &&
                                  std::fabs(cap.height - side * other.height) < same_circle;
      if (is_same_circle && side < 0.0)
        return false;
      is_new = !is_same_circle && !is_inside(cap, other, cosine);
      if (!is_new)
        break;
    }
    if (is_new)
      kept.push_back(cap);
  }
  caps = std::move(kept);
  return true;
}

/// Of some directions in general position the one whose opposite point is farthest from all
/// circles.
Vector3 chosen_pole(const std::vector<SphereCap>& caps) {
  constexpr int candidates = 12;
  Vector3 best;
  double largest = -1.0;
  for (int k = 0; k < candidates; ++k) {
    const double z = (2.0 * k + 1.37) / candidates - 1.0, angle = 0.7319 + 2.399963 * k,
                 r = std::sqrt(1.0 - z * z);
    const Vector3 pole{r * std::cos(angle), r * std::sin(angle), z};
    double nearest = 2.0;
    for (const SphereCap& cap : caps)
      nearest = std::min(nearest, std::fabs(cap.height + dot(cap.normal, pole)));
    if (nearest > largest) {
      largest = nearest;
      best = pole;
    }
  }
  return best;
}

} // namespace

PatchIntegrals uncovered_patch(std::vector<SphereCap> caps) {
  if (!make_unique(caps))
    return {};
  const Vector3 pole = chosen_pole(caps);
  BoundaryIntegrals boundary;
  for (std::size_t k = 0; k < caps.size(); ++k) {
    const CapCircle circle(caps[k], pole);
    CoveredAngles covered;
    for (std::size_t l = 0; l < caps.size() && !covered.are_all(); ++l)
      if (l != k)
        cover(covered, circle, caps[l], l > k);
    for (const AngleInterval& arc : covered.left_over())
      add_arc(boundary, circle, arc);
  }
  const bool has_opposite_point = std::all_of(caps.begin(), caps.end(), [&](const SphereCap& cap) {
    return cap.height + dot(cap.normal, pole) >= 0.0;
  });
  return patch_of(boundary, has_opposite_point);
}

} // namespace ellipsoid
