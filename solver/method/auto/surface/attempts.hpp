// The local attempts on a common normal of two superellipsoids: one table, a row an attempt.
//
// One in 15 000 pairs of exponents 2..8 needs more than the first row of the cold start, one in 2000 of exponents 8..40.
#pragma once

#include <array>
#include <limits>

#include "solver/method/auto/budgets.hpp"
#include "solver/method/auto/cover/incumbent.hpp"

namespace plumb {

/// Where an attempt from a direction n starts.
enum class StartPoint {
  mixed,   ///< by normal, blocky bodies by the middle
  chart,   ///< the ellipsoid's own chart direction
  normal,  ///< where the normals are n and -n
  middle   ///< both by the middle
};

enum class AttemptBy { newton, descent };

/// One attempt. Newton's iteration may raise the exponents from `cap` by the factor `growth` at each step. A descent
/// (surface_descent.hpp) has no start of its own and no other column.
struct Attempt {
  StartPoint start = StartPoint::normal;
  int limit = 40;  ///< steps
  bool line_search = false;
  double cap = std::numeric_limits<double>::infinity(), growth = 1;
  AttemptBy by = AttemptBy::newton;
  bool is_at_minimum = false;  ///< the start is one to rounding: no step has to descend
};

namespace attempts {

inline constexpr Attempt warm{.limit = 12};
inline constexpr Attempt first{.start = StartPoint::mixed, .limit = budget::first_steps};
inline constexpr Attempt off_saddle{.start = StartPoint::chart};
inline constexpr Attempt descent{.by = AttemptBy::descent};

/// How a descent ends: where the overlap is convex and the slope small, and where no step lowers it.
inline constexpr Attempt in_a_basin{.limit = 12}, at_the_bottom{.limit = 30};

/// What a cold start tries where the first attempt fails, in turn: exponents raised, descent, other starts, a line search.
struct ColdAttempt {
  Attempt attempt;
  bool is_limited = true;  ///< to budget::cold_attempts; else it follows the one before it in any case
};
inline constexpr std::array<ColdAttempt, 6> cold{
    {{{.start = StartPoint::chart, .limit = 30, .cap = 3, .growth = 2}},
     {descent},
     {{.start = StartPoint::normal, .limit = 60, .cap = 3, .growth = 1.5}, false},
     {{.start = StartPoint::middle, .limit = 60, .cap = 3, .growth = 1.5}},
     {{.start = StartPoint::normal, .limit = 60, .line_search = true}},
     {{.start = StartPoint::chart, .limit = 60, .line_search = true}}}};

/// What a search tries from a direction, in turn, where it is worth so many attempts.
struct SearchAttempt {
  Attempts worth;
  Attempt attempt;
};
inline constexpr std::array<SearchAttempt, 6> of_search{
    {{Attempts::one, {.start = StartPoint::normal, .limit = budget::first_steps}},
     {Attempts::all, {.start = StartPoint::normal, .limit = budget::first_steps, .is_at_minimum = true}},
     {Attempts::several, {.start = StartPoint::middle, .limit = budget::first_steps}},
     {Attempts::several, descent},
     {Attempts::all, {.start = StartPoint::normal, .limit = 30, .line_search = true}},
     {Attempts::all, {.start = StartPoint::middle, .limit = 30, .line_search = true}}}};

}  // namespace attempts
}  // namespace plumb
