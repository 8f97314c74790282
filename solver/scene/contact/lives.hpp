// Each contact's life, from where two bodies begin to overlap to where they no longer do: how long, how deep, how strong.
#pragma once

#include <optional>
#include <vector>

#include "solver/scene/body/world.hpp"

namespace plumb::scene {

/// Ends lie between steps: where the line through the two nearest overlaps is 0. Greatest values are those of parabolas through
/// three steps.
struct Life {
  std::uint32_t body1 = 0, body2 = 0;  ///< a wall as in the contact list
  double start = 0, duration = 0;      ///< of one that overlaps at the scene's start: 0
  double greatest_overlap = 0;
  std::optional<double> greatest_force;  ///< along the normal; none where no effect makes one
  bool has_ended = false;
};

/// The column of what is kept of each life.
[[nodiscard]] Column& add_lives(World& world);

/// Once all forces of a step are there.
void follow_lives(World& world);

/// Those that ended in this step: once the contacts are solved, and before they forget.
[[nodiscard]] std::vector<Life> ended_lives(const World& world);
/// Those that go on.
[[nodiscard]] std::vector<Life> lasting_lives(const World& world);

}  // namespace plumb::scene
