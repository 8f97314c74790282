#include "solver/lammps/superellipsoid/coefficients.hpp"

#include <cmath>

#include "solver/lammps/pair_arguments.hpp"

namespace plumb::scene {
namespace {

/// The words that are still to be read.
struct CoefficientWords {
  std::span<const std::string> left;

  std::string next(const std::string& after) {
    if (left.empty()) throw SceneError(after, "needs a word after it");
    const std::string word = left.front();
    left = left.subspan(1);
    return word;
  }
  double number(const std::string& after) {
    const double number = number_of(after, next(after));
    if (number < 0) throw SceneError(after, "must be a number, 0 or more");
    return number;
  }
};

void read_tangential(CoefficientWords& words, SuperellipsoidCoefficients& out) {
  const std::string model = words.next("tangential");
  if (model != "linear_history")
    throw SceneError("tangential", "'" + model + "' is not in LAMMPS's manual: use linear_history");
  out.tangential_stiffness = words.number(model);
  out.damping_share = words.number(model);
  out.friction = words.number(model);
  if (out.friction > 0 && out.tangential_stiffness == 0) throw SceneError(model, "friction needs a stiffness above 0");
}

void read_damping(CoefficientWords& words, SuperellipsoidCoefficients& out) {
  const std::string model = words.next("damping");
  if (model != "mass_velocity" && model != "viscoelastic")
    throw SceneError("damping", "must be mass_velocity or viscoelastic");
  out.is_by_mass = model == "mass_velocity";
}

}  // namespace

SuperellipsoidCoefficients parse_superellipsoid_coefficients(std::span<const std::string> all) {
  SuperellipsoidCoefficients out;
  CoefficientWords words{all};
  const std::string model = words.next("pair_coeff");
  if (model != "hooke" && model != "hertz") throw SceneError(model, "must be hooke or hertz");
  out.is_hertz = model == "hertz";
  out.stiffness = words.number(model);
  out.damping = words.number(model);
  while (!words.left.empty()) {
    const std::string name = words.next(model);
    if (name == "tangential")
      read_tangential(words, out);
    else if (name == "damping")
      read_damping(words, out);
    else if (name == "cutoff")
      (void)words.number(name);
    else if (name == "limit_damping")
      out.is_limited = true;
    else
      throw SceneError(name, "must be tangential, damping, limit_damping or cutoff");
  }
  if (out.stiffness == 0 && out.damping > 0) throw SceneError(model, "a dashpot needs a stiffness above 0");
  return out;
}

SuperellipsoidCoefficients mixed(const SuperellipsoidCoefficients& first, const SuperellipsoidCoefficients& second) {
  if (first.is_hertz != second.is_hertz || first.is_by_mass != second.is_by_mass)
    throw SceneError("types", "have different models: say by pair_coeff I J what is between them");
  SuperellipsoidCoefficients out = first;
  out.is_limited = first.is_limited || second.is_limited;
  for (double SuperellipsoidCoefficients::* field :
       {&SuperellipsoidCoefficients::stiffness, &SuperellipsoidCoefficients::damping,
        &SuperellipsoidCoefficients::tangential_stiffness, &SuperellipsoidCoefficients::damping_share,
        &SuperellipsoidCoefficients::friction})
    if (first.*field != second.*field) out.*field = std::sqrt(first.*field) * std::sqrt(second.*field);
  return out;
}

/// Neutral ones too: what a pair has not is mixed from its types.
Effects effects_of(const SuperellipsoidCoefficients& of) {
  Effects out;
  if (of.is_hertz)
    out.hertz = Hertz{.youngs_modulus = 1.5 * of.stiffness, .poissons_ratio = 0};  // E* = E / 2
  else
    out.linear = Linear{of.stiffness};
  out.damping = Damping{.pull = of.is_limited ? 0.0 : 1.0};
  (of.is_by_mass ? out.damping->mass_velocity : out.damping->viscoelastic) = of.damping;
  out.friction =
      Friction{.coefficient = of.friction, .stiffness = of.tangential_stiffness, .normal_share = of.damping_share};
  return out;
}

}  // namespace plumb::scene
