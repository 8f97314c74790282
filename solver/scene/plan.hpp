// The plan: what a scene needs, and nothing else.
//
// From the effects that are on follows what is asked of the solver, which bodies turn, whether there is a list of contacts, a
// broad phase, an integrator. An effect that can change nothing here is off, and the plan says why.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "solver/scene/effect.hpp"
#include "solver/scene/material/mixing.hpp"

namespace plumb::scene {

/// What a scene asks for.
enum class Analysis {
  touching,  ///< which bodies overlap, a yes or no each
  contacts,  ///< the contacts as they stand
  motion     ///< in time
};

/// How pairs that may touch are found.
enum class BroadPhase {
  none,  ///< no contacts, or all pairs are few enough to be one list for good
  tree   ///< R-tree over boxes around the bodies, built again when one has left its own
};

/// An effect, whether it runs, and why.
struct PlannedEffect {
  const Effect* effect = nullptr;
  bool is_on = false;
  std::string why;
  Needs needs;
};

/// All that follows from a scene before it runs; `plumb scene --plan` prints it.
struct Plan {
  Analysis analysis = Analysis::motion;
  std::vector<PlannedEffect> effects;  ///< all there are, in their order
  Effects asked;             ///< the scene's, what any pair of materials has, and the neutral ones that were forced on
  PairEffects pair_effects;  ///< of materials, where the scene has any
  Needs needs;               ///< of all that is on, outputs included
  std::string contacts_why, turning_why, broad_phase_why, time_step_why;
  BroadPhase broad_phase = BroadPhase::none;
  std::vector<bool> turns;  ///< for each body: whether its orientation is integrated
  Want want;                ///< what the solver is asked for
  double time_step = 0;
  std::int64_t steps = 0;
  std::int64_t steps_per_output = 0;  ///< 0: the first and the last state only

  /// Whether the effect of this name runs.
  [[nodiscard]] bool is_on(std::string_view effect) const;
  /// Whether any body turns.
  [[nodiscard]] bool has_turning() const;
};

/// For tests.
struct PlanOptions {
  /// Effects that are on whatever the scene asks for and whatever they can change, those it does not ask for at their neutral
  /// value: to test that an effect which is left out is one that changes nothing.
  std::set<std::string, std::less<>> forced;
  bool may_always_touch = false;  ///< wherever the bodies are: others are to come
};

/// Throws SceneError for what is illegal or has no meaning.
[[nodiscard]] Plan make_plan(const Scene& scene, const PlanOptions& options = {});

}  // namespace plumb::scene
