#include "reports/precision_error.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "reports/quantile.hpp"

namespace plumb::reports {
namespace {

double relative(const Real50& length, double size) {
  return static_cast<double>(Real50(abs(length) / size));
}

Vec3<Real50> precise(const Vec3<long double>& v) {
  return {Real50(v[0]), Real50(v[1]), Real50(v[2])};
}

double distance(const Vec3<long double>& a, const Vec3<Real50>& b, double size) {
  const Vec3<Real50> difference = precise(a) - b;
  return relative(Real50(difference.norm()), size);
}

/// Exact near 0, where a cosine says nothing.
double angle(const Vec3<long double>& a, const Vec3<Real50>& b) {
  const Vec3<Real50> n = precise(a);
  const Real50 across = n.cross(b).norm(), along = n.dot(b);
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
    solution = find_potential_reference(pair, problem);
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

AnswerError error_of(const Contact<long double>& answer, const Truth& truth) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (!truth.known) return {nan, nan, nan};
  return {
      relative(Real50(answer.overlap) - truth.overlap, truth.size),
      std::max(distance(answer.point1, truth.point1, truth.size), distance(answer.point2, truth.point2, truth.size)),
      angle(answer.normal, truth.normal)};
}

Spread spread(std::vector<double> values) {
  std::erase_if(values, [](double x) { return std::isnan(x); });
  return {quantile(values, 0.5), quantile(values, 0.99), quantile(values, 1)};
}

}  // namespace plumb::reports
