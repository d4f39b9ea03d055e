// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "paper_parameters.h"

#include "whole_token.h"

#include <cmath>
#include <fmt/format.h>

namespace ellipsoid::post {
namespace {

/// A variable of inputs/piling.in with the paper's value (SI units).
struct PaperParameter {
  const char *variable, *name;
  double value;
};

constexpr PaperParameter paper_parameters[] = {
    {"particles", "particles", 1000.0},
    {"a", "semi-axis a", 2.7e-3},
    {"b", "semi-axis b", 1.15e-3},
    {"mass", "mass", 2e-5},
    {"Imax", "largest moment of inertia", 3.445e-11},
    {"Imin", "smallest moment of inertia", 1.058e-11},
    {"E", "Young's modulus", 183e6},
    {"nu", "Poisson's ratio", 0.20},
    {"mu", "coefficient of friction", 0.3},
    {"eta_n", "normal damping", 100.0},
    {"eta_t", "tangential damping", 100.0},
    {"y0", "height of the drop", 0.150},
    {"interval", "time between drops", 0.04},
    {"settle", "time to settle", 10.0},
    {"g", "gravity", 9.81},
};

/// Words with the paper's choice.
constexpr const char* paper_words[][3] = {{"direction", "direction of friction", "displacement"},
                                          {"spacing", "spacing of sub-spheres", "paper"}};

} // namespace

std::optional<std::vector<std::string>> differences_from_paper(const RunLog& log) {
  constexpr double same = 1e-9; // of the value: the log has the digits that were typed
  std::vector<std::string> differences;
  for (const PaperParameter& parameter : paper_parameters) {
    const auto found = log.variables.find(parameter.variable);
    const auto value =
        found == log.variables.end() ? std::nullopt : whole_token<double>(found->second);
    if (!value)
      return std::nullopt;
    if (std::abs(*value - parameter.value) > same * parameter.value)
      differences.push_back(
          fmt::format("{} {:g} (paper: {:g})", parameter.name, *value, parameter.value));
  }
  for (const auto& [variable, name, word] : paper_words)
    if (const auto found = log.variables.find(variable);
        found != log.variables.end() && found->second != word)
      differences.push_back(fmt::format("{} {} (paper: {})", name, found->second, word));
  return differences;
}

} // namespace ellipsoid::post
