// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "output_options.h"
#include "row_store.h"

#include <string>

namespace ellipsoid::post {

/// Throws InputError where --csv and --json have one name.
void refuse_one_name(const OutputOptions& options);

/// As write_table(), with the same bytes, of rows that need not fit into memory.
/// @param[in] for_people other rows for standard output, of fewer quantities
void write_rows(const OutputOptions& options, const std::string& title, const RowStore& rows,
                const RowStore& for_people);
void write_rows(const OutputOptions& options, const std::string& title, const RowStore& rows);

} // namespace ellipsoid::post
