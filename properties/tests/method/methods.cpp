// The methods: closed forms, statuses, Jacobians, no heap in a solve.
#include "solver/method/methods.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "properties/generators/families.hpp"
#include "properties/tests/allocations.hpp"
#include "solver/method/published/common_normal_impl.hpp"
#include "solver/method/published/geometric_potential_impl.hpp"

namespace plumb {
namespace {

Pair unit_spheres(double distance) {
  Pair pair;
  pair.body2.position << 0, 0, distance;
  return pair;
}

TEST(Methods, SpheresInClosedForm) {
  for (const Method& method : methods()) {
    Pair pair = unit_spheres(0);
    pair.body2.shape.semi_axes.setConstant(2);
    pair.body2.position << 1, 2, 2;  // distance 3 less a fiftieth
    pair.body2.position *= 0.98;
    const Contact<double> c = method.solve(pair, {}, nullptr);
    ASSERT_EQ(c.status, Status::converged) << method.name;
    EXPECT_EQ(c.verdict, Verdict::overlapping) << method.name;
    EXPECT_NEAR(c.overlap, 0.06, 1e-15) << method.name;
    EXPECT_LE((c.normal - Vec3<double>(1, 2, 2) / 3).norm(), 2e-15) << method.name;
    EXPECT_LE((c.point1 - c.normal).norm(), 2e-15) << method.name;
    EXPECT_LE((c.point2 - (pair.body2.position - 2 * c.normal)).norm(), 2e-15) << method.name;
  }
}

TEST(Methods, SeparatedSpheresHaveANegativeOverlap) {
  for (const std::string_view name :
       {"new_cn", "minimum_distance", "geometric_potential", "geometric_potential_midway", "first_touch"}) {
    const Contact<double> c = find_method(name)->solve(unit_spheres(2.5), {}, nullptr);
    ASSERT_EQ(c.status, Status::converged) << name;
    EXPECT_EQ(c.verdict, Verdict::separated) << name;
    EXPECT_NEAR(c.overlap, -0.5, 1e-15) << name;
    EXPECT_LE((c.normal - Vec3<double>::UnitZ()).norm(), 1e-15) << name;
  }
}

/// On an axis the principal radii are b^2/a and c^2/a, and those of body 2 are found in world axes and lengths.
TEST(Methods, CurvatureWhereItIsAskedFor) {
  Pair pair;
  pair.body1.shape.semi_axes << 1, 2, 3;
  pair.body2.shape.semi_axes << 4, 3, 1;
  pair.body2.quaternion = {1, 0, 1, 0};  // its z axis along x
  pair.body2.position << 1.9, 0, 0;
  Want want;
  for (const std::string_view name :
       {"new_cn", "minimum_distance", "geometric_potential", "geometric_potential_midway", "first_touch"}) {
    want.curvature = true;
    const Contact<double> c = find_method(name)->solve(pair, want, nullptr);
    EXPECT_NEAR(c.curvature[0].radius1, 4, 1e-13) << name;
    EXPECT_NEAR(c.curvature[0].radius2, 9, 1e-13) << name;
    EXPECT_NEAR(std::abs(c.curvature[0].direction1[1]), 1, 1e-13) << name;
    EXPECT_NEAR(c.curvature[1].radius1, 9, 1e-13) << name;
    EXPECT_NEAR(c.curvature[1].radius2, 16, 1e-13) << name;
    EXPECT_NEAR(std::abs(c.curvature[1].direction2[2]), 1, 1e-13) << name;
    want.curvature = false;
    EXPECT_TRUE(std::isnan(find_method(name)->solve(pair, want, nullptr).curvature[0].radius1)) << name;
  }
}

TEST(Methods, TheAnswerNamesTheMethodThatAnswered) {
  for (const Method& method : methods()) EXPECT_EQ(method.solve(unit_spheres(1.9), {}, nullptr).method, method.name);
}

TEST(Methods, IllegalInputIsRefusedAndNothingElse) {
  Pair pair = unit_spheres(1.9);
  pair.body2.shape.semi_axes[1] = -1;
  for (const Method& method : methods()) {
    const Contact<double> c = method.solve(pair, {}, nullptr);
    EXPECT_EQ(c.status, Status::invalid_input);
    EXPECT_TRUE(std::isnan(c.overlap));
  }
}

TEST(Methods, EveryExitHasItsOwnStatus) {
  const Case c = generate("ellipsoid", 1, 7);
  for (const Method& method : methods()) {
    Want one_step;
    one_step.iteration_limit = 1;
    EXPECT_EQ(method.solve(c.pair, one_step, nullptr).status, Status::iteration_limit) << method.name;
  }
  // Coincident centres of equal spheres: no normal is better than another, and GP's gradient does not exist.
  EXPECT_EQ(find_method("geometric_potential_midway")->solve(unit_spheres(0), {}, nullptr).status, Status::not_finite);
}

TEST(Methods, AToleranceEndsEarlier) {
  const Case c = generate("spheroid", 1, 7);
  Want rough;
  rough.tolerance = 1e-3;
  const Method* method = find_method("new_cn");
  EXPECT_LT(method->solve(c.pair, rough, nullptr).evaluations, method->solve(c.pair, {}, nullptr).evaluations);
}

TEST(Methods, AWarmStartCostsLess) {
  Case c = generate("spheroid", 1, 7);
  const Method* method = find_method("new_cn");
  const Contact<double> cold = method->solve(c.pair, {}, nullptr);
  c.pair.body2.position[0] += 1e-6;
  EXPECT_LT(method->solve(c.pair, {}, &cold).iterations, method->solve(c.pair, {}, nullptr).iterations);
}

#if !defined(__SANITIZE_ADDRESS__)
TEST(Methods, NoHeapInASolve) {
  for (const std::string_view family : {"spheroid", "superquadric"})
    for (std::uint64_t i = 0; i < 20; ++i) {
      const Pair pair = generate(family, 3, i).pair;
      for (const Method& method : methods()) {
        Want all;
        all.curvature = all.derivatives = all.patch = true;
        const long before = allocations;
        const Contact<double> c = method.solve(pair, all, nullptr);
        (void)find_method_in<float>(method.name)->solve(pair, all, nullptr);
        ASSERT_EQ(allocations, before) << method.name << ", status " << name(c.status);
      }
    }
}
#endif

/// One template, two scalars: the answers differ by double's rounding, and long double's is the better one.
TEST(Methods, LongDoubleGivesTheSameAnswerWithMoreDigits) {
  for (std::uint64_t i = 0; i < 20; ++i) {
    const Pair pair = generate("spheroid", 4, i).pair;
    for (const Method& method : methods()) {
      // The published systems' wrong roots are ill conditioned: rounding decides where they end.
      if (method.name != "auto" && method.name != "new_cn") continue;
      const Contact<double> c = method.solve(pair, {}, nullptr);
      const Contact<long double> fine = find_method_in<long double>(method.name)->solve(pair, {}, nullptr);
      ASSERT_EQ(fine.status, Status::converged) << method.name;
      EXPECT_NEAR(c.overlap, static_cast<double>(fine.overlap), 1e-15 * 8 * size_of(pair));
      const Vec3<long double> d = fine.point2 - fine.point1;
      EXPECT_LT(static_cast<double>(d.cross(fine.normal).norm()), 1e-18 * 8 * size_of(pair));
    }
  }
}

/// Largest difference of a system's Jacobian from central differences, relative to its largest entry.
template <int Equations, int Unknowns, class System>
double jacobian_error(const System& system, const Eigen::Matrix<long double, Unknowns, 1>& x) {
  const long double step = 1e-6L;
  const auto at = system(x);
  Eigen::Matrix<long double, Equations, Unknowns> differences;
  for (int k = 0; k < Unknowns; ++k) {
    auto ahead = x, behind = x;
    ahead[k] += step;
    behind[k] -= step;
    differences.col(k) = (system(ahead).value - system(behind).value) / (2 * step);
  }
  return static_cast<double>((differences - at.jacobian).cwiseAbs().maxCoeff() / at.jacobian.cwiseAbs().maxCoeff());
}

TEST(Methods, JacobiansAreTheDerivatives) {
  using S = long double;
  for (const std::string_view family : {"spheroid", "ellipsoid"})
    for (std::uint64_t i = 0; i < 20; ++i) {
      const Pair pair = generate(family, 5, i).pair;
      const PlacedPair<S> placed = place<S>(pair);
      const Offsets<S> at = start_along<S>(placed, centre_line<S>(placed));
      Eigen::Matrix<S, 6, 1> six;
      six << at.r1, at.r2;
      Eigen::Matrix<S, 7, 1> seven;
      seven << six, S(0.1L);
      Eigen::Matrix<S, 4, 1> four;
      four << at.r1, S(1.3L);
      const double small = 1e-6;
      EXPECT_LT((jacobian_error<6, 6>(detail::LinNgSystem<S, false>{placed}, six)), small);
      EXPECT_LT((jacobian_error<6, 6>(detail::LinNgSystem<S, true>{placed}, six)), small);
      EXPECT_LT((jacobian_error<8, 7>(detail::NewSystem<S>{placed}, seven)), small);
      EXPECT_LT((jacobian_error<4, 4>(detail::DeepestSystem<S>{placed, placed.body1, placed.body2, S(2)}, four)),
                small);
      EXPECT_LT((jacobian_error<4, 4>(detail::MidwaySystem<S>{placed, S(2)}, four)), small);
    }
}

}  // namespace
}  // namespace plumb
