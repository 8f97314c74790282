// Bounds of the lowest overlap of convex bodies: known answers, directions sampled in 50 digits' place, other units, small budgets.
#include "solver/reference/convex_bounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "properties/generators/families.hpp"
#include "properties/tests/reference/drawn_bodies.hpp"
#include "solver/reference/reference.hpp"

namespace plumb::reference::convex_bounds_tests {
namespace {

using bodies_tests::draw_pair;
using bodies_tests::overlap_along;
using bodies_tests::shape_count;
using Vec = Vec3<double>;

constexpr int budget = 20'000;
constexpr double narrow = 1e-10;  // relative to the size
constexpr Quaternion unturned{1, 0, 0, 0}, quarter_about_x{1, 1, 0, 0}, half_about_x{0, 1, 0, 0};

ConvexBody at(const Shape& shape, const Vec& position, const Quaternion& turned = unturned, double swept = 0) {
  return {shape, swept, position, turned};
}

Superellipsoid<double> ellipsoid(double a, double b, double c) {
  return {Vec(a, b, c), 2, 2};
}

ConvexBounds bounds_of(const ConvexPair& pair, int cells = budget) {
  return bound_overlap(pair, not_valid<double>(), cells);
}

std::string named(const ConvexPair& pair, std::uint64_t index) {
  return std::string(name(pair.body1.shape)) + ", " + std::string(name(pair.body2.shape)) + ' ' + std::to_string(index);
}

template <class Each>
void for_all_pairs(std::uint64_t count, std::uint64_t seed, const Each& each) {
  for (std::size_t kind1 = 0; kind1 < shape_count; ++kind1)
    for (std::size_t kind2 = 0; kind2 < shape_count; ++kind2)
      for (std::uint64_t i = 0; i < count; ++i) {
        Stream stream("convex bounds", seed, (kind1 * shape_count + kind2) * count + i);
        const ConvexPair pair = draw_pair(kind1, kind2, stream);
        if (find_input_error(pair).reason.empty()) each(pair, stream, named(pair, i));
      }
}

struct Known {
  const char* name;
  ConvexPair pair;
  double overlap;
  double allowed = narrow;
};

const Box cube{{1, 1, 1}}, table{{2, 2, 1}};

std::vector<Known> known_answers() {
  const std::array<Vec, 3> triangle{Vec(0, 0, 0), Vec(1, 0, 0), Vec(0, 1, 0)};
  const std::array<Vec, 2> segment{Vec(0.2, 0.2, -1), Vec(0.2, 0.2, 1)};
  const std::array<Vec, 1> point{Vec(0.2, 0.2, 0.5)};
  const double root_half = std::sqrt(0.5);
  const Quaternion eighth_about_z{std::cos(M_PI / 8), 0, 0, std::sin(M_PI / 8)},
      eighth_about_x{std::cos(M_PI / 8), std::sin(M_PI / 8), 0, 0};
  return {
      {"spheres", {at(Capsule{0, 1}, Vec(0, 0, 0)), at(Capsule{0, 0.5}, Vec(0, 1.25, 0))}, 0.25},
      {"spheres apart", {at(Capsule{0, 1}, Vec(0, 0, 0)), at(ellipsoid(0.5, 0.5, 0.5), Vec(0, 2, 0))}, -0.5},
      {"concentric spheres", {at(ellipsoid(1, 1, 1), Vec(0, 0, 0)), at(ellipsoid(0.5, 0.5, 0.5), Vec(0, 0, 0))}, 1.5},
      {"cubes by their faces", {at(cube, Vec(0, 0, 0)), at(cube, Vec(0.125, 0.25, 1.75))}, 0.25},
      {"the same cube", {at(cube, Vec(0, 0, 0)), at(cube, Vec(0, 0, 0))}, 2},
      {"cubes that touch", {at(cube, Vec(0, 0, 0)), at(cube, Vec(0, 0, 2))}, 0},
      {"cubes apart", {at(cube, Vec(0, 0, 0)), at(cube, Vec(0.5, 0, 2.5))}, -0.5},
      {"crossed edges apart",
       {at(cube, Vec(0, 0, 0), eighth_about_z), at(cube, Vec(2.5 / root_half, 0, 0), {0.5, 0.5, 0.5, 0.5})},
       1 / root_half + 1 - 2.5 / root_half},
      {"crossed edges",
       {at(Box{Vec(1, 1, 4)}, Vec(0, 0, 0), eighth_about_z),
        at(Box{Vec(1, 4, 1)}, Vec(2.7, 0, 0), {std::cos(M_PI / 8), 0, std::sin(M_PI / 8), 0})},
       2 / root_half - 2.7},
      {"capsules side by side", {at(Capsule{1, 0.5}, Vec(0, 0, 0)), at(Capsule{1, 0.25}, Vec(0, 0.5, 1))}, 0.25},
      {"crossing capsules",
       {at(Capsule{1, 0.5}, Vec(0, 0, 0)), at(Capsule{1, 0.25}, Vec(0, 0, 0.5), quarter_about_x)},
       0.75},
      {"capsules end to end apart", {at(Capsule{1, 0.5}, Vec(0, 0, 0)), at(Capsule{1, 0.25}, Vec(0, 0, 3))}, -0.25},
      {"box on half-space", {at(HalfSpace{}, Vec(7, 8, 9)), at(Box{Vec(1, 2, 3)}, Vec(5, 6, 11.5))}, 0.5},
      {"corner on half-space",
       {at(Box{Vec(1, 1, 1)}, Vec(0, 0, 1), eighth_about_x), at(HalfSpace{}, Vec(3, 0, 0))},
       1 / root_half - 1},
      {"swept capsule on half-space",
       {at(Capsule{1, 0.5}, Vec(5, 6, 1.25), unturned, 0.25), at(HalfSpace{}, Vec(0, 0, 0))},
       0.5},
      {"tip down on a table", {at(table, Vec(0, 0, 0)), at(Cone{0.5, 1}, Vec(0.125, 0.25, 1.5), half_about_x)}, 0.25},
      {"tip above a table", {at(table, Vec(0, 0, 0)), at(Cone{0.5, 1}, Vec(0.125, 0.25, 2), half_about_x)}, -0.25},
      {"frustum on its bottom",
       {at(table, Vec(0, 0, 0)), at(Frustum{{1, 0.5}, 28}, Vec(0, 0, 11.875 + 0.0), unturned)},
       1 + 11 - 11.875},
      {"cone like a needle", {at(Cone{1e-160, 1}, Vec(0, 0, 0.125)), at(HalfSpace{}, Vec(0, 0, 0))}, 0.125},
      {"frustum like a needle",
       {at(Frustum{{3e-162, 1e-162}, 1}, Vec(0, 0, 0.25)), at(HalfSpace{}, Vec(0, 0, 0))},
       9.0 / 26 - 0.25},
      {"cylinder on its side",
       {at(table, Vec(0, 0, 0)), at(Cylinder{1, 0.5}, Vec(0.1, 0.2, 1.25), quarter_about_x)},
       0.25},
      {"cylinder on its end", {at(table, Vec(0, 0, 0)), at(Cylinder{1, 0.5}, Vec(0.1, 0.2, 1.75))}, 0.25},
      {"parallel cylinders", {at(Cylinder{1, 1}, Vec(0, 0, 0)), at(Cylinder{1, 0.25}, Vec(1, 0, 0))}, 0.25},
      {"coaxial cylinders", {at(Cylinder{3, 1}, Vec(0, 0, 0)), at(Cylinder{3, 0.25}, Vec(0, 0, 0))}, 1.25, 1e-5},
      {"segment through triangle",
       {at(make_polyhedron(triangle), Vec(0, 0, 0)), at(make_polyhedron(segment), Vec(0, 0, 0))},
       0.2},
      {"point above triangle",
       {at(make_polyhedron(triangle), Vec(0, 0, 0)), at(make_polyhedron(point), Vec(0, 0, 0))},
       -0.5},
      {"point and swept triangle",
       {at(make_polyhedron(triangle), Vec(0, 0, 0), unturned, 0.75), at(make_polyhedron(point), Vec(0, 0, 0))},
       0.25},
      {"octants", {at(PolySuperellipsoid{{1, 2, 3, 4, 5, 6}, 2, 2}, Vec(0, 0, 0)), at(table, Vec(-3.75, 0, 0))}, 0.25},
  };
}

TEST(ConvexBounds, HoldKnownAnswers) {
  for (const Known& known : known_answers()) {
    const ConvexBounds found = bounds_of(known.pair);
    const double size = size_of(known.pair), rounding = 4 * std::numeric_limits<double>::epsilon() * size;
    EXPECT_LE(found.lower, known.overlap + rounding) << known.name;
    EXPECT_GE(found.upper, known.overlap - rounding) << known.name;
    EXPECT_LE(found.upper - found.lower, known.allowed * size) << known.name;
  }
}

/// Downhill by random steps, each half as long where none of some leads lower.
double sampled_lowest(const ConvexPair& pair, Stream& stream) {
  Vec best = random_direction(stream);
  double lowest = overlap_along<double>(pair, best);
  const auto look = [&](const Vec& v) {
    const Vec n = v.normalized();
    const double overlap = overlap_along<double>(pair, n);
    if (!(overlap < lowest)) return false;
    lowest = overlap;
    best = n;
    return true;
  };
  for (int i = 0; i < 200; ++i) look(random_direction(stream));
  double step = 0.3;
  for (int halving = 0; halving < 29; ++halving, step /= 2) {
    bool is_lower = true;
    while (is_lower) {
      is_lower = false;
      for (int i = 0; i < 8; ++i) is_lower = look(best + step * random_direction(stream)) || is_lower;
    }
  }
  return lowest;
}

bool is_beside_half_space(const ConvexPair& pair) {
  return std::holds_alternative<HalfSpace>(pair.body1.shape) || std::holds_alternative<HalfSpace>(pair.body2.shape);
}

/// The only direction of finite overlap.
double overlap_beside_half_space(const ConvexPair& pair) {
  const bool is_first = std::holds_alternative<HalfSpace>(pair.body1.shape);
  const Vec own = rotation<double>((is_first ? pair.body1 : pair.body2).quaternion).col(2);
  return overlap_along<double>(pair, is_first ? own : Vec(-own));
}

TEST(ConvexBounds, LieBelowSampledOverlapsAndCloseTogether) {
  for_all_pairs(4, 1, [](const ConvexPair& pair, Stream& stream, const std::string& where) {
    const ConvexBounds found = bounds_of(pair);
    const double size = size_of(pair), rounding = 1e-13 * size;
    EXPECT_LE(found.lower, found.upper) << where;
    EXPECT_LE(found.upper - found.lower, narrow * size) << where;
    const double sampled = is_beside_half_space(pair) ? overlap_beside_half_space(pair) : sampled_lowest(pair, stream);
    EXPECT_LE(found.lower, sampled + rounding) << where;
    EXPECT_LE(found.upper, sampled + narrow * size) << where;
    EXPECT_GE(found.upper, (is_beside_half_space(pair) ? sampled : found.lower) - rounding) << where;
  });
}

TEST(ConvexBounds, HoldWithAnyBudgetAndFromAnyDirection) {
  for_all_pairs(2, 2, [](const ConvexPair& pair, Stream& stream, const std::string& where) {
    const ConvexBounds found = bounds_of(pair);
    for (const int cells : {0, 6, 30}) {
      const ConvexBounds rough = bound_overlap(pair, random_direction(stream), cells);
      EXPECT_LE(rough.cells, std::max(cells, 1)) << where;
      EXPECT_LE(rough.lower, found.upper) << where;
      EXPECT_GE(rough.upper, found.lower) << where;
    }
  });
}

ConvexPair swapped(const ConvexPair& pair) {
  return {pair.body2, pair.body1};
}

TEST(ConvexBounds, ExchangedBodiesHaveTheSameOverlap) {
  for_all_pairs(2, 3, [](const ConvexPair& pair, Stream&, const std::string& where) {
    const ConvexBounds found = bounds_of(pair), other = bounds_of(swapped(pair));
    EXPECT_LE(found.lower, other.upper) << where;
    EXPECT_GE(found.upper, other.lower) << where;
  });
}

TEST(ConvexBounds, BesideTheReferencesOfSuperellipsoids) {
  constexpr std::uint64_t pairs = 25;
  for (const Family& family : families())
    for (std::uint64_t i = 0; i < pairs; ++i) {
      const Pair pair = generate(family.name, 7, i).pair;
      const Reference truth = find_reference(pair, Effort::bounds);
      const ConvexBounds found = bound_overlap(convex(pair), not_valid<double>(), 2000);
      EXPECT_LE(Real50(found.lower), truth.overlap.upper) << family.name << ' ' << i;
      EXPECT_GE(Real50(found.upper), truth.overlap.lower) << family.name << ' ' << i;
    }
}

ConvexPair boxes(double unit, const Vec& apart) {
  return {at(Box{Vec(1, 2, 3) * unit}, Vec(0.5, 0.25, -1) * unit, {0.9, 0.1, 0.2, 0.3}, 0.125 * unit),
          at(Frustum{{1 * unit, 0.5 * unit}, 2 * unit}, apart * unit, {0.3, 0.2, -0.1, 0.8})};
}

TEST(ConvexBounds, UnitsOfPowersOfTwoChangeNoBit) {
  for (const Vec& apart : {Vec(1, 1, 0.5), Vec(4, 1, 0.5)}) {
    const ConvexBounds here = bounds_of(boxes(1, apart));
    for (const int exponent : {-900, -1, 40, 900}) {
      const double unit = std::ldexp(1.0, exponent);
      const ConvexBounds there = bounds_of(boxes(unit, apart));
      EXPECT_EQ(there.lower, here.lower * unit) << exponent;
      EXPECT_EQ(there.upper, here.upper * unit) << exponent;
      EXPECT_EQ(there.cells, here.cells) << exponent;
    }
  }
}

TEST(ConvexBounds, AreHonestWhereDoublesEnd) {
  const Box tiny{Vec(1e-300, 2e-300, 3e-300)}, least{Vec(5e-324, 5e-324, 1e-320)}, huge{Vec(1e308, 1.7e308, 1e308)};
  const Superellipsoid<double> round{Vec(1e-300, 2e-300, 3e-300), 1.5, 3};
  const double far = 1e300, end = 1.7e308;
  const Vec here(0, 0, 0);
  const std::array pairs{ConvexPair{at(round, Vec(far, 0, 0)), at(tiny, Vec(far, 0, 0))},
                         ConvexPair{at(round, Vec(far, 0, 0)), at(tiny, Vec(-far, 0, 0))},
                         ConvexPair{at(huge, Vec(end, 0, 0)), at(huge, Vec(-end, 0, 0), quarter_about_x)},
                         ConvexPair{at(huge, here), at(least, here)},
                         ConvexPair{at(least, here), at(round, here)},
                         ConvexPair{at(least, here), at(least, Vec(5e-324, 0, 0))},
                         ConvexPair{at(Capsule{end, end}, here, unturned, end), at(HalfSpace{}, Vec(end, end, end))}};
  for (const ConvexPair& pair : pairs) {
    const ConvexBounds found = bounds_of(pair, 200);
    EXPECT_LE(found.lower, found.upper) << name(pair.body1.shape);
    if (is_beside_half_space(pair)) continue;
    for (const Vec& n : {Vec(1, 0, 0), Vec(0, 1, 0), Vec(0, 0, 1), Vec(-1, 0, 0), Vec(0, -1, 0), Vec(0, 0, -1)})
      EXPECT_LE(Real50(found.lower), overlap_along<Real50>(pair, Vec3<Real50>(n.cast<Real50>())))
          << name(pair.body1.shape);
  }
}

}  // namespace
}  // namespace plumb::reference::convex_bounds_tests
