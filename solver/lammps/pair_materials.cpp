// What pair_style and pair_coeff say, and the materials of atoms' types that come of it.
#include <algorithm>
#include <array>

#include "solver/lammps/fix_plumb_nve.hpp"

namespace plumb::lammps {

void PairPlumbCn::settings(int count, char** words) {
  try {
    arguments_ = scene::parse_pair_arguments(std::vector<std::string>(words, words + count));
  } catch (const scene::SceneError& refusal) {
    error->all(FLERR, said(fmt::format("{}: {}", refusal.field, refusal.what())));
  }
}

PairPlumbCn::TypeRanges PairPlumbCn::types_of(int count, char** words) {
  require(count >= 2, "pair_coeff needs two types, or * *");
  const int types = atom->ntypes;
  if (allocated == 0) {
    memory->create(setflag, types + 1, types + 1, "pair:setflag");
    memory->create(cutsq, types + 1, types + 1, "pair:cutsq");
    for (int type = 0; type <= types; ++type) std::fill_n(setflag[type], types + 1, 0);
    allocated = 1;
  }
  TypeRanges out;
  for (std::size_t k = 0; k < 2; ++k)
    LAMMPS_NS::utils::bounds(FLERR, words[k], 1, types, out.low[k], out.high[k], error);
  return out;
}

void PairPlumbCn::coeff(int count, char** words) {
  const auto [low, high] = types_of(count, words);
  try {
    const auto given = scene::parse_material_arguments(std::vector<std::string>(words + 2, words + count));
    const bool are_same = low[0] == low[1] && high[0] == high[1];
    if (!are_same && low[0] <= high[1] && low[1] <= high[0])
      throw scene::SceneError(
          "types", "must be the same twice, for their materials, or none in common, for what is between them");
    for (int i = low[0]; i <= high[0]; ++i)
      for (int j = low[1]; j <= high[1]; ++j) {
        setflag[std::min(i, j)][std::max(i, j)] = 1;
        if (!are_same || i == j) give(std::min(i, j), std::max(i, j), given, count > 2);
      }
  } catch (const scene::SceneError& refusal) {
    error->all(FLERR, fmt::format("pair_coeff {} {}: {}: {}", words[0], words[1], refusal.field, refusal.what()));
  }
}

void PairPlumbCn::give(int type1, int type2, const scene::MaterialArguments& arguments, bool has_any) {
  if (materials_.empty() && !has_any) return;
  if (materials_.empty())
    for (int type = 1; type <= atom->ntypes; ++type)
      materials_.push_back({.name = fmt::format("type {}", type), .density = {}, .is_rigid = false, .effects = {}});
  const std::size_t first = index(type1) - 1, second = index(type2) - 1;
  if (first == second) {
    materials_[first].is_rigid = arguments.is_rigid;
    materials_[first].effects = arguments.effects;
    return;
  }
  if (arguments.is_rigid) throw scene::SceneError("rigid", "is of one type: pair_coeff I I rigid yes");
  std::erase_if(material_pairs_,
                [&](const scene::MaterialPair& pair) { return pair.between == std::array{first, second}; });
  if (has_any) material_pairs_.push_back({{first, second}, arguments.effects});
}

std::vector<scene::PartMaterial> PairPlumbCn::counted_materials() const {
  const std::size_t types = materials_.size();
  std::vector<long long> here(2 * types), all(2 * types);
  for (int i = 0; i < atom->nlocal && types > 0; ++i)
    if (is_body(i)) ++here[(is_fixed(i) ? types : 0) + index(atom->type[i]) - 1];
  const long long some = 2;  // that may meet each other
  for (const NewBody& one : motion_->new_bodies())
    if (comm->me == 0 && types > 0) here[index(one.type) - 1] += some;
  MPI_Allreduce(here.data(), all.data(), static_cast<int>(all.size()), MPI_LONG_LONG, MPI_SUM, world);
  std::vector<scene::PartMaterial> out;
  for (std::size_t k = 0; k < types; ++k)
    out.push_back({materials_[k], static_cast<std::size_t>(all[k]), static_cast<std::size_t>(all[types + k])});
  return out;
}

}  // namespace plumb::lammps
