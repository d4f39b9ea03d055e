// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "wall_law.h"

#include <algorithm>
#include <cstdlib>
#include <map>

namespace ellipsoid_host {

namespace {

/// Number of words that begin at `at` and are no part of the law; 0: a part of it.
std::size_t words_beside_law(const std::vector<std::string>& words, std::size_t at) {
  static const std::map<std::string, std::size_t> counts{{"mesh", 1},
                                                         {"n_meshes", 2},
                                                         {"track_energy", 1},
                                                         {"shear", 3},
                                                         {"temperature", 2},
                                                         {"store_force", 2},
                                                         {"store_force_contact", 2},
                                                         {"store_force_contact_every", 2},
                                                         {"store_force_contact_stress", 2},
                                                         {"allow_special_domain_periodic", 2}};
  const std::string& word = words[at];
  if (word == "primitive") { // type T SHAPE, the position of a plane; radius and axis of a cylinder
    constexpr std::size_t shape = 3;
    const bool is_plane =
        at + shape < words.size() && words[at + shape].find("plane") != std::string::npos;
    return shape + (is_plane ? 2 : 4);
  }
  if (word == "contact_area")
    return at + 1 < words.size() && words[at + 1] == "constant" ? 3 : 2;
  if (word == "meshes") {
    const auto number = std::find(words.begin(), words.end(), "n_meshes");
    return 1 + (words.end() - number > 1
                    ? static_cast<std::size_t>(std::atoi((number + 1)->c_str()))
                    : 0);
  }
  const auto found = counts.find(word);
  return found == counts.end() ? 0 : found->second;
}

} // namespace

std::string wall_law(const std::vector<std::string>& words) {
  std::string law;
  for (std::size_t k = 0; k < words.size();) {
    const std::size_t beside = words_beside_law(words, k);
    if (beside == 0)
      law += (law.empty() ? "" : " ") + words[k];
    k += std::max<std::size_t>(1, beside);
  }
  return law;
}

} // namespace ellipsoid_host
