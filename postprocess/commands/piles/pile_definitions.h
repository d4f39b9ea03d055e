// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

namespace ellipsoid::post {

// What the commands on piles say about their definitions in --help.
extern const char* const repose_definition;
extern const char* const porosity_definition;
extern const char* const coordination_definition;
extern const char* const pile_definition;

} // namespace ellipsoid::post
