// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "wall/mesh_contact.h"

#include "wall/wall_tolerances.h"

#include <algorithm>
#include <iterator>

namespace ellipsoid {

namespace {

/// Whether all triangles that contain the contact's foot lie behind its tangent plane.
bool is_supported(const TriangleContact& c, const std::vector<Triangle>& triangles, double size) {
  for (const Triangle& t : triangles) {
    const Vector3 away = nearest_point(t, c.foot) - c.foot;
    if (norm(away) > wall_tolerance::shared_point * size)
      continue;
    for (const Vector3& node : t) {
      const Vector3 way = node - c.foot;
      if (dot(c.normal, way) <
          -wall_tolerance::behind_plane * norm(way) -
              wall_tolerance::shared_point * wall_tolerance::behind_plane * size)
        return false;
    }
  }
  return true;
}

bool is_hidden(const TriangleContact& c, const std::vector<Triangle>& triangles,
               const Vector3& eye) {
  for (std::size_t k = 0; k < triangles.size(); ++k)
    if (static_cast<int>(k) != c.triangle &&
        crosses(triangles[k], eye, c.foot, 0.0, 1.0 - wall_tolerance::sight_end))
      return true;
  return false;
}

bool is_same(const TriangleContact& c, const TriangleContact& d, double size) {
  return norm(c.foot - d.foot) <= wall_tolerance::same_contact * size &&
         norm(c.normal - d.normal) <= wall_tolerance::same_contact;
}

/// Whether c is a deeper minimum beside d on the same ridge or plane: its foot lies in or beyond
/// the tangent plane of d. (In a groove the feet lie in front of each other's planes.)
bool is_outdone(const TriangleContact& c, const TriangleContact& d, double size) {
  return c.deep && d.overlap < c.overlap &&
         dot(d.normal, c.foot - d.foot) >= -wall_tolerance::shared_point * size;
}

/// Whether the wall that c touches is, but for cracks and unmatched corners, the one that the
/// deeper contact d is with: c's foot then lies in or beyond the tangent plane of d, in the cap of
/// the body that this plane cuts off.
bool is_part_of(const TriangleContact& c, const TriangleContact& d, double size) {
  using namespace wall_tolerance;
  const Vector3 way = c.foot - d.foot;
  const double in_front = -dot(d.normal, way); // of the tangent plane (length)
  if (in_front <= same_plane * size)
    return true;
  const bool face_c = c.feature == TriangleFeature::face,
             face_d = d.feature == TriangleFeature::face;
  if (in_front > unmatched * size || (face_c && face_d))
    return false;
  const double patch = std::sqrt(2.0 * d.reduced_radius * (d.overlap + unmatched * size));
  return norm(way) <= (face_c || face_d ? patch_reach * patch : crack_reach * unmatched * size);
}

/// Of contacts from index `first` on, the deepest one of each wall.
void keep_deepest(std::vector<TriangleContact>& contacts, std::size_t first, double size) {
  const auto begin = contacts.begin() + static_cast<std::ptrdiff_t>(first);
  std::sort(begin, contacts.end(), [](const TriangleContact& c, const TriangleContact& d) {
    return c.overlap != d.overlap ? c.overlap > d.overlap : c.triangle < d.triangle;
  });
  for (auto count = contacts.end() - begin; count > 1; --count) {
    const auto last = begin + (count - 1);
    if (std::any_of(begin, last,
                    [&](const TriangleContact& d) { return is_part_of(*last, d, size); }))
      contacts.erase(last);
  }
  std::sort(begin, contacts.end(), [](const TriangleContact& c, const TriangleContact& d) {
    return c.triangle < d.triangle;
  });
}

/// Whether two contacts are near enough to be one: the patch of one of them reaches the other.
bool overlap_as_patches(const TriangleContact& c, const TriangleContact& d) {
  const auto patch = [](const TriangleContact& e) { return e.reduced_radius * e.overlap; };
  const Vector3 way = c.foot - d.foot;
  return dot(way, way) <= std::max(patch(c), patch(d)); // radius sqrt(R h)
}

/// Of contacts that are connected by `related`, keeps the first in the order of `comes_first`.
template <class Related, class ComesFirst>
void keep_one_of_each_group(std::vector<TriangleContact>& contacts, std::size_t first,
                            const Related& related, const ComesFirst& comes_first) {
  std::vector<std::size_t> group(contacts.size() - first);
  for (std::size_t k = 0; k < group.size(); ++k) {
    group[k] = k;
    for (std::size_t l = 0; l < k; ++l)
      if (group[l] != group[k] && related(contacts[first + k], contacts[first + l]))
        std::replace(group.begin(), group.begin() + static_cast<std::ptrdiff_t>(k) + 1, group[l],
                     group[k]);
  }
  std::vector<TriangleContact> kept;
  for (std::size_t k = 0; k < group.size(); ++k) {
    bool best = true;
    for (std::size_t l = 0; l < group.size(); ++l)
      best = best && (l == k || group[l] != group[k] ||
                      !comes_first(contacts[first + l], contacts[first + k]));
    if (best)
      kept.push_back(contacts[first + k]);
  }
  contacts.resize(first);
  contacts.insert(contacts.end(), kept.begin(), kept.end());
}

/// Whether a contact at an edge or corner is not supported, or a contact of any kind is hidden.
bool is_false(const TriangleContact& c, const std::vector<Triangle>& triangles, const Vector3& eye,
              double size) {
  const bool face = c.feature == TriangleFeature::face;
  return (!face && !is_supported(c, triangles, size)) || is_hidden(c, triangles, eye);
}

/// Reduces the contacts from index `first` on, all of one body, to those that count.
void select(const SameSurface& same_surface, double size, std::size_t first,
            std::vector<TriangleContact>& contacts) {
  if (contacts.size() < first + 2)
    return;
  const std::vector<TriangleContact> all(contacts.begin() + static_cast<std::ptrdiff_t>(first),
                                         contacts.end());
  contacts.resize(first);
  std::copy_if(all.begin(), all.end(), std::back_inserter(contacts), [&](const TriangleContact& c) {
    return std::none_of(all.begin(), all.end(),
                        [&](const TriangleContact& d) { return is_outdone(c, d, size); });
  });
  keep_one_of_each_group(
      contacts, first,
      [&](const TriangleContact& c, const TriangleContact& d) { return is_same(c, d, size); },
      [](const TriangleContact& c, const TriangleContact& d) {
        const bool face_c = c.feature == TriangleFeature::face,
                   face_d = d.feature == TriangleFeature::face;
        return face_c != face_d ? face_c : c.triangle < d.triangle;
      });
  keep_deepest(contacts, first, size);
  keep_one_of_each_group(
      contacts, first,
      [&](const TriangleContact& c, const TriangleContact& d) {
        return overlap_as_patches(c, d) && same_surface(c.triangle, d.triangle);
      },
      [](const TriangleContact& c, const TriangleContact& d) {
        return c.overlap != d.overlap ? c.overlap > d.overlap : c.triangle < d.triangle;
      });
}

/// Whether the body reaches any triangle of the contact's plane.
template <class Body>
bool reaches_plane(const Body& body, const TriangleContact& c,
                   const std::vector<Triangle>& triangles, double size) {
  return std::any_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(),
                       [&](const Vector3& node) {
                         return std::fabs(dot(c.normal, node - c.foot)) <=
                                wall_tolerance::shared_point * size;
                       }) &&
           reaches(body, t);
  });
}

/// Whether a triangle lies in the plane of a shallow contact at a face: then it has no other.
bool is_in_plane(const Triangle& t, const TriangleContact& face, double size) {
  return !face.deep && std::all_of(t.begin(), t.end(), [&](const Vector3& node) {
    return std::fabs(dot(face.normal, node - face.foot)) <= wall_tolerance::on_triangle * size;
  });
}

/// The contact that is always there when the body reaches into a triangle.
template <class Body>
void add_growing_contact(const Body& body, const std::vector<Triangle>& triangles,
                         std::vector<TriangleContact>& contacts) {
  double smallest = 1.0;
  TriangleContact found;
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    double growth;
    const TriangleContact c = find_growing_contact(body, triangles[k], growth);
    if (!(growth < smallest))
      continue;
    smallest = growth;
    found = c;
    found.triangle = static_cast<int>(k);
  }
  if (found.triangle >= 0)
    contacts.push_back(found);
}

/// is_in_plane() for any of the contacts from index `first` to before `last`.
bool is_in_plane(const Triangle& t, const std::vector<TriangleContact>& contacts, std::size_t first,
                 std::size_t last, double size) {
  const auto begin = contacts.begin();
  return std::any_of(begin + static_cast<std::ptrdiff_t>(first),
                     begin + static_cast<std::ptrdiff_t>(last),
                     [&](const TriangleContact& c) { return is_in_plane(t, c, size); });
}

/// Adds the contacts at edges and corners of some triangles.
/// @param[in] first index of the first contact of this body; so far there are those at its faces
template <class Body>
void add_boundary_contacts(const Body& body, const Vector3& eye, double size,
                           const std::vector<Triangle>& triangles,
                           const std::vector<int>& with_boundary, std::size_t first,
                           std::vector<TriangleContact>& contacts) {
  const std::size_t last_face = contacts.size();
  for (const int k : with_boundary) {
    const Triangle& t = triangles[static_cast<std::size_t>(k)];
    if (is_in_plane(t, contacts, first, last_face, size))
      continue;
    TriangleContact c = find_boundary_contact(body, t);
    c.triangle = k;
    if (c.feature != TriangleFeature::none && !is_false(c, triangles, eye, size))
      contacts.push_back(c);
  }
}

/// @param[in] eye from where contact points must be seen
/// @param[in] size of the particle (length)
template <class Body>
void add_contacts(const Body& body, const Vector3& eye, double size,
                  const std::vector<Triangle>& triangles, const SameSurface& same_surface,
                  std::vector<TriangleContact>& contacts) {
  const std::size_t first = contacts.size();
  std::vector<int> with_boundary; // triangles whose edges and corners may touch
  bool near = false;
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    if (is_in_plane(triangles[k], contacts, first, contacts.size(), size))
      continue;
    TriangleContacts offered = find_face_contact(body, triangles[k]);
    near = near || offered.plane_is_reached;
    if (offered.boundary_may_touch)
      with_boundary.push_back(static_cast<int>(k));
    offered.face.triangle = static_cast<int>(k);
    if (offered.face.feature == TriangleFeature::none ||
        (offered.face_is_missed && !reaches_plane(body, offered.face, triangles, size)) ||
        is_false(offered.face, triangles, eye, size))
      continue;
    contacts.push_back(offered.face);
  }
  if (!near)
    return;
  add_boundary_contacts(body, eye, size, triangles, with_boundary, first, contacts);
  select(same_surface, size, first, contacts);
  if (contacts.size() == first)
    add_growing_contact(body, triangles, contacts);
}

} // namespace

void find_mesh_contacts(const EllipsoidBody& body, const std::vector<Triangle>& triangles,
                        const SameSurface& same_surface, std::vector<TriangleContact>& contacts) {
  contacts.clear();
  add_contacts(body, Vector3{}, extent(body), triangles, same_surface, contacts);
}

void find_mesh_contacts(const MultispherePose& pose, const std::vector<Triangle>& triangles,
                        const SameSurface& same_surface, std::vector<TriangleContact>& contacts) {
  contacts.clear();
  const MultisphereBody& spheres = *pose.body;
  const SphereCentres centres(pose);
  const double size = pose.scale * (spheres.half_length() + spheres.largest_radius());
  for (int k = 0; k < spheres.count(); ++k) {
    SphereBody body;
    body.centre = centres.at(k);
    body.radius = centres.radius(k);
    body.number = k;
    // Of a body with a hollow the way from its centre may pass a wall outside of it.
    body.beyond_wall = spheres.is_seen_from_origin(k) &&
                       std::any_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
                         return crosses(t, {}, body.centre, 0.0, 1.0);
                       });
    add_contacts(body, body.beyond_wall ? Vector3{} : body.centre, size, triangles, same_surface,
                 contacts);
  }
}

bool adjoin(const Triangle& first, const Triangle& second, double margin) {
  const auto touches = [margin](const Triangle& t, const Triangle& other) {
    return std::any_of(t.begin(), t.end(), [&](const Vector3& node) {
      return norm(nearest_point(other, node) - node) <= margin;
    });
  };
  return touches(first, second) || touches(second, first);
}

} // namespace ellipsoid
