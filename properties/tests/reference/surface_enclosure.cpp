// Surface points over boxes of charts, and the gauge over boxes of points: against points of the boxes in 50 digits.
#include "solver/reference/interval/surface_enclosure.hpp"

#include <gtest/gtest.h>

#include "properties/tests/reference/inside.hpp"
#include "solver/pose.hpp"
#include "solver/shape/chart.hpp"

namespace plumb::reference::surface_enclosure_tests {
namespace {

using namespace inside_tests;
using Fine = Real50;
using I = Interval80;

/// A box of a face's two coordinates: on folds and beside them as often as anywhere.
struct ChartBox {
  int major;
  Vec3<double> at, half = Vec3<double>::Zero();

  explicit ChartBox(Stream& stream) : major(static_cast<int>(stream.below(3))) {
    at[major] = stream.sign();
    for (const int step : {1, 2}) {
      at[(major + step) % 3] = stream.chance(0.3) ? 0 : stream.uniform(-1, 1);
      half[(major + step) % 3] = stream.log_uniform(1e-12, 0.1);
    }
  }
  [[nodiscard]] SurfaceBox<I> box() const { return {major, box_about<I>(at, half)}; }
  [[nodiscard]] CubePoint<Fine> draw(Stream& stream) const { return {draw_in_box(at, half, stream), major}; }
};

TEST(SurfaceEnclosure, PointsNormalsAndDerivativesLieInIt) {
  int narrow = 0;
  for (std::uint64_t draw = 0; draw < 120; ++draw) {
    Stream stream("charts", 1, draw);
    const Pair pair = draw_pair(stream);
    const EnclosedBody<I> body = enclose<I>(pair).body1;
    const PlacedBody<Fine> placed = place<Fine>(pair).body1;
    const ChartBox chart(stream);
    const SurfaceJet<I> jet = surface_jet<I>(body, chart.box());
    const SurfaceEnclosure<I> surface = enclose_surface<I>(body, chart.box());
    for (int k = 0; k < 4; ++k) {
      const CubePoint<Fine> there = chart.draw(stream);
      if (there.w[0] == 0 && there.w[1] == 0) continue;  // the pole: the derivatives' limits are many
      const SurfacePoint<Fine> truth = surface_point<Fine>(placed.shape, there);
      EXPECT_TRUE(are_in(jet.point, truth.point)) << draw << ", w " << there.w.transpose();
      EXPECT_TRUE(are_in(jet.normal, truth.normal)) << draw << ", w " << there.w.transpose();
      EXPECT_TRUE(are_in(jet.dpoint, truth.dpoint)) << draw << ", w " << there.w.transpose();
      EXPECT_TRUE(are_in(jet.dnormal, truth.dnormal)) << draw << ", w " << there.w.transpose();
      EXPECT_TRUE(are_in(surface.point, placed.to_pair_direction(truth.point))) << draw;
    }
    narrow += widest(jet.point) < 0.1 && widest(jet.normal) < 0.1 ? 1 : 0;
  }
  EXPECT_GT(narrow, 50);
}

TEST(SurfaceEnclosure, NarrowsWithItsBox) {
  for (std::uint64_t draw = 0; draw < 40; ++draw) {
    Stream stream("narrow", 1, draw);
    const EnclosedBody<I> body = enclose<I>(draw_pair(stream)).body1;
    ChartBox chart(stream);
    for (const int step : {1, 2}) chart.at[(chart.major + step) % 3] = stream.sign() * stream.uniform(0.2, 1);
    double before = std::numeric_limits<double>::infinity();
    for (const double half : {1e-4, 1e-7, 1e-10, 0.0}) {
      chart.half.setZero();
      for (const int step : {1, 2}) chart.half[(chart.major + step) % 3] = half;
      const SurfaceJet<I> jet = surface_jet<I>(body, chart.box());
      const double now = std::max({widest(jet.point), widest(jet.normal), widest(jet.dpoint), widest(jet.dnormal)});
      EXPECT_LE(now, before) << draw;
      EXPECT_LE(widest(jet.point), 1e3 * half + 1e-60) << draw;
      before = now;
    }
    EXPECT_LE(before, 1e-60) << draw;
  }
}

/// A change of an axis while the chart is held.
TEST(SurfaceEnclosure, TheColumnsByTheAxesAreDifferences) {
  for (std::uint64_t draw = 0; draw < 30; ++draw) {
    Stream stream("axes", 1, draw);
    const Pair pair = draw_pair(stream);
    const EnclosedBody<I> body = enclose<I>(pair).body1;
    const Superellipsoid<Fine> shape = place<Fine>(pair).body1.shape;
    ChartBox chart(stream);
    const CubePoint<Fine> at{chart.at.cast<Fine>(), chart.major};
    chart.half.setConstant(0);
    const SurfaceJet<I> jet = surface_jet<I>(body, chart.box());
    const Fine step("1e-18");
    for (int axis = 0; axis < 3; ++axis) {
      const auto grown = [&](const Fine& by) {  // by log a, the chart held
        Superellipsoid<Fine> out = shape;
        out.semi_axes[axis] *= exp(by);
        return surface_point<Fine>(out, at);
      };
      const SurfacePoint<Fine> ahead = grown(step), behind = grown(-step);
      const Vec3<Fine> point = (ahead.point - behind.point) / (2 * step),
                       normal = (ahead.normal - behind.normal) / (2 * step);
      for (int i = 0; i < 3; ++i) {
        EXPECT_LE(abs(Fine(point[i] - middle<Fine>(jet.point_by_shape(i, axis)))), Fine("1e-28")) << draw;
        EXPECT_LE(abs(Fine(normal[i] - middle<Fine>(jet.normal_by_shape(i, axis)))), Fine("1e-28")) << draw;
      }
    }
  }
}

TEST(SurfaceEnclosure, TheGaugeAndItsGradientLieInTheirs) {
  int narrow = 0;
  for (std::uint64_t draw = 0; draw < 120; ++draw) {
    Stream stream("gauge", 1, draw);
    const Pair pair = draw_pair(stream);
    const EnclosedBody<I> body = enclose<I>(pair).body1;
    const PlacedBody<Fine> placed = place<Fine>(pair).body1;
    const Vec3<double> x = generators::draw_direction(stream) * stream.uniform(0.3, 2);
    Vec3<double> half;
    for (double& h : half) h = stream.chance(0.2) ? 0 : stream.log_uniform(1e-12, 0.1);
    const GaugeEnclosure<I> found = enclose_gauge<I>(body, box_about<I>(x, half));
    for (int k = 0; k < 4; ++k) {
      const Vec3<Fine> there = draw_in_box(x, half, stream);
      const NormValue<Fine> truth = gauge_gradient<Fine>(placed.shape, placed.to_body(there));
      EXPECT_TRUE(is_in(found.value, truth.value)) << draw;
      EXPECT_TRUE(are_in(found.gradient, placed.to_pair_direction(truth.gradient))) << draw;
    }
    narrow += width(found.value) < 0.1 ? 1 : 0;
  }
  EXPECT_GT(narrow, 50);
}

}  // namespace
}  // namespace plumb::reference::surface_enclosure_tests
