// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "neighbour_pairs.h"

using namespace LIGGGHTS;

void NeighbourPairs::restart(std::size_t particles) {
  active_.clear();
  checks_.restart(particles, [this](const auto& visit) { for_each_in_lists(visit); });
}
