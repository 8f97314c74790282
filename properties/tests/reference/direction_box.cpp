// Both bodies over a box of directions, and the functionals that exclude stationary ones: against points of the box in 50 digits.
#include "solver/reference/interval/direction_box.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "properties/tests/reference/inside.hpp"
#include "solver/pose.hpp"
#include "solver/reference/frame.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb::reference::direction_box_tests {
namespace {

using namespace inside_tests;
using Fine = Real50;
using I = Interval80;

Cell draw_cell(Stream& stream) {
  return {static_cast<int>(stream.below(3)), stream.sign(), stream.chance(0.3) ? 0 : stream.uniform(-1, 1),
          stream.chance(0.3) ? 0 : stream.uniform(-1, 1), stream.log_uniform(1e-9, 0.2)};
}

Vec3<Fine> draw_in(const Cell& cell, Stream& stream) {
  Vec3<Fine> out;
  out[cell.axis] = cell.sign;
  out[(cell.axis + 1) % 3] = Fine(cell.u) + Fine(stream.uniform(-1, 1)) * cell.half;
  out[(cell.axis + 2) % 3] = Fine(cell.v) + Fine(stream.uniform(-1, 1)) * cell.half;
  return out;
}

/// The pair in 50 digits, in a frame of directions.
struct Truth {
  PlacedPair<Fine> placed;
  Mat3<Fine> frame;

  Truth(const Pair& pair, const DirectionFrame& f) : placed(place<Fine>(pair)), frame(f.columns.cast<Fine>()) {
    if (f.base >= 0) frame = (f.base == 0 ? placed.body1 : placed.body2).rotation * frame;
  }

  [[nodiscard]] const PlacedBody<Fine>& body(std::size_t b) const { return b == 0 ? placed.body1 : placed.body2; }
  /// R1'd and -R2'd.
  [[nodiscard]] Vec3<Fine> direction(std::size_t b, const Vec3<Fine>& v) const {
    return body(b).rotation.transpose() * (frame * v) * Fine(b == 0 ? 1 : -1);
  }
  /// G = p1(d) - p2(-d).
  [[nodiscard]] Vec3<Fine> gap(const Vec3<Fine>& v) const {
    Vec3<Fine> out = -placed.body2.centre;
    for (const std::size_t b : {0U, 1U})
      out += body(b).rotation * support_point<Fine>(body(b).shape, direction(b, v)).gradient * Fine(b == 0 ? 1 : -1);
    return out;
  }
  /// c.(G x d).
  [[nodiscard]] Fine functional(const Vec3<Fine>& c, const Vec3<Fine>& v) const {
    return c.dot(gap(v).cross(Vec3<Fine>(frame * v)));
  }
};

DirectionFrame draw_frame(Stream& stream) {
  return {frame_about(random_direction(stream)), static_cast<int>(stream.below(3)) - 1, false};
}

TEST(DirectionBox, PointsAndSecondDerivativesLieInIt) {
  int narrow = 0;
  for (std::uint64_t draw = 0; draw < 100; ++draw) {
    Stream stream("boxes", 1, draw);
    const Pair pair = draw_pair(stream);
    const DirectionFrame frame = draw_frame(stream);
    const Truth truth(pair, frame);
    const ChartedPair<I> charted(enclose<I>(pair), frame);
    const Cell cell = draw_cell(stream);
    const DirectionBox<I> box = direction_box<I>(charted, box_of<I>(cell, cell.half));
    for (int k = 0; k < 4; ++k) {
      const Vec3<Fine> v = draw_in(cell, stream);
      for (const std::size_t b : {0U, 1U}) {
        const Vec3<Fine> u = truth.direction(b, v);
        const NormHessian<Fine> h = support_hessian<Fine>(truth.body(b).shape, u);
        EXPECT_TRUE(are_in(box.bodies[b].direction, u)) << draw;
        EXPECT_TRUE(are_in(box.bodies[b].point, h.gradient)) << draw << ", u " << u.transpose();
        EXPECT_TRUE(are_in(box.bodies[b].hessian, h.hessian)) << draw << ", u " << u.transpose();
      }
    }
    narrow += widest(box.bodies[0].point) < 0.1 ? 1 : 0;
  }
  EXPECT_GT(narrow, 40);
}

TEST(DirectionBox, FunctionalsLieInTheirBoundsAndSlopesInTheirs) {
  int narrow = 0;
  for (std::uint64_t draw = 0; draw < 100; ++draw) {
    Stream stream("functionals", 1, draw);
    const Pair pair = draw_pair(stream);
    const DirectionFrame frame = draw_frame(stream);
    const Truth truth(pair, frame);
    const ChartedPair<I> charted(enclose<I>(pair), frame);
    const Cell cell = draw_cell(stream);
    const DirectionBox<I> box = direction_box<I>(charted, box_of<I>(cell, cell.half));
    const bool is_axis = stream.chance(0.5);
    const auto axis = static_cast<int>(stream.below(6));
    const Vec3<double> c = random_direction(stream);
    const Functional<I> phi = is_axis ? axis_functional<I>(charted, axis) : functional<I>(charted, c);
    const Mat3<Fine> base =
        frame.base < 0 ? Mat3<Fine>(Mat3<Fine>::Identity()) : truth.body(static_cast<std::size_t>(frame.base)).rotation;
    const Vec3<Fine> along = is_axis ? Vec3<Fine>(truth.body(static_cast<std::size_t>(axis / 3)).rotation.col(axis % 3))
                                     : Vec3<Fine>(base * c.cast<Fine>());
    const I value = value_of<I>(box, phi);
    for (int k = 0; k < 3; ++k) {
      const Vec3<Fine> v = draw_in(cell, stream);
      EXPECT_TRUE(is_in(value, truth.functional(along, v))) << draw;
      const Fine step("1e-22");
      for (const int component : {(cell.axis + 1) % 3, (cell.axis + 2) % 3}) {
        Vec3<Fine> ahead = v, behind = v;
        ahead[component] += step;
        behind[component] -= step;
        const Fine slope = (truth.functional(along, ahead) - truth.functional(along, behind)) / (2 * step);
        const I bounds = slope_of<I>(charted, box, phi, component) + hull<I>(-1e-15, 1e-15);
        EXPECT_TRUE(is_in(bounds, slope)) << draw << ", along " << component;
      }
    }
    narrow += width(value) < 0.1 ? 1 : 0;
  }
  EXPECT_GT(narrow, 40);
}

TEST(DirectionBox, NarrowsWithTheCell) {
  for (std::uint64_t draw = 0; draw < 30; ++draw) {
    Stream stream("narrow", 1, draw);
    Pair pair = draw_pair(stream);
    for (Body* body : {&pair.body1, &pair.body2}) body->shape.n1 = body->shape.n2 = stream.uniform(1.8, 3);
    const DirectionFrame frame = draw_frame(stream);
    const ChartedPair<I> charted(enclose<I>(pair), frame);
    const Functional<I> phi = functional<I>(charted, random_direction(stream));
    Cell cell = draw_cell(stream);
    cell.u = stream.uniform(-0.9, 0.9), cell.v = stream.uniform(-0.9, 0.9);
    double before = 1e9;
    for (const double half : {1e-3, 1e-6, 1e-9, 0.0}) {
      const DirectionBox<I> box = direction_box<I>(charted, box_of<I>(cell, half));
      const double now = width(value_of<I>(box, phi));
      EXPECT_LE(now, before) << draw;
      before = now;
    }
    EXPECT_LE(before, 1e-60) << draw;
  }
}

/// Body 2 where the common normal is F v, for a v in the cell: no functional may exclude it, by values or by slopes.
TEST(DirectionBox, NoExclusionOfACellThatHoldsACommonNormal) {
  int excluded = 0, tried = 0;
  for (std::uint64_t draw = 0; draw < 80; ++draw) {
    Stream stream("exclusions", 1, draw);
    Pair pair = draw_pair(stream);
    const DirectionFrame frame{frame_about(random_direction(stream)), -1, false};
    const Cell cell{static_cast<int>(stream.below(3)), stream.sign(), stream.uniform(-1, 1), stream.uniform(-1, 1),
                    stream.log_uniform(1e-6, 0.1)};
    const Vec3<Fine> v = cell.at(stream.uniform(-0.9, 0.9), stream.uniform(-0.9, 0.9)).cast<Fine>();
    pair.body2.position = pair.body1.position;
    const Truth concentric(pair, frame);
    const Vec3<Fine> n = (concentric.frame * v).normalized();
    const Vec3<Fine> centre = concentric.gap(v) - Fine(stream.uniform(0.05, 0.5)) * n;
    pair.body2.position = concentric.placed.to_world_point(centre, pair).cast<double>();
    const ChartedPair<I> charted(enclose<I>(pair), frame);
    // The rounded centre moves the common normal by 1e-15 or so: less than a tenth of the cell, but for flats.
    if (!(width(value_of<I>(direction_box<I>(charted, box_of<I>(cell, cell.half)),
                            functional<I>(charted, random_direction(stream)))) > 1e-12))
      continue;
    ++tried;
    for (int k = 0; k < 8; ++k) {
      const Exclusion by{k < 6 ? k : -1, random_direction(stream), stream.chance(0.5)};
      EXPECT_FALSE(holds<I>(charted, cell, by)) << draw << ", exclusion " << k;
    }
    // Elsewhere some do.
    Cell other = cell;
    other.sign = -cell.sign;
    other.half /= 16;
    for (int k = 0; k < 6; ++k)
      if (holds<I>(charted, other, {k, Vec3<double>::Zero(), false})) {
        ++excluded;
        break;
      }
  }
  EXPECT_GT(tried, 60);
  EXPECT_GT(excluded, 30);
}

TEST(DirectionBox, WithinIsWhatTheFrameSays) {
  Stream stream("within", 1, 0);
  int within = 0;
  for (int draw = 0; draw < 500; ++draw) {
    Mat3<double> frame = frame_about(random_direction(stream));
    frame.col(0) *= stream.uniform(0.5, 2);
    const double half = stream.log_uniform(1e-3, 1), x = stream.uniform(-2, 2) * half, y = stream.uniform(-2, 2) * half;
    const Vec3<Fine> d = frame.cast<Fine>() * Vec3<Fine>(Fine(x), Fine(y), Fine(1)) * Fine(stream.log_uniform(0.1, 10));
    const bool expected = std::abs(x) <= half && std::abs(y) <= half;
    EXPECT_EQ(is_within<I>(frame, enclosed<I>(d), half), expected) << draw;
    EXPECT_FALSE(is_within<I>(frame, enclosed<I>(Vec3<Fine>(-d)), half)) << draw;
    Mat3<double> mirrored = frame;
    mirrored.col(1) = -mirrored.col(1);
    EXPECT_FALSE(is_within<I>(mirrored, enclosed<I>(d), half)) << draw;
    within += expected ? 1 : 0;
  }
  EXPECT_GT(within, 60);
}

}  // namespace
}  // namespace plumb::reference::direction_box_tests
