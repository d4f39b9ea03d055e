// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "messages.h"

#include <fmt/format.h>
#include <set>

namespace ellipsoid::post {
namespace {

/// Where the warnings of this thread wait until those of the frames before have been printed.
thread_local std::vector<Warning>* waiting_warnings = nullptr;

bool is_muted = false;

} // namespace

MuteMessages::MuteMessages() { is_muted = true; }
MuteMessages::~MuteMessages() { is_muted = false; }

void report_error(const std::string& message) {
  if (!is_muted)
    fmt::print(stderr, "error: {}\n", message);
}

void print(const Warning& warning) {
  static std::set<std::string> known;
  if (is_muted)
    return;
  if (warning.once_for.empty() || known.insert(warning.once_for).second)
    fmt::print(stderr, "warning: {}\n", warning.message);
}

void report_warning(const std::string& message, const std::string& once_for) {
  if (waiting_warnings)
    waiting_warnings->push_back({message, once_for});
  else
    print({message, once_for});
}

KeepWarnings::KeepWarnings(std::vector<Warning>& kept) { waiting_warnings = &kept; }
KeepWarnings::~KeepWarnings() { waiting_warnings = nullptr; }

} // namespace ellipsoid::post
