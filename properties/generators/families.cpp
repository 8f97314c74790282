#include "properties/generators/families.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "properties/generators/draft.hpp"
#include "properties/generators/families_hard.hpp"
#include "solver/pose.hpp"

namespace plumb {
namespace family {

#define PLUMB_FAMILY(draw, ...) void draw(Stream&, Draft&);
#define PLUMB_FAMILY_OF_GENERATORS(...)
#include "properties/generators/family_rows.inc"
#undef PLUMB_FAMILY
#undef PLUMB_FAMILY_OF_GENERATORS

}  // namespace family
namespace {

constexpr auto kFamilies = std::to_array<Family>({
#define PLUMB_FAMILY(draw, name, per_minute, gated, summary) {name, summary, family::draw, nullptr, per_minute, gated},
#define PLUMB_FAMILY_OF_GENERATORS(generators, name, per_minute, gated, summary) \
  {name, summary, nullptr, generators, per_minute, gated},
#include "properties/generators/family_rows.inc"
#undef PLUMB_FAMILY
#undef PLUMB_FAMILY_OF_GENERATORS
});

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
  const Json from{{"family", hard_family}, {"generator", generator.name}, {"seed", seed}, {"index", index}};
  return finished(std::move(draft), fmt::format("{}/{}", hard_family, generator.name), from);
}

}  // namespace

std::span<const Family> families() {
  return kFamilies;
}

std::vector<std::string> family_names() {
  std::vector<std::string> out;
  for (const Family& family : kFamilies) out.emplace_back(family.name);
  return out;
}

const Family* find_family(std::string_view name) {
  const auto row = std::ranges::find(kFamilies, name, &Family::name);
  return row == kFamilies.end() ? nullptr : &*row;
}

std::vector<std::string_view> hard_generators() {
  std::vector<std::string_view> names;
  for (const HardGenerator& generator : hard_generator_table()) names.push_back(generator.name);
  return names;
}

Case generate(std::string_view name, std::uint64_t seed, std::uint64_t index) {
  const Family* row = find_family(name);
  if (row == nullptr) throw std::invalid_argument("no family named " + std::string(name));
  if (row->generators != nullptr) {
    const auto table = row->generators();
    return draw_hard(table[static_cast<std::size_t>(index % table.size())], std::nullopt, seed, index);
  }
  Stream stream(name, seed, index);
  Draft draft;
  row->draw(stream, draft);
  const Json from{{"family", name}, {"seed", seed}, {"index", index}};
  return finished(std::move(draft), std::string(name), from);
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
