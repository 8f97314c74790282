// Hulls of points: which are corners and which share a face is decided exactly, whatever the points are.
#include "solver/shape/hull.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <set>
#include <stdexcept>

#include "properties/generators/draft.hpp"

namespace plumb::hull_tests {
namespace {

using Vec = Vec3<double>;
using Points = std::vector<Vec>;

Hull hull_of(const Points& points) {
  return *make_polyhedron(points).hull;
}

/// Each edge lies in its two faces, once in either sense; each face turns left about its normal, and no corner lies beyond it.
void expect_sound(const Hull& hull) {
  std::set<std::array<int, 2>> links;
  for (const HullFace& face : hull.faces) {
    const std::size_t count = face.corners.size();
    ASSERT_GE(count, 3U);
    const auto corner = [&](std::size_t i) -> const Vec& {
      return hull.corners[static_cast<std::size_t>(face.corners[i % count])];
    };
    EXPECT_NEAR(face.normal.norm(), 1, 1e-15);
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_TRUE(links.insert({face.corners[i], face.corners[(i + 1) % count]}).second);
      const Vec before = corner(i + 1) - corner(i), after = corner(i + 2) - corner(i + 1);
      EXPECT_GT(before.cross(after).dot(face.normal), 0);
    }
    for (const Vec& other : hull.corners) EXPECT_LE(face.normal.dot(other - corner(0)), 1e-12);
  }
  for (const HullEdge& edge : hull.edges) {
    EXPECT_TRUE(links.contains(edge.corners));
    EXPECT_TRUE(links.contains({edge.corners[1], edge.corners[0]}));
  }
  EXPECT_EQ(links.size(), 2 * hull.edges.size());
}

void expect_counts(const Hull& hull, std::size_t corners, std::size_t edges, std::size_t faces) {
  EXPECT_EQ(hull.corners.size(), corners);
  EXPECT_EQ(hull.edges.size(), edges);
  EXPECT_EQ(hull.faces.size(), faces);
}

TEST(Hull, OfALatticeIsItsCube) {
  Points points;
  for (int i = 0; i < 125; ++i) {
    const int x = i % 5, y = i / 5 % 5, z = i / 25;
    points.emplace_back(0.1 * x, 0.1 * y, 0.1 * z);
  }
  const Hull hull = hull_of(points);
  expect_counts(hull, 8, 12, 6);
  expect_sound(hull);
  for (const HullFace& face : hull.faces) {
    EXPECT_EQ(face.corners.size(), 4U);
    EXPECT_EQ(face.normal.cwiseAbs().maxCoeff(), 1);
  }
}

TEST(Hull, CornersKeepTheirOrderAndRepeatedPointsCountOnce) {
  const Vec a(1, 0, 0), b(0, 1, 0), c(0, 0, 1), d(0, 0, 0);
  const Hull hull = hull_of({c, a, c, Vec(0.25, 0.25, 0.25), d, Vec(-0.0, 0, 0), a, b});
  EXPECT_EQ(hull.corners, (Points{c, a, d, b}));
  expect_counts(hull, 4, 6, 4);
  expect_sound(hull);
}

TEST(Hull, OfPointsOnASphereHasThemAll) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    Stream stream("sphere's hull", seed, 0);
    Points points;
    for (int i = 0; i < 200; ++i) points.push_back(random_direction(stream));
    const Hull hull = hull_of(points);
    EXPECT_EQ(hull.corners, points);
    expect_counts(hull, 200, 594, 396);
    expect_sound(hull);
  }
}

TEST(Hull, OfRandomPointsHoldsThemAndObeysEuler) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Stream stream("random hull", seed, 0);
    Points points;
    const double grid = seed % 2 == 0 ? 4 : 1e9;  // whole coordinates, few or many: coplanar points or none
    for (int i = 0; i < 60; ++i) {
      const double x = std::floor(stream.uniform(0, grid)), y = std::floor(stream.uniform(0, grid));
      points.push_back(Vec(x, y, std::floor(stream.uniform(0, grid))) / grid);
    }
    const Hull hull = hull_of(points);
    expect_sound(hull);
    EXPECT_EQ(hull.corners.size() + hull.faces.size(), hull.edges.size() + 2);
    for (const HullFace& face : hull.faces)
      for (const Vec& x : points)
        EXPECT_LE(face.normal.dot(x - hull.corners[static_cast<std::size_t>(face.corners[0])]), 1e-14);
  }
}

TEST(Hull, OfAPrismMergesItsEnds) {
  Points points;
  for (int i = 0; i < 60; ++i)
    for (const double z : {-1.0, 0.5, 1.0}) points.emplace_back(std::cos(i * kTurn / 60), std::sin(i * kTurn / 60), z);
  const Hull hull = hull_of(points);
  expect_counts(hull, 120, 180, 62);
  expect_sound(hull);
  EXPECT_EQ(
      std::count_if(hull.faces.begin(), hull.faces.end(), [](const HullFace& f) { return f.corners.size() == 60; }), 2);
}

TEST(Hull, OfCoplanarPointsIsAPolygonOfTwoFaces) {
  Points points;
  for (int i = 0; i < 25; ++i) points.emplace_back(i % 5, i / 5, 2 * (i % 5) - i / 5);
  const Hull hull = hull_of(points);
  expect_counts(hull, 4, 4, 2);
  EXPECT_EQ(hull.faces[0].normal, -hull.faces[1].normal);
  EXPECT_NEAR(std::abs(hull.faces[0].normal.dot(Vec(-2, 1, 1).normalized())), 1, 1e-15);
  for (const HullEdge& edge : hull.edges) EXPECT_NE(edge.faces[0], edge.faces[1]);
}

TEST(Hull, OfCollinearPointsIsASegmentAndOfOneAPoint) {
  Points points;
  for (int i = 0; i < 10; ++i) points.emplace_back(1 + 3 * (i * 7 % 10), 2 - (i * 7 % 10), 0.5 * (i * 7 % 10));
  const Hull segment = hull_of(points);
  expect_counts(segment, 2, 1, 0);
  EXPECT_EQ(segment.corners, (Points{Vec(1, 2, 0), Vec(28, -7, 4.5)}));
  EXPECT_EQ(segment.edges[0].faces, (std::array<int, 2>{-1, -1}));
  const Hull point = hull_of({Vec(1, 2, 3), Vec(1, 2, 3)});
  expect_counts(point, 1, 0, 0);
}

TEST(Hull, SliversAreDecidedByTheirLastBit) {
  const double least = std::numeric_limits<double>::denorm_min();
  const Vec a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  expect_counts(hull_of({a, b, c, Vec(0.25, 0.25, least)}), 4, 6, 4);
  expect_counts(hull_of({a, b, c, Vec(0.25, 0.25, 0)}), 3, 3, 2);
  expect_counts(hull_of({a, Vec(1, 1, 1), Vec(0.5, 0.5, std::nextafter(0.5, 1)), Vec(0.25, 0.25, 0.25)}), 3, 3, 2);
  // 0.1 i is no multiple of 0.1: rounding alone makes a polygon of these.
  Points rounded;
  for (int i = 0; i < 4; ++i) rounded.emplace_back(0.1 * i, 0.2 * i, 0.3 * i);
  EXPECT_GT(hull_of(rounded).corners.size(), 2U);
}

TEST(Hull, CoordinatesMayBeOfAnySize) {
  const Hull hull =
      hull_of({Vec(0, 0, 0), Vec(1e300, 0, 0), Vec(0, 1e-300, 0), Vec(1e300, 1, 5e-324), Vec(-1e308, 0, 0)});
  EXPECT_EQ(hull.corners.size() + hull.faces.size(), hull.edges.size() + 2);
  for (const HullFace& face : hull.faces) EXPECT_NEAR(face.normal.norm(), 1, 1e-15);
  const double end = std::numeric_limits<double>::max();
  expect_counts(hull_of({Vec(-end, 0, 0), Vec(end, 0, 0), Vec(0, end, 0), Vec(0, 0, -end)}), 4, 6, 4);
}

TEST(Hull, RefusesNoPointsAndNoNumbers) {
  EXPECT_THROW((void)make_polyhedron({}), std::invalid_argument);
  for (const double bad : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW((void)make_polyhedron(Points{Vec(0, bad, 0)}), std::invalid_argument);
}

}  // namespace
}  // namespace plumb::hull_tests
