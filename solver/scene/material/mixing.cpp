#include "solver/scene/material/mixing.hpp"

#include <algorithm>
#include <cmath>

namespace plumb::scene {
namespace {

/// The slot of one effect. `Self` is Effects, const or not.
template <class Parameters, class Self>
auto& slot_of(Self& effects) {
  using Slot = std::conditional_t<std::is_const_v<Self>, const std::optional<Parameters>, std::optional<Parameters>>;
  Slot* found = nullptr;
  each_effect(effects, [&](auto& slot) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(slot)>, std::optional<Parameters>>) found = &slot;
  });
  return *found;
}

/// A material's own, or the scene's; of a rigid one what an elastic law says of it.
template <class Parameters>
std::optional<Parameters> own(const Scene& scene, const Material& material) {
  if constexpr (IsElastic<Parameters>)
    if (material.is_rigid) return Parameters::rigid();
  const auto& of_material = slot_of<Parameters>(material.effects);
  return of_material ? of_material : slot_of<Parameters>(scene.effects);
}

template <class Parameters>
void require_elastic(const Scene& scene, const Material& material, const Material& other) {
  if (material.is_rigid || own<Parameters>(scene, material)) return;
  throw SceneError("materials." + material.name + "." + std::string(Parameters::name),
                   "missing: it meets " + other.name + ", which has one");
}

template <class Parameters>
std::optional<Parameters> mixed_of(const Scene& scene, const Material& first, const Material& second) {
  const auto a = own<Parameters>(scene, first), b = own<Parameters>(scene, second);
  if constexpr (IsElastic<Parameters>) {
    const bool any = (a && !first.is_rigid) || (b && !second.is_rigid);
    if (!any) return std::nullopt;
    require_elastic<Parameters>(scene, first, second);
    require_elastic<Parameters>(scene, second, first);
  }
  if (!a && !b) return std::nullopt;
  if (&first == &second) return a;
  return Parameters::mixed(a.value_or(Parameters{}), b.value_or(Parameters{}));
}

bool has_elastic_law(const Effects& effects) {
  bool has = false;
  each_effect(effects, [&](const auto& slot) {
    if constexpr (IsElastic<typename std::remove_cvref_t<decltype(slot)>::value_type>) has = has || slot.has_value();
  });
  return has;
}

/// A law of one stiffness for the whole scene cannot leave the overlap to one of two.
void require_not_rigid(const Scene& scene, const Material& material) {
  const auto require_without = [&](const auto& law, std::string_view name) {
    if (!material.is_rigid || !law) return;
    throw SceneError("materials." + material.name + ".rigid",
                     std::string(name) + " has one stiffness for all: leave rigid out");
  };
  require_without(scene.effects.volume, Volume::name);
  require_without(scene.effects.foundation, Foundation::name);
}

Effects effects_between(const Scene& scene, std::size_t first, std::size_t second) {
  const Material &a = scene.materials[first], &b = scene.materials[second];
  require_not_rigid(scene, a);
  require_not_rigid(scene, b);
  const MaterialPair* given = given_pair(scene, first, second);
  const bool is_law_given = given != nullptr && has_elastic_law(given->effects);
  Effects out = scene.effects;
  each_effect(out, [&](auto& slot) {
    using Parameters = typename std::remove_cvref_t<decltype(slot)>::value_type;
    if constexpr (Mixes<Parameters>) {
      if (given != nullptr && slot_of<Parameters>(given->effects))
        slot = slot_of<Parameters>(given->effects);
      else if (IsElastic<Parameters> && is_law_given)
        slot.reset();
      else
        slot = mixed_of<Parameters>(scene, a, b);
    }
  });
  if (a.is_rigid && b.is_rigid && !has_elastic_law(out))
    throw SceneError("materials.pairs",
                     names_of_pair(scene, first, second) + " are rigid and can meet: give them linear or hertz here");
  return out;
}

/// Bodies that move, and all there is to meet, by material.
struct Counts {
  std::vector<std::size_t> movable, all;

  explicit Counts(const Scene& scene) : movable(scene.materials.size()), all(scene.materials.size()) {
    for (const SceneBody& b : scene.bodies) {
      ++all[b.material];
      movable[b.material] += b.is_fixed ? 0 : 1;
    }
    for (const Wall& wall : scene.walls) ++all[wall.material];
  }
  [[nodiscard]] bool meet(std::size_t a, std::size_t b) const {
    if (a == b) return movable[a] > 0 && all[a] > 1;
    return (movable[a] > 0 && all[b] > 0) || (movable[b] > 0 && all[a] > 0);
  }
};

}  // namespace

bool PairEffects::has_any() const {
  return std::ranges::find(meets, 1) != meets.end();
}

const MaterialPair* given_pair(const Scene& scene, std::size_t first, std::size_t second) {
  const auto found = std::ranges::find_if(scene.material_pairs, [&](const MaterialPair& pair) {
    const auto [a, b] = pair.between;
    return (a == first && b == second) || (a == second && b == first);
  });
  return found == scene.material_pairs.end() ? nullptr : &*found;
}

std::string names_of_pair(const Scene& scene, std::size_t first, std::size_t second) {
  return scene.materials[first].name + " and " + scene.materials[second].name;
}

PairEffects pair_effects(const Scene& scene) {
  const std::size_t count = scene.materials.size();
  if (count == 0) return {};
  PairEffects out{count, std::vector<Effects>(count * count), std::vector<char>(count * count)};
  const Counts counts(scene);
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t b = a; b < count; ++b) {
      if (!counts.meet(a, b)) continue;
      out.meets[out.at(a, b)] = out.meets[out.at(b, a)] = 1;
      out.of[out.at(a, b)] = out.of[out.at(b, a)] = effects_between(scene, a, b);
    }
  return out;
}

Effects effects_of_all(const Scene& scene, const PairEffects& pairs) {
  Effects out = scene.effects;
  for (std::size_t k = 0; k < pairs.of.size(); ++k) {
    if (pairs.meets[k] == 0) continue;
    each_effect(out, [&](auto& slot) {
      using Parameters = typename std::remove_cvref_t<decltype(slot)>::value_type;
      const auto& of_pair = slot_of<Parameters>(pairs.of[k]);
      if (!slot) slot = of_pair;
      if constexpr (std::is_same_v<Parameters, Cohesion>)
        if (of_pair) slot->range = std::max(slot->range, of_pair->range);
    });
  }
  return out;
}

}  // namespace plumb::scene
