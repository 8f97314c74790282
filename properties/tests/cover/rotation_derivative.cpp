// The derivative of the overlap as directions turn about an axis of revolution: where a cell is said to have one sign of it,
// against differences of the overlap itself.
#include "solver/method/auto/cover/rotation_derivative.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "properties/generators/draft.hpp"
#include "solver/method/auto/cover/direction_cells.hpp"
#include "solver/pose.hpp"
#include "solver/reference/real.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb::rotation_derivative_tests {
namespace {

using Fine = Real50;
using Cell = DirectionCell<double>;

Cell draw_cell(Stream& stream) {
  Cell cell{0, 0, static_cast<int>(stream.below(Cell::faces)), 0};
  const auto depth = 1 + static_cast<int>(stream.below(7));
  while (cell.depth < depth) cell = cell.part(static_cast<int>(stream.below(Cell::parts)));
  return cell;
}

/// A body of revolution about its own `axis`, placed with that along `along`.
Body placed_along(const Vec3<double>& along, int axis, Stream& stream) {
  Body out;
  out.shape.semi_axes[axis] = stream.log_uniform(0.3, 3);
  if (axis == 2 && stream.chance(0.6)) out.shape.n1 = stream.log_uniform(1.3, 15);
  const Vec3<double> from = Vec3<double>::Unit(axis), about = from.cross(along);
  out.quaternion = {1 + from.dot(along), about[0], about[1], about[2]};
  return out;
}

struct Drawn {
  Pair pair;
  int axis1;  ///< body 1's own axis of revolution
};

/// Axes and centres off one line by `off`.
Drawn draw_pair(Stream& stream, double off) {
  const Vec3<double> axis = random_direction(stream);
  const auto axis1 = static_cast<int>(stream.below(3));
  Drawn out{{}, axis1};
  out.pair.body1 = placed_along(axis, axis1, stream);
  out.pair.body2 =
      placed_along((axis + off * random_direction(stream)).normalized(), static_cast<int>(stream.below(3)), stream);
  out.pair.body2.position = axis * stream.uniform(-0.5, 0.5) + off * random_direction(stream);
  return out;
}

Fine overlap_along(const PlacedPair<Fine>& pair, const Vec3<Fine>& n) {
  return support<Fine>(pair.body1.shape, pair.body1.to_body_direction(n)) +
         support<Fine>(pair.body2.shape, pair.body2.to_body_direction(-n)) - n.dot(pair.body2.centre);
}

/// d o / d angle at n about the unit `axis`, by a central difference of turns.
Fine slope_of_turn(const PlacedPair<Fine>& pair, const Vec3<Fine>& axis, const Vec3<Fine>& n) {
  const Fine angle("1e-16"), c = cos(angle), s = sin(angle);
  const Vec3<Fine> along = axis * axis.dot(n), across = n - along, third = axis.cross(n);
  const auto turned = [&](const Fine& sine) -> Vec3<Fine> { return along + c * across + sine * third; };
  return (overlap_along(pair, turned(s)) - overlap_along(pair, turned(-s))) / (2 * angle);
}

Vec3<Fine> draw_in(const Cell& cell, Stream& stream) {
  const Vec3<double> corner = cell.at(-1, -1).eigen(), u = cell.at(1, -1).eigen() - corner,
                     v = cell.at(-1, 1).eigen() - corner;
  return Vec3<double>(corner + stream.uniform() * u + stream.uniform() * v).cast<Fine>().normalized();
}

/// From far off one line to a hair off it: the overlap then changes by 1e-13 all around, and has its sign all the same.
TEST(RotationDerivative, TheOverlapRisesOrFallsAllOverACellOfOneSign) {
  for (const double off : {1.0, 1e-2, 1e-6, 1e-12}) {
    Stream stream("rotation", 1, static_cast<std::uint64_t>(-std::log10(off)));
    int with_one_sign = 0, rising = 0;
    for (int draw = 0; draw < 60; ++draw) {
      const Drawn drawn = draw_pair(stream, off);
      const auto derivative = RotationDerivative<double>::of(place<double>(drawn.pair));
      if (!derivative) FAIL() << draw;
      const Cell cell = draw_cell(stream);
      if (!derivative->has_one_sign(cell.corners())) continue;
      ++with_one_sign;
      const PlacedPair<Fine> fine = place<Fine>(drawn.pair);
      const Vec3<Fine> axis = fine.body1.rotation.col(drawn.axis1).normalized();
      const bool rises = slope_of_turn(fine, axis, draw_in(cell, stream)) > 0;
      for (int k = 0; k < 12; ++k)
        EXPECT_EQ(slope_of_turn(fine, axis, draw_in(cell, stream)) > 0, rises) << draw << ", off " << off;
      rising += rises ? 1 : 0;
    }
    EXPECT_GT(with_one_sign, 15) << off;
    EXPECT_GT(rising, 0) << off;
    EXPECT_LT(rising, with_one_sign) << off;
  }
}

/// A cell that holds a common normal has no one sign: the derivative vanishes there.
TEST(RotationDerivative, ACellWithAStationaryDirectionHasNone) {
  Stream stream("stationary", 1, 0);
  for (int draw = 0; draw < 200; ++draw) {
    // Body 2 where the common normal is n: c = p1(n) - p2(-n) - o n.
    Drawn drawn = draw_pair(stream, stream.log_uniform(1e-6, 1));
    drawn.pair.body2.position = drawn.pair.body1.position;
    const PlacedPair<double> concentric = place<double>(drawn.pair);
    const Cell cell = draw_cell(stream);
    const Vec3<double> n = draw_in(cell, stream).cast<double>();
    const auto point = [](const PlacedBody<double>& body, const Vec3<double>& u) {
      return body.to_pair_direction(support_point<double>(body.shape, body.to_body_direction(u)).gradient);
    };
    const Vec3<double> centre =
        point(concentric.body1, n) - point(concentric.body2, -n) - stream.uniform(0.01, 0.5) * n;
    drawn.pair.body2.position = concentric.to_world_point(centre, drawn.pair);
    const auto derivative = RotationDerivative<double>::of(place<double>(drawn.pair));
    if (!derivative) FAIL();
    EXPECT_FALSE(derivative->has_one_sign(cell.corners())) << draw;
  }
}

/// A sphere off a body's axis: the overlap falls towards the half plane of its centre, and only cells across that are left.
TEST(RotationDerivative, OfASphereBesideAnAxisItIsTheSideOfThePlane) {
  Pair pair;
  pair.body1.shape.semi_axes = {1, 1, 2};
  pair.body2.shape.semi_axes *= 0.5;
  pair.body2.position << 0.3, 0, 0.4;
  const auto derivative = RotationDerivative<double>::of(place<double>(pair));
  if (!derivative) FAIL();
  int beside = 0;
  Stream stream("sphere", 1, 0);
  for (int draw = 0; draw < 500; ++draw) {
    const auto corners = draw_cell(stream).corners();
    double least = 1, most = -1;
    for (const Vector3<double>& n : corners) least = std::min(least, n.y), most = std::max(most, n.y);
    const bool is_beside = least > 1e-9 || most < -1e-9;  // of the plane y = 0 through the axis and the centre
    EXPECT_EQ(derivative->has_one_sign(corners), is_beside) << draw;
    beside += is_beside ? 1 : 0;
  }
  EXPECT_GT(beside, 100);
  EXPECT_LT(beside, 500);
}

/// Axes on one line that holds the centres: o is the same all around.
TEST(RotationDerivative, OfCoaxialBodiesNoCellHasASign) {
  Stream stream("coaxial", 1, 0);
  for (int draw = 0; draw < 100; ++draw) {
    const Drawn drawn = draw_pair(stream, 0);
    const auto derivative = RotationDerivative<double>::of(place<double>(drawn.pair));
    if (!derivative) FAIL();
    EXPECT_FALSE(derivative->has_one_sign(draw_cell(stream).corners())) << draw;
  }
}

}  // namespace
}  // namespace plumb::rotation_derivative_tests
