// solver/plumb_adapter.hpp, which shares no code with the library, against the library's own shapes and frame.
#include "solver/plumb_adapter.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "corpus/solvers/solver.hpp"
#include "properties/generators/generators.hpp"
#include "solver/c/door.hpp"
#include "solver/pose.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb {
namespace {

using adapter::Frame;
using adapter::Vector;
using Vec = Vec3<double>;

Vec eigen(const Vector& v) {
  return Vec::Map(v.data());
}

Vector vector(const Vec& v) {
  return {v[0], v[1], v[2]};
}

adapter::Body body_of(const Superellipsoid<double>& shape) {
  return {vector(shape.semi_axes), shape.n1, shape.n2, {}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {1, 0, 0, 0}};
}

/// Powers amplify the rounding of their ratio by the exponent.
double rounding_of(const Superellipsoid<double>& s) {
  return 8 * kEpsilon * (1 + s.n1 + s.n2 + s.n1 / (s.n1 - 1) + s.n2 / (s.n2 - 1));
}

RC_GTEST_PROP(AdapterHelper, SupportIsTheLibrarysForDirectionsOfAnyLength, ()) {
  const auto s = *generators::shape();
  const Vec u = *generators::direction();
  const int exponent = *rc::gen::inRange(-1000, 1000);
  const Vector scaled = adapter::detail::scaled(vector(u), exponent);
  RC_PRE(adapter::detail::scaled(scaled, -exponent) == vector(u));
  const auto expected = support_point<double>(s, u);
  const adapter::Support found = body_of(s).support_in_body(scaled);
  RC_ASSERT(std::abs(found.height - expected.value) <= rounding_of(s) * expected.value);
  // Where a component is small its power is small, to the rounding of what it came from.
  RC_ASSERT((eigen(found.point) - expected.gradient).cwiseQuotient(s.semi_axes).cwiseAbs().maxCoeff() <=
            rounding_of(s));
}

RC_GTEST_PROP(AdapterHelper, GaugeIsTheLibrarys, ()) {
  const auto s = *generators::shape();
  const Vec x = *generators::direction();
  const auto expected = gauge_gradient<double>(s, x);
  const adapter::Gauge found = body_of(s).gauge_in_body(vector(x));
  RC_ASSERT(std::abs(found.value - expected.value) <= rounding_of(s) * expected.value);
  RC_ASSERT((eigen(found.gradient) - expected.gradient).cwiseProduct(s.semi_axes).cwiseAbs().maxCoeff() <=
            rounding_of(s));
}

RC_GTEST_PROP(AdapterHelper, RotationIsTheLibrarysForQuaternionsOfAnyLength, ()) {
  const Quaternion q = *generators::quaternion();
  const Mat3<double> expected = rotation<double>(q);
  const adapter::Matrix found = adapter::rotation(q);
  for (int i = 0; i < 3; ++i)
    RC_ASSERT((eigen(found[static_cast<std::size_t>(i)]) - expected.row(i).transpose()).cwiseAbs().maxCoeff() <=
              8 * kEpsilon);
}

RC_GTEST_PROP(AdapterHelper, FrameIsTheLibrarys, ()) {
  const Case drawn = *generators::case_of("hard");
  const auto expected = place<double>(drawn.pair);
  const Frame found(door::c_pair(drawn.pair));
  RC_ASSERT(found.exponent == expected.exponent);
  RC_ASSERT(found.size() >= 1 && found.size() < 2);
  RC_ASSERT(eigen(found.bodies[1].centre) == expected.body2.centre);
  RC_ASSERT(eigen(found.bodies[0].semi_axes) == expected.body1.shape.semi_axes);
  RC_ASSERT(eigen(found.bodies[1].semi_axes) == expected.body2.shape.semi_axes);
}

RC_GTEST_PROP(AdapterHelper, FramesSupportAndGaugeAreThoseOfThePlacedBody, ()) {
  const Case drawn = *generators::case_of("superquadric");
  const Vec u = *generators::direction();
  const auto placed = place<double>(drawn.pair);
  const adapter::Body body = Frame(door::c_pair(drawn.pair)).bodies[1];
  const auto expected = support_point<double>(placed.body2.shape, placed.body2.to_body_direction(u));
  const adapter::Support found = body.support(vector(u));
  const double allowed = 10 * rounding_of(placed.body2.shape) * (1 + placed.body2.centre.norm());
  RC_ASSERT(std::abs(found.height - expected.value - u.dot(placed.body2.centre)) <= allowed);
  // On the surface, and as far along u as it says; the point itself is as ill-conditioned as its face is flat.
  RC_ASSERT(std::abs(eigen(found.point).dot(u) - found.height) <= allowed);
  RC_ASSERT(std::abs(body.gauge(found.point).value - 1) <= allowed / placed.body2.shape.semi_axes.minCoeff());
}

RC_GTEST_PROP(AdapterHelper, BoxIsTheLeastOneAboutTheCloud, ()) {
  const Case drawn = *generators::case_of("superquadric");
  const adapter::Body body = Frame(door::c_pair(drawn.pair)).bodies[1];
  const adapter::Box box = body.box();
  for (const Vector& x : body.points(200)) {
    const Vec point = eigen(body.to_frame(x));
    RC_ASSERT((point - eigen(box.low)).minCoeff() >= -1e-12);
    RC_ASSERT((eigen(box.high) - point).minCoeff() >= -1e-12);
    RC_ASSERT(std::abs(body.gauge_in_body(x).value - 1) <= 1e-12);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    Vector u{};
    u[i] = 1;
    RC_ASSERT(std::abs(body.support(u).point[i] - box.high[i]) <= 1e-12);
  }
}

TEST(AdapterHelper, CloudIsAsDenseEverywhereAndOfTheNumberAskedFor) {
  const adapter::Body ball = body_of({{1, 1, 1}, 2, 2});
  const auto points = ball.points(1000);
  ASSERT_EQ(points.size(), 1000U);
  const double spacing = std::sqrt(4 * std::acos(-1.0) / 1000);  // of a square lattice of as many
  for (const Vector& x : points) {
    double nearest = 2;
    for (const Vector& y : points)
      if (&x != &y) nearest = std::min(nearest, (eigen(x) - eigen(y)).norm());
    EXPECT_GT(nearest, 0.7 * spacing);
    EXPECT_LT(nearest, 1.3 * spacing);
  }
}

plumb_pair two_balls(double unit) {
  Pair pair;
  pair.body1.shape.semi_axes = Vec::Constant(unit);
  pair.body2.shape.semi_axes = Vec::Constant(unit / 2);
  pair.body1.position = unit * Vec(3, -70, 500);
  pair.body2.position = pair.body1.position + 1.4 * unit * Vec::UnitX();
  return door::c_pair(pair);
}

TEST(AdapterHelper, AnswersGoBackToTheCallersUnitAndPlace) {
  for (const double unit : {1e-300, 1e-9, 1.0, 3.0, 1e300}) {
    SCOPED_TRACE(unit);
    const Frame frame(two_balls(unit));
    const double scale = unit * std::ldexp(1.0, -frame.exponent);
    plumb_contact contact{};
    frame.write({0.1 * scale, {5, 0, 0}, {scale, 0, 0}, {0.9 * scale, 0, 0}}, contact);
    EXPECT_EQ(contact.status, PLUMB_CONVERGED);
    EXPECT_EQ(contact.verdict, PLUMB_OVERLAPPING);
    EXPECT_NEAR(contact.overlap / unit, 0.1, 1e-15);
    EXPECT_EQ(Vec::Map(contact.normal), Vec::UnitX());
    EXPECT_LT((Vec::Map(contact.points[0]) / unit - Vec(4, -70, 500)).norm(), 1e-13);
    EXPECT_LT((Vec::Map(contact.contact_point) / unit - Vec(3.95, -70, 500)).norm(), 1e-13);
  }
}

TEST(AdapterHelper, WhatIsNotFiniteIsSaid) {
  const Frame frame(two_balls(1));
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Vector x{1, 0, 0};
  for (const adapter::Answer& answer : {adapter::Answer{nan, x, x, x}, adapter::Answer{1, {0, 0, 0}, x, x},
                                        adapter::Answer{1, x, {nan, 0, 0}, x}, adapter::Answer{1, x, x, {0, 0, nan}}}) {
    plumb_contact contact{};
    frame.write(answer, contact);
    EXPECT_EQ(contact.status, PLUMB_NOT_FINITE);
  }
}

int ask(const plumb_pair& pair, plumb_contact& contact, int shapes = PLUMB_SUPERELLIPSOIDS) {
  return adapter::run([&](plumb_abilities& abilities) { abilities.shapes = shapes; },
                      [](const Frame&, plumb_contact& out) { out.status = PLUMB_CONVERGED; }, pair, contact);
}

TEST(AdapterHelper, WhatIsNotLegalOrNotClaimedIsRefused) {
  plumb_contact contact{};
  plumb_pair pair = two_balls(1);
  EXPECT_EQ(ask(pair, contact, PLUMB_SPHERES), 0);
  pair.bodies[1].semi_axes[2] = 0.3;
  EXPECT_EQ(ask(pair, contact, PLUMB_SPHERES), 1);
  EXPECT_EQ(ask(pair, contact, PLUMB_ELLIPSOIDS), 0);
  pair.bodies[1].exponents[0] = std::nextafter(2.0, 3.0);
  EXPECT_EQ(ask(pair, contact, PLUMB_ELLIPSOIDS), 1);
  EXPECT_EQ(ask(pair, contact), 0);
  for (double* wrong : {&pair.bodies[0].semi_axes[1], &pair.bodies[1].exponents[1], &pair.bodies[0].position[2]}) {
    const double before = std::exchange(*wrong, std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(ask(pair, contact), 1);
    *wrong = before;
  }
  std::fill_n(pair.bodies[1].quaternion_wxyz, 4, 0.0);
  EXPECT_EQ(ask(pair, contact), 1);
}

TEST(AdapterHelper, AnExceptionIsNoAnswer) {
  plumb_contact contact{};
  const auto fail = [](const Frame&, plumb_contact&) { throw std::runtime_error("none"); };
  EXPECT_EQ(adapter::run([](plumb_abilities&) {}, fail, two_balls(1), contact), 0);
  EXPECT_EQ(contact.status, PLUMB_STALLED);
}

TEST(AdapterHelper, TheExampleInCAndTheOneInCppAnswerAlike) {
  const std::string folder = std::string(PLUMB_BINARY_DIR) + "/tests/";
  const Solver c = load_solver_in_process(folder + "foreign_example.so");
  const Solver cpp = load_solver_in_process(folder + "foreign_example_cpp.so");
  EXPECT_EQ(cpp.name, "solver:bounding-spheres");
  for (std::uint64_t i = 0; i < 100; ++i) {
    const Pair pair = generate("superquadric", 1, i).pair;
    const Contact<double> one = c.solve(pair, {}, nullptr), two = cpp.solve(pair, {}, nullptr);
    EXPECT_EQ(one.verdict, two.verdict);
    EXPECT_LT((one.normal - two.normal).norm(), 1e-14);
    const double size = size_of(pair);
    EXPECT_LT(std::abs(one.overlap - two.overlap), 1e-14 * size);
    EXPECT_LT((one.point2 - two.point2).norm(), 1e-14 * size);
  }
}

}  // namespace
}  // namespace plumb
