#include "reports/certified/compared.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reports/certified/six_equations.hpp"
#include "solver/method/methods.hpp"
#include "solver/pose.hpp"
#include "solver/reference/reference.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb::reports {
namespace {

constexpr int scanned = 400;      // directions looked at for starts
constexpr std::size_t tried = 3;  // of them, the lowest that are this far apart:
constexpr double apart = 0.2;     // rad

/// The lengths that rounding in 50 digits is relative to.
Real50 scale_of(const Pair& pair) {
  return Real50(size_of(pair)) + (pair.body2.position.cast<Real50>() - pair.body1.position.cast<Real50>()).norm();
}

/// By how much an overlap found with this residual may be off. The overlap is stationary, and the gauges enter at first
/// order with a factor of the bodies' sizes.
Real50 overlap_slack(const Pair& pair, const Real50& residual) {
  return scale_of(pair) * (Real50(8) * residual + Real50("1e-45"));
}

int group_of(const Pair& pair) {
  double largest = 2, least = 2;
  for (const double n : {pair.body1.shape.n1, pair.body1.shape.n2, pair.body2.shape.n1, pair.body2.shape.n2}) {
    largest = std::max(largest, n);
    least = std::min(least, n);
  }
  if (least < 8.0 / 7) return 3;
  return largest <= 8 ? 0 : (largest <= 40 ? 1 : 2);
}

/// Directions spread evenly over the sphere (Fibonacci lattice) with o there in double, lowest first.
std::vector<std::pair<double, Vec3<double>>> scan(const PlacedPair<double>& pair) {
  std::vector<std::pair<double, Vec3<double>>> out;
  for (int k = 0; k < scanned; ++k) {
    const double z = 1 - (2 * k + 1.0) / scanned, radius = std::sqrt(1 - z * z),
                 turn = k * std::numbers::pi * (3 - std::sqrt(5.0));
    const Vec3<double> n(radius * std::cos(turn), radius * std::sin(turn), z);
    const double h1 = support<double>(pair.body1.shape, pair.body1.to_body_direction(n));
    const double h2 = support<double>(pair.body2.shape, pair.body2.to_body_direction(-n));
    out.emplace_back(h1 + h2 - n.dot(pair.body2.centre), n);
  }
  std::stable_sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  return out;
}

/// The two points whose normals are n and -n, as a start for a method.
Contact<double> start_at(const Pair& pair, const PlacedPair<double>& placed, const Vec3<double>& n) {
  const auto point = [&](const PlacedBody<double>& body, const Vec3<double>& u) {
    return body.to_pair(support_point<double>(body.shape, body.to_body_direction(u)).gradient);
  };
  Contact<double> out;
  out.point1 = placed.to_world_point(point(placed.body1, n), pair);
  out.point2 = placed.to_world_point(point(placed.body2, -n), pair);
  return out;
}

/// What plumb's methods answer in double: each from its own start, new_cn also from the lowest of the scanned directions.
std::vector<Contact<double>> method_answers(const Pair& pair) {
  std::vector<Contact<double>> out;
  for (const Method& method : methods()) out.push_back(method.solve(pair, {}, nullptr));
  const PlacedPair<double> placed = place<double>(pair);
  std::vector<Vec3<double>> used;
  for (const auto& [overlap, n] : scan(placed)) {
    if (used.size() == tried) break;
    if (std::any_of(used.begin(), used.end(), [&](const auto& other) { return (other - n).norm() < apart; })) continue;
    used.push_back(n);
    const Contact<double> start = start_at(pair, placed, n);
    out.push_back(find_method("new_cn")->solve(pair, {}, &start));
  }
  return out;
}

/// No direction whatever may have a lower overlap than the certified lower bound.
void check_directions(const Pair& pair, const std::vector<Contact<double>>& answers, const Reference& reference,
                      Compared& out) {
  const Real50 slack = overlap_slack(pair, Real50(0));
  for (const Contact<double>& answer : answers) {
    if (!answer.normal.allFinite() || answer.normal.isZero()) continue;
    const Real50 overlap = overlap_along(pair, answer.normal.cast<Real50>());
    if (overlap < reference.overlap.lower - slack)
      out.contradictions.push_back(fmt::format("a direction's overlap is {:.3g} below the lower bound",
                                               static_cast<double>(reference.overlap.lower - overlap)));
  }
}

bool is_above(const Pair& pair, const SixEquations& six, const Reference& reference) {
  return six.overlap > reference.overlap.upper + overlap_slack(pair, six.residual);
}

/// The answers of the common-normal methods, lowest overlap first.
std::vector<Contact<double>> common_normals(const std::vector<Contact<double>>& answers) {
  std::vector<Contact<double>> out;
  for (const Contact<double>& answer : answers)
    if (answer.method == "new_cn" && answer.point1.allFinite() && answer.point2.allFinite() &&
        std::isfinite(answer.overlap))
      out.push_back(answer);
  std::stable_sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.overlap < b.overlap; });
  if (out.size() > 2) out.resize(2);
  return out;
}

/// A point of a body moved by `amount` of its semi-axes, to a side that no symmetry of the shapes prefers.
Vec3<Real50> disturbed(const Body& body, const Vec3<Real50>& point, double amount) {
  const Vec3<double> side(0.62, -0.48, 0.57);
  const Vec3<Real50> step = (body.shape.semi_axes.cwiseProduct(side) * amount).cast<Real50>();
  return point + rotation<Real50>(body.quaternion) * step;
}

/// Solves from the methods' answers and, where these lead nowhere or elsewhere, from the certified points disturbed.
SixEquations solve(const Pair& pair, const std::vector<Contact<double>>& answers, const Reference& reference,
                   Compared& out) {
  SixEquations best;
  const auto take = [&](const SixEquations& six, Comparison by) {
    const bool above = six.solved && is_above(pair, six, reference);
    if (six.solved && !above) out.comparison = by;
    if (above && out.comparison == Comparison::unsolved) out.comparison = Comparison::elsewhere;
    const bool better = best.solved ? six.solved && six.overlap < best.overlap
                                    : six.solved || six.residual < best.residual || best.reason.empty();
    if (better) best = six;
    return six.solved && !above;
  };
  for (const Contact<double>& answer : common_normals(answers))
    if (take(solve_six_equations(pair, answer.point1.cast<Real50>(), answer.point2.cast<Real50>()),
             Comparison::by_method))
      return best;
  const Solution& found = reference.common_normal;
  if (!found.point1.allFinite() || !found.point2.allFinite()) return best;
  for (const double amount : {1e-3, 1e-6, 1e-12})
    if (take(solve_six_equations(pair, disturbed(pair.body1, found.point1, amount),
                                 disturbed(pair.body2, found.point2, amount)),
             Comparison::by_disturbed))
      return best;
  return best;
}

/// How far outside a certified solution's radii the independent one is: <= 0 inside.
struct Excess {
  double normal, points;
};

Excess excess_over(const Pair& pair, const SixEquations& six, const Solution& solution) {
  const double rounding = 1e-47;
  const double turned = static_cast<double>((six.normal - solution.normal).norm());
  const double moved = std::max(static_cast<double>((six.point1 - solution.point1).norm()),
                                static_cast<double>((six.point2 - solution.point2).norm()));
  const double far = static_cast<double>(scale_of(pair)) + pair.body1.position.norm();
  return {turned - solution.normal_radius - six.normal_error - rounding,
          moved - solution.points_radius - six.points_error - rounding * far};
}

/// A common normal above the bounds must be another one.
void check_other(const Pair& pair, const SixEquations& six, const Reference& reference, Compared& out) {
  const Excess excess = excess_over(pair, six, reference.common_normal);
  if (excess.normal <= 0 && excess.points <= 0 && reference.common_normal.proved)
    out.contradictions.push_back(fmt::format("overlap of the certified normal {:.3g} above the upper bound",
                                             static_cast<double>(six.overlap - reference.overlap.upper)));
}

void check_solution(const Pair& pair, const SixEquations& six, const Reference& reference, Compared& out) {
  const Real50 slack = overlap_slack(pair, six.residual);
  if (six.overlap < reference.overlap.lower - slack)
    out.contradictions.push_back(fmt::format("overlap {:.3g} below the lower bound",
                                             static_cast<double>(reference.overlap.lower - six.overlap)));
  if (is_above(pair, six, reference)) return check_other(pair, six, reference, out);
  if (!out.unique_or_tied) return;
  const Solution* certified = &reference.common_normal;
  for (const Solution& tied : reference.tied)
    if (six.normal.dot(tied.normal) > six.normal.dot(certified->normal)) certified = &tied;
  const Excess excess = excess_over(pair, six, *certified);
  if (!(excess.normal > 0) && !(excess.points > 0)) return;
  const Stretch stretch = stretch_to(pair, six, certified->point1, certified->point2);
  if (excess.normal > 0 && !(stretch.holds && stretch.turn > excess.normal))
    out.contradictions.push_back(fmt::format("normal {:.3g} rad outside the radius", excess.normal));
  if (excess.points > 0 && !stretch.holds)
    out.contradictions.push_back(fmt::format("points {:.3g} outside the radius", excess.points));
}

/// Why not everything is proved; never empty.
std::string reason_of(const Reference& reference) {
  for (const std::string& reason : {reference.reason, reference.common_normal.reason})
    if (!reason.empty()) return reason;
  return "no reason given";
}

void take_claims(const Pair& pair, const Reference& reference, Compared& out) {
  const double size = size_of(pair);
  out.global = reference.global == Claim::proved;
  out.unique_or_tied = names_all_ties(reference);
  out.verdict = reference.verdict != Verdict::undecided;
  if (!out.global || !out.unique_or_tied || !out.verdict) out.reason = reason_of(reference);
  out.gap = static_cast<double>((reference.overlap.upper - reference.overlap.lower) / Real50(size));
  out.normal_radius = reference.common_normal.normal_radius;
  out.points_radius = reference.common_normal.points_radius / size;
}

}  // namespace

const std::vector<std::string>& groups() {
  static const std::vector<std::string> names{"to 8", "to 40", "above 40", "below 8/7"};
  return names;
}

Compared compare(const Case& c, Effort effort) {
  Compared out;
  out.name = c.name;
  out.group = group_of(c.pair);
  const Reference reference = find_reference(c.pair, effort);
  take_claims(c.pair, reference, out);
  const std::vector<Contact<double>> answers = method_answers(c.pair);
  check_directions(c.pair, answers, reference, out);
  const SixEquations six = solve(c.pair, answers, reference, out);
  out.residual = static_cast<double>(six.residual);
  out.stall = six.solved ? "" : std::string(six.reason);
  if (six.solved) check_solution(c.pair, six, reference, out);
  return out;
}

}  // namespace plumb::reports
