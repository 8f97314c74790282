#include "properties/generators/families.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "properties/generators/draft.hpp"
#include "properties/generators/families_hard.hpp"
#include "solver/pose.hpp"

namespace plumb {
namespace {

/// -ratio in a fifth of the draws: separated pairs.
double signed_ratio(Stream& stream, double low, double high) {
  const double ratio = stream.log_uniform(low, high);
  return stream.chance(0.2) ? -ratio : ratio;
}

/// The test bed of Lin & Ng and of Kildashti et al.: body 1 at the origin and unrotated, body 2 turned by Euler angles in
/// X-convention, a = b = 1, aspect c/a; overlap ratios as in the published study's wider range.
void draw_spheroid(Stream& stream, Draft& draft) {
  const double aspect = stream.log_uniform(1.0 / 3, 3), other = stream.log_uniform(1.0 / 3, 3);
  const bool equal = stream.chance(0.5);
  draft.pair.body1.shape.semi_axes[2] = aspect;
  draft.pair.body2.shape.semi_axes[2] = equal ? aspect : other;
  const Vec3<double> angles{stream.uniform(0, kTurn), std::acos(stream.uniform(-1, 1)), stream.uniform(0, kTurn)};
  draft.pair.body2.quaternion = quaternion_from_euler_zxz<double>(angles);
  draft.facts["euler_zxz"] = {angles[0], angles[1], angles[2]};
  place_on_random_line(stream, draft, stream.log_uniform(1e-3, 5e-2));
}

void draw_poses(Stream& stream, Pair& pair) {
  pair.body1.quaternion = random_rotation(stream);
  pair.body2.quaternion = random_rotation(stream);
  for (int i = 0; i < 3; ++i) pair.body1.position[i] = stream.uniform(-10, 10);
}

void draw_ellipsoid(Stream& stream, Draft& draft) {
  draft.pair.body1.shape = random_ellipsoid(stream, 20);
  draft.pair.body2.shape = random_ellipsoid(stream, 20);
  scale(draft.pair.body2.shape, stream.log_uniform(0.3, 3));
  draw_poses(stream, draft.pair);
  place_on_random_line(stream, draft, signed_ratio(stream, 1e-6, 0.5));
}

Superellipsoid<double> draw_superquadric_shape(Stream& stream) {
  const double share = stream.uniform();
  if (share < 0.15) return random_superellipsoid(stream, 5, 1.2, 2);
  if (share < 0.30) return random_superellipsoid(stream, 5, 8, 40);
  return random_superellipsoid(stream, 5, 2, 8);
}

void draw_superquadric(Stream& stream, Draft& draft) {
  draft.pair.body1.shape = draw_superquadric_shape(stream);
  draft.pair.body2.shape = draw_superquadric_shape(stream);
  scale(draft.pair.body2.shape, stream.log_uniform(0.3, 3));
  draw_poses(stream, draft.pair);
  place_on_random_line(stream, draft, signed_ratio(stream, 1e-6, 0.3));
}

constexpr std::array<Family, 4> kFamilies{{
    {"spheroid", "the published test bed at random: aspect 1/3..3, overlap ratio 1e-3..5e-2"},
    {"ellipsoid", "triaxial ellipsoids, aspect to 20, any poses, a fifth of them apart"},
    {"superquadric", "exponents mostly 2..8, some to 40, some 1.2..2, aspect to 5, a fifth of them apart"},
    {"hard", "the special places where published codes break, one generator for each"},
}};

Case finished(Draft&& draft, const std::string& kind, const Json& from) {
  Case out;
  out.name = kind + " seed " + from.at("seed").dump() + " index " + from.at("index").dump();
  out.pair = std::move(draft.pair);
  out.provenance = from;
  out.provenance.update(draft.facts);
  return out;
}

/// Between two neighbouring steps, on a logarithmic scale, or on one; the harder of the two in half of the draws.
double draw_knob(Stream& stream, std::span<const double> steps) {
  const std::size_t i = stream.below(steps.size() - 1);
  const double easy = steps[i], hard = steps[i + 1], share = stream.uniform();
  if (hard == 0 || stream.chance(0.5)) return hard;
  return std::exp(std::log(easy) + share * (std::log(hard) - std::log(easy)));
}

const HardGenerator& hard_generator(std::string_view name) {
  const auto table = hard_generator_table();
  const auto row = std::find_if(table.begin(), table.end(), [&](const auto& g) { return g.name == name; });
  if (row == table.end()) throw std::invalid_argument("no hard generator named " + std::string(name));
  return *row;
}

/// `knob`: nullopt draws one.
Case draw_hard(const HardGenerator& generator, std::optional<double> knob, std::uint64_t seed, std::uint64_t index) {
  Stream stream(generator.name, seed, index);
  Draft draft;
  const double drawn = draw_knob(stream, generator.steps), value = knob.value_or(drawn);
  draft.facts["knob"] = {{"name", generator.knob}, {"value", value}};
  generator.draw(stream, value, draft);
  const Json from{{"family", "hard"}, {"generator", generator.name}, {"seed", seed}, {"index", index}};
  return finished(std::move(draft), "hard/" + std::string(generator.name), from);
}

}  // namespace

std::span<const Family> families() {
  return kFamilies;
}

std::vector<std::string_view> hard_generators() {
  std::vector<std::string_view> names;
  for (const HardGenerator& generator : hard_generator_table()) names.push_back(generator.name);
  return names;
}

Case generate(std::string_view family, std::uint64_t seed, std::uint64_t index) {
  if (family == "hard") {
    const auto table = hard_generator_table();
    return generate_hard(table[static_cast<std::size_t>(index % table.size())].name, seed, index);
  }
  Stream stream(family, seed, index);
  Draft draft;
  if (family == "spheroid")
    draw_spheroid(stream, draft);
  else if (family == "ellipsoid")
    draw_ellipsoid(stream, draft);
  else if (family == "superquadric")
    draw_superquadric(stream, draft);
  else
    throw std::invalid_argument("no family named " + std::string(family));
  const Json from{{"family", family}, {"seed", seed}, {"index", index}};
  return finished(std::move(draft), std::string(family), from);
}

Case generate_hard(std::string_view generator, std::uint64_t seed, std::uint64_t index) {
  return draw_hard(hard_generator(generator), std::nullopt, seed, index);
}

std::span<const double> ladder_steps(std::string_view generator) {
  return hard_generator(generator).steps;
}

Case ladder_case(std::string_view generator, std::size_t step, std::uint64_t seed, std::uint64_t index) {
  const HardGenerator& row = hard_generator(generator);
  Case out = draw_hard(row, row.steps[step], seed, index);
  out.name += " step " + std::to_string(step + 1);
  out.provenance["step"] = step + 1;
  out.provenance["steps"] = row.steps.size();
  return out;
}

std::size_t step_of(std::string_view generator, double knob) {
  const std::span<const double> steps = hard_generator(generator).steps;
  const auto distance = [&](double step) {
    return step == knob ? 0 : step == 0 || knob == 0 ? HUGE_VAL : std::abs(std::log(step) - std::log(knob));
  };
  const auto nearest =
      std::min_element(steps.begin(), steps.end(), [&](double a, double b) { return distance(a) < distance(b); });
  return static_cast<std::size_t>(nearest - steps.begin());
}

}  // namespace plumb
