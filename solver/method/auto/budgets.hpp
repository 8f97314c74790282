// What `auto` may spend, each number once: steps of Newton's iteration and evaluations of the overlap.
#pragma once

namespace plumb::budget {

/// Steps of a first local solve. A caller whose iteration limit is below this asks to stop without a search.
inline constexpr int first_steps = 14;

/// Steps of Newton's iteration on two ellipsoids, and of their points at last: what is not at rest by then takes what the
/// search may spend.
inline constexpr int ellipsoid_steps = 100, settling_steps = 3;

/// Evaluations of a descent, and those after which no other attempt of the cold start begins: what is left is the search's.
inline constexpr int descent = 200, cold_attempts = 200;

/// Evaluations of a search that another follows, and of the last. All that came before count; the 15 of sectors and the last
/// solve do not. The law `evaluations` allows 2000.
inline constexpr int first_search = 850, last_search = 1650;

/// The same by quadrangles: of 10 000 pairs 70 are lost, with 1650 in their place 45. Their cells are as much as a stack of 60 KiB has room for.
inline constexpr int quadrangles = 560;

}  // namespace plumb::budget
