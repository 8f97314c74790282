// All solutions of the original six equations: closed forms of spheres, the equations in 50 digits, other proofs and Newton's
// method from random starts, none of which may find another, and cases that must not come out complete.
#include "reports/study/six_roots.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "properties/generators/draft.hpp"
#include "properties/generators/families.hpp"
#include "solver/method/methods.hpp"
#include "solver/pose.hpp"
#include "solver/reference/reference.hpp"
#include "solver/reference/search/stationary.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb::reports {
namespace {

constexpr double radius1 = 1, radius2 = 0.7;

Pair spheres(const Vec3<double>& between) {
  Pair pair;
  pair.body2.shape.semi_axes.setConstant(radius2);
  pair.body1.position << 3, -2, 1;
  pair.body2.position = pair.body1.position + between;
  return pair;
}

std::vector<SixBranch> all_branches() {
  std::vector<SixBranch> out;
  for (const int tau : {-1, 1})
    for (const int x : {-1, 1})
      for (const int y : {-1, 1})
        for (const int z : {-1, 1}) out.push_back({tau, {x, y, z}});
  return out;
}

// Spheres r1, r2, centres c apart: c + r2 T n - r1 n = D S n gives n_i = c_i / (D s_i + k_i), k = (r1 + r2, r1 + r2, r1 - tau r2), so
// that the solutions of a branch are the D > 0 with f(D) = sum c_i^2 / (D s_i + k_i)^2 = 1. f is convex between its poles:
// one solution between an end above 1 and one below, two or none between two ends above.
struct SphereBranch {
  Vec3<double> c;
  SixBranch branch;

  [[nodiscard]] double k(int i) const { return i < 2 ? radius1 + radius2 : radius1 - branch.tau * radius2; }
  [[nodiscard]] double f(double distance) const {
    double out = 0;
    for (int i = 0; i < 3; ++i)
      if (c[i] != 0) out += std::pow(c[i] / (distance * branch.signs[static_cast<std::size_t>(i)] + k(i)), 2);
    return out;
  }
  [[nodiscard]] double least_between(double a, double b) const {
    for (int i = 0; i < 200; ++i) {
      const double low = a + (b - a) / 3, high = b - (b - a) / 3;
      (f(low) < f(high) ? b : a) = f(low) < f(high) ? high : low;
    }
    return f(a);
  }
  [[nodiscard]] int count() const {
    std::vector<double> ends{0};
    for (int i = 0; i < 3; ++i)
      if (c[i] != 0 && -k(i) * branch.signs[static_cast<std::size_t>(i)] > 0) ends.push_back(k(i));
    std::sort(ends.begin(), ends.end());
    int out = ends.size() == 1 && f(0) < 1 ? 0 : 1;  // beyond the last pole
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      if (ends[i] == ends[i + 1]) continue;
      if (i == 0 && f(0) < 1)
        out += 1;
      else if (least_between(ends[i], ends[i + 1]) < 1)
        out += 2;
    }
    return out;
  }
};

int count(const SixRoots& set, const SixBranch& branch) {
  const auto is_it = [&](const SixBranch& b) { return b.tau == branch.tau && b.signs == branch.signs; };
  return static_cast<int>(std::count_if(set.roots.begin(), set.roots.end(), [&](const SixRoot& root) {
    return std::any_of(root.branches.begin(), root.branches.end(), is_it);
  }));
}
int count(const SixRoots& set, SixRootKind kind) {
  return static_cast<int>(
      std::count_if(set.roots.begin(), set.roots.end(), [&](const SixRoot& root) { return root.kind == kind; }));
}

TEST(SixRoots, SpheresHaveTheirClosedForm) {
  for (const Vec3<double>& c :
       {Vec3<double>(0.9, 0.8, 1.0), Vec3<double>(0.3, -1.2, 0.1), Vec3<double>(1, 1.3, -0.9)}) {
    SCOPED_TRACE(c.transpose());
    const Pair pair = spheres(c);
    const SixRoots set = find_six_roots(pair);
    ASSERT_TRUE(set.complete) << set.reason;
    const Vec3<double> exact = pair.body2.position - pair.body1.position;
    std::size_t sum = 0;
    for (const SixBranch& branch : all_branches()) {
      const SphereBranch closed{exact, branch};
      EXPECT_EQ(count(set, branch), closed.count());
      sum += static_cast<std::size_t>(closed.count());
    }
    EXPECT_EQ(set.roots.size(), sum);
    for (const SixRoot& root : set.roots) {
      const SphereBranch closed{exact, root.branches.front()};
      EXPECT_NEAR(closed.f(static_cast<double>(root.distance)), 1, 1e-9);
    }
  }
}

/// c_x = 0: s_x is open where n_x = 0, and with s_x = -1 there are two more, n_x of either sign, at D = r1 + r2.
TEST(SixRoots, BranchesThatCannotBeToldApartCountOnce) {
  const Pair pair = spheres({0, 0.8, 1.0});
  const SixRoots set = find_six_roots(pair);
  ASSERT_TRUE(set.complete) << set.reason;
  int in_plane = 0, off_plane = 0;
  for (const SixBranch& branch : all_branches()) {
    const SphereBranch closed{pair.body2.position - pair.body1.position, branch};
    if (branch.signs[0] > 0)
      in_plane += closed.count();
    else if (branch.signs[1] > 0 && closed.f(radius1 + radius2) < 1)
      off_plane += 2;
  }
  EXPECT_GT(off_plane, 0);
  EXPECT_EQ(static_cast<int>(set.roots.size()), in_plane + off_plane);
  for (const SixRoot& root : set.roots) {
    const bool is_shared = root.branches.size() == 2;
    EXPECT_TRUE(is_shared || root.branches.size() == 1);
    EXPECT_EQ(abs(root.normal1[0]) <= root.normal_radius, is_shared);
    in_plane -= is_shared ? 1 : 0;
  }
  EXPECT_EQ(in_plane, 0);
}

/// The six equations from the gauge, which the search does not use, at the points alone.
void expect_solution(const Pair& pair, const SixRoot& root) {
  using S = Real50;
  const double allowed = 1e-30;
  const PlacedPair<S> placed = place<S>(pair);
  const Vec3<S> r1 = placed.body1.to_body(placed.to_pair_point(root.point1, pair)),
                r2 = placed.body2.to_body(placed.to_pair_point(root.point2, pair));
  const Vec3<S> n1 = placed.body1.to_pair_direction(outward_normal<S>(placed.body1.shape, r1)),
                n2 = placed.body2.to_pair_direction(outward_normal<S>(placed.body2.shape, r2));
  const Vec3<S> d = root.point2 - root.point1, u = d / d.norm();
  Eigen::Matrix<S, 6, 1> value;
  value << gauge<S>(placed.body1.shape, r1) - S(1), gauge<S>(placed.body2.shape, r2) - S(1), n1[0] + n2[0],
      n1[1] + n2[1], abs(u[0]) - abs(n1[0]), abs(u[1]) - abs(n2[1]);
  EXPECT_LT(static_cast<double>(value.norm()), allowed);
  EXPECT_LT(static_cast<double>((n1 - root.normal1).norm() + (n2 - root.normal2).norm()), allowed);
  EXPECT_LT(static_cast<double>(abs(d.norm() - root.distance)), allowed);
  EXPECT_LT(static_cast<double>((Vec3<S>(u[0] + n1[0], u[1] - n2[1], u[2] + n1[2]) - root.residual).norm()), allowed);
  EXPECT_LT(root.normal_radius + root.points_radius / size_of(pair), 1e-45);
  for (const SixBranch& branch : root.branches)
    for (int i = 0; i < 3; ++i) {
      const S expected = S(branch.signs[static_cast<std::size_t>(i)] + 1) * n1[i];
      EXPECT_LT(static_cast<double>(abs(root.residual[i] - expected)), allowed);
    }
}

/// Random points on the surfaces, as an earlier answer.
Contact<double> random_start(Stream& stream, const Pair& pair) {
  const PlacedPair<double> placed = place<double>(pair);
  const auto drawn = [&](const PlacedBody<double>& body) -> Vec3<double> {
    return placed.to_world_point(body.to_pair(body.shape.semi_axes.cwiseProduct(random_direction(stream))), pair);
  };
  Contact<double> out;
  out.point1 = drawn(placed.body1);
  out.point2 = drawn(placed.body2);
  return out;
}

/// How many starts converge; each must end at a root of the set.
int expect_no_start_finds_another(const Pair& pair, const SixRoots& set, Stream&& stream, int starts) {
  int arrived = 0;
  for (int i = 0; i < starts; ++i) {
    const Contact<double> start = random_start(stream, pair),
                          end = find_method("original_cn")->iterate(pair, {}, &start);
    if (end.status != Status::converged) continue;
    ++arrived;
    EXPECT_TRUE(find_root(set, end.point1, end.point2, 1e-7 * size_of(pair)).has_value())
        << end.point1.transpose() << ", " << end.point2.transpose();
  }
  return arrived;
}

void expect_all_solutions(std::string_view family, std::uint64_t index, int starts) {
  const Case c = generate(family, 1, index);
  SCOPED_TRACE(c.name);
  const SixRoots set = find_six_roots(c.pair);
  ASSERT_TRUE(set.complete) << set.reason;
  for (const SixRoot& root : set.roots) expect_solution(c.pair, root);
  const Solution lowest = find_reference(c.pair).common_normal;
  const auto hit = find_root(set, lowest.point1.cast<double>(), lowest.point2.cast<double>(), 1e-13 * size_of(c.pair));
  if (!hit) FAIL() << "the lowest common normal is not among the roots";
  EXPECT_EQ(set.roots[*hit].kind, lowest.overlap > 0 ? SixRootKind::common_normal : SixRootKind::common_normal_apart);
  const StationarySet stationary = find_stationary(c.pair);
  ASSERT_TRUE(stationary.complete) << stationary.reason;
  EXPECT_EQ(count(set, SixRootKind::common_normal) + count(set, SixRootKind::common_normal_apart),
            static_cast<int>(stationary.pairs.size()));
  EXPECT_GT(expect_no_start_finds_another(c.pair, set, Stream("six roots", 1, index), starts), starts / 2);
}

TEST(SixRoots, SpheroidsHaveAllOfTheirs) {
  for (std::uint64_t i = 0; i < 8; ++i) expect_all_solutions("spheroid", i, 500);
}

TEST(SixRoots, EllipsoidsHaveAllOfTheirs) {
  for (std::uint64_t i = 0; i < 8; ++i) expect_all_solutions("ellipsoid", i, 200);
}

TEST(SixRoots, TheKindIsThatOfTheBranch) {
  EXPECT_EQ(kind_of({-1, {-1, -1, -1}}), SixRootKind::common_normal);
  EXPECT_EQ(kind_of({-1, {1, 1, 1}}), SixRootKind::common_normal_apart);
  EXPECT_EQ(kind_of({-1, {1, -1, -1}}), SixRootKind::signs);
  EXPECT_EQ(kind_of({-1, {-1, -1, 1}}), SixRootKind::z);
  EXPECT_EQ(kind_of({1, {-1, -1, -1}}), SixRootKind::z);
  EXPECT_EQ(kind_of({1, {1, 1, 1}}), SixRootKind::both);
  EXPECT_EQ(kind_of({-1, {1, -1, 1}}), SixRootKind::both);
  EXPECT_EQ(name(SixRootKind::common_normal_apart), "common normal, apart");
}

TEST(SixRoots, ARootIsFoundByBothItsPoints) {
  const SixRoots set = find_six_roots(spheres({0.9, 0.8, 1.0}));
  ASSERT_GT(set.roots.size(), 3u);
  const Vec3<double> x1 = set.roots[3].point1.cast<double>(), x2 = set.roots[3].point2.cast<double>();
  EXPECT_EQ(find_root(set, x1, x2, 1e-12), 3u);
  EXPECT_FALSE(find_root(set, x1, set.roots[2].point2.cast<double>(), 1e-12).has_value());
  EXPECT_FALSE(find_root(set, not_valid<double>(), x2, 1e-12).has_value());
}

/// Each common normal of coaxial bodies lies in a ring of them; touching spheres have a solution with D = 0.
TEST(SixRoots, AContinuumOrTouchingIsNotComplete) {
  Pair coaxial;
  coaxial.body1.shape.semi_axes << 1, 1, 2;
  coaxial.body2.shape.semi_axes << 1, 1, 3;
  coaxial.body2.position << 0, 0, 0.2;
  Pair shallow = coaxial;
  shallow.body2.position[2] = 4.95;
  Pair touching;
  touching.body2.position << 2, 0, 0;
  for (const Pair& pair : {coaxial, shallow, touching, Pair{}}) {
    const SixRoots set = find_six_roots(pair);
    EXPECT_FALSE(set.complete);
    EXPECT_NE(set.reason.find("continuum"), std::string::npos) << set.reason;
    EXPECT_LT(set.cells, SixRootLimits{}.cells);
  }
}

TEST(SixRoots, WhatEndsTheSearchIsReported) {
  const Pair pair = spheres({0.9, 0.8, 1.0});
  EXPECT_NE(find_six_roots(pair, {100, 50}).reason.find("budget"), std::string::npos);
  Pair block = pair;
  block.body2.shape.n1 = 4;
  EXPECT_NE(find_six_roots(block).reason.find("not supported"), std::string::npos);
  Pair none = pair;
  none.body1.shape.semi_axes[0] = 0;
  const SixRoots refused = find_six_roots(none);
  EXPECT_FALSE(refused.complete || refused.reason.empty());
}

}  // namespace
}  // namespace plumb::reports
