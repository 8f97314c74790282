// What the verifier of a cover is made of, each against brute force: the bounds of leaves, the curvature of regions, what
// follows from both for a solution.
#include "solver/reference/proof/verify.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "properties/tests/reference/inside.hpp"
#include "solver/pose.hpp"
#include "solver/reference/frame.hpp"
#include "solver/reference/reference.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb::reference::verify_tests {
namespace {

using namespace inside_tests;
using Fine = Real50;
using I = Interval80;

/// Their longest semi-axis 1, the centres up to so far apart.
Pair draw_pair_within(Stream& stream, double most_exponent, double most_apart) {
  const auto shape = [&] {
    Superellipsoid<double> out = random_superellipsoid(stream, 3, 1.4, most_exponent);
    out.semi_axes /= out.semi_axes.maxCoeff();
    return out;
  };
  return {{shape(), Vec3<double>::Zero(), random_rotation(stream)},
          {shape(), random_direction(stream) * stream.uniform(0, most_apart), random_rotation(stream)}};
}

/// Deep in each other.
Pair draw_deep_pair(Stream& stream, double most_exponent) {
  return draw_pair_within(stream, most_exponent, 0.4);
}

/// o, and s = o |F v|, in 50 digits.
struct Truth {
  PlacedPair<Fine> placed;
  Mat3<Fine> frame;

  Truth(const Pair& pair, const Mat3<double>& f) : placed(place<Fine>(pair)), frame(f.cast<Fine>()) {}

  [[nodiscard]] Fine stretched(const Vec3<Fine>& v) const {
    const Vec3<Fine> d = frame * v;
    return support<Fine>(placed.body1.shape, placed.body1.to_body_direction(d)) +
           support<Fine>(placed.body2.shape, placed.body2.to_body_direction(-d)) - d.dot(placed.body2.centre);
  }
  [[nodiscard]] Fine overlap(const Vec3<Fine>& v) const { return stretched(v) / (frame * v).norm(); }

  /// Of s - level |F v| by the two coordinates of a face.
  [[nodiscard]] Eigen::Matrix<Fine, 2, 2> hessian(const Vec3<Fine>& v, int axis, const Fine& level) const {
    const Vec3<Fine> d = frame * v;
    Mat3<Fine> all = Mat3<Fine>::Zero();
    for (const PlacedBody<Fine>* body : {&placed.body1, &placed.body2})
      all += body->rotation * support_hessian<Fine>(body->shape, body->to_body_direction(d)).hessian *
             body->rotation.transpose();
    const Fine length = d.norm();
    all -= (Mat3<Fine>::Identity() - d * d.transpose() / (length * length)) * (level / length);
    Eigen::Matrix<Fine, 3, 2> columns;
    columns << frame.col((axis + 1) % 3), frame.col((axis + 2) % 3);
    return columns.transpose() * all * columns;
  }
};

Fine least_eigenvalue(const Eigen::Matrix<Fine, 2, 2>& m) {
  const Fine half = (m(0, 0) - m(1, 1)) / 2;
  return (m(0, 0) + m(1, 1)) / 2 - sqrt(Fine(half * half + m(0, 1) * m(0, 1)));
}

Cell draw_region(Stream& stream, double least, double most) {
  return {static_cast<int>(stream.below(3)), stream.sign(), stream.uniform(-0.9, 0.9), stream.uniform(-0.9, 0.9),
          stream.log_uniform(least, most)};
}

Vec3<Fine> draw_in(const Cell& cell, Stream& stream) {
  const auto any = [&] { return stream.chance(0.3) ? stream.sign() : stream.uniform(-1, 1); };
  Vec3<Fine> out;
  out[cell.axis] = cell.sign;
  out[(cell.axis + 1) % 3] = Fine(cell.u) + Fine(any()) * cell.half;
  out[(cell.axis + 2) % 3] = Fine(cell.v) + Fine(any()) * cell.half;
  return out;
}

TEST(Verify, AFramesLengthsAreBetweenItsBounds) {
  Stream stream("frames", 1, 0);
  for (int draw = 0; draw < 100; ++draw) {
    Mat3<double> f = frame_about(random_direction(stream));
    for (int i = 0; i < 9; ++i) f(i / 3, i % 3) += stream.uniform(-1, 1) * (draw % 2 == 0 ? 0 : 0.05);
    const FramedPair<I> framed(enclose<I>(Pair{}), f);
    for (int k = 0; k < 20; ++k) {
      const Vec3<Fine> v = random_direction(stream).cast<Fine>();
      const Fine stretch = (f.cast<Fine>() * v).norm() / v.norm();
      EXPECT_LE(low_as<Fine>(framed.shortest), stretch + Fine("1e-45")) << draw;
      EXPECT_GE(high_as<Fine>(framed.longest), stretch - Fine("1e-45")) << draw;
    }
    EXPECT_GT(low(framed.shortest), draw % 2 == 0 ? 1 - 1e-12 : 0) << draw;
  }
}

TEST(Verify, TheOverlapAndItsSlopesAreThoseOfTheSupportFunctions) {
  for (std::uint64_t draw = 0; draw < 60; ++draw) {
    Stream stream("slopes", 1, draw);
    const Pair pair = draw_deep_pair(stream, 12);
    const Mat3<double> frame = frame_about(random_direction(stream));
    const Truth truth(pair, frame);
    const FramedPair<I> framed(enclose<I>(pair), frame);
    const Cell cell = draw_region(stream, 0.1, 0.2);
    const Vec3<Fine> v = draw_in(cell, stream);
    const OverlapAt<I> found = support_at<I>(framed, enclosed<I>(v));
    EXPECT_TRUE(is_in(overlap_at<I>(framed, enclosed<I>(v)), truth.overlap(v))) << draw;
    EXPECT_TRUE(is_in(found.value, truth.overlap(v))) << draw;
    const Fine level = truth.overlap(v), step("1e-18");
    Fine squares(0);
    for (const int i : {(cell.axis + 1) % 3, (cell.axis + 2) % 3}) {
      const auto lifted = [&](const Fine& by) -> Fine {
        Vec3<Fine> there = v;
        there[i] += by;
        return truth.stretched(there) - level * (truth.frame * there).norm();
      };
      const Fine slope = (lifted(step) - lifted(-step)) / (2 * step);
      EXPECT_LE(abs(Fine(slope - middle<Fine>(found.slope(framed.frame.col(i))))), Fine("1e-24")) << draw;
      squares += slope * slope;
    }
    EXPECT_LE(abs(Fine(high_as<Fine>(slope_at<I>(framed, cell.axis, enclosed<I>(v)).gradient) - sqrt(squares))),
              Fine("1e-23"))
        << draw;
  }
}

/// s - o |F v| has no less curvature anywhere in the region, o the overlap at any point of it.
TEST(Verify, TheCurvatureOfARegionIsALowerBound) {
  int positive = 0, close = 0;
  for (std::uint64_t draw = 0; draw < 80; ++draw) {
    Stream stream("curvature", 1, draw);
    const Pair pair = draw_pair_within(stream, 5, 1.6);
    const Mat3<double> frame = frame_about(random_direction(stream));
    const Truth truth(pair, frame);
    const FramedPair<I> framed(enclose<I>(pair), frame);
    Cell region = draw_region(stream, 1e-6, 0.05);
    for (int k = 0; k < 20; ++k)  // where the overlap is low it is the more often convex
      if (const Cell other = draw_region(stream, region.half, region.half);
          truth.overlap(other.at(0, 0).cast<Fine>()) < truth.overlap(region.at(0, 0).cast<Fine>()))
        region = other;
    const Fine first = low_as<Fine>(curvature_on<I>(framed, region)),
               best = low_as<Fine>(highest_curvature_on<I>(framed, region));
    EXPECT_GE(best, first) << draw;
    positive += first > 0 ? 1 : 0;
    const Fine level = truth.overlap(draw_in(region, stream));
    for (int k = 0; k < 4; ++k) {
      const Fine least = least_eigenvalue(truth.hessian(draw_in(region, stream), region.axis, level));
      EXPECT_LE(best, least) << draw << ", half " << region.half;
      close += best > 0 && best > Fine(0.8) * least ? 1 : 0;
    }
  }
  EXPECT_GT(positive, 30);
  EXPECT_GT(close, 60);
}

/// What follows for a solution that is off: the true one is within the radius, and nowhere in the region is o below the bound.
TEST(Verify, ARegionsSolutionIsWithinItsRadiusAndItsBoundHolds) {
  int located = 0, sharp = 0;
  for (std::uint64_t draw = 0; draw < 24; ++draw) {
    Stream stream("regions", 1, draw);
    const Pair pair = draw_pair_within(stream, 4, 1);
    const Reference reference = find_reference(pair);
    if (!reference.common_normal.proved) continue;
    const Mat3<double> frame = frame_about(random_direction(stream));
    const Truth truth(pair, frame);
    const FramedPair<I> framed(enclose<I>(pair), frame);
    Vec3<Fine> v = in_frame<Fine>(frame, reference.common_normal.normal);
    int axis = 0;
    v.cast<double>().cwiseAbs().maxCoeff(&axis);
    v /= Fine(abs(v[axis]));
    const double off = stream.log_uniform(1e-9, 1e-4);
    Cell region{axis, v[axis] > 0 ? 1.0 : -1.0, static_cast<double>(v[(axis + 1) % 3]),
                static_cast<double>(v[(axis + 2) % 3]), 64 * off};
    Vec3<Fine> moved = v;
    moved[axis] = region.sign;
    moved[(axis + 1) % 3] += off;
    moved[(axis + 2) % 3] -= off / 2;
    const RegionProof<I> proof = verify_region<I>(framed, region, enclosed<I>(moved));
    if (!proof.convex) continue;
    located += proof.located ? 1 : 0;
    if (proof.located) {
      EXPECT_GE(high_as<Fine>(proof.radius), (moved - v).norm()) << draw;
    }
    const Fine least = low_as<Fine>(I(proof.value - proof.deficit));
    for (int k = 0; k < 20; ++k) EXPECT_LE(least, truth.overlap(draw_in(region, stream))) << draw;
    EXPECT_LE(least, truth.overlap(v)) << draw;
    sharp += least >= truth.overlap(v) - Fine(1e3 * off * off) ? 1 : 0;
    // Where the region does not hold the true one that is not said.
    Cell beside = region;
    beside.half = off / 4;
    beside.u = static_cast<double>(moved[(axis + 1) % 3]);
    beside.v = static_cast<double>(moved[(axis + 2) % 3]);
    EXPECT_FALSE(verify_region<I>(framed, beside, enclosed<I>(moved)).located) << draw;
  }
  EXPECT_GT(located, 8);
  EXPECT_GT(sharp, 4);
}

/// Every face in 4^depth leaves of one kind, each with the support points at its middle for a witness.
Cover even_cover(const Pair& pair, const Mat3<double>& frame, int depth, Leaf kind) {
  const PlacedPair<double> placed = place<double>(pair);
  Cover out;
  out.frame = frame;
  const auto point = [](const PlacedBody<double>& body, const Vec3<double>& n) -> Vec3<double> {
    return support_point<double>(body.shape, body.to_body_direction(n)).gradient * (1 - 1e-13);
  };
  const auto walk = [&](const auto& self, const Cell& cell, int left) -> void {
    if (left > 0) {
      out.tree.push_back(Leaf::split);
      for (int k = 0; k < 4; ++k) self(self, cell.quarter(k), left - 1);
      return;
    }
    const Vec3<double> n = (frame * cell.at(0, 0)).normalized();
    out.tree.push_back(kind);
    out.witnesses.push_back({point(placed.body1, n), point(placed.body2, -n)});
  };
  for (int face = 0; face < 6; ++face) walk(walk, face_of_cube(face), depth);
  return out;
}

double lowest_of_many(const Pair& pair, Stream& stream) {
  const PlacedPair<double> placed = place<double>(pair);
  double out = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 8000; ++k) {
    const Vec3<double> n = random_direction(stream);
    out = std::min(out, support<double>(placed.body1.shape, placed.body1.to_body_direction(n)) +
                            support<double>(placed.body2.shape, placed.body2.to_body_direction(-n)) -
                            n.dot(placed.body2.centre));
  }
  return out;
}

/// The bound of open leaves, and the highest level that excluded ones stand, below the overlap of all directions.
TEST(Verify, ACoversLeavesBoundEveryDirection) {
  for (std::uint64_t draw = 0; draw < 4; ++draw) {
    Stream stream("leaves", 1, draw);
    const Pair pair = draw_deep_pair(stream, 8);
    const Mat3<double> frame = frame_about(random_direction(stream));
    const FramedPair<Interval18> framed(enclose<Interval18>(pair), frame);
    const double lowest = lowest_of_many(pair, stream);
    const CoverProof open = verify_cover<Interval18>(framed, even_cover(pair, frame, 3, Leaf::open), 0);
    ASSERT_TRUE(open.well_formed) << draw;
    EXPECT_LE(open.least_open, lowest) << draw;
    EXPECT_GE(open.least_open, 0.5 * lowest) << draw;
    const Cover excluding = even_cover(pair, frame, 3, Leaf::excluded);
    const auto stands = [&](double level) {
      const CoverProof proof = verify_cover<Interval18>(framed, excluding, level);
      return proof.well_formed && proof.excluded;
    };
    double stood = 0, fell = 4;
    ASSERT_TRUE(stands(0)) << draw;
    for (int k = 0; k < 12; ++k) (stands((stood + fell) / 2) ? stood : fell) = (stood + fell) / 2;
    EXPECT_LE(stood, lowest) << draw;
    // Both are least at a corner of the same leaf.
    EXPECT_NEAR(stood, open.least_open, 2e-3) << draw;
  }
}

TEST(Verify, NoTwoPointsOfBodiesApartAreNearer) {
  int bounded = 0;
  for (std::uint64_t draw = 0; draw < 60; ++draw) {
    Stream stream("apart", 1, draw);
    Pair pair = draw_deep_pair(stream, 8);
    pair.body2.position = random_direction(stream) * 3;
    const EnclosedPair<I> enclosed_pair = enclose<I>(pair);
    const auto inner = [&](const Superellipsoid<double>& shape) -> Vec3<double> {
      return support_point<double>(shape, random_direction(stream)).gradient * stream.uniform(0, 1 - 1e-12);
    };
    const Witness witness{inner(pair.body1.shape), inner(pair.body2.shape)};
    const auto least = least_overlap_apart<I>(enclosed_pair, witness);
    const auto apart = points_apart<I>(enclosed_pair, witness);
    if (!least || !apart) FAIL() << draw;
    const PlacedPair<double> placed = place<double>(pair);
    const Vec3<double> between = placed.body1.to_pair(witness.point1) - placed.body2.to_pair(witness.point2);
    EXPECT_NEAR(high(*least), -between.norm(), 1e-14) << draw;
    EXPECT_LE((between.cast<Fine>() -
               Vec3<Fine>(middle<Fine>((*apart)[0]), middle<Fine>((*apart)[1]), middle<Fine>((*apart)[2])))
                  .norm(),
              Fine(1e-14))
        << draw;
    for (const double factor : {1.0001 / (1 - 1e-12), 3.0}) {
      const Vec3<double> out = support_point<double>(pair.body1.shape, random_direction(stream)).gradient * factor;
      EXPECT_FALSE(least_overlap_apart<I>(enclosed_pair, {out, witness.point2})) << draw;
    }
    ++bounded;
  }
  EXPECT_EQ(bounded, 60);
}

TEST(Verify, ABoxOfDirectionsHoldsItsNormalsAndPoints) {
  int narrow = 0;
  for (std::uint64_t draw = 0; draw < 80; ++draw) {
    Stream stream("directions", 1, draw);
    const Pair pair = draw_deep_pair(stream, 12);
    const Mat3<double> frame = frame_about(random_direction(stream));
    const Truth truth(pair, frame);
    const Cell cell = draw_region(stream, 1e-9, 0.1);
    const DirectionEnclosure<I> found =
        enclose_direction<I>(FramedPair<I>(enclose<I>(pair), frame), box_of<I>(cell, cell.half));
    for (int k = 0; k < 4; ++k) {
      const Vec3<Fine> d = truth.frame * draw_in(cell, stream);
      const auto point = [](const PlacedBody<Fine>& body, const Vec3<Fine>& u) -> Vec3<Fine> {
        return body.to_pair(support_point<Fine>(body.shape, body.to_body_direction(u)).gradient);
      };
      EXPECT_TRUE(are_in(found.normal, Vec3<Fine>(d.normalized()))) << draw;
      EXPECT_TRUE(are_in(found.point1, point(truth.placed.body1, d))) << draw;
      EXPECT_TRUE(are_in(found.point2, point(truth.placed.body2, -d))) << draw;
    }
    narrow += widest(found.point1) < 0.1 ? 1 : 0;
  }
  EXPECT_GT(narrow, 30);
}

}  // namespace
}  // namespace plumb::reference::verify_tests
