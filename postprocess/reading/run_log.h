// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "math/vector3.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ellipsoid::post {

/// What a LIGGGHTS log file tells about a run.
struct RunLog {
  std::string path;
  std::string version;                          ///< first line that names LIGGGHTS
  std::map<std::string, std::string> variables; ///< values that were put in for ${name}
  std::map<std::string, std::string> seeds;     ///< of random numbers, by the fix's ID and style
  double loop_time = 0.0;                       ///< of all run commands together (s)
  int ranks = 0;                                ///< MPI processes of the last run command
  std::optional<double> time_step;              ///< where all steps since step 0 had this one (s)
  std::optional<Vector3> gravity;               ///< of `fix gravity`, all fixes together
  std::string untold_gravity; ///< command of a `fix gravity` that the log does not tell
  std::optional<std::int64_t> wanted_step;  ///< at which the last run command was to end
  std::optional<std::int64_t> reached_step; ///< of the last line of thermo output

  /// Whether the last run command came to its end; nothing where the log does not tell.
  std::optional<bool> is_complete() const;
};

/// Reads a log file. Throws InputError when it cannot be read.
RunLog read_run_log(const std::string& path);

/// The log in the folder of a dump, read once for all its frames (from any thread); null where
/// there is none. Throws InputError when it cannot be read.
const RunLog* run_log_of(const std::string& dump);

/// The files "log.*" and "*.log" in the folder of a dump, in the order of their names.
std::vector<std::string> logs_beside(const std::string& dump);
/// The first of them, or an empty string.
std::string log_beside(const std::string& dump);

} // namespace ellipsoid::post
