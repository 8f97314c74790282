// The family hard: each generator reaches the place that its name says.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

#include "properties/families.hpp"
#include "properties/generators.hpp"
#include "solver/pose.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb {
namespace {

constexpr std::uint64_t kCases = 200;

using Test = std::function<bool(const Case&)>;

double share(std::string_view generator, const Test& holds) {
  int count = 0;
  for (std::uint64_t i = 0; i < kCases; ++i) count += holds(generate_hard(generator, 7, i)) ? 1 : 0;
  return static_cast<double>(count) / static_cast<double>(kCases);
}

bool all(std::string_view generator, const Test& holds) {
  return share(generator, holds) == 1;
}

double fact(const Case& c, const char* name) {
  return c.provenance.at(name).get<double>();
}

double aspect_of(const Superellipsoid<double>& s) {
  return s.semi_axes.maxCoeff() / s.semi_axes.minCoeff();
}

bool is_subnormal(double x) {
  return x != 0 && std::abs(x) < std::numeric_limits<double>::min();
}

TEST(Hard, EveryGeneratorGivesLegalPairs) {
  for (const std::string_view generator : hard_generators())
    for (std::uint64_t i = 0; i < 100; ++i) {
      const Case c = generate_hard(generator, 9, i);
      EXPECT_TRUE(is_valid(c.pair)) << c.name << ": " << find_input_error(c.pair).field;
      EXPECT_EQ(c.provenance.at("generator").get<std::string>(), generator);
      EXPECT_EQ(format_case(c), format_case(generate_hard(generator, 9, i)));
    }
}

TEST(Hard, NamesAreDifferentAndTheFamilyTakesTurns) {
  const auto names = hard_generators();
  EXPECT_EQ(std::set(names.begin(), names.end()).size(), names.size());
  std::set<std::string> seen;
  for (std::uint64_t i = 0; i < names.size(); ++i)
    seen.insert(generate("hard", 1, 1000 + i).provenance.at("generator").get<std::string>());
  EXPECT_EQ(seen.size(), names.size());
}

TEST(Hard, NearTouchingOnBothSidesDownTo1em16) {
  const auto below = [](double limit) {
    return [=](const Case& c) { return std::abs(fact(c, "overlap_ratio")) < limit; };
  };
  for (const std::string_view name : {"near_touching_overlapping", "near_touching_separated"}) {
    EXPECT_TRUE(all(name, below(1e-4)));
    EXPECT_NEAR(share(name, below(1e-10)), 0.5, 0.15);
    EXPECT_GT(share(name, below(1e-15)), 0.03);
  }
  EXPECT_TRUE(all("near_touching_overlapping", [](const Case& c) { return fact(c, "overlap_ratio") > 0; }));
  EXPECT_TRUE(all("near_touching_separated", [](const Case& c) { return fact(c, "overlap_ratio") < 0; }));
}

TEST(Hard, DeepOverlapToConcentricAndInside) {
  EXPECT_TRUE(all("deep_overlap", [](const Case& c) { return fact(c, "overlap_ratio") >= 0.3; }));
  EXPECT_TRUE(all("concentric", [](const Case& c) { return c.pair.body1.position == c.pair.body2.position; }));
  EXPECT_TRUE(all("nearly_concentric", [](const Case& c) {
    const double distance = (c.pair.body2.position - c.pair.body1.position).norm();
    return distance > 0 && distance < 1.01e-2;
  }));
  const auto inside = [](const Body& inner, const Body& outer) {  // the corners of a box around the inner body
    const Mat3<double> to_outer = rotation<double>(outer.quaternion).transpose();
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3<double> sign((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 4) != 0 ? 1 : -1);
      const Vec3<double> x = rotation<double>(inner.quaternion) * inner.shape.semi_axes.cwiseProduct(sign);
      if (gauge<double>(outer.shape, to_outer * (x + inner.position - outer.position)) >= 1) return false;
    }
    return true;
  };
  EXPECT_TRUE(all("one_inside_other", [&](const Case& c) {
    return inside(c.pair.body2, c.pair.body1) || inside(c.pair.body1, c.pair.body2);
  }));
  EXPECT_NEAR(share("one_inside_other", [&](const Case& c) { return inside(c.pair.body2, c.pair.body1); }), 0.5, 0.15);
}

TEST(Hard, FarApart) {
  EXPECT_TRUE(all("far_apart", [](const Case& c) { return fact(c, "overlap_ratio") <= -1; }));
  EXPECT_GT(share("far_apart", [](const Case& c) { return fact(c, "overlap_ratio") < -1e4; }), 0.15);
}

TEST(Hard, NeedlesAndDiscsReachAspect1e4) {
  for (const std::string_view name : {"needle", "disc", "needle_against_disc"}) {
    EXPECT_TRUE(all(name, [](const Case& c) { return aspect_of(c.pair.body1.shape) >= 10; }));
    EXPECT_GT(share(name, [](const Case& c) { return aspect_of(c.pair.body1.shape) > 3e3; }), 0.08);
  }
}

TEST(Hard, SizeRatioReaches1e6OnEitherSide) {
  const auto ratio = [](const Case& c) {
    return c.pair.body1.shape.semi_axes.maxCoeff() / c.pair.body2.shape.semi_axes.maxCoeff();
  };
  EXPECT_GT(share("size_ratio", [&](const Case& c) { return ratio(c) > 1e5; }), 0.05);
  EXPECT_GT(share("size_ratio", [&](const Case& c) { return ratio(c) < 1e-5; }), 0.05);
}

TEST(Hard, ExponentsAtTheirExtremes) {
  const auto n1 = [](const Case& c) { return c.pair.body1.shape.n1; };
  EXPECT_TRUE(all("exponent_near_one", [&](const Case& c) { return n1(c) >= 1.1 && n1(c) <= 1.5; }));
  EXPECT_GT(share("exponent_near_one", [&](const Case& c) { return n1(c) == 1.1; }), 0.3);
  EXPECT_TRUE(all("exponent_near_two", [&](const Case& c) { return n1(c) != 2 && std::abs(n1(c) - 2) <= 1e-6; }));
  EXPECT_GT(share("exponent_near_two", [&](const Case& c) { return n1(c) < 2 && n1(c) > 2 - 1e-11; }), 0.1);
  EXPECT_GT(share("exponent_near_two", [&](const Case& c) { return n1(c) > 2 && n1(c) < 2 + 1e-11; }), 0.1);
  for (const double n : {8.0, 20.0, 50.0})
    EXPECT_GT(share("exponent_large", [&](const Case& c) { return n1(c) == n; }), 0.2);
}

TEST(Hard, ZeroCoordinatesWithDifferentExponents) {
  EXPECT_TRUE(all("zero_coordinate", [](const Case& c) {
    return c.pair.body1.shape.n1 != c.pair.body1.shape.n2 && (c.pair.body2.position.array() == 0).any();
  }));
}

TEST(Hard, FacesMeetWithEveryTilt) {
  for (const std::string_view name : {"face_face", "edge_face", "edge_edge", "corner_face"}) {
    EXPECT_NEAR(share(name, [](const Case& c) { return fact(c, "tilt") == 0; }), 0.25, 0.12);
    EXPECT_GT(share(name, [](const Case& c) { return fact(c, "tilt") > 0 && fact(c, "tilt") < 1e-12; }), 0.1);
    EXPECT_GT(share(name, [](const Case& c) { return fact(c, "tilt") > 1e-5; }), 0.05);
    EXPECT_NEAR(share(name, [](const Case& c) { return fact(c, "depth") > 0; }), 0.5, 0.15);
  }
}

/// An untilted pair of faces has exactly parallel faces: both rotations map axes on axes.
TEST(Hard, UntiltedFacesAreExactlyParallel) {
  EXPECT_TRUE(all("face_face", [](const Case& c) {
    const Mat3<double> r1 = rotation<double>(c.pair.body1.quaternion), r2 = rotation<double>(c.pair.body2.quaternion);
    return r2 * r2.transpose() == Mat3<double>::Identity() && (fact(c, "tilt") != 0 || r1 == Mat3<double>::Identity());
  }));
}

TEST(Hard, EqualParallelAndCoaxial) {
  EXPECT_TRUE(all("equal_parallel", [](const Case& c) {
    return c.pair.body1.shape.semi_axes == c.pair.body2.shape.semi_axes &&
           c.pair.body1.quaternion == c.pair.body2.quaternion;
  }));
  EXPECT_TRUE(all("coaxial", [](const Case& c) {
    const Vec3<double> offset = c.pair.body2.position - c.pair.body1.position;
    const Mat3<double> r = rotation<double>(c.pair.body2.quaternion);
    return (offset.array() != 0).count() == 1 && r * r.transpose() == Mat3<double>::Identity();
  }));
}

TEST(Hard, RightAnglesAndOneUlpBeside) {
  constexpr double kRight = 1.5707963267948966;
  for (const double angle : {0.0, kRight, 2 * kRight})
    for (const double towards : {-10.0, 10.0}) {
      EXPECT_GT(
          share("right_angles", [=](const Case& c) { return fact(c, "theta") == std::nextafter(angle, towards); }),
          0.02);
      EXPECT_GT(share("right_angles", [=](const Case& c) { return fact(c, "theta") == angle; }), 0.02);
    }
}

TEST(Hard, TiesAreExactOrNearlySo) {
  EXPECT_TRUE(all("tie", [](const Case& c) {
    const Vec3<double> x = c.pair.body2.position.cwiseAbs();
    return (x.array() == x.maxCoeff()).count() >= 2;
  }));
  EXPECT_TRUE(all("nearly_tie", [](const Case& c) {
    const double broken = std::abs(fact(c, "broken_by"));
    return broken > 0 && broken <= 1e-2;
  }));
}

TEST(Hard, UnitsPositionsAndQuaternionsOfEverySize) {
  EXPECT_GT(share("length_unit", [](const Case& c) { return size_of(c.pair) > 1e8; }), 0.1);
  EXPECT_GT(share("length_unit", [](const Case& c) { return size_of(c.pair) < 1e-8; }), 0.1);
  EXPECT_GT(share("far_from_origin", [](const Case& c) { return c.pair.body1.position.norm() > 1e7; }), 0.15);
  EXPECT_GT(share("huge_numbers", [](const Case& c) { return size_of(c.pair) > 1e200; }), 0.3);
  EXPECT_GT(share("subnormal_numbers", [](const Case& c) { return is_subnormal(size_of(c.pair)); }), 0.02);
  EXPECT_TRUE(all("subnormal_offset", [](const Case& c) {
    return is_subnormal(c.pair.body2.position[c.provenance.at("component").get<int>()]);
  }));
  const auto length = [](const Case& c) {
    const auto& q = c.pair.body1.quaternion;
    return std::max({std::abs(q[0]), std::abs(q[1]), std::abs(q[2]), std::abs(q[3])});
  };
  EXPECT_GT(share("quaternion_length", [&](const Case& c) { return length(c) < 1e-200; }), 0.1);
  EXPECT_GT(share("quaternion_length", [&](const Case& c) { return length(c) > 1e200; }), 0.08);
  EXPECT_GT(share("quaternion_length", [&](const Case& c) { return is_subnormal(length(c)); }), 0.02);
}

}  // namespace
}  // namespace plumb
