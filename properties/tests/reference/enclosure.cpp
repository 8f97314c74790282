// A pair's enclosure and its support functions over boxes, against points of the boxes in 50 digits.
#include "solver/reference/interval/enclosure.hpp"

#include <gtest/gtest.h>

#include "properties/tests/reference/inside.hpp"
#include "solver/pose.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb::reference::enclosure_tests {
namespace {

using namespace inside_tests;
using Fine = Real50;

template <class I>
class Enclosure : public testing::Test {
 public:
  /// The relative width of a number that a few operations made.
  static double rounding() {
    if constexpr (std::is_same_v<I, DoubleInterval>) return 1e-14;
    if constexpr (std::is_same_v<I, Interval80>) return 1e-76;
    return 1e-17;
  }
};
using Kinds = testing::Types<DoubleInterval, Interval18, Interval19, Interval80>;
TYPED_TEST_SUITE(Enclosure, Kinds);

TYPED_TEST(Enclosure, OfAPairHoldsThePlacedPair) {
  for (std::uint64_t draw = 0; draw < 60; ++draw) {
    Stream stream("pairs", 1, draw);
    Pair pair = draw_pair(stream);
    const double unit = stream.log_uniform(1e-6, 1e6);
    for (Body* body : {&pair.body1, &pair.body2}) {
      body->shape.semi_axes *= unit;
      body->position *= unit;
      for (double& q : body->quaternion) q *= 3.7;
    }
    const EnclosedPair<TypeParam> found = enclose<TypeParam>(pair);
    const PlacedPair<Fine> placed = place<Fine>(pair);
    EXPECT_EQ(found.exponent, placed.exponent);
    EXPECT_TRUE(are_in(found.centre, placed.body2.centre)) << draw;
    const auto expect_body = [&](const EnclosedBody<TypeParam>& body, const PlacedBody<Fine>& truth) {
      EXPECT_TRUE(are_in(body.semi_axes, truth.shape.semi_axes)) << draw;
      EXPECT_TRUE(are_in(body.rotation, truth.rotation)) << draw;
      EXPECT_LE(widest(body.rotation), this->rounding()) << draw;
      const Fine n1(body.n1), dual = n1 / (n1 - 1);
      EXPECT_TRUE(is_in(body.m1.m, dual) && is_in(body.m1.minus_one, Fine(dual - 1))) << draw;
      EXPECT_TRUE(is_in(body.m1.minus_two, Fine(dual - 2))) << draw;
    };
    expect_body(found.body1, placed.body1);
    expect_body(found.body2, placed.body2);
  }
}

/// Boxes of q = (a ux, b uy, c uz) from points to ones that hold zeros, at flats and edges as anywhere.
TYPED_TEST(Enclosure, OfASupportHoldsItAllOverTheBox) {
  int finite = 0;
  for (std::uint64_t draw = 0; draw < 80; ++draw) {
    Stream stream("supports", 1, draw);
    const Pair pair = draw_pair(stream);
    const EnclosedBody<TypeParam> body = enclose<TypeParam>(pair).body1;
    const Superellipsoid<Fine> shape = place<Fine>(pair).body1.shape;
    const Vec3<double> q = generators::draw_direction(stream);
    Vec3<double> half;
    for (double& h : half) h = stream.chance(0.2) ? 0 : stream.log_uniform(1e-12, 0.3);
    const IVec3<TypeParam> box = box_about<TypeParam>(q, half);
    const SupportEnclosure<TypeParam> found = support<TypeParam>(body, box);
    const TypeParam value = support_value<TypeParam>(body, box);
    for (int k = 0; k < 8; ++k) {
      const Vec3<Fine> there = draw_in_box(q, half, stream);
      const NormValue<Fine> truth = support_point<Fine>(shape, there.cwiseQuotient(shape.semi_axes));
      EXPECT_TRUE(is_in(found.value, truth.value)) << draw << ' ' << there.transpose();
      EXPECT_TRUE(is_in(value, truth.value)) << draw << ' ' << there.transpose();
      EXPECT_TRUE(are_in(found.point, truth.gradient)) << draw << ' ' << there.transpose();
    }
    finite += widest(found.point) < 1 ? 1 : 0;
  }
  EXPECT_GT(finite, 30);  // it says something
}

TYPED_TEST(Enclosure, OfASupportNarrowsWithItsBox) {
  for (std::uint64_t draw = 0; draw < 30; ++draw) {
    Stream stream("narrow", 1, draw);
    const EnclosedBody<TypeParam> body = enclose<TypeParam>(draw_pair(stream)).body1;
    Vec3<double> q;
    for (double& component : q) component = stream.sign() * stream.uniform(0.3, 1);
    for (const double half : {1e-2, 1e-4, 1e-6, 0.0}) {
      const SupportEnclosure<TypeParam> found =
          support<TypeParam>(body, box_about<TypeParam>(q, Vec3<double>::Constant(half)));
      const double allowed = 400 * half + 1e3 * this->rounding();  // an exponent of 1.1 has a curvature of 10
      EXPECT_LE(width(found.value), allowed) << draw << ' ' << half;
      EXPECT_LE(widest(found.point), allowed) << draw << ' ' << half;
    }
  }
}

/// No point outside is said to lie inside; of those inside none but within rounding of the surface is missed.
TYPED_TEST(Enclosure, OnlyPointsOfABodyLieInIt) {
  int inside = 0, outside = 0;
  for (std::uint64_t draw = 0; draw < 400; ++draw) {
    Stream stream("points", 1, draw);
    const Pair pair = draw_pair(stream);
    const EnclosedBody<TypeParam> body = enclose<TypeParam>(pair).body1;
    const Superellipsoid<Fine> shape = place<Fine>(pair).body1.shape;
    const Vec3<double> u = generators::draw_direction(stream);
    const double off = stream.chance(0.5) ? stream.signed_log_uniform(1e-16, 1e-12) : stream.uniform(-0.1, 0.1);
    const Vec3<double> x =
        support_point<double>({shape.semi_axes.cast<double>(), body.n1, body.n2}, u).gradient * (1 + off);
    const Fine gauge_there = gauge<Fine>(shape, x.cast<Fine>());
    const bool says = is_inside<TypeParam>(body, x);
    if (gauge_there > 1) {
      EXPECT_FALSE(says) << draw << ' ' << gauge_there - 1;
    }
    if (gauge_there < 1 - 1e-14) {
      EXPECT_TRUE(says) << draw << ' ' << gauge_there - 1;
    }
    (says ? inside : outside) += 1;
  }
  EXPECT_GT(inside, 100);
  EXPECT_GT(outside, 100);
}

/// y'Hy against the sum of weight (a.y)^2, at points of the box: a lower bound everywhere.
template <class I>
double least_sum(const HessianTerms<I>& terms, const Eigen::Vector2d& y) {
  I out(0.0);
  for (const RankOne<I>& term : terms)
    if (is_positive(term.weight))
      out += term.weight * square<I>(I(term.vector[0] * I(y[0]) + term.vector[1] * I(y[1])));
  return low(out);
}

TYPED_TEST(Enclosure, TermsOfTheHessianAreBelowItAllOverTheBox) {
  int sharp = 0, floors = 0;
  for (std::uint64_t draw = 0; draw < 120; ++draw) {
    Stream stream("terms", 1, draw);
    const Pair pair = draw_pair(stream);
    const EnclosedBody<TypeParam> body = enclose<TypeParam>(pair).body1;
    const Superellipsoid<Fine> shape = place<Fine>(pair).body1.shape;
    const Vec3<double> q = generators::draw_direction(stream);
    Vec3<double> half;
    for (double& h : half) h = stream.chance(0.2) ? 0 : stream.log_uniform(1e-9, 0.2);
    ChartMap<TypeParam> map;
    Eigen::Matrix<Fine, 3, 2> columns;
    for (int i = 0; i < 6; ++i) {
      const double entry = stream.uniform(-1, 1);
      map(i / 2, i % 2) = TypeParam(entry);
      columns(i / 2, i % 2) = Fine(entry);
    }
    const IVec3<TypeParam> box = box_about<TypeParam>(q, half);
    const std::array both{hessian_terms<TypeParam>(body, box, map), hessian_floor<TypeParam>(body, box, map)};
    for (int k = 0; k < 6; ++k) {
      const Vec3<Fine> there = draw_in_box(q, half, stream);
      // By q: of unit semi-axes.
      const Superellipsoid<Fine> unit{Vec3<Fine>::Ones(), shape.n1, shape.n2};
      const Mat3<Fine> hessian = support_hessian<Fine>(unit, there).hessian;
      const Eigen::Vector2d y(stream.uniform(-1, 1), stream.uniform(-1, 1));
      const Vec3<Fine> along = columns * y.cast<Fine>();
      Fine truth(0);
      for (int i = 0; i < 9; ++i)
        if (along[i / 3] != 0 && along[i % 3] != 0) truth += along[i / 3] * hessian(i / 3, i % 3) * along[i % 3];
      if (isnan(truth)) continue;  // infinite entries of either sign: a flat
      const double sharp_sum = least_sum<TypeParam>(both[0], y), floor_sum = least_sum<TypeParam>(both[1], y);
      EXPECT_LE(Fine(sharp_sum), truth * (1 + Fine(1e-13))) << draw << ", q " << there.transpose();
      EXPECT_LE(Fine(floor_sum), truth * (1 + Fine(1e-13))) << draw << ", q " << there.transpose();
      sharp += Fine(sharp_sum) > truth / 2 ? 1 : 0;
      floors += floor_sum > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(sharp, 100);
  EXPECT_GT(floors, 60);
}

}  // namespace
}  // namespace plumb::reference::enclosure_tests
