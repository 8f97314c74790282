// Certificates as the contract has them: decimals that are rounded outwards, and what is not proved is absent.
#pragma once

#include <string>

#include "corpus/json/json_text.hpp"
#include "solver/reference/reference.hpp"
#include "solver/reference/search/stationary.hpp"
#include "solver/reference/touch/touch.hpp"
#include "solver/shape/convex.hpp"

namespace plumb {

/// Directions that bounds of any shapes may look at: milliseconds, and at most seconds.
inline constexpr int kConvexCells = 100'000;

/// Verdict and bounds of the overlap; a bound that is infinite is absent.
void put_overlap(Json& out, const Bounds& overlap, int digits);

/// The fields of a reference, in `digits` significant digits.
void put_reference(Json& out, const Reference& found, int digits);

/// "condition_claims": what is proved of the solution's condition numbers, 50 digits given. Where one is infinite
/// or bounds nothing (is_beyond_first_order), "solutions_within": balls that hold the normals and points of every input within 8 epsilon.
/// "nearby": how far the exact answers to such inputs are, each number changed alone.
void put_condition_claims(Json& out, const Pair& pair, const Solution& found);

/// Bounds and verdict of a pair of any shapes, and what is not proved of it.
void put_convex(Json& out, const ConvexPair& pair, int digits);

/// "stationary": every common normal that is proved, and "complete": whether these are proved to be all.
void put_stationary(Json& out, const StationarySet& found, int digits);

/// Another problem's answer: a reference's fields where it is proved, or the reason.
void put_problem(Json& out, const Solution& found, int digits);

/// "distance": bounds of the centres' distance, and the touching normal where it is proved.
void put_first_touch(Json& out, const FirstTouchProof& found, int digits);

/// For people: what the fields above say, at most 80 columns but for reasons.
[[nodiscard]] std::string certificate_table(const Json& certificate);

}  // namespace plumb
