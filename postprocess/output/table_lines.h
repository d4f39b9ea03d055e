// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Lines of a table one by one: of files, and for people.
#pragma once

#include "table.h"

#include <string>
#include <vector>

namespace ellipsoid::post {

/// The keys, with commas and the line's end.
std::string csv_head(const std::vector<Quantity>& header);
/// A row's values in the order of the header, with all digits; missing ones empty.
std::string csv_line(const Row& row, const std::vector<Quantity>& header);

/// A row as an object, indented as an element of an array; without the line's end.
std::string json_element(const Row& row);

/// Names with their units, as heads of columns.
std::vector<std::string> head_cells(const std::vector<Quantity>& header);
/// A row's values in the order of the header, five digits; "-" where they are missing.
std::vector<std::string> cells(const Row& row, const std::vector<Quantity>& header);
/// Makes room for these cells.
void widen(std::vector<std::size_t>& widths, const std::vector<std::string>& cells);
/// Cells with these widths, the first one to the left, with the line's end.
std::string aligned_line(const std::vector<std::string>& cells,
                         const std::vector<std::size_t>& widths);

} // namespace ellipsoid::post
