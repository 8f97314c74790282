// The certificate: known answers to the last certified digit.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <optional>

#include "properties/generators/families.hpp"
#include "solver/pose.hpp"
#include "solver/reference/reference.hpp"
#include "solver/shape/superellipsoid.hpp"
#include "solver/shape/tangent.hpp"

namespace plumb {
namespace {

using W = Real100;  // of the closed forms: what is left of them after 50 digits counts as exact

constexpr double last_digit = 1e-40;  // of a well conditioned answer, relative to the size
const W exact("1e-90");

/// A common normal known without the reference; world frame.
struct Truth {
  W overlap;
  Vec3<W> normal, point1, point2;
};

double distance(const Vec3<W>& a, const Vec3<Real50>& b) {
  return static_cast<double>((a - b.cast<W>()).norm());
}

/// What every effort must keep, whatever it proves.
void expect_truth_within(const Reference& found, const Truth& truth, const std::string& what) {
  EXPECT_LE(W(found.overlap.lower), truth.overlap + exact) << what;
  EXPECT_GE(W(found.overlap.upper), truth.overlap - exact) << what;
  const Solution& s = found.common_normal;
  EXPECT_LE(distance(truth.normal, s.normal), s.normal_radius) << what;
  EXPECT_LE(distance(truth.point1, s.point1), s.points_radius) << what;
  EXPECT_LE(distance(truth.point2, s.point2), s.points_radius) << what;
  if (found.verdict != Verdict::undecided) {
    EXPECT_EQ(found.verdict == Verdict::overlapping, truth.overlap > 0) << what;
  }
}

/// At every effort; the certificate in all its digits is returned, and has to have them.
Reference expect_holds(const Pair& pair, const Truth& truth, const std::string& what) {
  for (const Effort effort : {Effort::bounds, Effort::proof})
    expect_truth_within(find_reference(pair, effort), truth, what + ", effort " + std::string(name(effort)));
  std::optional<Reference> cheaper;
  for (const Effort effort : efforts) {
    cheaper = find_reference(pair, effort, cheaper ? &*cheaper : nullptr);
    expect_truth_within(*cheaper, truth, what + ", handed on to " + std::string(name(effort)));
  }
  Reference found = find_reference(pair, Effort::digits);
  expect_truth_within(found, truth, what);
  EXPECT_TRUE(found.common_normal.proved) << what << ": " << found.reason;
  EXPECT_EQ(found.global, Claim::proved) << what;
  EXPECT_NE(found.verdict, Verdict::undecided) << what;
  return found;
}

void expect_sharp(const Reference& found, const Pair& pair, const std::string& what) {
  const double size = size_of(pair) + (pair.body2.position - pair.body1.position).norm();
  EXPECT_LE(static_cast<double>(found.overlap.upper - found.overlap.lower), last_digit * size) << what;
  EXPECT_LE(found.common_normal.normal_radius, last_digit) << what;
  EXPECT_LE(found.common_normal.points_radius, last_digit * (size + pair.body1.position.norm())) << what;
}

/// n a stationary direction of known support points.
Truth truth_of(const Pair& pair, const Vec3<W>& n, const Vec3<W>& offset1, const Vec3<W>& offset2) {
  Truth out{W(0), n, pair.body1.position.cast<W>() + offset1, pair.body2.position.cast<W>() + offset2};
  out.overlap = n.dot(out.point1 - out.point2);
  return out;
}

TEST(Certified, Spheres) {
  for (int i = 0; i < 40; ++i) {
    Pair pair;
    const double step = i, r1 = 1 + std::sin(step), r2 = 1.1 + std::cos(3 * step);
    pair.body1.shape.semi_axes.setConstant(r1);
    pair.body2.shape.semi_axes.setConstant(r2);
    pair.body1.position << std::sin(5 * step), 3 * std::cos(step), -1;
    const Vec3<double> line = Vec3<double>(std::cos(7 * step), std::sin(2 * step), 0.5).normalized();
    pair.body2.position = pair.body1.position + (i % 2 == 0 ? 0.9 : 1.3) * (r1 + r2) * line;
    const Vec3<W> c = pair.body2.position.cast<W>() - pair.body1.position.cast<W>();
    const Vec3<W> n = c / c.norm();
    const std::string what = "spheres " + std::to_string(i);
    const Reference found = expect_holds(pair, truth_of(pair, n, W(r1) * n, -W(r2) * n), what);
    expect_sharp(found, pair, what);
    EXPECT_EQ(found.unique, Claim::proved) << what;
  }
}

/// Bodies whose axes are the world's, on a line along one of them.
Pair on_axis(const Superellipsoid<double>& shape1, const Superellipsoid<double>& shape2, int axis, double distance) {
  Pair pair;
  pair.body1.shape = shape1;
  pair.body2.shape = shape2;
  pair.body1.position << 0.1, -0.7, 0.3;
  pair.body2.position = pair.body1.position;
  pair.body2.position[axis] += distance;
  return pair;
}

Truth truth_on_axis(const Pair& pair, int axis) {
  const Vec3<W> n = Vec3<W>::Unit(axis);
  return truth_of(pair, n, n * W(pair.body1.shape.semi_axes[axis]), -n * W(pair.body2.shape.semi_axes[axis]));
}

TEST(Certified, EllipsoidsOnAnAxis) {
  const Superellipsoid<double> shape1{{1.1, 0.7, 1.3}, 2, 2}, shape2{{0.6, 0.9, 0.8}, 2, 2};
  for (int axis = 0; axis < 3; ++axis)
    for (const double share : {0.97, 1.4}) {
      const Pair pair = on_axis(shape1, shape2, axis, share * (shape1.semi_axes[axis] + shape2.semi_axes[axis]));
      const std::string what = "axis " + std::to_string(axis) + " at " + std::to_string(share);
      expect_sharp(expect_holds(pair, truth_on_axis(pair, axis), what), pair, what);
    }
}

/// Flat on flat: the overlap and the normal have all their digits, the points are as vague as the faces are flat.
TEST(Certified, ParallelFaces) {
  for (const double n : {4.0, 6.0, 10.5, 20.0, 40.0})
    for (int axis = 0; axis < 3; ++axis)
      for (const double share : {0.97, 1.4}) {
        const Superellipsoid<double> shape1{{1.1, 0.7, 1.3}, n, n}, shape2{{0.6, 0.9, 0.8}, n, 4};
        const Pair pair = on_axis(shape1, shape2, axis, share * (shape1.semi_axes[axis] + shape2.semi_axes[axis]));
        const std::string what =
            "exponent " + std::to_string(n) + " axis " + std::to_string(axis) + " at " + std::to_string(share);
        const Reference found = expect_holds(pair, truth_on_axis(pair, axis), what);
        EXPECT_LE(found.common_normal.normal_radius, last_digit) << what;
      }
}

/// An ellipsoid whose support point at v (body axes) is alpha^2 v without rounding: semi-axes |alpha v| alpha, where
/// alpha v is a whole vector of whole length.
Superellipsoid<double> with_exact_support(const Vec3<double>& alpha, const Vec3<double>& v) {
  return {alpha * std::round(alpha.cwiseProduct(v).norm()), 2, 2};
}

/// Every number of these pairs is exact: v = (1, 2, 2) 5, |v| = 15; body 2 turned about x by the angle of 3, 4, 5.
TEST(Certified, ExactContacts) {
  const Vec3<double> v(10, -5, 10), alpha1(1, 6, 4.5), alpha2(3, 2, 1.5);
  for (const double depth : {1.0 / 64, -2.0}) {
    Pair pair;
    const Vec3<double> in_body2(10, 5, 10);  // R' v
    pair.body2.quaternion = {2, 1, 0, 0};
    pair.body1.shape = with_exact_support(alpha1, v);
    pair.body2.shape = with_exact_support(alpha2, in_body2);
    const Vec3<double> own = alpha2.cwiseAbs2().cwiseProduct(in_body2);
    const Vec3<double> offset1 = alpha1.cwiseAbs2().cwiseProduct(v);
    const Vec3<double> offset2 = -Vec3<double>(own[0], (3 * own[1] - 4 * own[2]) / 5, (4 * own[1] + 3 * own[2]) / 5);
    pair.body1.position << 3, 0.25, -7;
    pair.body2.position = pair.body1.position + offset1 - offset2 - depth * v;
    const Vec3<W> n = v.cast<W>() / W(15);
    const Truth truth = truth_of(pair, n, offset1.cast<W>(), offset2.cast<W>());
    ASSERT_LT(abs(truth.overlap - W(15 * depth)), exact);
    const std::string what = "depth " + std::to_string(depth);
    expect_sharp(expect_holds(pair, truth, what), pair, what);
  }
}

/// The two support points at n, in the pair's frame, and M = E'(H1 + H2)E - o.
struct AtDirection {
  Vec3<W> point1, point2;
  Tangent<W> basis;
  Eigen::Matrix<W, 2, 2> m;
};

AtDirection at_direction(const PlacedPair<W>& pair, const Vec3<W>& n) {
  const auto h1 = support_hessian<W>(pair.body1.shape, pair.body1.to_body_direction(n));
  const auto h2 = support_hessian<W>(pair.body2.shape, pair.body2.to_body_direction(-n));
  AtDirection out{pair.body1.to_pair(h1.gradient), pair.body2.to_pair(h2.gradient), tangent_basis<W>(n), {}};
  const Mat3<W>&r1 = pair.body1.rotation, &r2 = pair.body2.rotation;
  const Mat3<W> sum = r1 * h1.hessian * r1.transpose() + r2 * h2.hessian * r2.transpose();
  out.m = out.basis.transpose() * sum * out.basis;
  out.m.diagonal().array() -= n.dot(out.point1 - out.point2);
  return out;
}

/// Body 2 placed so that n is a common normal with the given overlap, but for the rounding of its position to doubles;
/// from n the stationary direction of the rounded pair is a few Newton steps in 100 digits away. Empty when it is not.
std::optional<Truth> build_backwards(Pair& pair, const Vec3<double>& direction, double overlap) {
  pair.body2.position = pair.body1.position;
  Vec3<W> n = direction.cast<W>() / direction.cast<W>().norm();
  const PlacedPair<W> concentric = place<W>(pair);
  const AtDirection built = at_direction(concentric, n);
  const Vec3<W> centre = concentric.to_world_point(built.point1 - built.point2, pair) - W(overlap) * n;
  pair.body2.position = centre.cast<double>();
  const PlacedPair<W> placed = place<W>(pair);
  AtDirection at = at_direction(placed, n);
  const auto residual = [&] { return W((at.basis.transpose() * (at.point1 - at.point2)).norm()); };
  for (int i = 0; i < 8 && residual() > W("1e-95"); ++i) {
    n -= at.basis * (at.m.inverse() * (at.basis.transpose() * (at.point1 - at.point2)));
    n /= n.norm();
    at = at_direction(placed, n);
  }
  if (!(residual() < W("1e-92"))) return {};
  return truth_of(pair, n, placed.to_world_point(at.point1, pair) - pair.body1.position.cast<W>(),
                  placed.to_world_point(at.point2, pair) - pair.body2.position.cast<W>());
}

Case regression(const std::string& file) {
  const std::string path = PLUMB_SOURCE_DIR "/corpus/cases/regressions/" + file;
  const std::optional<Case> c = CaseReader(path).next();
  if (!c) throw InputFailure(path, 0, "", "holds no case");
  return *c;
}

/// A normal that is known to be the higher of two is not handed out as the lowest, whichever can be located.
void expect_lowest(const Case& c) {
  const Reference found = find_reference(c.pair);
  const Solution& best = found.common_normal;
  if (best.solved) {
    EXPECT_LE(best.overlap, found.overlap.upper + size_of(c.pair) * Real50("1e-45")) << c.name;
  }
  const bool is_proved = found.unique == Claim::proved && found.global == Claim::proved && best.proved;
  EXPECT_EQ(is_proved, found.reason.empty()) << c.name << ": " << found.reason;
}

TEST(Certified, OfTwoThatNearlyTieTheLowerOne) {
  expect_lowest(regression("nearly-tied-flats.json"));
  for (std::uint64_t i = 0; i < 8; ++i) expect_lowest(generate_hard("tie", 3, i));
}

/// Two minima that no double tells apart: the lower one bounds the overlap, in any number of digits.
TEST(Certified, BoundsDoNotCross) {
  const Case c = regression("nearly-concentric-bounds-crossed.json");
  for (const Effort effort : efforts) {
    const Reference found = find_reference(c.pair, effort);
    EXPECT_LE(found.overlap.lower, found.overlap.upper) << name(effort);
    EXPECT_EQ(found.global, Claim::proved) << name(effort);
  }
}

/// Exponents of 50, edge across edge, an overlap of 1e-14: directions alone leave the verdict open.
TEST(Certified, CrossedEdgesThatHardlyOverlapAreDecided) {
  const Reference found = find_reference(regression("crossed-edges-undecided.json").pair);
  EXPECT_EQ(found.verdict, Verdict::overlapping);
  EXPECT_EQ(found.global, Claim::proved);
  EXPECT_LT(found.overlap.upper - found.overlap.lower, Real50(1e-40));
}

TEST(Certified, ContactsBuiltBackwards) {
  int sharp = 0;
  for (const std::string_view family : {"spheroid", "ellipsoid", "superquadric"})
    for (std::uint64_t i = 0; i < 40; ++i) {
      Case c = generate(family, 31, i);
      const double least = std::min(c.pair.body1.shape.semi_axes.minCoeff(), c.pair.body2.shape.semi_axes.minCoeff());
      const double step = static_cast<double>(i);
      const Vec3<double> direction(std::sin(step + 1), std::cos(2 * step), 0.3);
      const auto truth = build_backwards(c.pair, direction, i % 2 == 0 ? 1e-4 * least : -0.3 * least);
      if (!truth) {
        ADD_FAILURE() << c.name << ": no known answer";
        continue;
      }
      const Reference found = expect_holds(c.pair, *truth, c.name);
      sharp += found.common_normal.points_radius < last_digit * size_of(c.pair);
    }
  EXPECT_GE(sharp, 114);  // the others have exponents of which a normal fixes no point
}

/// A pair of that family whose bounds close a cover about one region.
std::optional<Reference> closed_cover(const Pair& pair) {
  Reference found = find_reference(pair, Effort::bounds);
  const auto is_closed = [](reference::Leaf leaf) {
    return leaf != reference::Leaf::open && leaf != reference::Leaf::bounded;
  };
  const auto& tree = found.cover.tree;
  if (found.cover.regions.size() != 1 || !std::all_of(tree.begin(), tree.end(), is_closed)) return std::nullopt;
  return found;
}

TEST(HandedOn, AClosedCoverIsTakenOverAndNoOther) {
  int closed = 0;
  for (std::uint64_t index = 0; index < 20; ++index) {
    const Pair pair = generate("superquadric", 1, index).pair;
    std::optional<Reference> cheaper = closed_cover(pair);
    if (!cheaper) continue;
    ++closed;
    const int marked = 1 << 20;  // cells that no search of its own looks at
    cheaper->cells = marked;
    const Reference fresh = find_reference(pair, Effort::proof), taken = find_reference(pair, Effort::proof, &*cheaper);
    EXPECT_EQ(taken.cells, marked);
    EXPECT_EQ(taken.global, fresh.global);
    EXPECT_EQ(taken.unique, fresh.unique);
    EXPECT_EQ(taken.common_normal.overlap, fresh.common_normal.overlap);
    EXPECT_LE(taken.overlap.lower, fresh.overlap.upper);
    EXPECT_GE(taken.overlap.upper, fresh.overlap.lower);

    Reference lower = *cheaper;
    lower.overlap.upper -= Real50(size_of(pair)) * Real50(1e-9);
    EXPECT_NE(find_reference(pair, Effort::proof, &lower).cells, marked) << "excluded above a lower level only";
    Reference beside = *cheaper;
    beside.cover.regions.front().u += 2 * beside.cover.regions.front().half;
    EXPECT_NE(find_reference(pair, Effort::proof, &beside).cells, marked) << "a region that holds another minimum";
    Reference open = *cheaper;
    open.cover.tree.back() = reference::Leaf::open;
    EXPECT_NE(find_reference(pair, Effort::proof, &open).cells, marked) << "a leaf that is open";
  }
  EXPECT_GT(closed, 5);
}

}  // namespace
}  // namespace plumb
