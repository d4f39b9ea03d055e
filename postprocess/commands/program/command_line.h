// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <string>
#include <vector>

namespace ellipsoid::post {

/// Keeps the words of the command line, for results that say how they were made.
void remember_command_line(std::vector<std::string> words);

/// The command line as one types it in a shell, with file names where the shell expanded a pattern.
std::string command_line();

} // namespace ellipsoid::post
