// Convex bodies: what is legal, what they are called, how far they reach.
#include "solver/shape/convex.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "properties/generators/draft.hpp"
#include "solver/shape/hull.hpp"
#include "solver/shape/shape_fields.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb::convex_tests {
namespace {

using Vec = Vec3<double>;
constexpr double infinite = std::numeric_limits<double>::infinity(), none = std::numeric_limits<double>::quiet_NaN();

ConvexBody at_origin(const Shape& shape, double swept = 0) {
  return {shape, swept, Vec(0, 0, 0), {1, 0, 0, 0}};
}

Polyhedron tetrahedron() {
  const std::array<Vec, 4> points{Vec(3, 0, 4), Vec(1, 0, 0), Vec(0, 1, 0), Vec(0, 0, 1)};
  return make_polyhedron(points);
}

template <class S>
Shape sample() {
  if constexpr (std::is_same_v<S, Polyhedron>)
    return tetrahedron();
  else
    return sample_of<S>();
}
template <class... S>
std::vector<Shape> samples(const std::variant<S...>* /*list*/) {
  std::vector<Shape> out;
  ((is_value<S> ? out.push_back(sample<S>()) : void()), ...);
  return out;
}

/// One of each.
std::vector<Shape> all_shapes() {
  return samples(static_cast<const Shape*>(nullptr));
}

TEST(ConvexShapes, AreCalledAsInCases) {
  const std::vector<std::string_view> names{"superellipsoid", "capsule", "cylinder",   "cone",
                                            "frustum",        "box",     "polyhedron", "poly_superellipsoid",
                                            "half_space"};  // in kept files and in C: these are never others
  const auto shapes = all_shapes();
  for (std::size_t i = 0; i < names.size(); ++i) EXPECT_EQ(name(shapes[i]), names[i]);
}

TEST(ConvexShapes, AllButTwoHalfSpacesAreLegal) {
  for (const Shape& shape : all_shapes()) {
    const bool is_half_space = std::holds_alternative<HalfSpace>(shape);
    EXPECT_EQ(find_input_error({at_origin(shape), at_origin(Box{Vec(1, 1, 1)})}).reason, "") << name(shape);
    const InputError refused = find_input_error({at_origin(shape), at_origin(HalfSpace{})});
    EXPECT_EQ(refused.field, is_half_space ? "shape.half_space" : "");
    EXPECT_EQ(refused.reason, is_half_space ? "two half-spaces have no lowest overlap" : "");
    EXPECT_EQ(refused.body, is_half_space ? 1 : 0);
  }
}

struct Illegal {
  ConvexBody body;
  std::string_view field;
};

std::vector<Illegal> illegal_bodies() {
  const Box cube{Vec(1, 1, 1)};
  return {{at_origin(Superellipsoid<double>{Vec(1, 0, 1), 2, 2}), "shape.superellipsoid.semi_axes[1]"},
          {at_origin(Superellipsoid<double>{Vec(1, 1, 1), 2, 1}), "shape.superellipsoid.exponents[1]"},
          {at_origin(Capsule{-1, 1}), "shape.capsule.half_length"},
          {at_origin(Capsule{1, 0}), "shape.capsule.radius"},
          {at_origin(Cylinder{0, 1}), "shape.cylinder.half_length"},
          {at_origin(Cylinder{1, infinite}), "shape.cylinder.radius"},
          {at_origin(Cone{0, 1}), "shape.cone.radius"},
          {at_origin(Cone{1, none}), "shape.cone.height"},
          {at_origin(Frustum{{-1, 1}, 1}), "shape.frustum.radii[0]"},
          {at_origin(Frustum{{1, none}, 1}), "shape.frustum.radii[1]"},
          {at_origin(Frustum{{0, 0}, 1}), "shape.frustum.radii"},
          {at_origin(Frustum{{0, 1}, 0}), "shape.frustum.height"},
          {at_origin(Box{Vec(1, -1, 1)}), "shape.box.half_extents[1]"},
          {at_origin(Polyhedron{}), "shape.polyhedron.points"},
          {at_origin(PolySuperellipsoid{{1, 1, 1, 1, 0, 1}, 2, 2}), "shape.poly_superellipsoid.semi_axes[4]"},
          {at_origin(PolySuperellipsoid{{1, 1, 1, 1, 1, 1}, 1, 2}), "shape.poly_superellipsoid.exponents[0]"},
          {at_origin(cube, -1), "shape.sphere_swept.radius"},
          {at_origin(Capsule{1.7e308, 1.7e308}), "shape.capsule"},
          {at_origin(Box{Vec(1.7e308, 1.7e308, 1)}), "shape.box"},
          {at_origin(Capsule{1e308, 1}, 1e308), "shape.sphere_swept.radius"},
          {{cube, 0, Vec(0, infinite, 0), {1, 0, 0, 0}}, "position"},
          {{cube, 0, Vec(0, 0, 0), {1, 0, none, 0}}, "orientation.quaternion_wxyz"},
          {{cube, 0, Vec(0, 0, 0), {0, 0, 0, 0}}, "orientation.quaternion_wxyz"}};
}

TEST(ConvexShapes, TheFirstIllegalFieldIsNamed) {
  const ConvexBody legal = at_origin(Box{Vec(1, 1, 1)});
  for (const auto& [body, field] : illegal_bodies()) {
    EXPECT_EQ(find_input_error({body, legal}).field, field);
    EXPECT_EQ(find_input_error({body, legal}).body, 0) << field;
    EXPECT_EQ(find_input_error({legal, body}).field, field);
    EXPECT_EQ(find_input_error({legal, body}).body, 1) << field;
    EXPECT_NE(find_input_error({legal, body}).reason, "") << field;
  }
}

TEST(ConvexShapes, BoundingRadiiAreThoseOfTheFarthestPoints) {
  const auto radius = [](const Shape& shape) { return bounding_radius(at_origin(shape)); };
  EXPECT_EQ(radius(Superellipsoid<double>{Vec(1, 2, 3), 2, 1.5}), 3);
  EXPECT_EQ(radius(Capsule{1, 2}), 3);
  EXPECT_EQ(radius(Cylinder{3, 4}), 5);
  EXPECT_EQ(radius(Cone{3, 4}), 3.0 * std::sqrt(1 + 1.0 / 9));
  EXPECT_EQ(radius(Cone{0.5, 4}), 3);
  EXPECT_EQ(radius(Frustum{{3, 3}, 8}), 5);
  EXPECT_EQ(radius(Box{Vec(2, 3, 6)}), 7);
  EXPECT_EQ(radius(tetrahedron()), 5);
  EXPECT_EQ(radius(PolySuperellipsoid{{1, 2, 3, 4, 5, 6}, 2, 2}), 6);
  EXPECT_EQ(radius(HalfSpace{}), 0);
  EXPECT_EQ(bounding_radius(at_origin(Box{Vec(2, 3, 6)}, 0.5)), 7.5);
  EXPECT_EQ(size_of(ConvexPair{at_origin(Capsule{1, 2}), at_origin(HalfSpace{})}), 3);
}

TEST(ConvexShapes, SquareSuperellipsoidsReachBeyondTheirAxes) {
  for (std::uint64_t i = 0; i < 20; ++i) {
    Stream stream("reach", 1, i);
    const Superellipsoid<double> shape = random_superellipsoid(stream, 3, 1.2, 20);
    const double radius = bounding_radius(at_origin(shape));
    Vec farthest = support_point<double>(shape, random_direction(stream)).gradient;
    for (int k = 0; k < 2000; ++k) {  // the farthest point's normal lies along itself
      const Vec x =
          support_point<double>(shape, k % 20 == 0 ? random_direction(stream) : farthest.normalized()).gradient;
      EXPECT_LE(x.norm(), radius * (1 + 1e-14));
      if (x.norm() > farthest.norm()) farthest = x;
    }
    EXPECT_GT(farthest.norm(), radius * (1 - 1e-6));
  }
}

TEST(ConvexShapes, APairOfSuperellipsoidsIsOne) {
  const Pair pair{{{Vec(1, 2, 3), 2, 4}, Vec(1, 0, 0), {1, 2, 3, 4}},
                  {{Vec(3, 2, 1), 3, 2}, Vec(0, 1, 0), {4, 3, 2, 1}},
                  Vec::Zero()};
  const ConvexPair same = convex(pair);
  EXPECT_EQ(std::get<Superellipsoid<double>>(same.body1.shape).n2, 4);
  EXPECT_EQ(same.body2.position, pair.body2.position);
  EXPECT_EQ(same.body2.quaternion, pair.body2.quaternion);
  EXPECT_EQ(same.body2.swept_radius, 0);
}

}  // namespace
}  // namespace plumb::convex_tests
