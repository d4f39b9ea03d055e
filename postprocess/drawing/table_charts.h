// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Charts of any columns of a table: curves, and maps of a value over two others.
#pragma once

#include "chart.h"
#include "table.h"

#include <string>
#include <vector>

namespace ellipsoid::post {

/// What is drawn: keys of columns.
struct TableChart {
  std::string x, group; ///< group: a curve for each of its values; empty: none
  std::vector<std::string> y;
  std::string value; ///< of maps
  std::string title;
  std::vector<std::string> margin = {}; ///< of each y, in its order; those without have none
};

/// Curves y over x, one for each y and group, in the order of the rows. Rows without both numbers
/// are left out; a row without a margin has none. Throws InputError for a column that no row has,
/// for more margins than curves, and where no row has both numbers.
Chart curve_chart(const Table& table, const TableChart& what);

/// Sentences that count what has no number (nan and inf are none) and is not in the curves, or
/// nothing.
std::string left_out_of_curves(const Table& table, const TableChart& what);

/// Sentences that count the cells of a map that stay blank, and rows that are not seen in it; or
/// nothing. Throws what draw_map() throws.
std::string left_out_of_map(const Table& table, const TableChart& what);

/// A map: a rectangle for each row with a value, coloured by the value, about (x, y).
/// @return the file's bytes. Throws InputError for missing columns, and where x or y are all equal.
std::string draw_map(PictureFormat format, const Table& table, const TableChart& what, int width,
                     int height);

/// "stress_zz_Pa" to "stress zz (Pa)".
std::string label_of_key(const std::string& key);

} // namespace ellipsoid::post
