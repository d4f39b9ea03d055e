// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Every tolerance of the ellipsoid contact search, with what it means physically.
// All are dimensionless: they are relative to the bodies' own size, or angles.
#pragma once

namespace ellipsoid {
namespace tolerance {

/// Newton's method is quadratic: a step of angle e leaves an error of about
/// (condition number of the Hessian) (change of the radii of curvature per radian) e^2. The search
/// stops when that predicted error of the normal falls below this angle (rad); the contact point is
/// then exact to this angle times the largest radius of curvature, the overlap to its square.
constexpr double normal_error = 1.0e-14;

/// The last step is not followed by a new evaluation when it is below this angle (rad): contact
/// point, overlap and radii then come from the derivatives at hand, with errors of this angle
/// squared.
constexpr double extrapolated_step = 1.0e-8;

/// The same for a pair that touched in the last time step (contact_batch.h): its normal is then
/// exact to 1e-12 rad, a ten-thousandth of what it turns in one time step of a pile at rest, and
/// one evaluation is enough for almost all.
constexpr double batch_normal_error = 1.0e-12;

/// A step of third order e leaves an error of less than k (c1 k r^2 + c2 T) e^3, with k the
/// condition number of the Hessian as tr^2 / det, r the relative change of the radii of curvature
/// per radian, and T = tr A / s^2 their second change where the first is 0, on flat sides (the
/// larger one of the two bodies). Random and flat-on-flat pairs up to aspect 100, with overlaps up
/// to 0.45 det W / tr W, had 0.63 of this error at most.
constexpr double third_order_squared_rate = 0.1;
constexpr double third_order_flat = 0.125;

/// Longest accepted Newton step (rad): beyond it the quadratic model of the support
/// functions of a slender body (aspect 20 turns its radius within 1/20 rad) says nothing.
constexpr double largest_step = 0.5;

/// Share of the predicted decrease that a step has to deliver (Armijo's condition).
constexpr double sufficient_decrease = 1.0e-4;

/// The overlap function is evaluated as a difference of lengths; its rounding noise is this
/// share of the distances of the support points. A step whose decrease hides in it is accepted.
constexpr double rounding_noise = 4.0e-15;

/// A Hessian eigenvalue below this share of the Hessian's trace counts as non-convex.
constexpr double convexity = 1.0e-9;

/// Newton steps before a contact is called not converged. Where the overlap equals a radius of
/// curvature the Hessian is singular and convergence only linear: random poses at aspect 20 have
/// needed up to 96 steps there.
constexpr int newton_limit = 200;

/// Halvings of one step before the search direction is given up.
constexpr int halving_limit = 40;

/// Iterations of the scalar search for the first normal; each at least halves the bracket.
constexpr int bracket_limit = 60;

/// Relative width at which the scalar search for the first normal stops: the result is only
/// a starting point, but its sign decides about touching (see first_normal).
constexpr double bracket_width = 1.0e-6;

/// The axis ratio of a contact ellipse is found so that ln(B/A) is met to this, as the normal of a
/// lasting contact (`batch_normal_error`), from which A and B follow.
constexpr double elliptic_error = 1.0e-12;

/// Steps of the secant search for it: 2 to 4 are needed for curvatures up to 1 : 1e8.
constexpr int elliptic_limit = 30;

/// The arithmetic-geometric mean is found when its two means differ by less than this (relative):
/// the next step would square it.
constexpr double elliptic_rounding = 1.0e-9;

} // namespace tolerance
} // namespace ellipsoid
