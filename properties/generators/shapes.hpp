// Convex bodies of every shape, and pairs of any two of them: what the families, the fuzz target and the tests of shapes draw from.
#pragma once

#include "properties/generators/draft.hpp"
#include "solver/shape/convex.hpp"
#include "solver/shape/shape_fields.hpp"

namespace plumb {

/// Kinds are Shape's alternatives in their order, without the foreign one, which is functions.
inline constexpr std::size_t shape_count = std::variant_size_v<Shape> - 1, half_space_kind = 8, foreign_place = 10;
static_assert(std::is_same_v<std::variant_alternative_t<foreign_place, Shape>, ForeignShape>);
static_assert(std::is_same_v<std::variant_alternative_t<half_space_kind, Shape>, HalfSpace>);

[[nodiscard]] inline bool is_legal(const Shape& shape) {
  return find_input_error(ConvexPair{{shape}, {}}).reason.empty();
}

/// make.operator()<S>() for the S of a kind.
template <class Make>
[[nodiscard]] Shape shape_of_kind(std::size_t kind, const Make& make) {
  return [&]<class... S>(const std::variant<S...>*) {
    const std::array makers{+[](const Make& by) -> Shape {
      if constexpr (is_value<S>)
        return by.template operator()<S>();
      else
        return {};
    }...};
    return makers[kind < foreign_place ? kind : kind + 1](make);
  }(static_cast<const Shape*>(nullptr));
}

/// Two kinds; two half-spaces have no contact.
struct ShapeKinds {
  std::size_t first, second;
};
inline constexpr std::size_t shape_pair_count = shape_count * (shape_count + 1) / 2 - 1;
/// Each two shapes once, 0 .. shape_pair_count - 1; a half-space is the second of its pairs.
[[nodiscard]] ShapeKinds shape_kinds(std::size_t number);

/// Lengths 0.1 .. 1.
[[nodiscard]] Shape draw_shape(std::size_t kind, Stream& stream);
/// Turned at random, some swept by a sphere, near the origin.
[[nodiscard]] ConvexBody draw_convex_body(std::size_t kind, Stream& stream);

/// As a body of the shape itself, no longer than along one axis 10^-decades of what it was: plates, needles.
[[nodiscard]] Shape flattened(const Shape& shape, double decades, Stream& stream);

/// Puts body 2 so that (normal, overlap) is a common normal of the pair up to rounding, and the lowest while the overlap is small or
/// below 0. `normal`: unit, from body 1 to body 2; a half-space has but its own.
void place_at_contact(ConvexPair& pair, const Vec3<double>& normal, double overlap);

/// Of two kinds: apart, touching to 1e-16 of the size, shallow, deep, one body inside the other; a tenth plates and needles.
[[nodiscard]] ConvexPair draw_shape_pair(const ShapeKinds& kinds, Stream& stream);

}  // namespace plumb
