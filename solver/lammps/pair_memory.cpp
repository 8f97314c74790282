// What contacts remember, by the IDs of their atoms: with the atoms between two lists of neighbours, in the part in the meantime.
//
// A contact across a periodic border is solved on both sides from positions that differ in last bits, and so do its memories. Before
// atoms move between processes the side of the lower ID tells the other: which of them goes on must not hang on who owns what.
#include "solver/lammps/fix_plumb_nve.hpp"

#include <domain.h>

namespace plumb::lammps {
namespace {

/// Of an atom: its ID, then a row for each contact.
std::span<const double> rows_of(const std::vector<double>& memory) {
  return std::span(memory).subspan(memory.empty() ? 0 : 1);
}

/// The row that begins with the key, without it; empty where none does.
std::span<const double> find_row(std::span<const double> rows, double key, std::size_t width) {
  for (; !rows.empty(); rows = rows.subspan(width))
    if (rows[0] == key) return rows.subspan(1, width - 1);
  return {};
}

}  // namespace

double PairPlumbCn::key_of(std::uint32_t body, std::size_t place) const {
  constexpr double places = 64;  // of a wall: more than any has
  if (body < atom_of_body_.size()) return static_cast<double>(atom->tag[atom_of_body_[body]]);
  return -1.0 - static_cast<double>(body - atom_of_body_.size()) - static_cast<double>(place) / places;
}

std::size_t PairPlumbCn::place_of(std::size_t contact) const {
  const auto& pairs = part_->world().contacts.pairs;
  std::size_t place = 0;
  while (place < contact && pairs[contact - place - 1] == pairs[contact]) ++place;
  return place;
}

void PairPlumbCn::recall() {
  const auto& pairs = part_->world().contacts.pairs;
  for (std::size_t c = 0; c < pairs.size(); ++c) {
    const auto [a, b] = pairs[c];
    const std::uint32_t mine = is_owned(a) ? a : b;
    const std::vector<double>& memory = motion_->memory_of(atom_of_body_[mine]);
    if (!memory.empty() && memory[0] != key_of(mine))
      error->one(FLERR, said("atoms have other IDs than in the run before, by which contacts "
                             "are known: use `delete_atoms .. compress no`"));
    const auto row = find_row(rows_of(memory), key_of(mine == a ? b : a, place_of(c)), row_width());
    if (!row.empty()) part_->set_history(c, row);
  }
}

void PairPlumbCn::remember() {
  store();
  is_stale_ = true;
}

void PairPlumbCn::note(std::uint32_t mine, double other, std::span<const double> row) {
  std::vector<double>& memory = motion_->memory_of(atom_of_body_[mine]);
  if (memory.empty()) memory.push_back(key_of(mine));
  memory.push_back(other);
  memory.insert(memory.end(), row.begin(), row.end());
}

void PairPlumbCn::store() {
  if (is_stale_) return;  // the atoms have it: nothing was pressed since
  motion_->forget_all();
  const bool has_borders = domain->xperiodic + domain->yperiodic + domain->zperiodic > 0;
  const auto is_told = [&](std::uint32_t a) { return has_borders && !is_owned(a); };
  std::vector<double> row(part_->history_width());
  const auto& pairs = part_->world().contacts.pairs;
  for (std::size_t c = 0; c < pairs.size(); ++c) {
    if (!part_->has_history(c)) continue;
    part_->history(c, row);
    const auto [a, b] = pairs[c];
    if (is_owned(a)) note(a, key_of(b, place_of(c)), row);
    if (is_owned(b) && !is_told(a)) note(b, key_of(a), row);
  }
  if (has_borders) ask_ghosts();
}

void PairPlumbCn::ask_ghosts() {
  std::vector<std::vector<double>> rows(index(atom->nlocal + atom->nghost));
  const auto& pairs = part_->world().contacts.pairs;
  for (const auto& [a, b] : pairs) {
    if (!is_owned(a) || is_owned(b) || b >= atom_of_body_.size()) continue;
    const auto row = find_row(rows_of(motion_->memory_of(atom_of_body_[a])), key_of(b), row_width());
    if (row.empty()) continue;
    std::vector<double>& out = rows[index(atom_of_body_[a])];
    out.push_back(key_of(b));
    out.insert(out.end(), row.begin(), row.end());
  }
  motion_->share(rows, row_width());
  for (const auto& [a, b] : pairs) {
    if (is_owned(a)) continue;
    const auto row = find_row(rows[index(atom_of_body_[a])], key_of(b), row_width());
    if (!row.empty()) note(b, key_of(a), row);
  }
}

}  // namespace plumb::lammps
