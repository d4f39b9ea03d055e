// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "new_numbers.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix_contact_history.h"
#include "force.h"
#include "modify.h"
#include "pair.h"

#include <vector>

using namespace LAMMPS_NS;

namespace ellipsoid_host {

namespace {

constexpr char history_style[] = "contacthistory";

/// The numbers are a protected member of the host's class: a derived class may reach them.
struct Partners : FixContactHistory {
  static int& number(FixContactHistory& fix, int i, int k) {
    return (fix.*(&Partners::partner_))[i][k];
  }
};

int new_number(const NewNumbers& numbers, int old) {
  const auto found = numbers.find(old);
  return found == numbers.end() ? 0 : found->second; // no particle has the number 0
}

std::array<double, 3> position(const Atom& atom, int i) {
  return {atom.x[i][0], atom.x[i][1], atom.x[i][2]};
}

/// Whether a particle of any rank has a contact history.
bool any_partners(const LAMMPS& lmp, FixContactHistory* histories) {
  int mine = 0, any = 0;
  for (int i = 0; histories && i < lmp.atom->nlocal; ++i)
    mine += histories->n_partner(i) > 0 ? 1 : 0;
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_SUM, lmp.world);
  return any > 0;
}

} // namespace

Renumbering::Renumbering(LAMMPS* lmp, bool numbers_anew) : lmp_(lmp), numbers_anew_(numbers_anew) {
  int dimension = 0;
  Fix* histories = lmp->modify->find_fix_style_strict(history_style, 0);
  const void* flag =
      lmp->force->pair && histories ? lmp->force->pair->extract("computeflag", dimension) : nullptr;
  if (flag && *static_cast<const int*>(flag) == 0)
    lmp->error->all(FLERR, "command delete_atoms: neighbour lists are not those of the present "
                           "particles, and contact histories would be lost; add 'run 0' before");
  if (histories)
    histories->setup_pre_exchange();
  for (int k = 0; k < lmp->modify->nfix; ++k)
    if (dynamic_cast<KnowsNumbers*>(lmp->modify->fix[k]))
      lmp->modify->fix[k]->setup_pre_exchange();
  // the host does this once more, with the same lists
  numbers_anew_ = any_partners(*lmp, static_cast<FixContactHistory*>(histories)) && numbers_anew;
  const Atom& atom = *lmp->atom;
  for (int i = 0; numbers_anew_ && i < atom.nlocal; ++i)
    old_numbers_[position(atom, i)] = atom.tag[i];
}

NewNumbers Renumbering::gather() const {
  const Atom& atom = *lmp_->atom;
  std::vector<int> mine; // old, new
  for (int i = 0; i < atom.nlocal; ++i)
    mine.insert(mine.end(), {old_numbers_.at(position(atom, i)), atom.tag[i]});
  const int count = static_cast<int>(mine.size());
  std::vector<int> counts(static_cast<std::size_t>(lmp_->comm->nprocs)), begins(counts.size());
  MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, lmp_->world);
  int total = 0;
  for (std::size_t rank = 0; rank < counts.size(); ++rank) {
    begins[rank] = total;
    total += counts[rank];
  }
  std::vector<int> all(static_cast<std::size_t>(total));
  MPI_Allgatherv(mine.data(), count, MPI_INT, all.data(), counts.data(), begins.data(), MPI_INT,
                 lmp_->world);
  NewNumbers numbers;
  for (std::size_t k = 0; k < all.size(); k += 2)
    numbers[all[k]] = all[k + 1];
  return numbers;
}

void Renumbering::finish() {
  if (!numbers_anew_)
    return;
  const NewNumbers numbers = gather();
  Fix* const fix = lmp_->modify->find_fix_style_strict(history_style, 0);
  if (!fix)
    return;
  auto& histories = *static_cast<FixContactHistory*>(fix);
  for (int i = 0; i < lmp_->atom->nlocal; ++i)
    for (int k = 0; k < histories.n_partner(i); ++k) {
      int& number = Partners::number(histories, i, k);
      number = new_number(numbers, number);
    }
  for (int k = 0; k < lmp_->modify->nfix; ++k)
    if (auto* knows = dynamic_cast<KnowsNumbers*>(lmp_->modify->fix[k]))
      knows->renumber(numbers);
}

} // namespace ellipsoid_host
