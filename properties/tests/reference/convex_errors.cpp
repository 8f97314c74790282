// What errors_of finds of answers that are right, and of answers that are wrong by a known length.
#include <gtest/gtest.h>

#include <limits>

#include "properties/tests/reference/drawn_bodies.hpp"
#include "solver/reference/convex/core.hpp"
#include "solver/reference/convex_bounds.hpp"

namespace plumb::reference::convex_errors_tests {
namespace {

using bodies_tests::shape_count;
using Vec = Vec3<double>;

constexpr double rounding = 1e-13;  // of lengths of order 1

/// The point of a body whose outward normal is n, to rounding.
Vec surface_point(const ConvexBody& body, const Vec& n) {
  const Mat3<double> turned = rotation<double>(body.quaternion);
  const cores::Core core = cores::core_of(body.shape, 0);
  const double radius = body.swept_radius + low(cores::radius_about_core(body.shape, 0));
  return body.position + turned * cores::farthest(core, turned.transpose() * n).at + radius * n;
}

/// Bodies that meet with opposite normals, `overlap` deep, and the contact that says so.
struct Met {
  ConvexPair pair;
  Contact<double> contact;
};

Met meet(std::size_t kind1, std::size_t kind2, double overlap, Stream& stream) {
  Met out{{draw_convex_body(kind1, stream), draw_convex_body(kind2, stream)}, {}};
  ConvexBody &body1 = out.pair.body1, &body2 = out.pair.body2;
  Contact<double>& contact = out.contact;
  contact.normal = random_direction(stream);
  if (std::holds_alternative<HalfSpace>(body1.shape)) contact.normal = rotation<double>(body1.quaternion).col(2);
  if (std::holds_alternative<HalfSpace>(body2.shape)) contact.normal = -rotation<double>(body2.quaternion).col(2);
  contact.overlap = overlap;
  contact.point1 = surface_point(body1, contact.normal);
  const Vec point2 = contact.point1 - overlap * contact.normal;
  body2.position += point2 - surface_point(body2, -contact.normal);
  contact.point2 = surface_point(body2, -contact.normal);
  return out;
}

template <class Each>
void for_all_met(double overlap, const Each& each) {
  for (std::size_t kind1 = 0; kind1 < shape_count; ++kind1)
    for (std::size_t kind2 = 0; kind2 < shape_count; ++kind2) {
      Stream stream("convex errors", kind1, kind2);
      const Met met = meet(kind1, kind2, overlap, stream);
      if (find_input_error(met.pair).reason.empty())
        each(met, std::string(name(met.pair.body1.shape)) + ", " + std::string(name(met.pair.body2.shape)));
    }
}

ConvexBounds bounds_of(const Met& met) {
  return bound_overlap(met.pair, met.contact.normal, 2000);
}

TEST(ConvexErrors, OfARightAnswerAreOfRounding) {
  for_all_met(-0.25, [](const Met& met, const std::string& where) {
    const ConvexErrors errors = errors_of(met.pair, met.contact, bounds_of(met));
    EXPECT_LT(errors.overlap, rounding) << where;
    EXPECT_LT(errors.point1, rounding) << where;
    EXPECT_LT(errors.point2, rounding) << where;
    EXPECT_LT(errors.touching1, rounding) << where;
    EXPECT_LT(errors.touching2, rounding) << where;
    EXPECT_LT(errors.alignment, rounding) << where;
  });
}

/// A point that is no corner and no rim, with its outward normal.
struct OnSurface {
  Shape shape;
  Vec point, normal;
};

/// At an angle about the axis.
std::array<OnSurface, 6> sides(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  const double depth = 11.0 / 28;  // of the frustum's bottom: (1 + 1 + 3/4) / (4 (1 + 1/2 + 1/4))
  const double face = std::pow(1 - 2 * std::pow(0.5, 20), 1.0 / 20), slope = std::pow(0.5, 19);
  return {{{Cylinder{0.75, 1}, {c, s, 0.3}, {c, s, 0}},
           {Frustum{{1, 0.5}, 1}, {0.75 * c, 0.75 * s, 0.5 - depth}, Vec(c, s, 0.5).normalized()},
           {Cone{1e-3, 1}, {5e-4 * c, 5e-4 * s, 0.25}, Vec(c, s, 1e-3).normalized()},
           {Capsule{0.5, 1}, {c, s, 0.3}, {c, s, 0}},
           {Box{{1, 1, 1}}, {0.9 * c, 0.9 * s, 1}, {0, 0, 1}},
           {Superellipsoid<double>{{1, 1, 1}, 20, 20}, {0.5, 0.5, face}, Vec(slope, slope, 1).normalized()}}};
}

/// The search for the nearest point alone ends 1e-12 to 6e-11 away on curved surfaces.
TEST(ConvexErrors, OfAPointOnASideAreOfRounding) {
  constexpr double last_digits = 1e-14;
  Stream stream("points on sides", 1, 1);
  for (int i = 0; i < 60; ++i)
    for (const double swept : {0.0, 0.25})
      for (const OnSurface& side : sides(stream.uniform(0, 6))) {
        const ConvexBody body{
            side.shape, swept, random_direction(stream), {stream.uniform(), stream.uniform(), stream.uniform(), 1}};
        const Mat3<double> turned = rotation<double>(body.quaternion);
        Contact<double> contact;
        contact.normal = turned * side.normal;
        contact.point1 = contact.point2 = body.position + turned * side.point + swept * contact.normal;
        const ConvexErrors errors = errors_of({body, body}, contact, {0, 0, 0});
        EXPECT_LT(errors.point1, last_digits) << name(body.shape) << ' ' << i;
      }
}

TEST(ConvexErrors, APointOutsideIsAsFarAsItWasMoved) {
  constexpr double moved = 1e-3;
  for_all_met(-0.25, [&](Met met, const std::string& where) {
    met.contact.point1 += moved * met.contact.normal;
    met.contact.point2 -= moved * met.contact.normal;
    const ConvexErrors errors = errors_of(met.pair, met.contact, bounds_of(met));
    for (const double error : {errors.point1, errors.point2}) {
      EXPECT_GE(error, moved - rounding) << where;
      EXPECT_LE(error, moved + rounding) << where;
    }
    EXPECT_LT(errors.touching1, rounding) << where;
    EXPECT_NEAR(errors.alignment, 2 * moved, rounding) << where;
  });
}

TEST(ConvexErrors, APointInsideIsNoFurtherThanItWasMoved) {
  constexpr double moved = 1e-3;
  for_all_met(-0.25, [&](Met met, const std::string& where) {
    met.contact.point1 -= moved * met.contact.normal;
    met.contact.point2 += moved * met.contact.normal;
    const ConvexErrors errors = errors_of(met.pair, met.contact, bounds_of(met));
    EXPECT_LE(errors.point1, moved + rounding) << where;
    EXPECT_LE(errors.point2, moved + rounding) << where;
    EXPECT_NEAR(errors.touching1, moved, rounding) << where;
    EXPECT_NEAR(errors.touching2, moved, rounding) << where;
  });
}

TEST(ConvexErrors, OfAnOverlapAreItsDistanceFromTheBounds) {
  const Contact<double> none;
  Met met{{{Box{Vec(1, 1, 1)}, 0, Vec(0, 0, 0), {1, 0, 0, 0}}, {Box{Vec(1, 1, 1)}, 0, Vec(0, 0, 1.75), {1, 0, 0, 0}}},
          none};
  met.contact.normal = Vec(0, 0, 1);
  met.contact.point1 = Vec(0, 0, 1);
  met.contact.point2 = Vec(0, 0, 0.75);
  for (const double wrong : {-0.125, 0.0, 0.125}) {
    met.contact.overlap = 0.25 + wrong;
    const ConvexErrors errors = errors_of(met.pair, met.contact, bounds_of(met));
    EXPECT_NEAR(errors.overlap, std::abs(wrong), rounding);
    EXPECT_NEAR(errors.alignment, std::abs(wrong), rounding);
  }
}

TEST(ConvexErrors, OfATiltedNormalAreSeenByTouching) {
  const Contact<double> none;
  Met met{{{HalfSpace{}, 0, Vec(0, 0, 0), {1, 0, 0, 0}}, {Box{Vec(1, 1, 1)}, 0, Vec(0, 0, 1), {1, 0, 0, 0}}}, none};
  met.contact.overlap = 0;
  met.contact.point1 = met.contact.point2 = Vec(0, 0, 0);
  met.contact.normal = Vec(1e-3, 0, 1).normalized();
  const ConvexErrors errors = errors_of(met.pair, met.contact, bounds_of(met));
  EXPECT_NEAR(errors.touching1, 1e-3 * size_of(met.pair), 1e-8);
  EXPECT_NEAR(errors.touching2, 1e-3, 1e-8);
  EXPECT_LT(errors.point1, rounding);
}

TEST(ConvexErrors, OfNoNumbersAreInfinite) {
  Stream stream("no numbers", 1, 1);
  const Met met = meet(2, 5, 0, stream);
  const ConvexErrors errors = errors_of(met.pair, Contact<double>{}, bounds_of(met));
  for (const double error :
       {errors.overlap, errors.point1, errors.point2, errors.touching1, errors.touching2, errors.alignment})
    EXPECT_EQ(error, std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace plumb::reference::convex_errors_tests
