#include "properties/laws/laws_symmetry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "properties/laws/allowance.hpp"

namespace plumb::law {
namespace {

using Wide = long double;

/// What the answer to the transformed pair must be, and how much it may differ (lengths in the transformed pair's unit).
struct Expected {
  double overlap;
  Vec3<double> normal, point1, point2;
  double input_error = 0;  ///< relative change of the input by the transformation's own rounding, in `few`
  double rounding = 0;     ///< of the points, a length
  Vec3<double> contact_point = not_valid<double>();  ///< NaN: not asked for
};

/// Of common normals, whose points' condition holds for what is between them; and only where there is one.
Vec3<double> judged_contact_point(const Evidence& e) {
  return e.problem == Problem::common_normal ? e.answer.contact_point : not_valid<double>();
}

/// The one place where a law asks for another pair than the one given. Whoever says that he has no answer to it has said nothing
/// wrong, and the law says nothing either; plumb's own methods are to have one.
std::optional<Contact<double>> answer_to(const Evidence& e, const Pair& related) {
  const Contact<double> got = e.solve(related);
  if (got.status != Status::converged && !e.is_own) return std::nullopt;
  return got;
}

/// What the answer itself has not, because it is not claimed, is not asked of another either.
double severity_where_claimed(double own, double error, double allowed) {
  return std::isnan(own) ? 0 : severity_of(error, allowed);
}

/// A verdict without an overlap (Abilities::claimed).
bool is_bare(const Contact<double>& answer) {
  return answer.status == Status::converged && answer.verdict == Verdict::separated && std::isnan(answer.overlap);
}

Finding compare(const Evidence& e, const Pair& asked, const Expected& want, const char* what) {
  const std::optional<Contact<double>> answer = answer_to(e, asked);
  if (!answer) return {};
  const Contact<double>& got = *answer;
  const auto found = [&](double severity, const std::string& detail) -> Finding {
    return {FindingKind::asymmetric, severity, {}, fmt::format("{}: {}", what, detail)};
  };
  // A claim of nothing but "apart": where the answer itself has an overlap, that is by how much the two differ.
  if (is_bare(got) && !is_bare(e.answer))
    return found(severity_of(std::abs(want.overlap), 2 * few_of(size_of(asked))), "apart, it says");
  if (got.status != Status::converged) return found(wrong_altogether, fmt::format("status {}", name(got.status)));
  const Condition& condition = e.own.condition;
  const double times = 2 + want.input_error,
               size = size_of(asked) + (std::isnan(want.overlap) ? 0 : std::abs(want.overlap));
  const double overlap = severity_where_claimed(want.overlap, std::abs(got.overlap - want.overlap),
                                                times * few_of(condition.overlap * size));
  const double normal =
      severity_where_claimed(want.normal[0], (got.normal - want.normal).norm(), times * few * (1 + condition.normal));
  const double of_contact_point =
      want.contact_point.allFinite() ? (got.contact_point - want.contact_point).stableNorm() : 0;
  const double of_points = std::max((got.point1 - want.point1).stableNorm(), (got.point2 - want.point2).stableNorm());
  const double allowed = times * few_of(condition.points * size) + want.rounding;
  const double points =
      std::max(severity_where_claimed(want.point1[0], of_points, allowed), severity_of(of_contact_point, allowed));
  const double worst = std::max({overlap, normal, points});
  return found(
      worst, fmt::format("overlap {:.3g}, normal {:.3g}, points {:.3g} times the allowance", overlap, normal, points));
}

/// Two minima that tie within rounding may be exchanged by anything: the laws of symmetry say nothing of them.
bool is_tied(const Evidence& e) {
  const auto holds_one = [&](const std::vector<Solution>& others) {
    return std::any_of(others.begin(), others.end(), [&](const Solution& other) { return ties(e, other); });
  };
  // Where ties are not all known there may be one: concentric bodies give either of two opposite normals.
  return !names_all_ties(e.reference) || holds_one(e.reference.tied) || holds_one(e.reference.close);
}

Vec3<double> cycled(const Vec3<double>& v) {
  return {v[2], v[0], v[1]};
}

/// Where the motion takes the world's points: turned by 120 degrees about (1, 1, 1) through the pivot (x to y, y to z, z to
/// x), then shifted by a few sizes.
struct Motion {
  Vec3<double> pivot, shift;

  explicit Motion(const Pair& pair) : pivot(pair.body1.position), shift(Vec3<double>::Zero()) {
    const double size = size_of(pair), largest = 1e300;
    if (size + far_from_origin(pair) < largest) shift << 3 * size, -2 * size, size;
  }
  [[nodiscard]] Vec3<double> operator()(const Vec3<double>& x) const { return pivot + cycled(x - pivot) + shift; }
};

/// The quaternion is (1, 1, 1, 1) q.
Body moved(const Body& body, const Motion& motion) {
  Body out = body;
  out.position = motion(body.position);
  const auto [w, x, y, z] = body.quaternion;
  out.quaternion = {w - x - y - z, w + x - y + z, w + x + y - z, w - x + y + z};
  return out;
}

Body rescaled(const Body& body, double unit) {
  Body out = body;
  out.shape.semi_axes *= unit;
  out.position *= unit;
  return out;
}

bool is_sphere(const Body& body) {
  const Vec3<double>& axes = body.shape.semi_axes;
  return axes[0] == axes[1] && axes[1] == axes[2] && body.shape.n1 == 2 && body.shape.n2 == 2;
}

/// Powers of two leave every bit only while nothing comes near the ends of the range.
bool in_normal_range(const Pair& pair) {
  const double largest = 1e250, smallest = 1e-250;
  const auto safe = [&](double x) { return x == 0 || (std::abs(x) < largest && std::abs(x) > smallest); };
  for (const Body* body : {&pair.body1, &pair.body2})
    for (int i = 0; i < 3; ++i)
      if (!safe(body->shape.semi_axes[i]) || !safe(body->position[i])) return false;
  return true;
}

bool same_bits(double a, double b) {
  return a == b || (a != a && b != b);
}

bool same_bits(const Vec3<double>& a, const Vec3<double>& b) {
  return same_bits(a[0], b[0]) && same_bits(a[1], b[1]) && same_bits(a[2], b[2]);
}

/// Whether b is a with its lengths multiplied by the unit, bit for bit.
bool same_contact(const Contact<double>& a, const Contact<double>& b, double unit) {
  const auto scaled = [&](const Vec3<double>& x) -> Vec3<double> { return x * unit; };
  return a.status == b.status && a.verdict == b.verdict && same_bits(a.overlap * unit, b.overlap) &&
         same_bits(a.normal, b.normal) && same_bits(scaled(a.point1), b.point1) &&
         same_bits(scaled(a.point2), b.point2) && a.evaluations == b.evaluations;
}

}  // namespace

Finding swap_changes_nothing(const Evidence& e) {
  if (!e.solve || is_tied(e)) return {};
  const Contact<double>& a = e.answer;
  return compare(e, swapped(e.pair),
                 {a.overlap, -a.normal, a.point2, a.point1, 0, 2 * point_rounding(e.pair), judged_contact_point(e)},
                 "bodies exchanged");
}

Finding rigid_motion_changes_nothing(const Evidence& e) {
  if (!e.solve || is_tied(e)) return {};
  const Contact<double>& a = e.answer;
  const Motion motion(e.pair);
  const Pair asked{moved(e.pair.body1, motion), moved(e.pair.body2, motion), cycled(e.pair.motion)};
  const double far = far_from_origin(asked) / size_of(e.pair);  // rounding of the new positions
  return compare(e, asked,
                 {a.overlap, cycled(a.normal), motion(a.point1), motion(a.point2), 1 + 2 * far,
                  2 * point_rounding(e.pair) + 2 * point_rounding(asked)},
                 "turned by 120 degrees about (1, 1, 1) and shifted");
}

Finding limits_are_reached(const Evidence& e) {
  if (!e.solve || is_tied(e)) return {};
  const Contact<double>& a = e.answer;
  if (is_sphere(e.pair.body1) && is_sphere(e.pair.body2) && e.pair.motion.isZero(0)) {
    const Vec3<Wide> d = e.pair.body2.position.cast<Wide>() - e.pair.body1.position.cast<Wide>();
    const Wide overlap = Wide(e.pair.body1.shape.semi_axes[0]) + e.pair.body2.shape.semi_axes[0] - d.norm();
    const double error = static_cast<double>(std::abs(overlap - a.overlap));
    return {FindingKind::overlap_error,
            severity_where_claimed(a.overlap, error, 2 * few_of(scale_of(e, e.own))),
            {},
            "not the spheres' closed form"};
  }
  Pair asked = e.pair;
  bool is_limit = false;
  for (Body* body : {&asked.body1, &asked.body2})
    for (double* n : {&body->shape.n1, &body->shape.n2})
      if (*n == 2) {
        is_limit = true;
        *n = std::nextafter(2.0, 3.0);
      }
  if (!is_limit) return {};
  return compare(e, asked, {a.overlap, a.normal, a.point1, a.point2, 2, 2 * point_rounding(e.pair)},
                 "exponents one step above 2");
}

Finding unit_changes_nothing(const Evidence& e) {
  if (!e.solve || !in_normal_range(e.pair)) return {};
  const double unit = 1024;
  const auto got = answer_to(e, {rescaled(e.pair.body1, unit), rescaled(e.pair.body2, unit), e.pair.motion});
  if (!got || same_contact(e.answer, *got, unit)) return {};
  if (e.is_own) return {FindingKind::asymmetric, wrong_altogether, {}, "other bits in a unit 1024 times smaller"};
  const bool is_apart = is_bare(*got) && !is_bare(e.answer);
  const double error = std::abs((is_apart ? 0 : got->overlap) - e.answer.overlap * unit);
  return {
      FindingKind::asymmetric,
      severity_where_claimed(e.answer.overlap, error, 2 * few_of(e.own.condition.overlap * scale_of(e, e.own)) * unit),
      {},
      "another overlap in a unit 1024 times smaller"};
}

Finding repeats_bit_for_bit(const Evidence& e) {
  if (!e.solve || same_contact(e.answer, e.solve(e.pair), 1)) return {};
  return {FindingKind::nondeterministic, wrong_altogether, {}, "the same pair gives other bits"};
}

}  // namespace plumb::law
