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

} // namespace ellipsoid::post
