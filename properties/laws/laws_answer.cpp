#include "properties/laws/laws_answer.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "properties/laws/allowance.hpp"
#include "properties/laws/seen_point.hpp"

namespace plumb::law {
namespace {

std::string opposition_text(const SeenPoint& at1, const SeenPoint& at2) {
  const auto angle = static_cast<double>(std::atan2(at1.normal.cross(at2.normal).norm(), -at1.normal.dot(at2.normal)));
  return "n1 + n2 is not 0: the normals at the points are " + in_degrees(angle) + " from opposite";
}

/// How far a point is from the line between two others.
double off_segment(const Vec3<Wide>& point, const Vec3<Wide>& from, const Vec3<Wide>& to) {
  const Vec3<Wide> d = to - from, reached = point - from;
  const Wide square = d.squaredNorm(), share = square > 0 ? std::clamp<Wide>(reached.dot(d) / square, 0, 1) : 0;
  return static_cast<double>((reached - share * d).stableNorm());
}

/// A point that slides along its surface stays on it: what takes it off is no more than an overlap may be off.
double surface_slack(const Evidence& e) {
  return std::max(overlap_slack(e), e.accuracy.points.value_or(0) * size_of(e.pair));
}

SeenPair both_points(const Evidence& e) {
  return e.seen ? e.seen() : see_both(e.pair, e.answer);
}

/// |d x n1| against its rounding and a slack (rad), and the sign of d.n1 once |d| is above it.
double collinearity_severity(const Evidence& e, const SeenPair& s, double slack = 0) {
  const double distance = static_cast<double>(s.d.norm());
  const double allowed = 2 * point_rounding(e.pair) + distance * (normal_rounding(s.at1) + slack);
  const double across = static_cast<double>(s.d.cross(s.at1.normal).norm());
  const bool wrong_side = static_cast<double>(s.d.dot(s.at1.normal)) * e.answer.overlap > 0;
  return wrong_side && distance > allowed ? wrong_altogether : severity_of(across, allowed);
}

bool shows_surfaces(const Evidence& e) {
  return has_points(e) && resolves_surfaces(e.pair);
}

bool has_infinity(const Vec3<double>& v) {
  return (v.array().abs() == HUGE_VAL).any();
}

bool has_all_solutions(const Evidence& e) {
  return e.problem == Problem::common_normal && e.reference.effort == Effort::digits && e.all_solutions;
}

/// Whether the certified set of solutions takes the place of a condition number, or of a solution that may not be the only one.
bool asks_for_all_solutions(const Evidence& e, double condition) {
  return (std::isinf(condition) || !names_all_lowest(e.reference)) && has_all_solutions(e);
}

/// Whether an answer may lie in the certified set instead of within its condition number.
/// corpus/cases/regressions/edge-on-face-apart.json
bool may_be_in_the_set(const Evidence& e, double condition) {
  return reference::is_beyond_first_order(condition) && has_all_solutions(e);
}

/// What inputs within rounding do to the answer: more than the condition number says where that has no range worth the name.
/// corpus/cases/regressions/point-in-a-corner.json
reference::NearbyAnswers nearby_of(const Evidence& e, const Solution& truth) {
  if (&truth != &e.own || e.reference.effort != Effort::digits || !e.nearby || !truth.solved) return {};
  return e.nearby();
}

/// The set itself where a ball is a poor likeness of it: ties, rings. It holds normals that are a root of epsilon off, which
/// only an answer's points show.
double normal_severity_in_set(const Evidence& e) {
  const reference::SolutionSet& all = e.all_solutions();
  if (reference::may_be_lowest(e.pair, all, e.answer.normal)) return 0;
  const double angle = angle_between(e.answer.normal.cast<Real50>(), all.normal.cast<Real50>());
  const double severity = severity_of(angle, all.normal_radius + few + e.accuracy.normal);
  const double beyond_the_set = 2;
  return e.accuracy.normal > 0 ? severity : std::max(beyond_the_set, severity);
}

/// Of the distance between two points that may each slide along its surface: to second order, and what is asked of each.
double lengthwise_slack(const Evidence& e, const Condition& condition) {
  const double sliding = points_slack(e, condition) / size_of(e.pair);
  return 2 * overlap_slack(e) + (sliding * sliding + 2 * e.accuracy.points.value_or(0)) * size_of(e.pair);
}

/// Of points: in the balls, and no further apart than an overlap in the set says: the ball of a ring holds much else.
double points_severity_in_set(const Evidence& e) {
  const reference::SolutionSet& all = e.all_solutions();
  if (std::isinf(all.points_radius)) return 0;
  const double off = std::max((e.answer.point1 - all.point1).stableNorm(), (e.answer.point2 - all.point2).stableNorm());
  const double apart = (e.answer.point1 - e.answer.point2).stableNorm();
  const double uneven = std::abs(apart - std::abs(static_cast<double>(e.own.overlap)));
  return std::max(severity_of(off, all.points_radius + point_rounding(e.pair) + points_slack(e, e.own.condition)),
                  severity_of(uneven, 2 * all.delta + width_of(e.reference.overlap) + 2 * point_rounding(e.pair) +
                                          lengthwise_slack(e, e.own.condition)));
}

/// How far an overlap is from the lowest, as far as that is known.
double overlap_error(const Evidence& e, double overlap) {
  const Real50 said(overlap);
  if (e.own.solved && (e.problem != Problem::common_normal || names_all_lowest(e.reference)))
    return static_cast<double>(abs(Real50(said - nearest(e).overlap)));
  const Bounds& lowest = e.reference.overlap;
  if (said > lowest.upper) return static_cast<double>(Real50(said - lowest.upper));
  return said < lowest.lower ? static_cast<double>(Real50(lowest.lower - said)) : 0;
}

/// Of the two points from an answer's, or of what is between them from its contact point.
double distance_to(const Evidence& e, const Solution& other) {
  if (!has_points(e))
    return off_segment(e.answer.contact_point.cast<Wide>(), other.point1.cast<Wide>(), other.point2.cast<Wide>());
  return static_cast<double>((e.answer.point1.cast<Real50>() - other.point1).norm() +
                             (e.answer.point2.cast<Real50>() - other.point2).norm());
}

}  // namespace

const Solution& nearest(const Evidence& e) {
  const bool has_normal = e.answer.normal.allFinite();
  const bool has_place = has_points(e) || e.answer.contact_point.allFinite();
  if (e.problem != Problem::common_normal || (!has_normal && !has_place)) return e.own;
  const Vec3<Real50> n = e.answer.normal.cast<Real50>();
  const auto is_nearer = [&](const Solution& a, const Solution& b) {
    return has_normal ? n.dot(a.normal) > n.dot(b.normal) : distance_to(e, a) < distance_to(e, b);
  };
  const Solution* best = &e.own;
  for (const auto* others : {&e.reference.tied, &e.reference.close})
    for (const Solution& other : *others)
      if (ties(e, other) && is_nearer(other, *best)) best = &other;
  return *best;
}

bool has_points(const Evidence& e) {
  return e.answer.point1.allFinite() && e.answer.point2.allFinite();
}

bool is_whole(const Contact<double>& answer) {
  return std::isfinite(answer.overlap) && answer.normal.allFinite() && answer.point1.allFinite() &&
         answer.point2.allFinite();
}

// Somebody's answer may leave fields out; a solver that is asked for all of them may not, unless there is nothing to find.
Finding answers_are_finite(const Evidence& e) {
  const Contact<double>& a = e.answer;
  const bool infinite = std::isinf(a.overlap) || has_infinity(a.normal) || has_infinity(a.point1) ||
                        has_infinity(a.point2) || has_infinity(a.contact_point);
  const bool is_all_there = e.claims == nullptr ? is_whole(a) : e.claims->is_whole(a);
  const bool missing = a.status == Status::converged && e.own.solved && e.solve && !is_all_there;
  if (a.status == Status::not_finite) return {FindingKind::not_finite, wrong_altogether, {}, "status not_finite"};
  if (infinite || missing) return {FindingKind::not_finite, wrong_altogether, {}, "a NaN or an infinity in the answer"};
  return {};
}

Finding converges(const Evidence& e) {
  if (e.answer.status == Status::converged) return {};
  return {FindingKind::nonconverged, wrong_altogether, {}, fmt::format("status {}", name(e.answer.status))};
}

Finding verdict_is_right(const Evidence& e) {
  const Solution& found = e.reference.common_normal;
  const Real50 nearest_to_zero = e.reference.verdict == Verdict::separated     ? e.reference.overlap.upper
                                 : e.reference.verdict == Verdict::overlapping ? e.reference.overlap.lower
                                                                               : Real50(0);
  const bool is_lowest = found.solved && (names_all_lowest(e.reference) || e.reference.verdict != Verdict::undecided);
  const auto truth = static_cast<double>(is_lowest ? found.overlap : nearest_to_zero);
  // A verdict may be left open within the floor that every method documents (undecided_floor epsilon of the size).
  const double allowed = 2 * few_of(size_of(e.pair) + std::abs(truth)) + overlap_slack(e);
  const Verdict said = e.answer.verdict;
  if (said == Verdict::undecided && std::isnan(e.answer.overlap)) return {};
  const double doubt = is_lowest ? severity_of(width_of(found.bounds), allowed) : 0;
  const auto detail = [&] { return fmt::format("says {}, overlap is {:.17g}", name(said), truth); };
  if (truth < 0 && said == Verdict::overlapping)
    return {FindingKind::false_contact, severity_of(-truth, allowed), {}, detail(), doubt};
  if (truth > 0 && said != Verdict::overlapping)
    return {FindingKind::missed_contact, severity_of(truth, allowed), {}, detail(), doubt};
  return {};
}

namespace {

/// Right or not: to a rounding that has grown much, or to the accuracy that is asked for.
bool is_a_common_normal(const Evidence& e, const SeenPair& s) {
  const double much = 1e3;
  if (std::max(opposition_severity(s.at1, s.at2), collinearity_severity(e, s)) <= much) return true;
  const double slack = e.accuracy.normal;
  return slack > 0 && std::max(opposition_severity(s.at1, s.at2, slack), collinearity_severity(e, s, slack)) <= 1;
}

}  // namespace

Finding has_the_lowest_overlap(const Evidence& e) {
  if (e.problem != Problem::common_normal || !shows_surfaces(e) || std::isnan(e.answer.overlap)) return {};
  const double excess = static_cast<double>(Real50(e.answer.overlap) - e.own.overlap);
  const double allowed = few_of(e.own.condition.overlap * scale_of(e, e.own)) + overlap_slack(e);
  const double severity = severity_of(excess, allowed), doubt = doubt_of(e, width_of(e.own.bounds), allowed);
  if (!(severity + doubt > 1)) return {};
  // Only a common normal can be the wrong one; anything else is misaligned, and the laws after this one say how.
  if (!is_a_common_normal(e, both_points(e))) return {};
  // Where the normal is determined at all, one that is right makes it an error of the overlap alone.
  const Solution& truth = nearest(e);
  const double turned = angle_between(e.answer.normal.cast<Real50>(), truth.normal);
  if (has_definite_normal(truth) && turned <= few * (1 + truth.condition.normal) + e.accuracy.normal) return {};
  return {FindingKind::wrong_branch,
          severity,
          {},
          "another common normal's overlap: " + expected_and_got(static_cast<double>(e.own.overlap), e.answer.overlap),
          doubt};
}

PointFindings points_show(const Evidence& e) {
  if (!shows_surfaces(e)) return {};
  const SeenPair s = both_points(e);
  const double gap = std::max(s.at1.gap, s.at2.gap);
  PointFindings out;
  out.surface = {FindingKind::off_surface,
                 severity_of(gap, point_rounding(e.pair) + surface_slack(e)),
                 {},
                 fmt::format("off the surface by {:.3g}", gap)};
  if (e.problem != Problem::common_normal && e.problem != Problem::first_touch) return out;
  out.opposite = {FindingKind::misaligned, opposition_severity(s.at1, s.at2), {}, opposition_text(s.at1, s.at2)};
  if (e.problem == Problem::first_touch) return out;
  out.collinear = {
      FindingKind::misaligned, collinearity_severity(e, s), {}, "p2 - p1 is not along n1 with the overlap's sign"};
  return out;
}

Finding normals_are_opposite(const Evidence& e) {
  return points_show(e).opposite;
}

Finding points_lie_on_the_normal(const Evidence& e) {
  return points_show(e).collinear;
}

Finding points_are_on_surfaces(const Evidence& e) {
  return points_show(e).surface;
}

/// The points of a first touch lie along the motion: along the normal they are the overlap apart.
Finding agrees_with_itself(const Evidence& e) {
  const Contact<double>& a = e.answer;
  const bool has_normal = a.normal.allFinite(), is_along_motion = e.problem == Problem::first_touch;
  if (!has_points(e) || std::isnan(a.overlap) || (is_along_motion && !has_normal)) return {};
  const Vec3<Wide> n = a.normal.cast<Wide>(), d = a.point1.cast<Wide>() - a.point2.cast<Wide>();
  const auto distance = static_cast<double>(d.stableNorm());
  const double rounding =
      2 * (point_rounding(e.pair) + few_of(std::abs(a.overlap))) + (is_along_motion ? few_of(distance) : 0);
  const double lengthwise = rounding + lengthwise_slack(e, e.own.condition);
  const double allowed = rounding + 2 * points_slack(e, e.own.condition) + e.accuracy.normal * std::abs(a.overlap);
  const double length = is_along_motion ? std::abs(static_cast<double>(n.dot(d) - Wide(a.overlap)))
                                        : std::abs(distance - std::abs(a.overlap));
  const double across =
      has_normal && !is_along_motion ? static_cast<double>((d - Wide(a.overlap) * n).stableNorm()) : length;
  const double along = has_normal ? std::abs(static_cast<double>(n.dot(d) - Wide(a.overlap))) : length;
  const double severity = e.accuracy.is_rounding()
                              ? severity_of(across, allowed)
                              : std::max(severity_of(across, allowed), severity_of(along, lengthwise));
  return {length > allowed ? FindingKind::overlap_error : FindingKind::misaligned,
          severity,
          {},
          fmt::format("p1 - p2 is not overlap times normal by {:.3g}", across)};
}

Finding normal_agrees(const Evidence& e) {
  if (!e.answer.normal.allFinite()) return {};
  const Solution& truth = nearest(e);
  const double of_length = severity_of(std::abs(e.answer.normal.stableNorm() - 1), few + e.accuracy.normal);
  if (of_length > 1) return {FindingKind::misaligned, of_length, {}, "the normal is no unit vector"};
  if (asks_for_all_solutions(e, truth.condition.normal))
    return {FindingKind::misaligned, normal_severity_in_set(e), {}, "the normal of no input within rounding"};
  const double angle = angle_between(e.answer.normal.cast<Real50>(), truth.normal);
  const double allowed = few * (1 + truth.condition.normal) + e.accuracy.normal;
  double severity = severity_of(angle, allowed);
  if (severity > 1)
    severity = std::min(severity, severity_of(angle, few + nearby_of(e, truth).normal + e.accuracy.normal));
  if (severity > 1 && may_be_in_the_set(e, truth.condition.normal))
    severity = std::min(severity, normal_severity_in_set(e));
  return {FindingKind::misaligned,
          severity,
          {},
          "normal " + in_degrees(angle) + " off",
          doubt_of(e, truth.normal_radius, allowed)};
}

Finding overlap_agrees(const Evidence& e) {
  if (std::isnan(e.answer.overlap)) return {};
  if (e.problem != Problem::common_normal && !e.own.proved) return {};
  const Solution& truth = nearest(e);
  const double error = overlap_error(e, e.answer.overlap);
  const double rounding = e.own.solved
                              ? few_of(truth.condition.overlap * scale_of(e, truth))
                              : few_of(largest_overlap_condition * (size_of(e.pair) + std::abs(e.answer.overlap)));
  const double allowed = rounding + overlap_slack(e);
  return {FindingKind::overlap_error,
          severity_of(error, allowed),
          {},
          "overlap: " + expected_and_got(static_cast<double>(truth.overlap), e.answer.overlap),
          e.own.solved ? doubt_of(e, width_of(truth.bounds), allowed) : 0};
}

namespace {

/// A place that is `error` from the certified one. Where the condition number says too little, the answers to inputs within
/// rounding are asked, or the certified set, from which it is `in_set` off.
template <class SeverityInSet>
Finding place_agrees(const Evidence& e, double error, double rounding, const SeverityInSet& in_set,
                     std::string detail) {
  const Solution& truth = nearest(e);
  const double condition = truth.condition.points, slack = points_slack(e, truth.condition);
  if (asks_for_all_solutions(e, condition)) return {FindingKind::point_error, in_set(), {}, std::move(detail)};
  const double allowed = few_of(condition * scale_of(e, truth)) + rounding + slack;
  double severity = severity_of(error, allowed);
  if (severity > 1) severity = std::min(severity, severity_of(error, rounding + nearby_of(e, truth).points + slack));
  if (severity > 1 && may_be_in_the_set(e, condition)) severity = std::min(severity, in_set());
  return {FindingKind::point_error, severity, {}, std::move(detail), doubt_of(e, truth.points_radius, allowed)};
}

/// One point, between the certified ones; where these are a set, no further from them than the set reaches.
Finding middle_agrees(const Evidence& e) {
  const Solution& truth = nearest(e);
  const double rounding = 2 * point_rounding(e.pair);
  const auto off = [&](const auto& point1, const auto& point2) {
    const Vec3<Wide> from = point1.template cast<Wide>(), to = point2.template cast<Wide>();
    return off_segment(e.answer.contact_point.cast<Wide>(), from, to);
  };
  const auto severity_in_set = [&] {
    const reference::SolutionSet& all = e.all_solutions();
    return severity_of(off(all.point1, all.point2), all.points_radius + rounding + points_slack(e, truth.condition));
  };
  const double error = off(truth.point1, truth.point2);
  return place_agrees(e, error, rounding, severity_in_set, fmt::format("the contact point is {:.3g} off", error));
}

}  // namespace

Finding points_agree(const Evidence& e) {
  if (!has_points(e)) return {};
  const Solution& truth = nearest(e);
  const double error = std::max(static_cast<double>((e.answer.point1.cast<Real50>() - truth.point1).norm()),
                                static_cast<double>((e.answer.point2.cast<Real50>() - truth.point2).norm()));
  return place_agrees(
      e, error, point_rounding(e.pair), [&] { return points_severity_in_set(e); },
      fmt::format("a point off by {:.3g}", error));
}

/// Where a force would act, wherever between the points a method has it. Who leaves it out says nothing wrong.
Finding contact_point_is_between(const Evidence& e) {
  const Contact<double>& a = e.answer;
  if (e.problem != Problem::common_normal || !a.contact_point.allFinite()) return {};
  if (e.claims != nullptr && e.claims->points == Points::midway) return middle_agrees(e);
  if (!has_points(e)) return {};
  const double off = off_segment(a.contact_point.cast<Wide>(), a.point1.cast<Wide>(), a.point2.cast<Wide>());
  return {FindingKind::point_error,
          severity_of(off, 2 * point_rounding(e.pair) + points_slack(e, e.own.condition)),
          {},
          fmt::format("the contact point is {:.3g} off", off)};
}

Finding evaluations_are_few(const Evidence& e) {
  const double most = 2000;
  return {FindingKind::slow, e.answer.evaluations / most, {}, fmt::format("{} evaluations", e.answer.evaluations)};
}

}  // namespace plumb::law
