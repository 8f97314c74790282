#include "solver/lammps/superellipsoid/pair_plumb_superellipsoid.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "solver/scene/body/mass.hpp"

namespace plumb::lammps {

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
  return given_[static_cast<std::size_t>(low * (atom->ntypes + 1) + high)];
}

void PairPlumbSuperellipsoid::coeff(int count, char** words) {
  TypeRanges types = types_of(count, words);
  if (types.low == types.high && types.low[0] > types.low[1]) {  // 2 1 is 1 2
    std::swap(types.low[0], types.low[1]);
    types.high = types.low;
  }
  given_.resize(static_cast<std::size_t>((atom->ntypes + 1) * (atom->ntypes + 1)));
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
  const EllipsoidBonus shapes(*atom);
  if (!shapes.is_there() || n1 < 0 || n2 < 0 || density < 0) return;  // what is missing is said later
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!is_body(i) || atom->ellipsoid[i] < 0) continue;
    for (const int exponent : {n1, n2})
      if (atom->dvector[exponent][i] == 0) atom->dvector[exponent][i] = 2;
    if (atom->dvector[density][i] != 0) continue;
    const auto [a, b, c] = shapes.semi_axes(i);
    const Superellipsoid<double> shape{{a, b, c}, atom->dvector[n1][i], atom->dvector[n2][i]};
    atom->dvector[density][i] = atom->rmass[i] / scene::mass_properties(shape).volume;
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
