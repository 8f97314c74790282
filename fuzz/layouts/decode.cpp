#include "fuzz/layouts/decode.hpp"

#include <algorithm>
#include <cmath>

#include "fuzz/layouts/layout_fields.hpp"
#include "solver/pose.hpp"
#include "solver/reference/reference.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb {

PairRecipe decode_recipe(layout::Bytes bytes) {
  using namespace layout;
  PairRecipe recipe;
  const double unit = read_unit(bytes, 68);
  const auto shape1 = read_shape(bytes, 0, nullptr);
  const auto shape2 = read_shape(bytes, kBodySize, &shape1);
  recipe.pair.body1 = {
      {shape1.semi_axes * unit, shape1.n1, shape1.n2}, Vec3<double>::Zero(), read_quaternion(bytes, 0)};
  recipe.pair.body2 = {
      {shape2.semi_axes * unit, shape2.n1, shape2.n2}, Vec3<double>::Zero(), read_quaternion(bytes, kBodySize)};
  const auto [cz, sz] = cos_sin_deg(angle(bytes, 56));
  const auto [ca, sa] = cos_sin_deg(angle(bytes, 60));
  recipe.line = {sz * ca, sz * sa, cz};
  recipe.overlap_ratio = read_overlap_ratio(bytes, 64);
  recipe.origin = read_origin(bytes, 70, size_of(recipe.pair));
  return recipe;
}

long double reach(const Body& body, const Vec3<long double>& line) {
  const Superellipsoid<long double> shape{body.shape.semi_axes.cast<long double>(), body.shape.n1, body.shape.n2};
  return support<long double>(shape, rotation<long double>(body.quaternion).transpose() * line);
}

long double touching_distance(const Pair& pair, const Vec3<long double>& line) {
  const auto touch = first_touch<long double>(pair, line);
  if (touch.solved && std::isfinite(touch.distance)) return touch.distance;
  return reach(pair.body1, line) + reach(pair.body2, line);
}

Pair placed(const PairRecipe& recipe) {
  Pair out = recipe.pair;
  const long double distance = touching_distance(recipe.pair, recipe.line) * (1 - recipe.overlap_ratio);
  out.body1.position = recipe.origin;
  out.body2.position = (recipe.origin.cast<long double>() + recipe.line * distance).cast<double>();
  return out;
}

Case decode(layout::Bytes bytes) {
  Case c;
  c.name = "decoded bytes";
  c.pair = placed(decode_recipe(bytes));
  c.provenance =
      Json{{"layout", "pair-1"}, {"bytes", layout::hex(bytes.first(std::min(bytes.size(), kPairLayoutSize)))}};
  return c;
}

}  // namespace plumb
