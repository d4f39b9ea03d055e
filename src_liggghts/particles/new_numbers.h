// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// `delete_atoms` numbers the remaining particles anew, while contact histories know partners by
// their numbers: they are given the new ones.
#pragma once

#include <array>
#include <map>
#include <unordered_map>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace ellipsoid_host {

/// New numbers by old ones; those of deleted particles are missing.
using NewNumbers = std::unordered_map<int, int>;

/// A fix that knows particles by their numbers.
class KnowsNumbers {
 public:
  virtual ~KnowsNumbers() = default;
  virtual void renumber(const NewNumbers& numbers) = 0;
};

/// Lives as long as the host deletes particles; where it numbers them anew they do not move
/// meanwhile.
class Renumbering {
 public:
  /// Hands the histories from the neighbour lists to the particles; stops with one line if these
  /// are not the particles of the lists any more.
  /// @param[in] numbers_anew false: particles keep their numbers
  Renumbering(LAMMPS_NS::LAMMPS* lmp, bool numbers_anew);
  /// Whether there are contacts that know partners by numbers which change.
  bool is_needed() const { return numbers_anew_; }
  /// Gives the contact histories the new numbers. Called on all ranks.
  void finish();

 private:
  LAMMPS_NS::LAMMPS* lmp_;
  bool numbers_anew_;
  std::map<std::array<double, 3>, int> old_numbers_; // by position, of the particles of this rank

  NewNumbers gather() const;
};

} // namespace ellipsoid_host
