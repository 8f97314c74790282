#include "reports/precision/precision_error.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "reports/bench/quantile.hpp"
#include "reports/precision/precision_methods.hpp"
#include "solver/scalar.hpp"

namespace plumb::reports {
namespace {

double relative(const Real50& length, double size) {
  return static_cast<double>(Real50(abs(length) / size));
}

double distance(const Vec3<Real50>& a, const Vec3<Real50>& b, double size) {
  const Vec3<Real50> difference = a - b;
  return relative(Real50(difference.norm()), size);
}

/// Exact near 0, where a cosine says nothing.
double angle(const Vec3<Real50>& a, const Vec3<Real50>& b) {
  const Real50 across = a.cross(b).norm(), along = a.dot(b);
  return std::atan2(static_cast<double>(across), static_cast<double>(along));
}

}  // namespace

Truth truth_of(const Pair& pair, Problem problem) {
  Truth out;
  out.size = size_of(pair);
  Solution solution;
  if (problem == Problem::common_normal) {
    const Reference reference = find_reference(pair, Effort::digits);
    out.known = reference.global == Claim::proved && reference.unique == Claim::proved;
    solution = reference.common_normal;
  } else {
    solution = find_problem_reference(pair, problem);
    out.known = true;
  }
  out.known = out.known && solution.solved && solution.proved;
  out.overlap = solution.overlap;
  out.normal = solution.normal;
  out.point1 = solution.point1;
  out.point2 = solution.point2;
  out.condition = solution.condition;
  return out;
}

AnswerError error_of(const Contact<Real50>& answer, const Truth& truth) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (!truth.known) return {nan, nan, nan};
  const auto finite = [](double error) { return error == error ? error : std::numeric_limits<double>::infinity(); };
  return {finite(relative(Real50(answer.overlap - truth.overlap), truth.size)),
          std::max(finite(distance(answer.point1, truth.point1, truth.size)),
                   finite(distance(answer.point2, truth.point2, truth.size))),
          finite(angle(answer.normal, truth.normal))};
}

Spread spread(std::vector<double> values) {
  std::erase_if(values, [](double x) { return std::isnan(x); });
  return {quantile(values, 0.5), quantile(values, 0.99), quantile(values, 1)};
}

Envelope envelope(const std::vector<Truth>& truths, std::string_view scalar, double epsilon) {
  const auto allowed = [&](const auto& of) {
    std::vector<double> out;
    for (const Truth& truth : truths)
      if (truth.known) out.push_back(of(truth) * epsilon);
    return spread(out);
  };
  // Of bodies far apart the overlap's rounding is its own, not the size's.
  const auto scale = [](const Truth& t) { return 1 + relative(t.overlap, t.size); };
  return {scalar, allowed([&](const Truth& t) { return t.condition.overlap * scale(t); }),
          allowed([](const Truth& t) { return t.condition.normal; }),
          allowed([](const Truth& t) { return t.condition.points; })};
}

std::vector<Envelope> envelopes(const std::vector<Truth>& truths) {
  return {envelope(truths, name_of_scalar<float>, epsilon<float>()),
          envelope(truths, name_of_scalar<double>, epsilon<double>()),
          envelope(truths, name_of_scalar<long double>, static_cast<double>(epsilon<long double>())),
          envelope(truths, name_of_scalar<Real50>, static_cast<double>(epsilon<Real50>()))};
}

}  // namespace plumb::reports
