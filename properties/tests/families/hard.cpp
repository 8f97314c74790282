// The family hard: each generator reaches the place that its name says.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "properties/generators/families.hpp"
#include "properties/generators/generators.hpp"
#include "solver/pose.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb {
namespace {

constexpr std::uint64_t kCases = 200;

using Test = std::function<bool(const Case&)>;

/// Drawn once: to draw one takes longer than to look at it.
const std::vector<Case>& cases_of(std::string_view generator) {
  static std::map<std::string, std::vector<Case>, std::less<>> drawn;
  std::vector<Case>& out = drawn[std::string(generator)];
  for (std::uint64_t i = out.size(); i < kCases; ++i) out.push_back(generate_hard(generator, 7, i));
  return out;
}

double share(std::string_view generator, const Test& holds) {
  const auto count = std::ranges::count_if(cases_of(generator), holds);
  return static_cast<double>(count) / static_cast<double>(kCases);
}

bool all(std::string_view generator, const Test& holds) {
  return share(generator, holds) == 1;
}

double fact(const Case& c, const char* name) {
  return c.provenance.at(name).get<double>();
}

double knob(const Case& c) {
  return c.provenance.at("knob").at("value").get<double>();
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

/// What is steered reaches from the first step of its ladder to the last, and is on each of them often enough.
TEST(Hard, EveryStepOfEveryLadderIsDrawn) {
  for (const std::string_view generator : hard_generators()) {
    const auto steps = ladder_steps(generator);
    ASSERT_GE(steps.size(), 5u) << generator;
    for (std::size_t i = 1; i < steps.size(); ++i)
      EXPECT_GT(share(generator, [&](const Case& c) { return knob(c) == steps[i]; }), 0.01) << generator << ' ' << i;
    const auto [low, high] = std::minmax_element(steps.begin(), steps.end());
    EXPECT_TRUE(all(generator, [&](const Case& c) { return knob(c) >= *low * 0.999 && knob(c) <= *high * 1.001; }))
        << generator;
  }
}

TEST(Hard, ALadderCaseIsOnItsStepAndOtherwiseTheSame) {
  for (const std::string_view generator : hard_generators())
    for (std::size_t i = 0; i < ladder_steps(generator).size(); ++i) {
      const Case c = ladder_case(generator, i, 3, 1);
      EXPECT_TRUE(is_valid(c.pair)) << c.name << ": " << find_input_error(c.pair).field;
      EXPECT_EQ(knob(c), ladder_steps(generator)[i]);
      EXPECT_EQ(step_of(generator, knob(c)), i);
      EXPECT_EQ(c.provenance.at("step"), i + 1);
    }
  EXPECT_EQ(step_of("face_face", 3e-7), 2u);
  EXPECT_EQ(step_of("face_face", 1e-200), 7u);
}

TEST(Hard, NearTouchingOnBothSidesDownTo1em16) {
  EXPECT_TRUE(all("near_touching_overlapping", [](const Case& c) { return fact(c, "overlap_ratio") == knob(c); }));
  EXPECT_TRUE(all("near_touching_separated", [](const Case& c) { return fact(c, "overlap_ratio") == -knob(c); }));
}

TEST(Hard, DeepOverlapToConcentricAndInside) {
  EXPECT_TRUE(all("deep_overlap", [](const Case& c) { return fact(c, "overlap_ratio") >= 0.3; }));
  EXPECT_TRUE(all("nearly_concentric", [](const Case& c) {
    const double distance = (c.pair.body2.position - c.pair.body1.position).stableNorm();
    return (distance == 0) == (knob(c) == 0) && distance < 1.01e-2;
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
  EXPECT_TRUE(all("far_apart", [](const Case& c) { return c.pair.body2.position.stableNorm() > 0.3 * knob(c); }));
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
  EXPECT_TRUE(all("exponent_near_one", [&](const Case& c) { return n1(c) == knob(c); }));
  EXPECT_TRUE(all("exponent_near_two", [&](const Case& c) { return n1(c) != 2 && std::abs(n1(c) - 2) <= 1e-6; }));
  EXPECT_GT(share("exponent_near_two", [&](const Case& c) { return n1(c) < 2 && n1(c) > 2 - 1e-11; }), 0.1);
  EXPECT_GT(share("exponent_near_two", [&](const Case& c) { return n1(c) > 2 && n1(c) < 2 + 1e-11; }), 0.1);
  EXPECT_TRUE(all("exponent_large", [&](const Case& c) { return n1(c) == knob(c); }));
}

TEST(Hard, ZeroCoordinatesWithDifferentExponents) {
  EXPECT_TRUE(all("zero_coordinate", [](const Case& c) {
    const double least = c.pair.body2.position.cwiseAbs().minCoeff();
    return c.pair.body1.shape.n1 != c.pair.body1.shape.n2 && (knob(c) == 0 ? least == 0 : least < 8 * knob(c));
  }));
}

TEST(Hard, FacesMeetOnBothSides) {
  for (const std::string_view name : {"face_face", "edge_face", "edge_edge", "corner_face"})
    EXPECT_NEAR(share(name, [](const Case& c) { return fact(c, "depth") > 0; }), 0.5, 0.15);
}

/// An untilted pair of faces has exactly parallel faces: both rotations map axes on axes.
TEST(Hard, UntiltedFacesAreExactlyParallel) {
  EXPECT_TRUE(all("face_face", [](const Case& c) {
    const Mat3<double> r1 = rotation<double>(c.pair.body1.quaternion), r2 = rotation<double>(c.pair.body2.quaternion);
    return r2 * r2.transpose() == Mat3<double>::Identity() && (knob(c) != 0 || r1 == Mat3<double>::Identity());
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
    return (offset.array() != 0).count() <= (knob(c) == 0 ? 1 : 2) && r * r.transpose() == Mat3<double>::Identity();
  }));
}

TEST(Hard, RightAnglesAndOneUlpBeside) {
  const std::array right{-std::numbers::pi / 2, 0.0, std::numbers::pi / 2, std::numbers::pi, 3 * std::numbers::pi / 2};
  const std::size_t last = ladder_steps("right_angles").size() - 1;
  std::set<double> at, beside;
  for (std::uint64_t i = 0; i < kCases; ++i) {
    at.insert(fact(ladder_case("right_angles", last, 7, i), "theta"));
    beside.insert(fact(ladder_case("right_angles", last - 1, 7, i), "theta"));
  }
  EXPECT_EQ(at, std::set(right.begin(), right.end()));
  EXPECT_EQ(beside.size(), 2 * right.size());
  for (const double angle : beside)
    EXPECT_TRUE(std::any_of(right.begin(), right.end(), [&](double r) {
      return angle != r && std::abs(angle - r) <= std::numeric_limits<double>::epsilon() * std::max(1.0, std::abs(r));
    })) << angle;
}

TEST(Hard, TiesAreExactOrNearlySo) {
  EXPECT_TRUE(all("tie", [](const Case& c) {
    const Vec3<double> x = c.pair.body2.position.cwiseAbs();
    const double most = x.maxCoeff(), broken = knob(c);
    return (x.array() >= most * (1 - 2 * broken)).count() >= 2 && (broken == 0 || x[0] != x[1] || x[1] != x[2]);
  }));
}

TEST(Hard, UnitsPositionsAndQuaternionsOfEverySize) {
  EXPECT_GT(share("length_unit", [](const Case& c) { return size_of(c.pair) > 1e8; }), 0.1);
  EXPECT_GT(share("length_unit", [](const Case& c) { return size_of(c.pair) < 1e-8; }), 0.1);
  EXPECT_GT(share("far_from_origin", [](const Case& c) { return c.pair.body1.position.norm() > 1e7; }), 0.15);
  EXPECT_GT(share("huge_numbers", [](const Case& c) { return size_of(c.pair) > 1e200; }), 0.3);
  EXPECT_GT(share("subnormal_numbers", [](const Case& c) { return is_subnormal(size_of(c.pair)); }), 0.02);
  EXPECT_TRUE(all("subnormal_offset", [](const Case& c) {
    return std::abs(c.pair.body2.position[c.provenance.at("component").get<int>()]) == knob(c);
  }));
  const auto length = [](const Case& c) {
    const auto& q = c.pair.body1.quaternion;
    return std::max({std::abs(q[0]), std::abs(q[1]), std::abs(q[2]), std::abs(q[3])});
  };
  EXPECT_GT(share("quaternion_length", [&](const Case& c) { return length(c) < 1e-200; }), 0.1);
  EXPECT_GT(share("quaternion_length", [&](const Case& c) { return length(c) > 1e200; }), 0.05);
  EXPECT_GT(share("quaternion_length", [&](const Case& c) { return is_subnormal(length(c)); }), 0.02);
}

}  // namespace
}  // namespace plumb
