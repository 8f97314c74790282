// Families of pairs of convex bodies of any shapes: the campaign draws from them by name, `plumb ladder` freezes those with a knob.
//
// Adding one: a function and a row in families_shapes.cpp.
#pragma once

#include <span>
#include <string_view>

#include "properties/generators/shapes.hpp"

namespace plumb {

struct ShapeFamily {
  std::string_view name, summary;
  std::string_view knob;          ///< what is steered; empty: nothing is
  std::span<const double> steps;  ///< its values, the easiest first; case after case takes one after the other
  ConvexPair (*draw)(Stream&, std::uint64_t index, double knob);
};
[[nodiscard]] std::span<const ShapeFamily> shape_families();
/// nullptr where there is none of that name.
[[nodiscard]] const ShapeFamily* find_shape_family(std::string_view name);

/// Case `index` of a family under a seed. Of one with a knob the step is index % steps, and what else is drawn goes by index / steps.
[[nodiscard]] Case generate(const ShapeFamily& family, std::uint64_t seed, std::uint64_t index);

}  // namespace plumb
