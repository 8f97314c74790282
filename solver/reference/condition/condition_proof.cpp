#include "solver/reference/condition/condition_proof.hpp"
#include "solver/standard_arithmetic.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace plumb::reference {
namespace {

using I = Interval80;
using Solutions = ByDisturbance<I, 4>;

// G' x = choice b with M = C G': |1 - M| <= q < 1 gives |x - C choice b| <= q / (1 - q) |C choice b|, a column at a time.
Solutions enclosed_solution(const SquareForm& form, const Linearised<I>& by, const I& q) {
  Solutions x = form.inverse * (form.choice * by.change);
  const I growth = high_end<I>(I(q / (I(1.0) - q)));
  for (int j = 0; j < disturbances; ++j) {
    I largest(0.0);
    for (int i = 0; i < 4; ++i) largest += magnitude<I>(x(i, j));
    const I off = growth * high_end<I>(largest);
    for (int i = 0; i < 4; ++i) x(i, j) += hull<I>(I(-off), off);
  }
  return x;
}

/// No entry is infinite or NaN.
bool is_bounded(const Magnitudes<I>& m) {
  const double infinite = std::numeric_limits<double>::infinity();
  for (const I* x : {&m.overlap, &m.normal1, &m.normal2, &m.point1, &m.point2})
    if (!(high(*x) < infinite)) return false;
  return true;
}

IVec3<I> ball(const Vec3<double>& centre, double radius) {
  return enclosed<I>(centre) + IVec3<I>::Constant(hull<I>(-radius, radius));
}

/// A contact point relative to its body's centre.
IVec3<I> reach(const IVec3<I>& point, const Body& body) {
  return point - enclosed<I>(body.position);
}

/// The support functions' share of the overlap's condition: 2 |p x n| by the turn, h by the axes, and at most
/// h log 2 (1 / n1 + 1 / n2) by the exponents.
I support_part(const IVec3<I>& n, const IVec3<I>& p, const Superellipsoid<double>& shape) {
  const I h = dot(n, p);
  const I exponents = log(I(2.0)) * (I(1.0) / I(shape.n1) + I(1.0) / I(shape.n2));
  return I(2.0) * frobenius_norm<I>(cross_product<I>(p, n)) + h * (I(1.0) + hull<I>(I(0.0), exponents));
}

}  // namespace

std::string_view name(ConditionClaim claim) {
  switch (claim) {
    case ConditionClaim::certified: return "certified";
    case ConditionClaim::refuted: return "refuted";
    case ConditionClaim::infinite: return "infinite";
    case ConditionClaim::open: break;
  }
  return "open";
}

ConditionClaim judge(double reported, double lower, double upper) {
  const double factor = 2;
  if (reported == std::numeric_limits<double>::infinity())
    return upper * factor < 1 / machine_epsilon ? ConditionClaim::refuted : ConditionClaim::infinite;
  if (upper <= factor * reported && reported <= factor * lower) return ConditionClaim::certified;
  return lower > factor * reported || reported > factor * upper ? ConditionClaim::refuted : ConditionClaim::open;
}

ConditionClaim certify_overlap_condition(const Pair& pair, const SolutionSet& set, double reported) {
  const StandardArithmetic mode;
  if (!(set.normal_radius < 1) || !std::isfinite(set.points_radius)) return ConditionClaim::open;
  const IVec3<I> n = ball(set.normal, set.normal_radius);
  const I found =
      I(2.0) + (support_part(n, reach(ball(set.point1, set.points_radius), pair.body1), pair.body1.shape) +
                support_part(-n, reach(ball(set.point2, set.points_radius), pair.body2), pair.body2.shape)) /
                   I(size_of(pair));
  return judge(reported, low(found), high(found));
}

ConditionProof certify_condition(const Pair& pair, const ChartPair<Real50>& at, const Condition& reported) {
  const StandardArithmetic mode;
  const EnclosedPair<I> enclosed = enclose<I>(pair);
  const SquareForm form = square_form(place<Real50>(pair), at);
  ConditionProof out;
  const ProvedBox box = prove_solution(enclosed, form, at);
  out.solution = box.proof;
  if (box.proof.exists) {
    const Linearised<I> by = linearised<I>(box.jet, {});
    const Magnitudes<I> found = magnitudes<I>(box.jet, by, enclosed_solution(form, by, box.contraction));
    if (is_bounded(found)) {
      out.lower = {low(found.overlap), std::max(low(found.normal1), low(found.normal2)),
                   std::max(low(found.point1), low(found.point2))};
      out.upper = {high(found.overlap), std::min(high(found.normal1), high(found.normal2)),
                   std::max(high(found.point1), high(found.point2))};
    }
  }
  out.overlap = judge(reported.overlap, out.lower.overlap, out.upper.overlap);
  out.normal = judge(reported.normal, out.lower.normal, out.upper.normal);
  out.points = judge(reported.points, out.lower.points, out.upper.points);
  return out;
}

ConditionProof certify_condition(const Pair& pair, const Solution& found) {
  const StandardArithmetic mode;
  const PlacedPair<Real50> placed = place<Real50>(pair);
  const auto chart = [&](const PlacedBody<Real50>& body, const Vec3<Real50>& point) {
    return chart_of_point<Real50>(body.shape, body.to_body(placed.to_pair_point(point, pair)));
  };
  return certify_condition(pair, {chart(placed.body1, found.point1), chart(placed.body2, found.point2)},
                           found.condition);
}

}  // namespace plumb::reference
