// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

namespace ellipsoid::post {

/// A check of an option's value by a function that throws for what it refuses.
CLI::Validator check_by(std::function<void(const std::string&)> parse);

} // namespace ellipsoid::post
