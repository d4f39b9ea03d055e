// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <string>

namespace ellipsoid::post {

/// Bytes as base64 text (RFC 4648).
std::string base64(const std::string& bytes);

} // namespace ellipsoid::post
