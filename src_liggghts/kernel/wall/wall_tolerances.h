// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Every tolerance of the contacts with walls, with what it means physically.
// All are dimensionless: angles, or shares of a body's size.
#pragma once

namespace ellipsoid {
namespace wall_tolerance {

/// Relative change at which the search for the nearest or farthest surface point stops: rounding.
constexpr double search = 4.0e-16;

/// Steps of that search. Newton's method takes about 6; bisection, which it falls back to, at most
/// as many as the numbers have bits, for each of the exponents that a point near an axis runs
/// through.
constexpr int search_limit = 200;

/// A point so little outside a triangle (share of the body's size) counts as on it: neighbours that
/// share the point then both claim it, and one of the two is dropped as the same contact.
constexpr double on_triangle = 1.0e-9;

/// Nodes of neighbouring triangles may differ by so much (share of the body's size): coordinates in
/// files have few digits.
constexpr double shared_point = 1.0e-5;

/// Largest angle (rad) by which a triangle may reach in front of the tangent plane of a contact at
/// its edge or corner: rounding of the normal. Far below same_contact, so that a contact which
/// neither neighbour gives up is recognised as the same.
constexpr double behind_plane = 1.0e-8;

/// Contacts with points (share of the body's size) and normals (rad) closer than this are the same.
constexpr double same_contact = 1.0e-5;

/// A contact whose foot lies no farther in front of the tangent plane of a deeper one (share of the
/// body's size) touches the same plane: corners of the triangles off by shared_point each.
constexpr double same_plane = 2.0 * shared_point;

/// Cracks between triangles, and steps at corners that do not match, up to this share of the body's
/// size are no features of the wall.
constexpr double unmatched = 1.0e-3;

/// How far from a contact such steps are looked for, in radii sqrt(2 R h) of its patch: enough for
/// patches of bodies up to aspect 4, which are longer than that.
constexpr double patch_reach = 2.0;

/// Distance of two edges at one crack, in widest cracks: across it, and along a step in it.
constexpr double crack_reach = 2.0;

/// A wall hides a contact point when it crosses the line of sight from the body's centre nearer
/// than this share of the line short of the point: the triangles around the point end there, too.
constexpr double sight_end = 1.0e-4;

/// A body that fits a hollow cylinder's curvature exactly would have an infinite reduced radius.
/// The factor 1 - w/R of its relative curvature around the axis is kept above this: the reduced
/// radius is at most 10 times that at a plane.
constexpr double conformity = 0.01;

} // namespace wall_tolerance
} // namespace ellipsoid
