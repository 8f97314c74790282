#include "properties/laws/screen.hpp"

#include <algorithm>
#include <cmath>

#include "properties/laws/allowance.hpp"
#include "properties/laws/laws_answer.hpp"
#include "solver/pose.hpp"

namespace plumb {
namespace {

using Wide = long double;

/// Of a placed pair, a length in its frame.
Wide depth_in_frame(const PlacedPair<Wide>& placed, const Vec3<Wide>& n) {
  const Wide reach1 = support<Wide>(placed.body1.shape, placed.body1.to_body_direction(n));
  const Wide reach2 = support<Wide>(placed.body2.shape, placed.body2.to_body_direction(-n));
  return reach1 + reach2 - n.dot(placed.body2.centre - placed.body1.centre);
}

/// What rounding does to an overlap: that of the input, of the answer and of the unit vector.
double allowed_depth(const Pair& pair, double overlap) {
  return law::few_of(reference::largest_overlap_condition * (size_of(pair) + std::abs(overlap)));
}

double excess_over(const PlacedPair<Wide>& placed, double overlap, const Vec3<double>& direction) {
  const Wide depth = placed.to_world_length(depth_in_frame(placed, direction.cast<Wide>().normalized()));
  return static_cast<double>(overlap - depth);
}

/// Against its own overlap; an undecided one is left open within twice the floor that every method documents.
double verdict_severity(const Pair& pair, const Contact<double>& answer) {
  const double allowed = 2 * law::few_of(size_of(pair));
  const Verdict of_overlap = answer.overlap > 0 ? Verdict::overlapping : Verdict::separated;
  return answer.verdict == of_overlap ? 0 : law::severity_of(std::abs(answer.overlap), allowed);
}

}  // namespace

Wide depth_along(const Pair& pair, const Vec3<Wide>& n) {
  const auto placed = place<Wide>(pair);
  return placed.to_world_length(depth_in_frame(placed, n));
}

Screening screen(const Pair& pair, const Contact<double>& answer, std::span<const Vec3<double>> witnesses) {
  static const Reference no_reference;
  Screening out;
  const auto set = [&](ScreenCheck check, double severity) {
    double& slot = out.severity[static_cast<std::size_t>(check)];
    slot = std::max(slot, severity);
    out.worst = std::max(out.worst, severity);
  };
  if (answer.status != Status::converged || !law::is_whole(answer)) {
    set(ScreenCheck::converges, law::wrong_altogether);
    return out;
  }
  const Evidence evidence{pair, Problem::common_normal, answer, no_reference, no_reference.common_normal, {}};
  set(ScreenCheck::itself, law::agrees_with_itself(evidence).severity);
  set(ScreenCheck::between, law::contact_point_is_between(evidence).severity);
  const law::PointFindings points = law::points_show(evidence);
  set(ScreenCheck::opposite, points.opposite.severity);
  set(ScreenCheck::collinear, points.collinear.severity);
  set(ScreenCheck::surface, points.surface.severity);
  const auto placed = place<Wide>(pair);
  const double allowed = allowed_depth(pair, answer.overlap);
  set(ScreenCheck::own_depth, law::severity_of(std::abs(excess_over(placed, answer.overlap, answer.normal)), allowed));
  for (const Vec3<double>& witness : witnesses)
    set(ScreenCheck::lowest, law::severity_of(excess_over(placed, answer.overlap, witness), allowed));
  set(ScreenCheck::verdict, verdict_severity(pair, answer));
  return out;
}

}  // namespace plumb
