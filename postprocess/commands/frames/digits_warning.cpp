// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "digits_warning.h"

#include "messages.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>

namespace ellipsoid::post {
namespace {

/// The warning, or an empty string.
std::string digits_warning(const Frame& frame, const ParticleSet& set) {
  constexpr std::size_t sampled = 200;
  bool is_six_digits = true, is_single = true;
  double farthest = 0.0;
  for (std::size_t k = 0; k < std::min(sampled, set.particles.size()); ++k)
    for (const double x : {set.particles[k].centre.x, set.particles[k].centre.y}) {
      is_six_digits = is_six_digits && std::strtod(fmt::format("{:.6g}", x).c_str(), nullptr) == x;
      is_single = is_single && static_cast<double>(static_cast<float>(x)) == x;
      farthest = std::max(farthest, std::abs(x));
    }
  if (!(is_six_digits || is_single) || !(farthest > 0.0))
    return "";
  const double error =
      is_single ? farthest * 6e-8 : 0.5 * std::pow(10.0, std::floor(std::log10(farthest)) - 5.0);
  const double b = mean_smallest_axis(set, all_members(set));
  return fmt::format("{}: positions have {}, an error of {:.1e} b: contacts and overlaps from them "
                     "are blurred; use a text dump with `dump_modify ID format \"... %.16g ...\"`",
                     frame.location.file, is_single ? "single precision" : "six digits", error / b);
}

} // namespace

void warn_of_digits(const ChosenFrame& chosen) {
  const std::string warning = digits_warning(chosen.frame, chosen.set);
  if (!warning.empty())
    report_warning(warning, "digits of " + chosen.frame.location.file); // once per file is enough
}

void warn_of_own_images(const ChosenFrame& chosen, const ContactNetwork& network) {
  if (network.reaches_itself)
    report_warning(chosen.run +
                       ": the box repeats so closely that particles come near their own images; "
                       "contacts with these are not counted",
                   "images of " + chosen.run);
}

} // namespace ellipsoid::post
