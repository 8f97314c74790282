// The families: deterministic, legal, and covering what they claim.
#include "properties/generators/families.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <map>
#include <set>

#include "properties/generators/families_shapes.hpp"
#include "properties/generators/generators.hpp"
#include "properties/tests/draws.hpp"
#include "solver/pose.hpp"
#include "solver/reference/reference.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb {
namespace {

constexpr std::uint64_t kCases = 400;
constexpr std::array<std::uint64_t, 3> kFirstBits{0xde9e6dea4b3055d0u, 0x22c51d34744e820eu, 0xdc6cfcf336a1b365u};

bool same(const Case& a, const Case& b) {
  return format_case(a) == format_case(b);
}

/// Calls test(case) for the first cases of a family.
template <class Test>
void for_each(std::string_view family, Test test) {
  for (std::uint64_t i = 0; i < kCases; ++i) test(generate(family, 11, i));
}

template <class Test>
double share(std::string_view family, Test holds) {
  int count = 0;
  for_each(family, [&](const Case& c) { count += holds(c) ? 1 : 0; });
  return static_cast<double>(count) / static_cast<double>(kCases);
}

double ratio_of(const Case& c) {
  return c.provenance.at("overlap_ratio").get<double>();
}

double aspect_of(const Superellipsoid<double>& s) {
  return s.semi_axes.maxCoeff() / s.semi_axes.minCoeff();
}

/// o(n) = h1(n) + h2(-n) - n.(c2 - c1) at the direction of the centre line: an upper bound of the overlap.
double overlap_along_centres(const Pair& pair) {
  const PlacedPair<double> placed = place<double>(pair);
  const Vec3<double> n = placed.body2.centre.normalized();
  return support<double>(placed.body1.shape, placed.body1.to_body_direction(n)) +
         support<double>(placed.body2.shape, placed.body2.to_body_direction(-n)) - n.dot(placed.body2.centre);
}

TEST(Families, AreLegalNamedAndRecorded) {
  for (const Family& family : families())
    for_each(family.name, [&](const Case& c) {
      EXPECT_TRUE(is_valid(c.pair)) << c.name << ": " << find_input_error(c.pair).field;
      EXPECT_EQ(c.provenance.at("family").get<std::string>(), family.name);
      EXPECT_EQ(c.provenance.at("seed").get<std::uint64_t>(), 11u);
      EXPECT_NE(c.name.find("seed 11 index"), std::string::npos);
    });
}

/// Any order, any shard: a case depends on (family, seed, index) alone.
TEST(Families, DependOnSeedAndIndexAlone) {
  for (const Family& family : families()) {
    std::map<std::uint64_t, std::string> backwards;
    for (std::uint64_t i = 60; i-- > 0;) backwards[i] = format_case(generate(family.name, 5, i));
    for (std::uint64_t shard = 0; shard < 3; ++shard)
      for (std::uint64_t i = shard; i < 60; i += 3) EXPECT_EQ(format_case(generate(family.name, 5, i)), backwards[i]);
    std::set<std::string> seen;
    for (const auto& [index, text] : backwards) seen.insert(text);
    EXPECT_EQ(seen.size(), 60u);
    EXPECT_FALSE(same(generate(family.name, 5, 0), generate(family.name, 6, 0)));
  }
}

TEST(ShapeFamilies, AreLegalNamedAndDependOnSeedAndIndexAlone) {
  for (const ShapeFamily& family : shape_families()) {
    std::set<std::string> seen;
    for (std::uint64_t i = 0; i < 200; ++i) {
      const Case c = generate(family, 11, i);
      const InputError error = find_input_error(c.convex.value_or(ConvexPair{}));
      ASSERT_TRUE(error.reason.empty()) << c.name << ": " << error.field << " " << error.reason;
      EXPECT_EQ(c.provenance.at("family").get<std::string>(), family.name);
      EXPECT_EQ(format_case(c), format_case(generate(family, 11, i)));
      seen.insert(format_case(c));
    }
    EXPECT_EQ(seen.size(), 200u) << family.name;
  }
}

TEST(ShapeFamilies, MeetEachTwoShapesInTurn) {
  std::set<std::array<std::size_t, 2>> met;
  for (std::size_t i = 0; i < shape_pair_count; ++i) {
    const auto [first, second] = shape_kinds(i);
    EXPECT_TRUE(first <= second || second == half_space_kind) << first << ' ' << second;
    EXPECT_FALSE(first == half_space_kind && second == half_space_kind);
    met.insert({first, second});
  }
  EXPECT_EQ(met.size(), shape_pair_count);
}

/// Of the lowest steps nothing is left but rounding.
TEST(ShapeFamilies, AxesAreTiltedByTheirKnob) {
  const ShapeFamily& family = *find_shape_family("shapes_tilted_axes");
  for (std::uint64_t i = 0; i < 10 * family.steps.size(); ++i) {
    const ConvexPair pair = generate(family, 3, i).convex.value_or(ConvexPair{});
    const Vec3<double> first = rotation<double>(pair.body1.quaternion).col(2),
                       second = rotation<double>(pair.body2.quaternion).col(2);
    EXPECT_NEAR(std::asin(first.cross(second).norm()), family.steps[i % family.steps.size()], 1e-15);
  }
}

/// The numbers themselves, so that a change of the generators does not go unseen.
TEST(Families, StreamIsTheSameOnEveryMachine) {
  Stream stream("spheroid", 1, 0);
  const std::array drawn{stream.bits(), stream.bits(), stream.bits()};
  Stream again("spheroid", 1, 0), other("spheroid", 1, 1);
  for (const std::uint64_t bits : drawn) {
    EXPECT_EQ(again.bits(), bits);
    EXPECT_NE(other.bits(), bits);
  }
  EXPECT_EQ(drawn, kFirstBits);
}

TEST(Families, UnknownNamesAreRefused) {
  EXPECT_THROW((void)generate("sphere", 1, 1), std::invalid_argument);
  EXPECT_THROW((void)generate_hard("sphere", 1, 1), std::invalid_argument);
}

TEST(Families, SpheroidIsTheTestBed) {
  for_each("spheroid", [](const Case& c) {
    for (const Body* body : {&c.pair.body1, &c.pair.body2}) {
      const auto& s = body->shape;
      EXPECT_TRUE(s.semi_axes[0] == 1 && s.semi_axes[1] == 1 && s.n1 == 2 && s.n2 == 2);
      EXPECT_TRUE(s.semi_axes[2] >= 1.0 / 3 && s.semi_axes[2] <= 3);
    }
    EXPECT_EQ(c.pair.body1.position, Vec3<double>::Zero());
    EXPECT_EQ(c.pair.body1.quaternion, (Quaternion{1, 0, 0, 0}));
    EXPECT_TRUE(ratio_of(c) >= 1e-3 && ratio_of(c) <= 5e-2);
    EXPECT_GT(overlap_along_centres(c.pair), 0) << c.name;
  });
  const auto prolate = [](const Case& c) { return c.pair.body1.shape.semi_axes[2] > 1; };
  const auto equal = [](const Case& c) { return c.pair.body1.shape.semi_axes == c.pair.body2.shape.semi_axes; };
  EXPECT_NEAR(share("spheroid", prolate), 0.5, 0.1);
  EXPECT_NEAR(share("spheroid", equal), 0.5, 0.1);
}

TEST(Families, SpheroidOverlapIsSteered) {
  for (std::uint64_t i = 0; i < 40; ++i) {
    const Case c = generate("spheroid", 2, i);
    ASSERT_FALSE(c.provenance.contains("placement")) << c.name;
    const auto h = first_touch<long double>(c.pair, c.pair.body2.position.cast<long double>().normalized());
    ASSERT_TRUE(h.solved);
    const long double length = c.pair.body2.position.cast<long double>().norm();
    EXPECT_NEAR(static_cast<double>((h.distance - length) / h.distance), ratio_of(c), 1e-15);
  }
}

TEST(Families, AFifthOfTheEllipsoidsAndSuperquadricsIsApart) {
  for (const std::string_view family : {"ellipsoid", "superquadric"})
    EXPECT_NEAR(share(family, [](const Case& c) { return ratio_of(c) < 0; }), 0.2, 0.07);
}

TEST(Families, EllipsoidAspectsReachTwenty) {
  for_each("ellipsoid", [](const Case& c) { EXPECT_LE(aspect_of(c.pair.body1.shape), 20 * (1 + 1e-12)); });
  EXPECT_GT(share("ellipsoid", [](const Case& c) { return aspect_of(c.pair.body1.shape) > 10; }), 0.2);
  EXPECT_GT(share("ellipsoid", [](const Case& c) { return aspect_of(c.pair.body1.shape) < 3; }), 0.02);
}

TEST(Families, SuperquadricExponentsAreSpreadAsTheySay) {
  const auto within = [](double low, double high) {
    return share("superquadric",
                 [=](const Case& c) { return c.pair.body1.shape.n1 >= low && c.pair.body1.shape.n1 < high; });
  };
  EXPECT_NEAR(within(1.2, 2), 0.15, 0.06);
  EXPECT_NEAR(within(2, 8), 0.70, 0.08);
  EXPECT_NEAR(within(8, 40.001), 0.15, 0.06);
  const auto equal = [](const Case& c) { return c.pair.body1.shape.n1 == c.pair.body1.shape.n2; };
  EXPECT_NEAR(share("superquadric", equal), 1.0 / 3, 0.08);
}

/// First touch stands behind most placements; where it is not solved the case says so.
TEST(Families, FirstTouchIsSolvedForMost) {
  for (const auto& [family, largest] :
       std::map<std::string, double>{{"spheroid", 0}, {"ellipsoid", 0.01}, {"superquadric", 0.1}})
    EXPECT_LE(share(family, [](const Case& c) { return c.provenance.contains("placement"); }), largest) << family;
}

RC_GTEST_PROP(Simpler, IsLegalAndDifferent, ()) {
  const Case c = *generators::case_of(*rc::gen::element<std::string>("spheroid", "ellipsoid", "superquadric", "hard"));
  const std::vector<Case> candidates = simpler(c);
  std::set<std::string> seen;
  for (Case candidate : candidates) {
    RC_ASSERT(is_valid(candidate.pair));
    RC_ASSERT(candidate.expect.empty());
    candidate.provenance = c.provenance;
    RC_ASSERT(!same(candidate, c));
    RC_ASSERT(seen.insert(format_case(candidate)).second);
  }
}

/// Whatever is taken, it ends; and always taking the last, the least preferred, is the longest way.
TEST(Simpler, Ends) {
  for (const Family& family : families())
    for (std::uint64_t i = 0; i < draws(20); ++i)
      for (const bool last : {false, true}) {
        Case c = generate(family.name, 3, i);
        int steps = 0;
        for (std::vector<Case> next = simpler(c); !next.empty(); next = simpler(c)) {
          c = last ? next.back() : next.front();
          ASSERT_LT(++steps, 2000) << c.name;
        }
        EXPECT_EQ(c.pair.body1.shape.semi_axes, c.pair.body2.shape.semi_axes) << c.name;
      }
}

TEST(Simpler, UnitSpheresAtTheOriginAreTheSimplest) {
  EXPECT_TRUE(simpler(Case{}).empty());
}

/// A failure that needs only an overlap and an exponent shrinks to little else.
TEST(Simpler, KeepsWhatAFailureNeeds) {
  const auto fails = [](const Case& c) { return c.pair.body1.shape.n1 > 5 && c.pair.body2.position.norm() > 0.1; };
  int tried = 0;
  for (std::uint64_t i = 0; tried < 10; ++i) {
    Case c = generate("superquadric", 4, i);
    if (!fails(c)) continue;
    ++tried;
    for (bool moved = true; moved;) {
      moved = false;
      for (const Case& candidate : simpler(c))
        if (fails(candidate)) {
          c = candidate;
          moved = true;
          break;
        }
    }
    EXPECT_EQ(c.pair.body1.quaternion, (Quaternion{1, 0, 0, 0})) << format_case(c);
    EXPECT_EQ(c.pair.body1.shape.semi_axes, Vec3<double>::Ones()) << format_case(c);
    EXPECT_EQ(c.pair.body1.shape.n1, std::round(c.pair.body1.shape.n1)) << format_case(c);
  }
}

}  // namespace
}  // namespace plumb
