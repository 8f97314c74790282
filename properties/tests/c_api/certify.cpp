// plumb_certify says in doubles what the reference proves, never more.
#include <gtest/gtest.h>

#include <cmath>

#include "properties/generators/families.hpp"
#include "solver/c/door.hpp"
#include "solver/plumb.h"
#include "solver/reference/reference.hpp"

namespace plumb {
namespace {

plumb_certificate certificate_of(const Pair& pair) {
  const plumb_pair c = door::c_pair(pair);
  plumb_certificate out{};
  out.size = sizeof out;
  EXPECT_EQ(plumb_certify(&c, &out), PLUMB_OK);
  return out;
}

/// How far the reference's point is from the printed one.
Real50 distance(const Vec3<Real50>& to, const double (&from)[3]) {
  return (to - Vec3<double>::Map(from).cast<Real50>()).norm();
}

class CCertify : public testing::TestWithParam<const char*> {};

TEST_P(CCertify, HoldsTheReferencesBoundsAndBalls) {
  for (std::uint64_t i = 0; i < 12; ++i) {
    const Pair pair = generate(GetParam(), 8, i).pair;
    const Reference expected = find_reference(pair);
    const plumb_certificate found = certificate_of(pair);
    EXPECT_EQ(found.verdict, static_cast<int>(expected.verdict)) << i;
    EXPECT_EQ(found.global, static_cast<int>(expected.global)) << i;
    EXPECT_EQ(found.unique, static_cast<int>(expected.unique)) << i;
    EXPECT_LE(Real50(found.overlap_lower), expected.overlap.lower) << i;
    EXPECT_GE(Real50(found.overlap_upper), expected.overlap.upper) << i;
    EXPECT_EQ(std::isnan(found.normal[0]), !expected.common_normal.proved) << i;
    if (!expected.common_normal.proved) continue;
    const Solution& solution = expected.common_normal;
    EXPECT_GE(Real50(found.normal_radius), solution.normal_radius + distance(solution.normal, found.normal)) << i;
    EXPECT_GE(Real50(found.points_radius), solution.points_radius + distance(solution.point1, found.points[0])) << i;
    EXPECT_GE(Real50(found.points_radius), solution.points_radius + distance(solution.point2, found.points[1])) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Families, CCertify, testing::Values("ellipsoid", "superquadric", "hard"),
                         [](const auto& family) { return std::string(family.param); });

TEST(CCertifyErrors, AreArguments) {
  plumb_pair pair = door::c_pair(generate("spheroid", 8, 0).pair);
  plumb_certificate certificate{};
  EXPECT_EQ(plumb_certify(&pair, &certificate), PLUMB_ERROR_ARGUMENT);  // its size is not set
  certificate.size = sizeof certificate;
  EXPECT_EQ(plumb_certify(&pair, nullptr), PLUMB_ERROR_ARGUMENT);
  pair.bodies[0].exponents[0] = 1;
  EXPECT_EQ(plumb_certify(&pair, &certificate), PLUMB_ERROR_ARGUMENT);
}

}  // namespace
}  // namespace plumb
