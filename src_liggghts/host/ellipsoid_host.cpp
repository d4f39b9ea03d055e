// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "ellipsoid_host.h"

#include "fix_property_global.h"
#include "lammps.h"
#include "whole_number.h"

#include <cmath>
#include <cstdlib>
#include <sstream>

using namespace LAMMPS_NS;

namespace ellipsoid_host {

namespace {

std::string readable(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

enum class Range { positive, not_negative };

/// Table [type][type] of a global property, every entry finite and within the range.
MatrixProperty* checked_per_type_pair(PropertyRegistry& registry, const char* name,
                                      const char* caller, Range range, const char* unit) {
  MatrixProperty* matrix = MODEL_PARAMS::createPerTypePairProperty(registry, name, caller);
  const bool zero = range == Range::not_negative;
  for (int i = 1; i <= registry.max_type(); ++i)
    for (int j = 1; j <= registry.max_type(); ++j) {
      const double value = matrix->data[i][j];
      if (std::isfinite(value) && (value > 0.0 || (zero && value == 0.0)))
        continue;
      const std::string message =
          std::string("property/global ") + name + " for types " + std::to_string(i) + " and " +
          std::to_string(j) + " is " + readable(value) + ": " + caller + " needs finite values " +
          (zero ? ">= 0 (" : "> 0 (") + unit + "); correct the fix property/global";
      registry.getLAMMPS()->error->all(FLERR, message.c_str());
    }
  return matrix;
}

} // namespace

MatrixProperty* viscous_damping_normal(PropertyRegistry& registry, const char* caller, bool) {
  return checked_per_type_pair(registry, "viscousDampingNormal", caller, Range::not_negative,
                               "1/time");
}

MatrixProperty* viscous_damping_tangential(PropertyRegistry& registry, const char* caller, bool) {
  return checked_per_type_pair(registry, "viscousDampingTangential", caller, Range::not_negative,
                               "1/time");
}

MatrixProperty* spring_stiffness_normal(PropertyRegistry& registry, const char* caller, bool) {
  return checked_per_type_pair(registry, "springStiffnessNormal", caller, Range::positive,
                               "force/length");
}

MatrixProperty* spring_stiffness_tangential(PropertyRegistry& registry, const char* caller, bool) {
  return checked_per_type_pair(registry, "springStiffnessTangential", caller, Range::not_negative,
                               "force/length");
}

void ArgumentReader::complain(const std::string& message) const {
  error_->all(FLERR, (title_ + message).c_str());
  std::abort(); // not reached: the call above ends the program
}

std::string ArgumentReader::keyword() { return arguments_[index_++]; }

std::string ArgumentReader::word(const std::string& keyword) {
  if (done())
    complain("keyword '" + keyword + "' lacks a value at the end of the command; add it");
  return arguments_[index_++];
}

double ArgumentReader::number(const std::string& keyword, double smallest, double largest) {
  const std::string token = word(keyword);
  const std::optional<double> value = whole_number(token.c_str());
  if (value && *value >= smallest && *value <= largest)
    return *value;
  std::string range = "a finite number";
  if (smallest > -HUGE_VAL)
    range += " >= " + readable(smallest);
  if (largest < HUGE_VAL)
    range += " <= " + readable(largest);
  complain("keyword '" + keyword + "' has the value '" + token + "', allowed is " + range);
}

double ArgumentReader::positive(const std::string& keyword) {
  const double value = number(keyword, -HUGE_VAL, HUGE_VAL);
  if (value <= 0.0)
    complain("keyword '" + keyword + "' has the value '" + arguments_[index_ - 1] +
             "', allowed is a finite number > 0");
  return value;
}

int ArgumentReader::integer(const std::string& keyword, int smallest, int largest) {
  const std::string token = word(keyword);
  const std::optional<long> value = whole_integer(token.c_str());
  if (value && *value >= smallest && *value <= largest)
    return static_cast<int>(*value);
  complain("keyword '" + keyword + "' has the value '" + token + "', allowed is an integer from " +
           std::to_string(smallest) + " to " + std::to_string(largest));
}

int ArgumentReader::choice(const std::string& keyword, const std::vector<std::string>& options) {
  const std::string token = word(keyword);
  std::string list;
  for (std::size_t k = 0; k < options.size(); ++k) {
    if (token == options[k])
      return static_cast<int>(k);
    list += (k ? ", '" : "'") + options[k] + "'";
  }
  complain("keyword '" + keyword + "' has the value '" + token + "', allowed is one of " + list);
}

} // namespace ellipsoid_host
