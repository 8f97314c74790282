// Foreign shapes: known ones behind functions are answered as they are themselves, and functions of no convex body are never answered.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "properties/tests/reference/drawn_bodies.hpp"
#include "solver/method/convex.hpp"
#include "solver/method/convex/core.hpp"
#include "solver/reference/convex_bounds.hpp"

namespace plumb::foreign_tests {
namespace {

using Vec = Vec3<double>;

/// A shape by its core, behind the functions.
struct Known {
  detail::RoundedCore of;

  explicit Known(const Shape& shape) : of(std::visit(detail::CoreOf(0, unwatched), shape)) {}

  static inline detail::ForeignWatch unwatched;
};

void support(const void* data, const double* n, double* x) {
  const auto& [core, radius] = static_cast<const Known*>(data)->of;
  const Vec u = Vec::Map(n);
  Vec::Map(x) = radius * u + std::visit([&](const auto& of) { return of.support(u); }, core).point;
}
void hessian(const void* data, const double* n, double* h) {
  const auto& [core, radius] = static_cast<const Known*>(data)->of;
  const Vec u = Vec::Map(n);
  const detail::CorePoint at = std::visit([&](const auto& of) { return of.support(u); }, core);
  Mat3<double>::Map(h) = radius * (Mat3<double>::Identity() - u * u.transpose()) +
                         std::visit([&](const auto& of) { return of.support(at.piece, u); }, core).hessian;
}
/// An honest enclosure of the ellipsoids below: each number is a few roundings off.
void enclose(const void* data, const double* n, double* lower, double* upper) {
  support(data, n, lower);
  for (int i = 0; i < 3; ++i) {
    const double off = 64 * std::numeric_limits<double>::epsilon() * std::abs(lower[i]) + 1e-300;
    upper[i] = lower[i] + off;
    lower[i] -= off;
  }
}

ForeignShape foreign(const Known& known, const Shape& shape, bool has_hessian) {
  return {support, has_hessian ? hessian : nullptr, nullptr, &known, bounding_radius({shape}) * (1 + 1e-14), 0};
}

struct Compared {
  int converged, stalled;
};

/// Pairs of a known shape behind functions and any other.
Compared compare(std::size_t kind1, std::size_t kind2, bool has_hessian, int pairs) {
  Compared out{};
  Stream stream("foreign", 1, 100 * kind1 + kind2);
  for (int i = 0; i < pairs; ++i) {
    const ConvexPair pair = reference::bodies_tests::draw_pair(kind1, kind2, stream);
    const Known known1(pair.body1.shape), known2(pair.body2.shape);
    ConvexPair behind = pair;
    behind.body1.shape = foreign(known1, pair.body1.shape, has_hessian);
    if (i % 2 == 0 && kind2 != 8) behind.body2.shape = foreign(known2, pair.body2.shape, has_hessian);
    const Contact<double> expected = solve_convex(pair, {}, nullptr), found = solve_convex(behind, {}, nullptr);
    const InputError error = find_foreign_error(behind);
    if (error.reason.ends_with("inscribed_radius") && (kind1 == 6 || kind2 == 6)) continue;  // a hull beside its origin
    EXPECT_EQ(error.reason, "") << i;
    if (expected.status != Status::converged) continue;
    if (found.status != Status::converged) {
      ++out.stalled;
      continue;
    }
    ++out.converged;
    EXPECT_NEAR(found.overlap, expected.overlap, 2e-13 * size_of(pair)) << i;
  }
  return out;
}

/// Bodies with edges stall the most: their pieces are not told.
TEST(ForeignShapes, AreAnsweredAsTheShapesBehindThem) {
  for (const bool has_hessian : {false, true}) {
    int converged = 0, stalled = 0;
    for (std::size_t kind1 = 0; kind1 < 8; ++kind1)
      for (const std::size_t kind2 : {0U, 1U, 2U, 5U, 6U, 8U, 9U}) {
        SCOPED_TRACE(std::to_string(kind1) + " " + std::to_string(kind2) + (has_hessian ? " with its Hessian" : ""));
        const Compared all = compare(kind1, kind2, has_hessian, 6);
        converged += all.converged;
        stalled += all.stalled;
      }
    EXPECT_LE(stalled, converged / (has_hessian ? 10 : 5));
  }
}

/// Of any function, which the test owns.
using Function = std::function<Vec(const Vec&)>;

ForeignShape by(const Function& function) {
  const auto call = [](const void* data, const double* n, double* x) {
    Vec::Map(x) = (*static_cast<const Function*>(data))(Vec::Map(n));
  };
  return {call, nullptr, nullptr, &function, 2, 0.5};
}

ConvexPair beside_box(const ForeignShape& shape, double z) {
  return {{shape, 0, {0, 0, 0}, {1, 0.1, 0.2, 0.3}}, {Box{{0.5, 0.75, 0.5}}, 0.125, {0.25, 0.125, z}, {1, 0.2, 0, 0}}};
}

struct Mistake {
  const char* name;
  Function function;
  Status status;
};

std::vector<Mistake> mistakes() {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  return {
      {"NaN", [](const Vec&) { return Vec(0, none, 0); }, Status::not_finite},
      {"infinite", [](const Vec& n) { return Vec(n / 0.0); }, Status::not_finite},
      {"NaN somewhere", [](const Vec& n) { return std::abs(n[2]) > 0.5 ? Vec(none, 0, 0) : n; }, Status::not_finite},
      {"too far", [](const Vec& n) { return Vec(3 * n); }, Status::invalid_input},
      {"a point", [](const Vec&) { return Vec(0, 0, 0); }, Status::invalid_input},
      {"against n", [](const Vec& n) { return Vec(-n); }, Status::invalid_input},
      {"a gradient of no support", [](const Vec& n) { return Vec(n[0], n[1], n[2] * n[2] * n[2]); },
       Status::invalid_input},
      {"the gauge's point", [](const Vec& n) { return Vec(n / Vec(n[0], n[1], 2 * n[2]).norm()); },
       Status::invalid_input},
      {"float", [](const Vec& n) { return Vec(n.cast<float>().normalized().cast<double>()); }, Status::invalid_input},
      {"dented", [](const Vec& n) { return Vec((1 - 1e-3 * std::cos(40 * n[0])) * n); }, Status::invalid_input}};
}

TEST(ForeignShapes, FunctionsOfNoConvexBodyAreNeverAnswered) {
  for (const auto& [name, function, status] : mistakes())
    for (const double z : {-3.0, -1.25, -0.5, 0.0, 0.75, 1.5, 4.0}) {
      const ConvexPair pair = beside_box(by(function), z);
      const Contact<double> found = solve_convex(pair, {}, nullptr);
      EXPECT_NE(found.status, Status::stalled) << name << " " << z;
      if (found.status == Status::converged)
        ADD_FAILURE() << name << " " << z << ": " << found.overlap << " " << found.normal.transpose();
      EXPECT_TRUE(std::isnan(found.overlap)) << name;
      const InputError error = find_foreign_error(pair);
      EXPECT_EQ(error.field, "shape.foreign.support") << name;
      EXPECT_EQ(error.body, 0);
      EXPECT_EQ(error.reason == "writes what is no finite number", found.status == Status::not_finite) << name;
      if (z == 0.0) {
        EXPECT_EQ(found.status, status) << name;
      }
    }
}

TEST(ForeignShapes, WhatChangesFromCallToCallIsNotAnswered) {
  int calls = 0;
  const Function changing = [&](const Vec& n) { return Vec((1 + 1e-9 * (++calls % 7)) * n); };
  for (const double z : {-0.5, 0.0, 1.0, 3.0})
    EXPECT_EQ(solve_convex(beside_box(by(changing), z), {}, nullptr).status, Status::invalid_input) << z;
}

TEST(ForeignShapes, IllegalOnesAreNamed) {
  const Function ball = [](const Vec& n) { return n; };
  const auto error = [&](auto&& change) {
    ForeignShape shape = by(ball);
    change(shape);
    const ConvexPair pair = beside_box(shape, 1);
    EXPECT_EQ(solve_convex(pair, {}, nullptr).status, Status::invalid_input);
    return find_input_error(pair).field;
  };
  EXPECT_EQ(error([](ForeignShape& s) { s.support = nullptr; }), "shape.foreign.support");
  EXPECT_EQ(error([](ForeignShape& s) { s.bounding_radius = 0; }), "shape.foreign.bounding_radius");
  EXPECT_EQ(error([](ForeignShape& s) { s.inscribed_radius = -1; }), "shape.foreign.inscribed_radius");
  EXPECT_EQ(error([](ForeignShape& s) { s.inscribed_radius = 3; }), "shape.foreign.inscribed_radius");
}

TEST(ForeignShapes, AreProvedByTheirEnclosuresAlone) {
  Stream stream("enclosed", 1, 0);
  for (int i = 0; i < 40; ++i) {
    const Shape ellipsoid = Superellipsoid<double>{{1, stream.uniform(0.3, 1), stream.uniform(0.3, 1)}, 2, 2};
    ConvexPair pair = reference::bodies_tests::draw_pair(i % 2 == 0 ? 5 : 2, 0, stream);
    pair.body2.shape = ellipsoid;
    const Known known(ellipsoid);
    ForeignShape shape = foreign(known, ellipsoid, true);
    ConvexPair behind = pair;
    behind.body2.shape = shape;
    const Contact<double> answer = solve_convex(behind, {}, nullptr);
    const reference::ConvexBounds open = reference::bound_overlap(behind, answer.normal, 2000);
    EXPECT_TRUE(std::isinf(open.lower) && std::isinf(open.upper));
    const reference::ConvexErrors unknown = reference::errors_of(behind, answer, open);
    EXPECT_EQ(unknown.overlap, 0);
    EXPECT_EQ(unknown.point2, 0);
    EXPECT_EQ(unknown.touching2, 0);
    EXPECT_NE(reference::what_is_open(behind, open).find("body 2 has no enclosures"), std::string_view::npos);
    shape.enclose = enclose;
    behind.body2.shape = shape;
    const reference::ConvexBounds bounds = reference::bound_overlap(behind, answer.normal, 2000),
                                  own = reference::bound_overlap(pair, answer.normal, 2000);
    EXPECT_LE(bounds.lower, own.upper) << i;
    EXPECT_GE(bounds.upper, own.lower) << i;
    EXPECT_LE(bounds.upper - bounds.lower, 2 * (own.upper - own.lower) + 1e-12) << i;
    const reference::ConvexErrors errors = reference::errors_of(behind, answer, bounds);
    EXPECT_LE(std::max({errors.overlap, errors.point1, errors.point2, errors.touching1, errors.touching2}), 1e-12) << i;
  }
}

}  // namespace
}  // namespace plumb::foreign_tests
