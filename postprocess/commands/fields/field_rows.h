// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "fields.h"
#include "image_data.h"
#include "table.h"

#include <array>
#include <string>

namespace ellipsoid::post {

/// What the files know: other quantities are left out.
struct KnownFields {
  bool has_motion = false, has_spins = false, has_forces = false, has_walls = false,
       has_normals = false;
};

/// Names of the three components of vectors: x y z, or r t z.
using ComponentNames = std::array<std::string, 3>;

/// All quantities.
void append_fields(Row& row, const Fields& fields, const KnownFields& known,
                   const ComponentNames& names);

/// All numbers of the quantities, in their order.
std::vector<double> field_numbers(const Fields& fields, const KnownFields& known);

/// Columns with the standard error of each quantity ("..._standard_error_UNIT").
/// @param[in] errors in the order of field_numbers(); empty: not known
void append_field_errors(Row& row, const KnownFields& known, const ComponentNames& names,
                         const std::vector<double>& errors);

/// The few of all quantities that people look at first, with their errors.
void append_main_fields(Row& row, const Row& all, const ComponentNames& names);

/// All quantities at the points of a grid.
std::vector<GridValues> grid_values(const std::vector<Fields>& fields, const KnownFields& known);

} // namespace ellipsoid::post
