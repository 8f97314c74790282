#include "reports/stability/certified.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "corpus/json/decimal.hpp"
#include "corpus/json/fields.hpp"
#include "solver/pose.hpp"
#include "solver/reference/condition/solution_set.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb::reports {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

Real50 read_real(const Field& field, Rounding rounding = Rounding::nearest) {
  const Real50 x = read_decimal(field.text(), rounding);
  if (!isfinite(x)) field.fail("is no decimal number");
  return x;
}

Vec3<Real50> read_reals(const Field& field) {
  Vec3<Real50> out;
  for (int i = 0; i < 3; ++i) out[i] = read_real(field.element(static_cast<std::size_t>(i), 3, "numbers"));
  return out;
}

double read_radius(const Field& field) {
  return static_cast<double>(read_real(field, Rounding::up));
}

Bounds read_bounds(const Field& field) {
  Bounds out;
  if (const auto lower = field.find("lower")) out.lower = read_real(*lower, Rounding::down);
  if (const auto upper = field.find("upper")) out.upper = read_real(*upper, Rounding::up);
  return out;
}

Condition read_condition(const Field& field) {
  const auto factor = [&](const char* key) {
    const Field at = field.member(key);
    const double value = at.value() == "infinite" ? infinite : at.number();
    if (!(value >= 0)) at.fail("is negative");
    return value;
  };
  return {factor("overlap"), factor("normal"), factor("points")};
}

/// Nothing where normal or points are not located.
void append_answer(const Field& field, std::vector<CertifiedAnswer>& out) {
  if (!field.has("normal") || !field.has("points") || !field.has("condition")) return;
  const Field points = field.member("points");
  out.push_back({read_bounds(field.member("overlap")), read_reals(field.member("normal")),
                 read_reals(points.element(0, 2, "points")), read_reals(points.element(1, 2, "points")),
                 read_radius(field.member("normal_radius")), read_radius(field.member("points_radius")),
                 read_condition(field.member("condition")), 0, 0});
  const auto nearby = field.find("nearby");
  if (!nearby) return;
  out.back().nearby_normal = nearby->member("normal").number();
  out.back().nearby_points = nearby->member("points").number();
}

std::optional<SolutionBalls> read_balls(const Field& certificate) {
  const auto set = certificate.find("solutions_within");
  if (!set) return std::nullopt;
  SolutionBalls out;
  if (const auto radius = set->find("normal_radius")) {
    out.normal = set->member("normal").vector().cast<Real50>();
    out.normal_radius = radius->number();
  }
  if (const auto radius = set->find("points_radius")) {
    const Field points = set->member("points");
    out.point1 = points.element(0, 2, "points").vector().cast<Real50>();
    out.point2 = points.element(1, 2, "points").vector().cast<Real50>();
    out.points_radius = radius->number();
  }
  return out;
}

void read_certificate(const Field& provenance, CertifiedCase& out) {
  const Field knob = provenance.member("knob"), certificate = provenance.member("certificate");
  out.ladder = provenance.member("generator").text();
  out.knob = knob.member("name").text();
  out.value = knob.member("value").number();
  out.step = static_cast<std::uint64_t>(
      provenance.member("step").whole_number(1, provenance.member("steps").whole_number(1, 1000)));
  out.overlap = read_bounds(certificate.member("overlap"));
  if (!(out.overlap.lower <= out.overlap.upper) || !isfinite(Real50(out.overlap.upper - out.overlap.lower)))
    certificate.member("overlap").fail("is no pair of bounds, lower and upper");
  if (certificate.has("condition")) out.condition = read_condition(certificate.member("condition"));
  append_answer(certificate, out.answers);
  for (const char* others : {"tied", "close"})
    if (const auto list = certificate.find(others))
      for (const Field& other : list->elements()) append_answer(other, out.answers);
  out.balls = read_balls(certificate);
}

double length_of(const Vec3<Real50>& v) {
  const double out = static_cast<double>(Real50(v.norm()));
  return out == out ? out : infinite;
}

double angle_of(const Vec3<Real50>& a, const Vec3<Real50>& b) {
  const double out =
      2 * std::atan2(length_of(a.normalized() - b.normalized()), length_of(a.normalized() + b.normalized()));
  return out == out ? out : infinite;
}

/// What the errors are relative to, and what a world-frame point may be off for its representation.
struct Lengths {
  double scale, sum, far, least;
};

Lengths lengths_of(const CertifiedCase& truth) {
  const double size = size_of(truth.c.pair), depth = std::abs(static_cast<double>(truth.overlap.upper));
  const auto reach = [](const Body& body) { return body.position.lpNorm<Eigen::Infinity>(); };
  return {std::max(size, depth), size + depth, std::max(reach(truth.c.pair.body1), reach(truth.c.pair.body2)),
          std::numeric_limits<double>::denorm_min()};
}

/// And of stochastic rounding, whose epsilon is twice double's.
bool is_of_double(double epsilon) {
  return epsilon <= 2 * std::numeric_limits<double>::epsilon();
}

/// k epsilon times a condition number, and in double and better what nearby inputs do, where that is more. In float a condition
/// number that reaches too far bounds nothing, and nothing else is certified.
double allowed_by(double condition, double nearby, double epsilon) {
  const double linear = reference::rounding_epsilons * epsilon * condition;
  if (!is_of_double(epsilon)) return linear <= reference::first_order_range ? linear : infinite;
  const double epsilons = std::max(1.0, epsilon / std::numeric_limits<double>::epsilon());
  return std::max(std::isfinite(linear) ? linear : 0, epsilons * nearby);
}

/// Relative to `scale`. One step between subnormal numbers is no error: it is what a double of such a length is.
double overlap_error(const Bounds& bounds, const Real50& overlap, double scale) {
  const Real50 off = std::max(Real50(overlap - bounds.upper), Real50(bounds.lower - overlap));
  const double out = static_cast<double>(Real50((off - std::numeric_limits<double>::denorm_min()) / scale));
  return out == out ? std::max(0.0, out) : infinite;
}

Errors3 errors_to(const CertifiedAnswer& truth, const Contact<Real50>& answer, double scale) {
  return {overlap_error(truth.overlap, answer.overlap, scale), angle_of(answer.normal, truth.normal),
          std::max(length_of(answer.point1 - truth.point1), length_of(answer.point2 - truth.point2)) / scale};
}

/// Where a ball takes the place of a condition number the error is still the distance from the answer; what is in the ball is right.
void admit_balls(const CertifiedCase& truth, const Contact<Real50>& answer, const Condition& condition, double rounding,
                 CertifiedErrors& out) {
  if (!truth.balls) return;
  using reference::is_beyond_first_order;
  const SolutionBalls& balls = *truth.balls;
  if (is_beyond_first_order(condition.normal) && angle_of(answer.normal, balls.normal) <= balls.normal_radius)
    out.allowed.normal = std::max(out.allowed.normal, out.error.normal);
  const double off = std::max(length_of(answer.point1 - balls.point1), length_of(answer.point2 - balls.point2));
  if (is_beyond_first_order(condition.points) && off <= balls.points_radius + rounding)
    out.allowed.points = std::max(out.allowed.points, out.error.points);
}

/// How far a point is from a body's surface, to first order; infinite for NaN.
double gap(const Body& body, const Vec3<Real50>& point) {
  const Superellipsoid<Real50> shape{body.shape.semi_axes.cast<Real50>(), body.shape.n1, body.shape.n2};
  const Vec3<Real50> x = rotation<Real50>(body.quaternion).transpose() * (point - body.position.cast<Real50>());
  const NormValue<Real50> g = gauge_gradient<Real50>(shape, x);
  const double out = static_cast<double>(Real50(abs(Real50(g.value - 1)) / g.gradient.norm()));
  return out == out ? out : infinite;
}

/// What needs no certificate but for the sign of the overlap. `rounding`: of a point, a length; `of_overlap`: a length.
std::string contradiction(const CertifiedCase& truth, const Contact<Real50>& answer, double epsilon, double rounding,
                          double of_overlap) {
  const Pair& pair = truth.c.pair;
  const double few = reference::rounding_epsilons * epsilon;
  if (truth.overlap.lower > of_overlap && answer.verdict != Verdict::overlapping) return "says that they are apart";
  if (truth.overlap.upper < -of_overlap && answer.verdict == Verdict::overlapping) return "says that they overlap";
  if (!(std::abs(length_of(answer.normal) - 1) <= few)) return "the normal is no unit vector";
  const Vec3<Real50> d = answer.point1 - answer.point2;
  const double allowed = 2 * (rounding + few * static_cast<double>(abs(answer.overlap)));
  if (!(length_of(Vec3<Real50>(d - answer.overlap * answer.normal)) <= allowed))
    return "p1 - p2 is not overlap times normal";
  const double thinnest = std::min(pair.body1.shape.semi_axes.minCoeff(), pair.body2.shape.semi_axes.minCoeff());
  const bool is_resolved = rounding < thinnest;  // else the world's numbers do not tell a body's sides
  if (is_resolved && !(std::max(gap(pair.body1, answer.point1), gap(pair.body2, answer.point2)) <= rounding))
    return "a point is off its surface";
  return "";
}

}  // namespace

CertifiedCase read_certified(Case c, const std::string& file, int line) {
  CertifiedCase out;
  try {
    const Json document{{"provenance", c.provenance}};
    read_certificate(Field(document).member("provenance"), out);
  } catch (const FieldError& error) {
    throw InputFailure(file, line, error.field, error.what());
  }
  out.c = std::move(c);
  return out;
}

bool CertifiedErrors::is_right() const {
  return broken.empty() && error.overlap <= allowed.overlap && !(error.normal > allowed.normal) &&
         !(error.points > allowed.points);
}

CertifiedErrors errors_against(const CertifiedCase& truth, const Contact<Real50>& answer, double epsilon) {
  const double few = reference::rounding_epsilons * epsilon;
  const Lengths length = lengths_of(truth);
  const double tiny = reference::rounding_epsilons * length.least / length.scale;
  const double of_overlap = few * truth.condition.overlap * length.sum / length.scale + tiny;
  const double rounding = few * (length.sum + length.far) / length.scale + tiny;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  CertifiedErrors out{{overlap_error(truth.overlap, answer.overlap, length.scale), nan, nan},
                      {of_overlap, infinite, infinite},
                      contradiction(truth, answer, epsilon, rounding * length.scale, 2 * of_overlap * length.scale)};
  const double highest = static_cast<double>(truth.overlap.upper) + of_overlap * length.scale;
  double best = infinite;
  for (const CertifiedAnswer& other : truth.answers) {
    const Errors3 error = errors_to(other, answer, length.scale);
    if (static_cast<double>(other.overlap.lower) > highest || !(error.normal < best)) continue;
    best = error.normal;
    out.error.normal = error.normal;
    out.error.points = error.points;
    out.allowed.normal = allowed_by(1 + other.condition.normal, other.nearby_normal, epsilon) + other.normal_radius;
    out.allowed.points =
        allowed_by(other.condition.points * (length.sum / length.scale), other.nearby_points / length.scale, epsilon) +
        rounding + other.points_radius / length.scale;
    if (is_of_double(epsilon)) admit_balls(truth, answer, other.condition, rounding * length.scale, out);
  }
  return out;
}

}  // namespace plumb::reports
