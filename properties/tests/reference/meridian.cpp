// The verifier of meridians against brute force: the bounds of arcs and valleys, what makes a half circle, and who is of
// revolution.
#include "solver/reference/proof/meridian.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <functional>

#include "properties/tests/reference/inside.hpp"
#include "solver/pose.hpp"
#include "solver/reference/frame.hpp"
#include "solver/reference/reference.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb::reference::meridian_tests {
namespace {

using namespace inside_tests;
using I = Interval80;

/// Bodies of revolution about one line: the frame's third axis.
struct Coaxial {
  Pair pair;
  Mat3<double> frame;

  explicit Coaxial(Stream& stream) {
    for (Body* body : {&pair.body1, &pair.body2}) {
      body->shape.semi_axes[2] = stream.log_uniform(0.3, 3);
      if (stream.chance(0.5)) body->shape.n1 = stream.log_uniform(1.5, 6);
    }
    // Whole components: the axis is then exact.
    pair.body1.quaternion = pair.body2.quaternion = random_axis_rotation(stream);
    const Vec3<double> axis = place<double>(pair).body1.rotation.col(2);
    pair.body2.position = axis * stream.uniform(0.1, 0.8);
    frame = frame_about(axis);
  }

  [[nodiscard]] double overlap_along(const Vec3<double>& n) const {
    const PlacedPair<double> placed = place<double>(pair);
    return support<double>(placed.body1.shape, placed.body1.to_body_direction(n)) +
           support<double>(placed.body2.shape, placed.body2.to_body_direction(-n)) - n.dot(placed.body2.centre);
  }
  [[nodiscard]] double overlap_at(double place) const {
    return overlap_along((frame * chart_at<double>(place)).normalized());
  }
  /// The support points at a place, a hair inside.
  [[nodiscard]] Witness witness_at(double place_of) const {
    const PlacedPair<double> placed = place<double>(pair);
    const Vec3<double> n = (frame * chart_at<double>(place_of)).normalized();
    const auto point = [](const PlacedBody<double>& body, const Vec3<double>& u) -> Vec3<double> {
      return support_point<double>(body.shape, body.to_body_direction(u)).gradient * (1 - 1e-13);
    };
    return {point(placed.body1, n), point(placed.body2, -n)};
  }
  /// `arcs` equal arcs, a multiple of 4, each with the support points at its middle.
  [[nodiscard]] Meridian even(int arcs) const {
    Meridian out;
    out.places.push_back(0);
    for (int k = 0; k < arcs; ++k) {
      out.places.push_back(4.0 * (k + 1) / arcs);
      out.witnesses.push_back(witness_at(4.0 * (k + 0.5) / arcs));
    }
    return out;
  }
  [[nodiscard]] FramedPair<I> framed() const { return {enclose<I>(pair), frame}; }

  [[nodiscard]] double lowest() const {
    double out = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= 2000; ++k) out = std::min(out, overlap_at(4.0 * k / 2000));
    return out;
  }
};

TEST(Meridian, PlacesGoRoundTheHalfCircle) {
  double before = -1;
  for (int k = 0; k <= 400; ++k) {
    const Vec3<double> v = chart_at<double>(k / 100.0);
    EXPECT_EQ(v.cwiseAbs().maxCoeff(), 1) << k;
    EXPECT_EQ(v[1], 0) << k;
    const double angle = std::atan2(v[0], v[2]);
    EXPECT_GT(angle, before) << k;
    before = angle;
  }
  EXPECT_EQ(chart_at<double>(0.0), Vec3<double>(0, 0, 1));
  EXPECT_EQ(chart_at<double>(4.0), Vec3<double>(0, 0, -1));
}

TEST(Meridian, AnArcsBoundIsBelowTheOverlapAllOverIt) {
  int close = 0;
  for (std::uint64_t draw = 0; draw < 60; ++draw) {
    Stream stream("arcs", 1, draw);
    const Coaxial bodies(stream);
    const FramedPair<I> framed = bodies.framed();
    const double first = std::floor(stream.uniform(0, 4)) + stream.uniform(0, 0.7),
                 last = first + stream.uniform(0, 0.25);
    const auto apart = points_apart<I>(framed.pair, bodies.witness_at((first + last) / 2));
    if (!apart) FAIL() << draw;
    const double least = least_on<I>(framed, {first, last}, *apart);
    double lowest = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= 50; ++k) lowest = std::min(lowest, bodies.overlap_at(first + (last - first) * k / 50));
    EXPECT_LE(least, lowest + 1e-15) << draw;
    close += least > 0.9 * lowest ? 1 : 0;
  }
  EXPECT_GT(close, 30);
}

TEST(Meridian, AValleysBoundIsBelowTheOverlapAllOverIt) {
  int bounded = 0, close = 0;
  for (std::uint64_t draw = 0; draw < 120; ++draw) {
    Stream stream("valleys", 1, draw);
    const Coaxial bodies(stream);
    const FramedPair<I> framed = bodies.framed();
    // About the lowest place, and anywhere.
    double place = stream.uniform(0.05, 3.95);
    if (stream.chance(0.7))
      for (int k = 0; k <= 400; ++k)
        if (bodies.overlap_at(k / 100.0) < bodies.overlap_at(place)) place = k / 100.0;
    const double reach = stream.log_uniform(1e-3, 0.2), first = std::max(0.0, place - reach),
                 last = std::min(4.0, place + reach * stream.uniform(0.5, 2));
    const auto least = least_in<I>(framed, {first, last, place, 0});
    if (!least) continue;
    ++bounded;
    double lowest = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= 100; ++k) lowest = std::min(lowest, bodies.overlap_at(first + (last - first) * k / 100));
    EXPECT_LE(low(*least), lowest + 1e-15) << draw;
    close += low(*least) > lowest - 1e-3 ? 1 : 0;
  }
  EXPECT_GT(bounded, 40);
  EXPECT_GT(close, 30);
}

/// A valley over a corner of the cube, or whose place lies outside, bounds nothing.
TEST(Meridian, AValleyIsOnOneFaceAndHoldsItsPlace) {
  Stream stream("one face", 1, 0);
  Pair spheres;
  spheres.body2.position << 0, 0, 0.5;
  const FramedPair<I> framed(enclose<I>(spheres), Mat3<double>::Identity());
  EXPECT_TRUE(least_in<I>(framed, {0, 0.1, 0, 0}));
  EXPECT_FALSE(least_in<I>(framed, {0.9, 1.1, 0.95, 0}));
  EXPECT_FALSE(least_in<I>(framed, {2.9, 3.1, 2.95, 0}));
  EXPECT_FALSE(least_in<I>(framed, {0, 0.1, 0.100001, 0}));
  EXPECT_FALSE(least_in<I>(framed, {0, 0.1, 0, -1e-20}));
}

/// The whole of it, against all directions and not the meridian's alone.
TEST(Meridian, NoDirectionIsLowerThanItProves) {
  for (std::uint64_t draw = 0; draw < 20; ++draw) {
    Stream stream("meridians", 1, draw);
    const Coaxial bodies(stream);
    const MeridianProof<I> proof = verify_meridian<I>(bodies.pair, bodies.framed(), bodies.even(32));
    ASSERT_TRUE(proof.well_formed) << draw;
    EXPECT_GT(low(proof.least), 0.5 * bodies.lowest()) << draw;
    for (int k = 0; k < 2000; ++k)
      EXPECT_LE(low(proof.least), bodies.overlap_along(random_direction(stream)) + 1e-15) << draw;
    EXPECT_LE(low(proof.least), bodies.lowest() + 1e-15) << draw;
  }
}

TEST(Meridian, WithAGapOrAPointOutsideItIsNone) {
  Stream stream("tampered", 1, 0);
  const Coaxial bodies(stream);
  const FramedPair<I> framed = bodies.framed();
  const Meridian honest = bodies.even(16);
  const auto holds = [&](const std::function<void(Meridian&)>& change) {
    Meridian out = honest;
    change(out);
    return verify_meridian<I>(bodies.pair, framed, out).well_formed;
  };
  EXPECT_TRUE(holds([](Meridian&) {}));
  EXPECT_FALSE(holds([](Meridian& m) { m.places.front() = 1e-9; }));
  EXPECT_FALSE(holds([](Meridian& m) { m.places.back() = 3.999; }));
  EXPECT_FALSE(holds([](Meridian& m) { m.places[4] = 1.01; }));  // the corner at 1
  EXPECT_FALSE(holds([](Meridian& m) { m.places[12] = 2.99; }));
  EXPECT_FALSE(holds([](Meridian& m) { std::swap(m.places[6], m.places[7]); }));
  EXPECT_FALSE(holds([](Meridian& m) { m.places[6] = m.places[7]; }));
  EXPECT_FALSE(holds([](Meridian& m) { m.places[6] = std::numeric_limits<double>::quiet_NaN(); }));
  EXPECT_FALSE(holds([](Meridian& m) { m.witnesses.pop_back(); }));
  EXPECT_FALSE(holds([](Meridian& m) { m.places.erase(m.places.begin() + 6); }));
  for (std::size_t k = 0; k < honest.witnesses.size(); ++k) {
    EXPECT_FALSE(holds([k](Meridian& m) { m.witnesses[k].point1 *= 1.001; })) << k;
    EXPECT_FALSE(holds([k](Meridian& m) { m.witnesses[k].point2 *= 1.001; })) << k;
  }
}

/// Bodies that only look coaxial: the bound is what it is without the difference, and infinite for a body not of revolution.
TEST(Meridian, OfBodiesNotOfRevolutionItProvesNothing) {
  Stream stream("triaxial", 1, 0);
  Coaxial bodies(stream);
  const Meridian honest = bodies.even(32);
  bodies.pair.body1.shape = {{1, 0.9, 1.2}, 2, 2};
  const MeridianProof<I> proof = verify_meridian<I>(bodies.pair, bodies.framed(), honest);
  EXPECT_FALSE(proof.well_formed && low(proof.least) > -1e300);
  Coaxial tilted(stream);
  const double straight = low(verify_meridian<I>(tilted.pair, tilted.framed(), tilted.even(32)).least);
  tilted.pair.body2.position += 1e-3 * tilted.frame.col(0);
  const Meridian own = tilted.even(32);
  const double least = low(verify_meridian<I>(tilted.pair, tilted.framed(), own).least);
  EXPECT_LE(least, straight - 1e-3);
  for (int k = 0; k < 2000; ++k) EXPECT_LE(least, tilted.overlap_along(random_direction(stream)));
}

TEST(Meridian, TheAxisOfRevolutionIsTheUnequalOne) {
  using Shape = Superellipsoid<double>;
  EXPECT_EQ(axis_of_revolution(Shape{{1, 1, 2}, 2, 2}), 2);
  EXPECT_EQ(axis_of_revolution(Shape{{2, 1, 1}, 2, 2}), 0);
  EXPECT_EQ(axis_of_revolution(Shape{{1, 2, 1}, 2, 2}), 1);
  EXPECT_EQ(axis_of_revolution(Shape{{1, 1, 2}, 5, 2}), 2);
  EXPECT_EQ(axis_of_revolution(Shape{{2, 1, 1}, 5, 2}), std::nullopt);
  EXPECT_EQ(axis_of_revolution(Shape{{1, 1, 2}, 2, 5}), std::nullopt);
  EXPECT_EQ(axis_of_revolution(Shape{{1, 2, 3}, 2, 2}), std::nullopt);
  EXPECT_EQ(axis_of_revolution(Shape{{1, std::nextafter(1.0, 2.0), 3}, 2, 2}), std::nullopt);
  EXPECT_TRUE(is_sphere(Shape{{2, 2, 2}, 2, 2}));
  EXPECT_FALSE(is_sphere(Shape{{2, 2, 2}, 2, 2.1}));
  EXPECT_FALSE(is_sphere(Shape{{2, 2, std::nextafter(2.0, 3.0)}, 2, 2}));
}

TEST(Meridian, OfSpheresTheLowestIsAlongTheLineOfCentres) {
  Pair spheres;
  spheres.body1.shape.semi_axes.setConstant(1.25);
  spheres.body2.position << 0.3, 0.4, 1.2;  // 1.3 apart
  EXPECT_TRUE(is_in(lowest_overlap_of_spheres<I>(enclose<I>(spheres)),
                    Real50(1.25) + 1 - spheres.body2.position.cast<Real50>().norm()));
}

}  // namespace
}  // namespace plumb::reference::meridian_tests
