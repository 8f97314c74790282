#include "properties/laws/laws_convex.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "corpus/certificate/certificate.hpp"
#include "properties/laws/allowance.hpp"
#include "properties/laws/laws_answer.hpp"
#include "solver/reference/convex_bounds.hpp"

namespace plumb {
namespace {

using law::severity_of;

/// Lengths that an answer may be off without a finding.
struct Allowed {
  double overlap, points, normal;
};

struct ConvexEvidence {
  const ConvexPair& pair;
  const Contact<double>& answer;
  bool must_be_whole;
  reference::ConvexBounds bounds;
  reference::ConvexErrors errors;  ///< of a whole answer
};

/// Rounding, which is relative to sizes and distances, and what is asked for beside it. Each length by itself: the sum of large ones is
/// infinite, and would allow anything.
Allowed allowed_of(const ConvexEvidence& e, const Accuracy& accuracy) {
  const double in_place_of_a_condition_number = 128;
  const double size = size_of(e.pair);
  double rounding = 0, tilt = 0;
  for (const double length : {size, std::abs(e.bounds.upper), e.pair.body1.position.lpNorm<Eigen::Infinity>(),
                              e.pair.body2.position.lpNorm<Eigen::Infinity>()}) {
    rounding += in_place_of_a_condition_number * law::few_of(length);
    tilt += accuracy.normal * length;
  }
  const double overlap = rounding + accuracy.overlap * size;
  return {overlap, overlap + accuracy.points.value_or(0) * size, overlap + tilt};
}

std::string in_words(double length) {
  return std::isfinite(length) ? fmt::format("{:.3g}", length) : "a length that is not bounded";
}

Finding finite(const ConvexEvidence& e, const Allowed& /*allowed*/) {
  const Contact<double>& a = e.answer;
  const bool missing = e.must_be_whole && a.status == Status::converged && !law::is_whole(a);
  const bool infinite = std::isinf(a.overlap) || a.normal.array().isInf().any() || a.point1.array().isInf().any() ||
                        a.point2.array().isInf().any();
  if (a.status != Status::not_finite && !missing && !infinite) return {};
  return {FindingKind::not_finite, law::wrong_altogether, "finite", "a NaN or an infinity in the answer"};
}

Finding converges(const ConvexEvidence& e, const Allowed& /*allowed*/) {
  if (e.answer.status == Status::converged) return {};
  return {FindingKind::nonconverged, law::wrong_altogether, "converges",
          fmt::format("status {}", name(e.answer.status))};
}

Finding verdict_is_right(const ConvexEvidence& e, const Allowed& allowed) {
  const Verdict said = e.answer.verdict;
  if (said == Verdict::undecided && std::isnan(e.answer.overlap)) return {};
  const double missed = said == Verdict::overlapping ? 0 : e.bounds.lower,
               made_up = said == Verdict::separated ? 0 : -e.bounds.upper;
  return {made_up > missed ? FindingKind::false_contact : FindingKind::missed_contact,
          severity_of(std::max(made_up, missed), allowed.overlap), "verdict",
          fmt::format("says {}, overlap is within {:.17g} .. {:.17g}", name(said), e.bounds.lower, e.bounds.upper)};
}

Finding normal_is_unit(const ConvexEvidence& e, const Allowed& /*allowed*/) {
  if (!law::is_whole(e.answer)) return {};
  return {FindingKind::misaligned, severity_of(std::abs(e.answer.normal.stableNorm() - 1), law::few), "normal",
          "the normal is no unit vector"};
}

/// What a body reaches beyond the plane of its point because that point is off the surface is another law's.
double beyond_plane(double touching, double point) {
  return std::isfinite(point) ? touching - point : 0;
}

Finding bodies_touch_their_planes(const ConvexEvidence& e, const Allowed& allowed) {
  if (!law::is_whole(e.answer)) return {};
  const double beyond =
      std::max(beyond_plane(e.errors.touching1, e.errors.point1), beyond_plane(e.errors.touching2, e.errors.point2));
  return {FindingKind::misaligned, severity_of(beyond, allowed.normal), "opposite",
          fmt::format("a body reaches {} beyond the plane through its point", in_words(beyond))};
}

Finding points_are_on_surfaces(const ConvexEvidence& e, const Allowed& allowed) {
  if (!law::is_whole(e.answer)) return {};
  const double off = std::max(e.errors.point1, e.errors.point2);
  return {FindingKind::off_surface, severity_of(off, allowed.points), "surface",
          fmt::format("off the surface by {}", in_words(off))};
}

Finding agrees_with_itself(const ConvexEvidence& e, const Allowed& allowed) {
  const Contact<double>& a = e.answer;
  if (!law::is_whole(a)) return {};
  const double distance = (a.point1 - a.point2).stableNorm();
  const bool has_length = std::abs(distance - std::abs(a.overlap)) <= allowed.normal;
  return {has_length ? FindingKind::misaligned : FindingKind::overlap_error,
          severity_of(e.errors.alignment, allowed.normal), "itself",
          fmt::format("p1 - p2 is not overlap times normal by {}", in_words(e.errors.alignment))};
}

/// Where all else is right, a common normal whose overlap is not the lowest.
Finding overlap_is_lowest(const ConvexEvidence& e, const Allowed& allowed) {
  const double overlap = e.answer.overlap;
  if (std::isnan(overlap)) return {};
  const double error = std::max({0.0, overlap - e.bounds.upper, e.bounds.lower - overlap});
  const bool is_another = law::is_whole(e.answer) && overlap > e.bounds.upper;
  return {is_another ? FindingKind::wrong_branch : FindingKind::overlap_error, severity_of(error, allowed.overlap),
          is_another ? "lowest" : "overlap",
          fmt::format("overlap {:.17g}, lowest within {:.17g} .. {:.17g}", overlap, e.bounds.lower, e.bounds.upper)};
}

Finding first_broken(const ConvexEvidence& e, const Accuracy& accuracy) {
  const Allowed allowed = allowed_of(e, accuracy);
  for (const auto check : {finite, converges, verdict_is_right, normal_is_unit, bodies_touch_their_planes,
                           agrees_with_itself, points_are_on_surfaces, overlap_is_lowest})
    if (Finding found = check(e, allowed); found.severity > 1) return found;
  return {};
}

/// Of accuracy_levels, the finest first.
std::size_t right_from(const ConvexEvidence& e) {
  const auto level = std::ranges::find_if(
      accuracy_levels, [&](const AccuracyLevel& l) { return first_broken(e, l.accuracy).kind == FindingKind::none; });
  return static_cast<std::size_t>(level - accuracy_levels.begin());
}

}  // namespace

Judgement judge_convex(const ConvexPair& pair, const Contact<double>& answer, const Accuracy& accuracy, bool whole) {
  ConvexEvidence e{pair, answer, whole, reference::bound_overlap(pair, answer.normal, kConvexCells), {}};
  if (answer.status == Status::converged && law::is_whole(answer))
    e.errors = reference::errors_of(pair, answer, e.bounds);
  Judgement out{{first_broken(e, accuracy)}};
  out.judged = std::isfinite(e.bounds.lower) || std::isfinite(e.bounds.upper);
  out.right_from = right_from(e);
  out.overlap_error = std::max({0.0, answer.overlap - e.bounds.upper, e.bounds.lower - answer.overlap}) / size_of(pair);
  return out;
}

}  // namespace plumb
