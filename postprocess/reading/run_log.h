// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <map>
#include <string>

namespace ellipsoid::post {

/// What a LIGGGHTS log file tells about a run.
struct RunLog {
  std::string path;
  std::string version;                          ///< first line that names LIGGGHTS
  std::map<std::string, std::string> variables; ///< values that were put in for ${name}
  double loop_time = 0.0;                       ///< of all run commands together (s)
  int ranks = 0;                                ///< MPI processes of the last run command
};

/// Reads a log file. Throws InputError when it cannot be read.
RunLog read_run_log(const std::string& path);

/// The first file "log.*" or "*.log" in the folder of a dump, or an empty string.
std::string log_beside(const std::string& dump);

} // namespace ellipsoid::post
