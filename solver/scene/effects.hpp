// The one list of effects, in the order in which they act: the parameters of each, and a row.
//
// Adding one: in effect/ NAME.hpp with its parameters and NAME.cpp with role() and install(); here its include and its row; its fields in
// corpus/scene/scene-1.schema.json. All else reads the row, CMake too.
#pragma once

#include <optional>

#include "solver/scene/effect/across/friction.hpp"
#include "solver/scene/effect/across/rolling.hpp"
#include "solver/scene/effect/across/twisting.hpp"
#include "solver/scene/effect/conduction.hpp"
#include "solver/scene/effect/drag.hpp"
#include "solver/scene/effect/gravity.hpp"
#include "solver/scene/effect/moving_walls.hpp"
#include "solver/scene/effect/normal/cohesion.hpp"
#include "solver/scene/effect/normal/damping.hpp"
#include "solver/scene/effect/normal/dmt.hpp"
#include "solver/scene/effect/normal/foundation.hpp"
#include "solver/scene/effect/normal/hertz.hpp"
#include "solver/scene/effect/normal/jkr.hpp"
#include "solver/scene/effect/normal/linear.hpp"
#include "solver/scene/effect/normal/volume.hpp"
#include "solver/scene/effect/periodic_box.hpp"

#define PLUMB_EFFECTS(ROW)       \
  ROW(Gravity, gravity)          \
  ROW(Linear, linear)            \
  ROW(Hertz, hertz)              \
  ROW(Volume, volume)            \
  ROW(Foundation, foundation)    \
  ROW(Damping, damping)          \
  ROW(Friction, friction)        \
  ROW(Rolling, rolling)          \
  ROW(Twisting, twisting)        \
  ROW(Cohesion, cohesion)        \
  ROW(Drag, drag)                \
  ROW(Conduction, conduction)    \
  ROW(MovingWalls, moving_walls) \
  ROW(Dmt, dmt)                  \
  ROW(Jkr, jkr)                  \
  ROW(PeriodicBox, periodic_box)

namespace plumb::scene {

/// The effects asked for. One that is default-constructed is neutral: it changes nothing.
struct Effects {
#define PLUMB_EFFECT(Parameters, effect) std::optional<Parameters> effect;
  PLUMB_EFFECTS(PLUMB_EFFECT)
#undef PLUMB_EFFECT
};

/// visit(effects.gravity), .. in the order in which they act. `Self` is Effects, const or not.
template <class Self, class Visit>
void each_effect(Self& effects, Visit&& visit) {
#define PLUMB_EFFECT(Parameters, effect) visit(effects.effect);
  PLUMB_EFFECTS(PLUMB_EFFECT)
#undef PLUMB_EFFECT
}

}  // namespace plumb::scene
