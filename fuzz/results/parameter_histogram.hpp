// Where a method fails: its answers counted over two properties of a pair, in fixed cells, so that atlases add up.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>

#include "corpus/json/fields.hpp"
#include "solver/reference/reference.hpp"

namespace plumb {

/// What a pair is placed by.
enum class Property {
  aspect,    ///< the longest semi-axis over the shortest, of the more slender body
  overlap,   ///< certified overlap over the smaller body's size; < 0 apart
  exponent,  ///< of the four, the one furthest from 2 (by its ratio)
  tilt       ///< between the bodies' z axes, folded to 0..90 degrees
};
inline constexpr std::size_t kProperties = 4;

/// The cells of a property: title with unit, and the lower edge of each cell; the first has none, and none is empty.
struct Scale {
  std::string title;
  std::span<const double> edges;  ///< cell i holds edges[i - 1] <= x < edges[i]
  [[nodiscard]] std::size_t cells() const { return edges.size() + 1; }
  [[nodiscard]] std::size_t cell_of(double x) const;
  /// "1.5..2", "below 1.5", "20 and more"
  [[nodiscard]] std::string label(std::size_t cell) const;
};
[[nodiscard]] Scale scale_of(Property property);

/// The cell of a pair on each scale. `reference`: of the least effort, so that it does not depend on who was judged before.
using Place = std::array<std::uint8_t, kProperties>;
[[nodiscard]] Place place_in_atlas(const Pair& pair, const Reference& reference);

struct AtlasCell {
  std::uint64_t answers = 0, judged = 0, failures = 0, not_converged = 0;
  std::uint64_t iterations = 0;  ///< of all answers together
  void merge(const AtlasCell& other);
};

/// The two maps that the report draws.
struct AtlasMap {
  std::string_view name;
  Property x, y;
};
inline constexpr std::array kAtlasMaps{AtlasMap{"aspect-overlap", Property::aspect, Property::overlap},
                                       AtlasMap{"exponent-tilt", Property::exponent, Property::tilt}};

class Atlas {
 public:
  using Cells = std::map<std::pair<int, int>, AtlasCell>;  ///< (x, y)
  void add(const Place& place, const AtlasCell& answer);
  void merge(const Atlas& other);
  /// Of the map kAtlasMaps[i]; only cells with answers.
  [[nodiscard]] const Cells& map(std::size_t i) const { return maps_[i]; }
  [[nodiscard]] Json to_json() const;
  /// Throws FieldError.
  void read(const Field& field);

 private:
  std::array<Cells, kAtlasMaps.size()> maps_;
};

}  // namespace plumb
