#include "properties/doctor/replies.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plumb::doctor {
namespace {

using Vector = Vec3<double>;

/// A NaN is no match.
double or_infinite(double miss) {
  return std::isnan(miss) ? std::numeric_limits<double>::infinity() : miss;
}

double points_miss(const Contact<double>& given, const Contact<double>& told, const Abilities& abilities) {
  if (abilities.points == Points::none) return 0;
  if (abilities.points == Points::two)
    return std::max(or_infinite((given.point1 - told.point1).norm()), or_infinite((given.point2 - told.point2).norm()));
  const bool anywhere_between = abilities.problem == Problem::common_normal;
  return anywhere_between ? distance_to_segment(given.contact_point, told.point1, told.point2)
                          : (given.contact_point - told.contact_point).norm();
}

/// Of bodies that are certified to overlap nothing but the unclaimed fields is taken away: it may say by mistake that they are apart.
Contact<double> claimed_of(const Abilities& abilities, const Question& question, Contact<double> answer) {
  Abilities claims = abilities;
  if (question.truth.verdict == Verdict::overlapping) claims.apart = Apart::distance;
  if (answer.status != Status::converged) answer.overlap = std::numeric_limits<double>::quiet_NaN();
  return claims.claimed(answer);
}

double median(std::vector<double> values, double without) {
  if (values.empty()) return without;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

bool is_bare_verdict(const Contact<double>& given, const Abilities& abilities) {
  return abilities.apart != Apart::distance && given.verdict == Verdict::separated && !std::isfinite(given.overlap);
}

double distance_to_segment(const Vector& x, const Vector& a, const Vector& b) {
  const Vector d = b - a;
  const double square = d.squaredNorm(), share = square > 0 ? std::clamp((x - a).dot(d) / square, 0.0, 1.0) : 0;
  return (x - a - share * d).norm();
}

Miss worse(const Miss& a, const Miss& b) {
  return {a.verdict || b.verdict, std::max(a.overlap, b.overlap), std::max(a.normal, b.normal),
          std::max(a.points, b.points)};
}

Allowance allowance_of(double tolerance) {
  // The coarsest levels that people ask for: 1 degree, 1e-3 of the size. Points move by the normal's turn times a radius of
  // curvature, which is below twice the size in the questions. Above the most, mistakes would pass.
  const double degree = std::numbers::pi / 180, depth = 1e-3, curvature_radius = 2, most_depth = 1e-2, most = 0.1;
  const double turn = std::clamp(std::sqrt(2 * tolerance), degree, most);
  return {std::clamp(2 * tolerance, depth, most_depth), turn, std::min(curvature_radius * turn, most)};
}

double severity_of(const Miss& miss, const Allowance& allowance) {
  if (miss.verdict) return std::numeric_limits<double>::infinity();
  return std::max({miss.overlap / allowance.overlap, miss.normal / allowance.normal, miss.points / allowance.points});
}

Miss miss_between(const Contact<double>& given, const Told& told, const Abilities& abilities) {
  Miss out;
  out.verdict = given.verdict != told.contact.verdict;
  if (is_bare_verdict(given, abilities)) return out;
  out.overlap = or_infinite(std::abs(given.overlap - told.contact.overlap) / told.size);
  if (abilities.normal)
    out.normal = or_infinite((given.normal - told.contact.normal).norm() / told.contact.normal.norm());
  out.points = or_infinite(points_miss(given, told.contact, abilities) / told.size);
  return out;
}

Reply reply_of(const Abilities& abilities, const Question& question, Contact<double> answer, bool vouched) {
  if (vouched) answer.status = Status::converged;
  const bool says_apart = abilities.apart != Apart::distance && answer.verdict == Verdict::separated;
  Reply out;
  out.raw = answer;
  out.answered = answer.status == Status::converged || says_apart;
  out.contact = claimed_of(abilities, question, answer);
  out.miss = miss_between(out.contact, {question.truth, size_of(question.pair)}, abilities);
  out.right = out.answered && severity_of(out.miss, allowance_of(abilities.tolerance)) <= 1;
  return out;
}

Reply ask(const Solver& solver, const Question& question) {
  return reply_of(solver.abilities, question, solver.solve(question.pair, {}, nullptr), false);
}

Fit fit_to(std::span<const Question> questions, std::span<const Reply> replies) {
  std::vector<double> factors, lengths;
  for (std::size_t i = 0; i < replies.size(); ++i) {
    const Contact<double>& given = replies[i].contact;
    if (!replies[i].answered) continue;
    if (std::isfinite(given.overlap)) factors.push_back(given.overlap / questions[i].truth.overlap);
    if (given.normal.allFinite()) lengths.push_back(given.normal.norm());
  }
  return {median(std::move(factors), 1), median(std::move(lengths), 1)};
}

}  // namespace plumb::doctor
