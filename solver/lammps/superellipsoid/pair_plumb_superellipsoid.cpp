#include "solver/lammps/superellipsoid/pair_plumb_superellipsoid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "solver/scene/body/mass.hpp"

namespace plumb::lammps {
namespace {

/// Of an atom whose shape is one. Exponents are 2 where none were set.
std::optional<double> volume_of(LAMMPS_NS::Atom& atom, int i) {
  if (atom.ellipsoid[i] < 0) return {};
  const auto [a, b, c] = EllipsoidBonus(atom).semi_axes(i);
  const double n1 = atom.dvector[vector_of(atom, "n1")][i], n2 = atom.dvector[vector_of(atom, "n2")][i];
  const bool is_unset = n1 == 0 && n2 == 0;
  const Body body{{{a, b, c}, is_unset ? 2 : n1, is_unset ? 2 : n2}};
  if (!find_input_error({body, body}).reason.empty()) return {};
  return scene::mass_properties(body.shape).volume;
}

}  // namespace

void PairPlumbSuperellipsoid::settings(int count, char** words) {
  using std::string_view_literals::operator""sv;
  constexpr std::array without_effect{"no_bounding_box"sv, "curvature_gaussian"sv, "geometric"sv};
  try {
    for (int k = 0; k < count; ++k)
      if (std::ranges::find(without_effect, words[k]) == without_effect.end())
        (void)scene::number_of("cutoff", words[k]);
  } catch (const scene::SceneError& refusal) {
    error->all(FLERR, said(fmt::format("{}: {}", refusal.field, refusal.what())));
  }
}

std::optional<scene::SuperellipsoidCoefficients>& PairPlumbSuperellipsoid::given(int type1, int type2) {
  const auto [low, high] = std::minmax(type1, type2);
  return given_[static_cast<std::size_t>(low) * row_of_types() + static_cast<std::size_t>(high)];
}

void PairPlumbSuperellipsoid::coeff(int count, char** words) {
  TypeRanges types = types_of(count, words);
  if (types.low == types.high && types.low[0] > types.low[1]) {  // 2 1 is 1 2
    std::swap(types.low[0], types.low[1]);
    types.high = types.low;
  }
  given_.resize(row_of_types() * row_of_types());
  try {
    const Coefficients coefficients =
        scene::parse_superellipsoid_coefficients(std::vector<std::string>(words + 2, words + count));
    for (int i = types.low[0]; i <= types.high[0]; ++i)
      for (int j = std::max(types.low[1], i); j <= types.high[1]; ++j) {
        given(i, j) = coefficients;
        setflag[i][j] = 1;
      }
    if (types.low[0] > types.high[1]) throw scene::SceneError("types", "are none: the lower ones come first");
  } catch (const scene::SceneError& refusal) {
    error->all(FLERR, fmt::format("pair_coeff {} {}: {}: {}", words[0], words[1], refusal.field, refusal.what()));
  }
}

std::optional<scene::SuperellipsoidCoefficients> PairPlumbSuperellipsoid::between(int type1, int type2) {
  if (const auto& own = given(type1, type2)) return own;
  const auto &first = given(type1, type1), &second = given(type2, type2);
  if (!first || !second) return {};
  try {
    return mixed(*first, *second);
  } catch (const scene::SceneError& refusal) {
    error->all(FLERR, fmt::format("pair_coeff {} {}: {}: {}", type1, type2, refusal.field, refusal.what()));
  }
  return {};
}

void PairPlumbSuperellipsoid::complete_shapes() const {
  const int n1 = vector_of(*atom, "n1"), n2 = vector_of(*atom, "n2"), density = vector_of(*atom, "density");
  if (!EllipsoidBonus(*atom).is_there() || n1 < 0 || n2 < 0 || density < 0) return;  // what is missing is said later
  for (int i = 0; i < atom->nlocal; ++i) {
    const auto volume = is_body(i) ? volume_of(*atom, i) : std::nullopt;
    if (!volume) continue;
    double &own1 = atom->dvector[n1][i], &own2 = atom->dvector[n2][i], &own_density = atom->dvector[density][i];
    if (own1 == 0 && own2 == 0) own1 = own2 = 2;
    if (own_density == 0) own_density = atom->rmass[i] / *volume;
  }
}

void weigh_by_density(LAMMPS_NS::Atom& atom) {
  constexpr double rounding = 1e-12;
  const int density = vector_of(atom, "density");
  for (int i = 0; i < atom.nlocal; ++i) {
    const auto volume = volume_of(atom, i);
    const double mass = atom.dvector[density][i] * volume.value_or(0);
    if (mass > 0 && std::abs(mass - atom.rmass[i]) > rounding * mass) atom.rmass[i] = mass;
  }
}

void PairPlumbSuperellipsoid::give_effects() {
  for (int i = 1; i <= atom->ntypes; ++i)
    for (int j = i; j <= atom->ntypes; ++j)
      if (const auto coefficients = between(i, j)) give(i, j, {effects_of(*coefficients), false}, true);
}

void PairPlumbSuperellipsoid::init_style() {
  complete_shapes();
  give_effects();
  PairPlumbCn::init_style();
}

}  // namespace plumb::lammps
