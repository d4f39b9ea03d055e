// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "law/contact_laws.h"
#include "vectorised/batch.h"

namespace ellipsoid {

/// Columns of numbers, one per contact: what is known of it, what the laws hand on from one to the
/// next, and what they make of it.
struct LawColumns {
  enum Input {
    nx,
    ny,
    nz, ///< unit normal, from j to i
    lix,
    liy,
    liz, ///< lever: contact point relative to the centre of i
    ljx,
    ljy,
    ljz,
    overlap,
    radius,   ///< reduced radius
    radius_i, ///< of curvature
    radius_j,
    vx,
    vy,
    vz, ///< velocity of the centre of i relative to that of j
    wix,
    wiy,
    wiz, ///< angular velocity
    wjx,
    wjy,
    wjz,
    mass_i,
    mass_j,
    sx,
    sy,
    sz, ///< spring of the last step
    rx,
    ry,
    rz,         ///< rolling torque of the last step
    parameters, ///< and those after it, see LawParameters
    input_count = parameters + LawParameters::count
  };
  enum Result {
    fx,
    fy,
    fz, ///< force on i
    tix,
    tiy,
    tiz, ///< torque on i
    tjx,
    tjy,
    tjz,
    new_sx,
    new_sy,
    new_sz,
    new_rx,
    new_ry,
    new_rz,
    slip_x,
    slip_y,
    slip_z, ///< tangential velocity
    normal_force,
    along_normal, ///< the same with the pull of cohesion
    normal_stiffness,
    tangential_stiffness,
    tangential_damping,
    reduced_mass,
    result_count
  };
  alignas(64) double in[input_count][Batch::column_length];
  alignas(64) double out[result_count][Batch::column_length];
  LawSettings settings{};
  bool are_in_plane = false; ///< all contacts, and so forces along x and y and torques along z
};

} // namespace ellipsoid
