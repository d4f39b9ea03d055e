// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

namespace ellipsoid::post {

/// A check of an option's value by a function that throws for what it refuses.
CLI::Validator check_by(std::function<void(const std::string&)> parse);

/// Refuses options that were given although they have no effect there: wrong usage.
/// @param[in] reason completes "--option has no effect "
void refuse_without_effect(const CLI::App& command, const std::vector<std::string>& options,
                           const std::string& reason);

/// Whether both bounds of a pair may be the same.
enum class EqualBounds { refused, allowed };

/// Refuses pairs of bounds, one after the other, whose lower one does not come first.
/// Throws InputError that names the option and the pair.
void require_ascending_pairs(const std::string& option, const std::vector<double>& bounds,
                             EqualBounds equal = EqualBounds::refused);

} // namespace ellipsoid::post
