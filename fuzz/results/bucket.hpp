// What a failure is, in words: finding, method, shape class and regime; and which of two cases is the simpler.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "solver/contact.hpp"
#include "solver/reference/reference.hpp"
#include "solver/shape/convex.hpp"

namespace plumb {

/// touching | shallow | moderate | deep | separated | unknown by the reference's overlap over the smaller body's size (below
/// 1e-9, 1e-2, 1e-1, above), then the first that holds of: far (from the origin), unequal (sizes), parallel (two body axes to
/// within 1e-3 rad, round bodies by their axis of revolution), on-axis (the centre line along a body axis).
[[nodiscard]] std::string regime(const Pair& pair, const Reference& reference);

/// "misaligned-original_cn-spheroids-shallow": a file name, the same on every host.
[[nodiscard]] std::string bucket(std::string_view finding, std::string_view method, const Pair& pair,
                                 const Reference& reference);

/// "nonconverged-auto-cone-box", and "-swept" where a sweep is.
[[nodiscard]] std::string bucket(std::string_view finding, std::string_view method, const ConvexPair& pair);

/// The same for the same bits, and hardly ever for others; the same on every host.
[[nodiscard]] std::uint64_t digest(const Pair& pair);
[[nodiscard]] std::uint64_t digest(const ConvexPair& pair);

/// Smaller is simpler: the classes of the two bodies, whether they differ, how many of their numbers are not 0 or 1, and the
/// decimal digits that it takes to write them.
using Simplicity = std::array<int, 4>;
[[nodiscard]] Simplicity simplicity(const Pair& pair);
/// Of shapes: their places in the list, whether they differ, how many are swept, and how long it takes to write them.
[[nodiscard]] Simplicity simplicity(const ConvexPair& pair);

}  // namespace plumb
