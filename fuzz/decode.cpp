#include "fuzz/decode.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fuzz/layout_fields.hpp"
#include "solver/pose.hpp"
#include "solver/reference/reference.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb {
namespace {

using layout::angle;
using layout::Bytes;
using layout::cos_sin_deg;
using layout::kBodySize;
using layout::log_magnitude;
using layout::read;

constexpr std::array<double, 16> kOverlaps{1e-2, 0,    1e-3, 5e-2, 0.1,   0.2,   0.5,   0.9,
                                           1e-4, 1e-6, 1e-8, 1e-9, 1e-10, 1e-12, 1e-14, 1e-16};

double read_unit(Bytes bytes) {
  const int byte = static_cast<int>(read(bytes, 69, 1));
  const int k = byte < 128 ? byte : byte - 256, decades = k / 8;
  switch (read(bytes, 68, 1) % 3) {
    case 1: return std::ldexp(1.0, k);
    case 2: return static_cast<double>(std::pow(10.0L, static_cast<long double>(decades)));
    default: return 1;
  }
}

long double read_overlap_ratio(Bytes bytes) {
  const std::uint32_t v = read(bytes, 66, 2);
  const long double linear = static_cast<long double>(v) / 65535;
  const long double log = v < 256 ? static_cast<long double>(kOverlaps[v % kOverlaps.size()]) : log_magnitude(v);
  switch (read(bytes, 64, 1) % 4) {
    case 0: return log;
    case 1: return -log;
    case 2: return linear;
    default: return -4 * linear;
  }
}

Vec3<double> read_origin(Bytes bytes, double size) {
  const double distance =
      size * static_cast<double>(std::pow(10.0L, 8.0L * static_cast<long double>(read(bytes, 71, 1)) / 255));
  switch (read(bytes, 70, 1) % 8) {
    case 5: return {distance, 0, 0};
    case 6: return {distance, distance, distance};
    case 7: return {distance, -2 * distance, 3 * distance};
    default: return Vec3<double>::Zero();
  }
}

}  // namespace

PairRecipe decode_recipe(Bytes bytes) {
  PairRecipe recipe;
  const double unit = read_unit(bytes);
  const auto shape1 = layout::read_shape(bytes, 0, nullptr);
  const auto shape2 = layout::read_shape(bytes, kBodySize, &shape1);
  recipe.pair.body1 = {
      {shape1.semi_axes * unit, shape1.n1, shape1.n2}, Vec3<double>::Zero(), layout::read_quaternion(bytes, 0)};
  recipe.pair.body2 = {
      {shape2.semi_axes * unit, shape2.n1, shape2.n2}, Vec3<double>::Zero(), layout::read_quaternion(bytes, kBodySize)};
  const auto [cz, sz] = cos_sin_deg(angle(bytes, 56));
  const auto [ca, sa] = cos_sin_deg(angle(bytes, 60));
  recipe.line = {sz * ca, sz * sa, cz};
  recipe.overlap_ratio = read_overlap_ratio(bytes);
  recipe.origin = read_origin(bytes, size_of(recipe.pair));
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

Case decode(Bytes bytes) {
  const PairRecipe recipe = decode_recipe(bytes);
  const long double distance = touching_distance(recipe.pair, recipe.line) * (1 - recipe.overlap_ratio);
  const Vec3<long double> centre = recipe.origin.cast<long double>() + recipe.line * distance;
  Case c;
  c.name = "decoded bytes";
  c.pair = recipe.pair;
  c.pair.body1.position = recipe.origin;
  c.pair.body2.position = centre.cast<double>();
  c.provenance =
      Json{{"layout", "pair-1"}, {"bytes", layout::hex(bytes.first(std::min(bytes.size(), kPairLayoutSize)))}};
  return c;
}

}  // namespace plumb
