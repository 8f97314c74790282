// What an effect goes by in each contact: one for all, or that of the two materials.
#pragma once

#include <vector>

#include "solver/scene/body/world.hpp"

namespace plumb::scene {

template <class Value>
class ByPair {
 public:
  /// `own`: of a scene without materials; `value_of` makes one of a pair's parameters.
  template <class Parameters, class Make>
  ByPair(const World& world, const Parameters& own, const std::optional<Parameters> Effects::* slot,
         const Make& value_of)
      : world_(&world) {
    if (world.pair_effects.of.empty()) values_ = {value_of(own)};
    for (const Effects& effects : world.pair_effects.of)
      values_.push_back(value_of((effects.*slot).value_or(Parameters{})));
  }

  /// `value_of` makes one of all that a pair has.
  template <class Make>
  ByPair(const World& world, const Make& value_of) : world_(&world) {
    if (world.pair_effects.of.empty()) values_ = {value_of(world.effects)};
    for (const Effects& effects : world.pair_effects.of) values_.push_back(value_of(effects));
  }

  [[nodiscard]] const Value& at(std::size_t contact) const {
    if (values_.size() == 1) return values_.front();
    const auto [i, j] = world_->contacts.pairs[contact];
    return values_[world_->pair_effects.at(world_->bodies.material[i], world_->bodies.material[j])];
  }

 private:
  const World* world_;
  std::vector<Value> values_;
};

/// The parameters themselves.
template <class Parameters>
[[nodiscard]] ByPair<Parameters> by_pair(const World& world, const Parameters& own,
                                         std::optional<Parameters> Effects::* slot) {
  return {world, own, slot, [](const Parameters& of_pair) { return of_pair; }};
}

}  // namespace plumb::scene
