// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "porosity_value.h"

#include "input_error.h"

#include <algorithm>
#include <fmt/format.h>

namespace ellipsoid::post {

double porosity_of(double solid, double total) {
  constexpr double rounding = 1.0e-9;
  const double porosity = 1.0 - solid / total;
  if (!(porosity >= -rounding && porosity <= 1.0 + rounding))
    throw InputError(
        fmt::format("the porosity came out as {:.6g}, which is none (0 to 1): the region "
                    "({:.6g}) is smaller than what is in it ({:.6g}); finer --columns or "
                    "another --floor may help, else this is an error of the program",
                    porosity, total, solid));
  return std::clamp(porosity, 0.0, 1.0);
}

} // namespace ellipsoid::post
