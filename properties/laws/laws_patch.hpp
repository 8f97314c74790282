// What must be true of a patch (contact.hpp): each law once, for the tests, the seeded bugs and whoever else asks.
#pragma once

#include <functional>
#include <limits>
#include <span>
#include <string_view>

#include "properties/laws/laws.hpp"

namespace plumb {

/// A patch of a pair that overlaps, and how to have others.
struct PatchEvidence {
  const Pair& pair;
  const Patch& patch;
  double tolerance;  ///< to which it was asked for
  /// The patch of a related pair to a tolerance.
  std::function<Patch(const Pair&, double tolerance)> solve;
};

struct PatchLaw {
  std::string_view name;
  std::string_view statement;
  Finding (*check)(const PatchEvidence&);
  bool is_cheap = true;  ///< no proof, and no more than one other patch
};
[[nodiscard]] std::span<const PatchLaw> patch_laws();

/// The first law that is broken.
[[nodiscard]] Finding judge_patch(const PatchEvidence& evidence);

/// What the certified bounds of volume, centre and second moments say, whose polyhedra have 8 4^level triangles.
struct BoundsSaid {
  Finding finding;
  double width =
      std::numeric_limits<double>::infinity();  ///< of the volume's, over the volume; infinite where none are proved
};
[[nodiscard]] BoundsSaid against_bounds(const PatchEvidence& evidence, int level = 3);

/// The largest relative difference of two patches, each number by what it is measured with: a volume, an area, a width. `side` -1: seen from
/// the other body.
[[nodiscard]] double difference(const Patch& a, const Patch& b, int side = 1);

/// Whether doubles hold a volume of the pair's size with all its digits.
[[nodiscard]] bool has_volumes(const Pair& pair);

}  // namespace plumb
