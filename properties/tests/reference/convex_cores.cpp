// What the bounds of convex bodies trust: supports that hold those of 50 digits, points that lie in their bodies, cells that bound.
#include <gtest/gtest.h>

#include "properties/tests/reference/drawn_bodies.hpp"
#include "properties/tests/reference/inside.hpp"
#include "solver/reference/convex/proved.hpp"
#include "solver/reference/frame.hpp"

namespace plumb::reference::convex_cores_tests {
namespace {

using bodies_tests::draw_pair;
using bodies_tests::draw_shape;
using bodies_tests::OutsideOf;
using bodies_tests::shape_count;
using bodies_tests::SupportOf;
using cores::I;
using plumb::half_space_kind;
using Vec = Vec3<double>;

/// Any but the half-space, which has no core.
std::size_t draw_kind(Stream& stream) {
  const std::size_t kind = stream.below(shape_count - 1);
  return kind == half_space_kind ? shape_count - 1 : kind;
}

template <class Each>
void for_all_shapes(std::uint64_t count, std::string_view name_of_draws, const Each& each) {
  for (std::size_t kind = 0; kind < shape_count; ++kind)
    for (std::uint64_t i = 0; i < (kind == half_space_kind ? 0 : count); ++i) {
      Stream stream(name_of_draws, kind, i);
      const Shape shape = draw_shape(kind, stream);
      each(shape, cores::core_of(shape, 0), stream);
    }
}

/// To the rounding of the number itself.
bool is_in(const I& box, const Real50& x) {
  const Real50 rounding("1e-44");
  return Real50(low(box)) <= x + rounding && x - rounding <= Real50(high(box));
}

/// Often along an axis or across it.
Vec draw_direction(Stream& stream) {
  Vec out = random_direction(stream);
  for (double& x : out)
    if (stream.chance(0.15)) x = 0;
  return out.norm() > 0 ? out : Vec(0, 0, 1);
}

TEST(ConvexCores, SupportsHoldThoseOfManyDigits) {
  for_all_shapes(60, "core supports", [](const Shape& shape, const cores::Core& core, Stream& stream) {
    const Vec middle = draw_direction(stream), none = Vec::Zero(), half = Vec::Constant(stream.log_uniform(1e-6, 1));
    const I radius = cores::radius_about_core(shape, 0);
    for (const Vec& width : {none, half}) {
      const IVec3<I> box = inside_tests::box_about<I>(middle, width);
      const I found = cores::support_of(core, box) + radius * length_of<I>(box);
      for (int k = 0; k < (width == none ? 1 : 20); ++k) {
        const Vec3<Real50> u = inside_tests::draw_in_box(middle, width, stream);
        EXPECT_TRUE(is_in(found, std::visit(SupportOf<Real50>{u}, shape))) << name(shape);
      }
      EXPECT_LT(inside_tests::width(found), width == none ? 1e-13 : 10) << name(shape);
    }
  });
}

TEST(ConvexCores, ProvedPointsLieInTheirBodies) {
  for_all_shapes(200, "core points", [](const Shape& shape, const cores::Core& core, Stream& stream) {
    if (std::holds_alternative<Polyhedron>(shape)) return;
    const Vec u = draw_direction(stream);
    const Vec surface = cores::farthest(core, u).at;
    for (const double scale : {1.0, 1 + 1e-15, 1 + stream.log_uniform(1e-14, 1), 1 - stream.uniform()}) {
      const IVec3<I> found = cores::proved_point(core, {surface * scale});
      const Vec x(low(found[0]), low(found[1]), low(found[2]));
      EXPECT_EQ(x, Vec(high(found[0]), high(found[1]), high(found[2])));
      EXPECT_LE(std::visit(OutsideOf<Real50>{x.cast<Real50>()}, shape), 0) << name(shape) << ' ' << scale;
      EXPECT_LE((x - surface).norm(), scale == 1 ? 1e-13 : 2) << name(shape);
    }
  });
}

TEST(ConvexCores, CornersAreProvedAsTheyStand) {
  const std::array<Vec, 4> corners{Vec(0, 0, 0), Vec(1, 0, 0), Vec(0, 2, 0), Vec(0, 0, 4)};
  const cores::Core core = cores::core_of(make_polyhedron(corners), 1);
  const cores::CorePoint top = cores::farthest(core, Vec(0, 0, 1));
  EXPECT_EQ(top.corner, 3);
  const IVec3<I> found = cores::proved_point(core, top);
  EXPECT_TRUE(is_exactly(found[2], 2));
  EXPECT_EQ(top.at, Vec(0, 0, 2));
}

/// Four unit corners about a direction.
cores::CornersOfCell cell_about(const Vec& n, double half) {
  const Mat3<double> frame = frame_about(n);
  cores::CornersOfCell out;
  for (std::size_t j = 0; j < 4; ++j)
    out[j] = (frame * Cell{2, 1, 0, 0, half}.at(j % 2 == 0 ? -1 : 1, j / 2 == 0 ? -1 : 1)).normalized();
  return out;
}

TEST(ConvexCores, ProvedCellsBoundAllTheirDirections) {
  for (std::uint64_t i = 0; i < 400; ++i) {
    Stream stream("proved cells", 1, i);
    const ConvexPair pair = draw_pair(draw_kind(stream), draw_kind(stream), stream);
    const cores::PlacedCores placed(pair);
    const Vec middle = random_direction(stream);
    const double half = stream.log_uniform(1e-4, 1);
    cores::LowDirection lowest{middle, 10};
    const cores::Mixture mixture = cores::mixture_in(placed, cell_about(middle, half), {}, {10, 10}, lowest);
    const Mat3<double> frame = frame_about(middle);
    const double bound = cores::proved_in(placed, mixture, frame, {2, 1, 0, 0, half});
    EXPECT_LE(bound, mixture.value > 0 ? mixture.value + 1e-12 : 0);
    for (int k = 0; k < 20; ++k) {
      const Vec n = frame * Vec(stream.uniform(-half, half), stream.uniform(-half, half), 1);
      EXPECT_LE(bound, high(placed.overlap_at(n))) << i;
    }
    EXPECT_LE(cores::proved_everywhere(placed, mixture), low(placed.overlap_at(lowest.n)) + 1e-12) << i;
  }
}

TEST(ConvexCores, TheBestMixtureIsThatOfTheGame) {
  for (std::uint64_t i = 0; i < 500; ++i) {
    Stream stream("games", 1, i);
    cores::Points points;
    for (std::size_t k = 0; k < 1 + stream.below(8); ++k) points.push_back(random_direction(stream) + Vec(0, 0, 0.5));
    const cores::CornersOfCell corners = cell_about(Vec(0, 0, 1), stream.log_uniform(1e-5, 1));
    const cores::GameSolution game = cores::best_mixture(points, corners);
    Vec answer = Vec::Zero();
    for (std::size_t j = 0; j < 4; ++j) answer += game.corner_weights[j] * corners[j];
    double most = points[0].dot(answer);
    for (const Vec& point : points) most = std::max(most, point.dot(answer));
    EXPECT_NEAR(game.value, most, 1e-12) << i;  // neither side can do better: both are right
  }
}

TEST(ConvexCores, TheNearestMixtureHasNoNearerPoint) {
  for (std::uint64_t i = 0; i < 500; ++i) {
    Stream stream("nearest mixtures", 1, i);
    cores::Points points;
    for (std::size_t k = 0; k < 1 + stream.below(7); ++k) points.push_back(random_direction(stream));
    const Vec w = cores::mixed(points, cores::nearest_mixture(points));
    for (const Vec& point : points) EXPECT_GE(point.dot(w), w.squaredNorm() - 1e-12) << i;
  }
}

}  // namespace
}  // namespace plumb::reference::convex_cores_tests
