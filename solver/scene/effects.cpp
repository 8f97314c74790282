#include <algorithm>
#include <array>

#include "solver/scene/effect.hpp"

namespace plumb::scene {
namespace {

template <auto member>
[[nodiscard]] constexpr Effect row() {
  using Parameters = typename std::remove_cvref_t<decltype(Effects{}.*member)>::value_type;
  return {Parameters::name,
          Mixes<Parameters>,
          [](const Effects& effects) { return (effects.*member).has_value(); },
          [](Effects& effects) {
            if (!(effects.*member)) (effects.*member).emplace();
          },
          [](const Effects& effects, const Scene& scene) { return role(*(effects.*member), scene); },
          [](const Effects& effects, World& world) { install(*(effects.*member), world); }};
}

// One row an effect, written by scene.cmake from effects.hpp: a build can leave one out to show that its absence changes nothing.
constexpr std::array list{
#include "effect_rows.inc"
};

}  // namespace

std::span<const Effect> effects() {
  return list;
}

const Effect* find_effect(std::string_view name) {
  const auto found = std::ranges::find(list, name, &Effect::name);
  return found == list.end() ? nullptr : &*found;
}

}  // namespace plumb::scene
