// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "progress_line.h"

#include <cstdio>
#include <fmt/format.h>
#include <unistd.h>

namespace ellipsoid::post {

void show_progress_line(const std::string& text) {
  if (isatty(STDERR_FILENO) == 0)
    return;
  fmt::print(stderr, "\r{:70}\r{}", "", text);
  std::fflush(stderr);
}

void clear_progress_line() { show_progress_line(""); }

} // namespace ellipsoid::post
