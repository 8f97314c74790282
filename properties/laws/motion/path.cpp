#include "properties/laws/motion/path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "corpus/command/interrupt.hpp"
#include "properties/laws/allowance.hpp"
#include "properties/laws/judged_answer.hpp"
#include "solver/pose.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb {
namespace {

using law::few;
using law::few_of;
using law::severity_of;
using law::worse;
using PathScalar = long double;

Vec3<PathScalar> between_centres(const Pair& pair) {
  return pair.body2.position.cast<PathScalar>() - pair.body1.position.cast<PathScalar>();
}

double shift_between(const Pair& from, const Pair& to) {
  return static_cast<double>((between_centres(to) - between_centres(from)).stableNorm());
}

/// Largest displacement of a point of the body's box by its turn alone.
double swept(const Body& from, const Body& to) {
  const Mat3<PathScalar> change = rotation<PathScalar>(to.quaternion) - rotation<PathScalar>(from.quaternion);
  const Vec3<PathScalar> axes = from.shape.semi_axes.cast<PathScalar>();
  PathScalar most = 0;
  for (const int y : {-1, 1})
    for (const int z : {-1, 1}) {
      const Vec3<PathScalar> corner(axes[0], y * axes[1], z * axes[2]);
      most = std::max(most, Vec3<PathScalar>(change * corner).stableNorm());
    }
  return static_cast<double>(most);
}

/// rad. |R - I| by Frobenius is 2 sqrt(2) sin(angle / 2).
double turned(const Body& from, const Body& to) {
  const Mat3<PathScalar> change = rotation<PathScalar>(to.quaternion) - rotation<PathScalar>(from.quaternion);
  const PathScalar half_sine = change.norm() / (2 * std::sqrt(PathScalar(2)));
  return static_cast<double>(2 * std::asin(std::min(half_sine, PathScalar(1))));
}

PathScalar support_along(const Body& body, const Vec3<PathScalar>& n) {
  const Superellipsoid<PathScalar> shape{body.shape.semi_axes.cast<PathScalar>(), body.shape.n1, body.shape.n2};
  return support<PathScalar>(shape, rotation<PathScalar>(body.quaternion).transpose() * n);
}

/// o_P(n).
double overlap_along(const Pair& pair, const Vec3<double>& normal) {
  const Vec3<PathScalar> n = normal.cast<PathScalar>().normalized();
  return static_cast<double>(support_along(pair.body1, n) + support_along(pair.body2, -n) -
                             n.dot(between_centres(pair)));
}

/// delta: how far the answer's overlap may be off.
double overlap_rounding(const PathStep& step) {
  const double condition = step.own->solved ? step.own->condition.overlap : law::largest_overlap_condition;
  return few_of(condition * (size_of(step.pair) + std::abs(step.cold.overlap)));
}

/// few |grad o|, at most.
double direction_rounding(const Pair& pair) {
  return few_of(pair.body1.shape.semi_axes.norm() + pair.body2.shape.semi_axes.norm() +
                static_cast<double>(between_centres(pair).stableNorm()));
}

bool have_overlaps(const PathLink& link) {
  return link.problem == Problem::common_normal && std::isfinite(link.from.cold.overlap) &&
         std::isfinite(link.to.cold.overlap);
}

bool have_normals(const PathLink& link) {
  return link.problem == Problem::common_normal && link.from.cold.normal.allFinite() && link.to.cold.normal.allFinite();
}

Finding overlap_is_lipschitz(const PathLink& link) {
  if (!have_overlaps(link)) return {};
  const double moved = displacement(link.from.pair, link.to.pair);
  const double change = std::abs(link.to.cold.overlap - link.from.cold.overlap);
  return {FindingKind::overlap_error,
          severity_of(change, moved + overlap_rounding(link.from) + overlap_rounding(link.to)),
          {},
          fmt::format("the overlap changes by {:.3g} where no point moves by more than {:.3g}", change, moved)};
}

/// (3), of the answer's normal at `to` seen from `from`.
Finding follows(const PathStep& from, const PathStep& to) {
  const double allowed = 2 * displacement(from.pair, to.pair) + overlap_rounding(from) + 2 * overlap_rounding(to) +
                         direction_rounding(from.pair);
  const double excess = overlap_along(from.pair, to.cold.normal) - from.cold.overlap;
  return {FindingKind::misaligned,
          severity_of(std::max(excess, 0.0), allowed),
          {},
          fmt::format("the other step's normal has an overlap higher by {:.3g}, the motion allows {:.3g}", excess,
                      allowed)};
}

Finding normal_follows(const PathLink& link) {
  if (!have_overlaps(link) || !have_normals(link)) return {};
  return worse(follows(link.from, link.to), follows(link.to, link.from));
}

/// Of the certified solutions that tie to within rounding.
std::vector<Vec3<Real50>> lowest_normals(const PathStep& step) {
  const Solution& lowest = step.reference->common_normal;
  const double rounding = few_of(size_of(step.pair) + std::abs(static_cast<double>(lowest.overlap)));
  std::vector<Vec3<Real50>> out{lowest.normal};
  for (const auto* others : {&step.reference->tied, &step.reference->close})
    for (const Solution& other : *others)
      if (static_cast<double>(Real50(other.overlap - lowest.overlap)) <= rounding) out.push_back(other.normal);
  return out;
}

double widest_certified_angle(const PathLink& link) {
  double widest = 0;
  for (const Vec3<Real50>& a : lowest_normals(link.from))
    for (const Vec3<Real50>& b : lowest_normals(link.to)) widest = std::max(widest, law::angle_between(a, b));
  return widest;
}

bool knows_the_normal(const PathStep& step) {
  const Solution& found = step.reference->common_normal;
  return found.solved && names_all_lowest(*step.reference) && law::has_definite_normal(found);
}

/// How far the answer's normal may be off, and the certified one.
double normal_rounding_of(const PathStep& step) {
  const Solution& found = step.reference->common_normal;
  return few * (1 + found.condition.normal) + (step.reference->effort == Effort::digits ? 0 : found.normal_radius);
}

Finding normal_has_a_rate(const PathLink& link) {
  if (!have_normals(link) || !knows_the_normal(link.from) || !knows_the_normal(link.to)) return {};
  const double largest_first_order = 0.1;
  const double kappa =
      std::max(link.from.reference->common_normal.condition.normal, link.to.reference->common_normal.condition.normal);
  const double linear = kappa * relative_motion(link.from.pair, link.to.pair);
  const double first_order = linear < largest_first_order ? linear : 0;
  const double angle = law::angle_between(link.from.cold.normal.cast<Real50>(), link.to.cold.normal.cast<Real50>());
  const double allowed =
      std::max(first_order, widest_certified_angle(link)) + normal_rounding_of(link.from) + normal_rounding_of(link.to);
  return {
      FindingKind::misaligned,
      severity_of(angle, allowed),
      {},
      fmt::format("the normal turns by {:.3g} rad, the certified curvature and normals allow {:.3g}", angle, allowed)};
}

/// What `seen` says of the bodies at `judged`, which are at most `moved` further in or out.
Finding keeps_its_verdict(const PathStep& seen, const PathStep& judged, double moved) {
  const double overlap = seen.cold.overlap;
  const Verdict right = overlap > 0 ? Verdict::overlapping : Verdict::separated;
  if (judged.cold.verdict == right) return {};
  const double allowed = 2 * few_of(size_of(judged.pair) + std::abs(overlap)) + overlap_rounding(seen);
  return {
      overlap > 0 ? FindingKind::missed_contact : FindingKind::false_contact,
      severity_of(std::max(std::abs(overlap) - moved, 0.0), allowed),
      {},
      fmt::format("says {} where the overlap is within {:.3g} of {:.17g}", name(judged.cold.verdict), moved, overlap)};
}

Finding verdict_does_not_flicker(const PathLink& link) {
  if (!have_overlaps(link)) return {};
  const double moved = displacement(link.from.pair, link.to.pair);
  return worse(keeps_its_verdict(link.to, link.to, 0),
               worse(keeps_its_verdict(link.from, link.to, moved), keeps_its_verdict(link.to, link.from, moved)));
}

Finding differs_when_warm(double severity, const std::string& detail) {
  return {FindingKind::nondeterministic, severity, {}, "warm: " + detail};
}

Finding warm_is_cold(const PathLink& link) {
  const Contact<double>&cold = link.to.cold, &warm = link.to.warm;
  const Finding& broken = link.to.broken_warm;
  if (broken.kind != FindingKind::none && link.to.broken_cold.kind == FindingKind::none)
    return differs_when_warm(broken.severity, fmt::format("{}, {}", name(broken.kind), broken.detail));
  if (!std::isfinite(cold.overlap) || !std::isfinite(warm.overlap)) return {};
  const double rounding = 2 * overlap_rounding(link.to);
  const double severity = severity_of(std::abs(warm.overlap - cold.overlap), rounding);
  if (severity > 1)
    return differs_when_warm(severity, fmt::format("overlap {:.17g}, cold {:.17g}", warm.overlap, cold.overlap));
  if (warm.verdict == cold.verdict) return {};
  const double floor = 2 * few_of(size_of(link.to.pair)) + rounding;
  return differs_when_warm(severity_of(std::abs(cold.overlap), floor),
                           fmt::format("says {}, cold {}", name(warm.verdict), name(cold.verdict)));
}

constexpr std::array all_path_laws{
    PathLaw{"lipschitz", "the overlap changes by no more than the largest displacement of a point",
            overlap_is_lipschitz},
    PathLaw{"no_flicker", "the verdict stays while the overlap is further from zero than the bodies move",
            verdict_does_not_flicker},
    PathLaw{"normal_follows", "the normal of one step is a good direction of the next", normal_follows},
    PathLaw{"normal_rate", "the normal turns no faster than the certified curvature allows, or the certified normal",
            normal_has_a_rate},
    PathLaw{"warm_is_cold", "a warm start changes nothing but the work", warm_is_cold},
};

void judge_link(std::vector<PathFinding>& out, const PathEvidence& evidence, std::size_t step) {
  const PathLink link{evidence.problem, evidence.steps[step - 1], evidence.steps[step]};
  for (const PathLaw& law : all_path_laws) {
    Finding finding = law.check(link);
    if (!(finding.severity > 1)) continue;
    finding.law = law.name;
    out.push_back({step, std::move(finding)});
  }
}

}  // namespace

double displacement(const Pair& from, const Pair& to) {
  return shift_between(from, to) + swept(from.body1, to.body1) + swept(from.body2, to.body2);
}

double relative_motion(const Pair& from, const Pair& to) {
  return std::max({shift_between(from, to) / size_of(to), turned(from.body1, to.body1), turned(from.body2, to.body2)});
}

std::span<const PathLaw> path_laws() {
  return all_path_laws;
}

std::vector<PathFinding> judge_path(const PathEvidence& evidence) {
  std::vector<PathFinding> out;
  for (std::size_t step = 0; step < evidence.steps.size(); ++step) {
    const Finding& broken = evidence.steps[step].broken_cold;
    if (broken.kind != FindingKind::none) out.push_back({step, broken});
    if (step > 0) judge_link(out, evidence, step);
  }
  return out;
}

PathJudge::PathJudge(const std::vector<Pair>& pairs, const ReferenceSource& source) : pairs_(pairs) {
  for (const Pair& pair : pairs_) judges_.emplace_back(pair, source);
}

PathEvidence PathJudge::follow(Problem problem, const WarmSolve& solve) {
  PathEvidence out{problem, {}};
  const auto judged = [&](std::size_t i, const Contact<double>* last, Finding& broken) {
    Contact<double> answer;
    try {
      answer = solve(pairs_[i], last);
      broken = judges_[i].judge(problem, answer).finding;
    } catch (const NoAnswer& e) {
      broken = finding_of(e);
    }
    return answer;
  };
  for (std::size_t i = 0; i < pairs_.size() && !interrupted(); ++i) {
    PathStep step{pairs_[i], {}, {}, {}, {}, nullptr, nullptr};
    step.cold = judged(i, nullptr, step.broken_cold);
    step.warm = step.cold;
    step.broken_warm = step.broken_cold;
    if (i > 0) step.warm = judged(i, &out.steps.back().warm, step.broken_warm);
    step.reference = &judges_[i].reference();
    step.own = &judges_[i].solution(problem);
    out.steps.push_back(std::move(step));
  }
  return out;
}

}  // namespace plumb
