#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>

#include "properties/generators/paths.hpp"

namespace plumb::motion {
namespace {

Superellipsoid<double> block(double a, double b, double c, double exponent) {
  return {{a, b, c}, exponent, exponent};
}

/// The digits times 1e-1 .. 1e-16, from large to small; divided once, so that they stay short decimals.
std::vector<double> decades(std::initializer_list<double> digits) {
  std::vector<double> out;
  for (int power = 1; power <= 16; ++power)
    for (const double digit : digits) out.push_back(digit / std::pow(10, power));
  return out;
}

/// The values, 0, and the values' opposites in reverse.
std::vector<double> through_zero(const std::vector<double>& values) {
  std::vector<double> out = values;
  out.push_back(0);
  for (auto value = values.rbegin(); value != values.rend(); ++value) out.push_back(-*value);
  return out;
}

/// first / per_unit and on in steps of 1 / per_unit, `count` of them: each divided once.
void append_even(std::vector<double>& out, int first, int count, double per_unit) {
  for (int i = 0; i < count; ++i) out.push_back((first + i) / per_unit);
}

/// The pair at each value of what is steered.
template <class Place>
std::vector<Draft> steer(const Pair& pair, const char* what, const std::vector<double>& values, Place place) {
  std::vector<Draft> out;
  for (const double value : values) {
    Draft draft{pair, Json::object()};
    draft.facts[what] = value;
    place(draft, value);
    out.push_back(std::move(draft));
  }
  return out;
}

/// Two equal cubes with rounded edges, as far along x as along y.
Pair cubes(double exponent) {
  Pair pair;
  pair.body1.shape = pair.body2.shape = block(1, 1, 1, exponent);
  pair.body2.position << 0.5, 0.5, 0;
  return pair;
}

/// Around a quarter turn: the angle itself, one ulp beside it on either side, and powers of ten.
void append_around(std::vector<double>& angles, double centre) {
  for (const double end : {-1e300, 1e300}) angles.push_back(std::nextafter(centre, end));
  angles.push_back(centre);
  for (const double beside : {1e-4, 1e-3, 2e-2})
    for (const double sign : {-1, 1}) angles.push_back(centre + sign * beside);
}

}  // namespace

std::vector<Draft> face_turn(double exponent) {
  Pair pair;
  pair.body1.shape = block(1, 0.8, 0.6, exponent);
  pair.body2.shape = block(0.7, 0.9, 0.5, exponent);
  pair.body2.position << 0.2, 0.1, 1.099;
  // (1, 0, tilt/2, 0) keeps every digit of the smallest tilt.
  return steer(pair, "tilt", through_zero(decades({1, 0.3})),
               [](Draft& draft, double tilt) { draft.pair.body2.quaternion[2] = tilt / 2; });
}

std::vector<Draft> slide_over_edge(double exponent) {
  Pair pair;
  pair.body1.shape = block(1, 1, 0.5, exponent);
  pair.body2.shape = block(0.4, 0.4, 0.4, exponent);
  pair.body2.position << 0, 0.1, 0.89;
  pair.body2.quaternion = {1, 0.01, 0.02, 0.05};
  std::vector<double> along;
  append_even(along, 0, 14, 20);
  append_even(along, 56, 56, 80);
  append_even(along, 28, 10, 20);
  return steer(pair, "along", along, [](Draft& draft, double x) { draft.pair.body2.position[0] = x; });
}

std::vector<Draft> roll_through_tie(double exponent) {
  return steer(cubes(exponent), "turn", through_zero(decades({1})),
               [](Draft& draft, double turn) { draft.pair.body2.quaternion[3] = turn / 2; });
}

std::vector<Draft> slide_through_tie(double exponent) {
  return steer(cubes(exponent), "broken_by", through_zero(decades({1})),
               [](Draft& draft, double shift) { draft.pair.body2.position[0] += shift; });
}

std::vector<Draft> touch_and_part(double exponent) {
  Pair pair;
  pair.body1.shape = block(1, 0.7, 0.5, exponent);
  pair.body2.shape = block(0.6, 0.8, 0.4, exponent);
  pair.body2.quaternion = {0.7, 0.3, -0.5, 0.2};
  std::vector<double> depths = through_zero(decades({-1}));
  for (std::size_t i = depths.size() - 1; i-- > 0;) depths.push_back(depths[i]);
  const Vec3<double> normal = Vec3<double>(2, 3, 6) / 7;
  return steer(pair, "depth", depths, [&](Draft& draft, double depth) { place_at_contact(draft, normal, depth); });
}

std::vector<Draft> through_concentric(double exponent) {
  Pair pair;
  pair.body1.shape = block(1, 0.9, 0.8, exponent);
  pair.body2.shape = block(0.3, 0.2, 0.25, exponent);
  pair.body2.quaternion = {1, 0.2, -0.3, 0.4};
  std::vector<double> before;
  append_even(before, -15, 14, 10);
  for (const double s : decades({-1})) before.push_back(s);
  const Vec3<double> line = Vec3<double>(2, 3, 6) / 7;
  return steer(pair, "along", through_zero(before),
               [&](Draft& draft, double s) { draft.pair.body2.position = s * line; });
}

std::vector<Draft> spin_about_axis(double distance) {
  Pair pair;
  pair.body1.shape = pair.body2.shape = block(0.5, 0.5, 1, 2);
  pair.body2.position << 0, 0, distance;
  std::vector<double> angles;
  for (int quarter = 0; quarter <= 2; ++quarter) append_around(angles, quarter * (std::numbers::pi / 2));
  for (int i = -4; i <= 40; ++i)
    if (i % 18 != 0) angles.push_back(i * (std::numbers::pi / 36));
  std::sort(angles.begin(), angles.end());
  return steer(pair, "angle", angles,
               [](Draft& draft, double angle) { draft.pair.body2.quaternion = turn(Vec3<double>::UnitY(), angle); });
}

std::vector<Draft> needle_sweep() {
  Pair pair;
  pair.body1.shape = block(1, 1, 0.01, 2);
  pair.body2.shape = block(0.001, 0.001, 1, 2);
  pair.body2.quaternion = {1, 0.15, 0, 0};
  std::vector<double> beyond{0.1, 0.05, 0.02, 0.01, 0.007, 0.005, 0.004, 0.003, 0.0025};
  for (int i = 20; i >= -20; --i) beyond.push_back(i / 10'000.0);
  for (const double inside : {0.0025, 0.003, 0.004, 0.005, 0.007, 0.01, 0.015, 0.02, 0.03, 0.04, 0.05, 0.06, 0.08, 0.1})
    beyond.push_back(-inside);
  return steer(pair, "beyond_rim", beyond,
               [](Draft& draft, double x) { draft.pair.body2.position << 1 + x, 0.02, 0.1; });
}

std::vector<Draft> far_jump(double exponent) {
  static constexpr std::array<Quaternion, 8> poses{{{1, 0, 0, 0},
                                                    {1, 2, 3, 4},
                                                    {4, -3, 2, -1},
                                                    {0, 1, 0, 0},
                                                    {1, 1, 1, 1},
                                                    {3, 0, -5, 1},
                                                    {1, -1, 0, 0},
                                                    {0, 2, -1, 7}}};
  Pair pair;
  pair.body1.shape = block(1, 0.3, 0.1, exponent);
  pair.body2.shape = block(0.8, 0.2, 0.4, exponent);
  pair.body2.position << 0.5, 0.35, 0.3;
  std::vector<double> values;
  append_even(values, 0, 56, 1);
  return steer(pair, "count", values, [](Draft& draft, double count) {
    const std::size_t i = static_cast<std::size_t>(count);
    const double angle = 0.01 * static_cast<double>(i % 7);
    draft.facts = {{"pose", i / 7}, {"turn", angle}};
    draft.pair.body2.quaternion = product(turn(Vec3<double>(2, 3, 6) / 7, angle), poses[i / 7]);
  });
}

}  // namespace plumb::motion
