// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <string>
#include <vector>

namespace ellipsoid::post {

/// Prints "error: ..." on standard error.
void report_error(const std::string& message);
/// Prints "warning: ..." on standard error; of several with the same `once_for` only the first.
/// From a measure in a thread: when it is the frame's turn, see KeepWarnings.
void report_warning(const std::string& message, const std::string& once_for = "");

struct Warning {
  std::string message, once_for;
};

/// As long as it lives, nothing is printed.
class MuteMessages {
 public:
  MuteMessages();
  ~MuteMessages();
  MuteMessages(const MuteMessages&) = delete;
  MuteMessages& operator=(const MuteMessages&) = delete;
};

/// Prints a warning that was kept.
void print(const Warning& warning);

/// As long as it lives, the warnings of its thread go to a list instead.
class KeepWarnings {
 public:
  explicit KeepWarnings(std::vector<Warning>& kept);
  ~KeepWarnings();
  KeepWarnings(const KeepWarnings&) = delete;
  KeepWarnings& operator=(const KeepWarnings&) = delete;
};

} // namespace ellipsoid::post
