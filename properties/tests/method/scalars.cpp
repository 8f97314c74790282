// The methods in other scalars than double: float keeps to what its rounding allows, and long double and 50 digits show the order
// of convergence.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "properties/generators/families.hpp"
#include "solver/method/automatic.hpp"
#include "solver/method/published/common_normal_impl.hpp"
#include "solver/reference/condition/solution_set.hpp"
#include "solver/reference/reference.hpp"

namespace plumb {
namespace {

TEST(Scalars, FloatIsWithinItsEnvelope) {
  const double few = reference::rounding_epsilons * epsilon<float>();
  for (std::uint64_t i = 0; i < 60; ++i) {
    const Pair pair = generate("ellipsoid", 6, i).pair;
    const Solution truth = find_reference(pair).common_normal;
    const Contact<float> c = find_method_in<float>("auto")->solve(pair, {}, nullptr);
    ASSERT_EQ(c.status, Status::converged) << i;
    const auto off = [](const Vec3<float>& a, const Vec3<Real50>& b) {
      return (a.cast<double>() - b.cast<double>()).norm();
    };
    const double size = size_of(pair);
    EXPECT_LE(off(c.normal, truth.normal), few * truth.condition.normal) << i;
    EXPECT_LE(off(c.point1, truth.point1), few * truth.condition.points * size) << i;
    EXPECT_LE(off(c.point2, truth.point2), few * truth.condition.points * size) << i;
    EXPECT_LE(std::abs(c.overlap - static_cast<double>(truth.overlap)), few * truth.condition.overlap * size) << i;
  }
}

TEST(Scalars, FloatIsRoundedInThePairsFrame) {
  Pair near = generate("ellipsoid", 6, 1).pair, far = near;
  far.body1.position[0] += 1e6;
  far.body2.position[0] += 1e6;
  const Contact<float> a = find_method_in<float>("auto")->solve(near, {}, nullptr),
                       b = find_method_in<float>("auto")->solve(far, {}, nullptr);
  EXPECT_NEAR(a.overlap, b.overlap, 1e-6);
  EXPECT_LE((a.normal - b.normal).norm(), 1e-5);
}

// The start says the answer, and its correction has a length without a reciprocal.
TEST(Scalars, NeedlesThatTouchByTheirEndsKeepTheirStart) {
  Pair pair;
  pair.body1.shape.semi_axes = pair.body2.shape.semi_axes = {1.9, 1.4e-10, 1.4e-10};
  pair.body2.position = {3.8, 0, 0};
  const Contact<float> c = find_method_in<float>("auto")->solve(pair, {}, nullptr);
  EXPECT_EQ(c.status, Status::converged);
  EXPECT_EQ(c.iterations, 0);
  EXPECT_LE((c.normal - Vec3<float>::UnitX()).norm(), 4 * epsilon<float>());
}

/// How far the normals of a solve's first iterates are from its last one's.
template <class S>
std::vector<double> errors(SolveFunction<S> solve, const Pair& pair, int most) {
  const Vec3<S> last = solve(pair, {}, nullptr).normal;
  std::vector<double> out;
  for (Want want{.iteration_limit = 0}; want.iteration_limit <= most; ++want.iteration_limit)
    out.push_back(static_cast<double>(S((solve(pair, want, nullptr).normal - last).norm())));
  return out;
}

/// log(e2/e1) / log(e1/e0) of the last three errors above the rounding; NaN where there are none.
double order(const std::vector<double>& e, double rounding) {
  for (std::size_t k = e.size(); k-- > 2;)
    if (e[k] > rounding && e[k - 2] < 0.1) return std::log(e[k] / e[k - 1]) / std::log(e[k - 1] / e[k - 2]);
  return std::numeric_limits<double>::quiet_NaN();
}

template <class S>
double median_order(SolveFunction<S> solve, std::string_view family, int most, double rounding) {
  std::vector<double> orders;
  for (std::uint64_t i = 0; i < 20; ++i) {
    const Pair pair = generate(family, 6, i).pair;
    if (solve(pair, {}, nullptr).status != Status::converged) continue;
    const double found = order(errors(solve, pair, most), rounding);
    if (!std::isnan(found)) orders.push_back(found);
  }
  EXPECT_GE(orders.size(), 10U) << family;
  std::sort(orders.begin(), orders.end());
  return orders[orders.size() / 2];
}

TEST(Scalars, NewCnIsQuadratic) {
  for (const std::string_view family : {"spheroid", "ellipsoid", "superquadric"})
    EXPECT_GT(median_order<Real50>(new_cn<Real50>, family, 20, 1e-48), 1.9) << family;
}

// Spheroids take it two steps, too few for an order.
TEST(Scalars, AutoIsQuadratic) {
  for (const std::string_view family : {"ellipsoid", "superquadric"})
    EXPECT_GT(median_order<long double>(automatic<long double>, family, 13, 1e-17), 1.8) << family;
}

}  // namespace
}  // namespace plumb
