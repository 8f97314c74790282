// Principal curvature against closed forms, and at the places where radii are infinite or zero.
#include "solver/shape/curvature.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>

#include "properties/generators/generators.hpp"

namespace plumb::curvature_tests {
namespace {

using Shape = Superellipsoid<double>;
using Vec = Vec3<double>;
using Curvature = PrincipalCurvature<double>;
using generators::direction;
using generators::shape;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Curvature curvature_at(const Shape& s, const Vec& x) {
  return principal_curvature<double>(s, x);
}

TEST(Curvature, SphereHasItsRadiusEverywhere) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    Stream stream("sphere", 0, i);
    const Curvature c = curvature_at(Shape{Vec::Constant(3), 2, 2}, generators::draw_direction(stream));
    EXPECT_NEAR(c.radius1, 3, 16 * kEpsilon * 3);
    EXPECT_NEAR(c.radius2, 3, 16 * kEpsilon * 3);
  }
}

/// At the end of the axis a: b^2/a along b and c^2/a along c.
TEST(Curvature, EllipsoidAtTheEndsOfItsAxes) {
  for (const Vec& axes : {Vec(1, 2, 3), Vec(1, 1e-3, 10), Vec(1e4, 1, 1), Vec(1, 1, 1e-4)})
    for (int i = 0; i < 3; ++i)
      for (const double sign : {-1.0, 1.0}) {
        const Curvature c = curvature_at(Shape{axes, 2, 2}, Vec::Unit(i) * sign);
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const double along_j = axes[j] * axes[j] / axes[i], along_k = axes[k] * axes[k] / axes[i];
        EXPECT_NEAR(c.radius1, std::min(along_j, along_k), 8 * kEpsilon * c.radius1);
        EXPECT_NEAR(c.radius2, std::max(along_j, along_k), 8 * kEpsilon * c.radius2);
        if (along_j != along_k) {
          EXPECT_EQ(c.direction1.cwiseAbs(), Vec::Unit(along_j < along_k ? j : k));
        }
      }
}

/// Ellipsoid with shape matrix S: the radii's product is (h^4 / (abc)^2)^-1 at a point whose normal has support h, their
/// sum the trace of the support function's Hessian, (tr S - |p|^2) / h.
RC_GTEST_PROP(Curvature, EllipsoidAnywhere, ()) {
  Shape s = *shape();
  s.n1 = s.n2 = 2;
  RC_PRE(s.semi_axes.minCoeff() > 0.1);
  const Vec u = *direction();
  const auto support = support_point<double>(s, u);
  const Curvature c = curvature_at(s, support.gradient);
  const double squares = s.semi_axes.squaredNorm(), product = s.semi_axes.prod(), h = support.value;
  const double sum = (squares - support.gradient.squaredNorm()) / h;
  RC_ASSERT(std::abs(c.radius1 + c.radius2 - sum) <= 1e-12 * sum);
  RC_ASSERT(std::abs(c.radius1 * c.radius2 / (product * product / (h * h * h * h)) - 1) <= 1e-11);
}

RC_GTEST_PROP(Curvature, IsNeverNaNAndItsFrameIsOrthonormal, ()) {
  const Shape s = *shape();
  const auto at = CubePoint<double>::of(*direction());
  const Curvature c = principal_curvature<double>(s, at);
  RC_ASSERT(c.radius1 >= 0);
  RC_ASSERT(c.radius2 >= c.radius1 * (1 - 1e-9));
  const Vec n = surface_point<double>(s, at).normal;
  RC_ASSERT((c.direction1.cross(c.direction2) - n).norm() <= 32 * kEpsilon);
  RC_ASSERT(std::abs(c.direction1.dot(n)) <= 16 * kEpsilon);
}

RC_GTEST_PROP(Curvature, ScalesWithTheUnitOfLength, ()) {
  const Shape s = *shape();
  const Vec u = *direction();
  for (const double component : u) RC_PRE(component == 0 || std::abs(component) > 1e-3);  // no bit lost to underflow
  const auto at = CubePoint<double>::of(u);
  Shape scaled = s;
  scale(scaled, 0x1p200);
  const Curvature c = principal_curvature<double>(s, at), d = principal_curvature<double>(scaled, at);
  RC_ASSERT(d.radius1 == c.radius1 * 0x1p200);
  RC_ASSERT(d.radius2 == c.radius2 * 0x1p200);
}

/// In the middle of a face of exponent above 2 the surface is flat, of exponent below 2 it has an edge or a tip.
TEST(Curvature, FlatsAndEdges) {
  const Vec axes(1, 2, 3);
  for (int i = 0; i < 3; ++i) {
    const Curvature flat = curvature_at(Shape{axes, 4, 4}, Vec::Unit(i));
    EXPECT_EQ(flat.radius1, kInfinity);
    EXPECT_EQ(flat.radius2, kInfinity);
    const Curvature tip = curvature_at(Shape{axes, 1.5, 1.5}, Vec::Unit(i));
    EXPECT_EQ(tip.radius1, 0);
    EXPECT_EQ(tip.radius2, 0);
  }
  const Curvature cylinder = curvature_at(Shape{Vec(2, 2, 3), 8, 2}, Vec(1, 1, 0));  // flat along z, round about it
  EXPECT_NEAR(cylinder.radius1, 2, 16 * kEpsilon * 2);
  EXPECT_EQ(cylinder.radius2, kInfinity);
  EXPECT_LE((cylinder.direction2.cwiseAbs() - Vec::UnitZ()).norm(), 4 * kEpsilon);
  const Curvature lens = curvature_at(Shape{Vec(2, 2, 3), 1.5, 2}, Vec(1, 1, 0));  // an edge around the equator
  EXPECT_EQ(lens.radius1, 0);
  EXPECT_NEAR(lens.radius2, 2, 16 * kEpsilon * 2);
  const Curvature mixed = curvature_at(Shape{axes, 4, 1.5}, Vec(1, 0, 0));  // flat along z, an edge across y
  EXPECT_EQ(mixed.radius1, 0);
  EXPECT_EQ(mixed.radius2, kInfinity);
}

/// n1 = 2 != n2 at the pole: the values along the x and the y axis, a^2/c and b^2/c.
TEST(Curvature, PoleWithOuterExponentTwo) {
  const Curvature c = curvature_at(Shape{Vec(1, 2, 4), 2, 6}, Vec(0, 0, 1));
  EXPECT_DOUBLE_EQ(c.radius1, 0.25);
  EXPECT_DOUBLE_EQ(c.radius2, 1);
}

/// So close to the pole that the normal's map underflows: as at the pole.
TEST(Curvature, BesideThePole) {
  const Curvature c = curvature_at(Shape{Vec::Ones(), 50, 1.5}, Vec(0, 1e-247, 1));
  EXPECT_EQ(c.radius1, kInfinity);
  EXPECT_EQ(c.radius2, kInfinity);
}

/// The meridian of the curve |x|^n + |z|^n = 1 at 45 degrees: radius 2^(1/2 - 1/n) / (n - 1).
TEST(Curvature, SuperellipseAtItsCorner) {
  for (const double n : {1.25, 1.5, 2.0, 3.0, 8.0, 40.0}) {
    const Curvature c = curvature_at(Shape{Vec::Ones(), n, 2}, Vec(1, 0, 1));
    const double meridian = std::pow(2, 0.5 - 1 / n) / (n - 1), parallel = std::pow(2, 0.5 - 1 / n);
    EXPECT_NEAR(c.radius1, std::min(meridian, parallel), 1e-13 * c.radius1) << n;
    EXPECT_NEAR(c.radius2, std::max(meridian, parallel), 1e-13 * c.radius2) << n;
  }
}

/// A needle of aspect 1e300: the squares in the normal's length would overflow.
TEST(Curvature, IsNoNaNAtTheEndsOfTheRange) {
  for (const double n1 : {1.5, 2.0, 50.0})
    for (const double n2 : {1.5, 2.0, 50.0}) {
      const Superellipsoid<double> shape{{1e-150, 1e150, 1e-150}, n1, n2};
      const PrincipalCurvature<double> c = principal_curvature<double>(shape, shape.semi_axes);
      EXPECT_FALSE(std::isnan(c.radius1) || std::isnan(c.radius2)) << n1 << ' ' << n2;
      EXPECT_TRUE(c.direction1.allFinite() && c.direction2.allFinite()) << n1 << ' ' << n2;
    }
}

}  // namespace
}  // namespace plumb::curvature_tests
