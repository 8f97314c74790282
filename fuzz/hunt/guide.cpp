#include "fuzz/hunt/guide.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "properties/laws/laws_answer.hpp"
#include "properties/laws/screen.hpp"
#include "solver/method/methods.hpp"

namespace plumb::hunting {
namespace {

/// What a guide that knows no condition numbers leaves to rounding: those of ordinary pairs are below 1e6.
constexpr double kRoundingOfNormal = 1e-9, kRoundingOfOverlap = 1e-13;

Solver second_to(Problem problem) {
  if (problem != Problem::common_normal)
    for (const Method& own : methods())
      if (own.problem == problem) return find_solvers(std::string(own.name)).front();
  return find_solvers("auto").front();
}

double degrees_between(const Vec3<double>& a, const Vec3<double>& b) {
  if (!a.allFinite() || !b.allFinite()) return 0;
  const double angle = 2 * std::atan2((a - b).norm(), (a + b).norm());
  return angle / kRadiansPerDegree;
}

double relative_difference(const Pair& pair, const Contact<double>& a, const Contact<double>& b) {
  const double difference = std::abs(a.overlap - b.overlap) / size_of(pair);
  return std::isfinite(difference) ? difference : 0;
}

bool has_wrong_verdict(const Contact<double>& answer, const Contact<double>& second) {
  return second.verdict != Verdict::undecided && answer.verdict != second.verdict &&
         (answer.verdict == Verdict::overlapping || second.verdict == Verdict::overlapping);
}

FindingKind wrong_verdict(const Contact<double>& answer) {
  return answer.verdict == Verdict::overlapping ? FindingKind::false_contact : FindingKind::missed_contact;
}

struct Error {
  FindingKind kind;
  double over;
};

}  // namespace

Guide::Guide(const Abilities& abilities, const Accuracy& accuracy)
    : abilities_(abilities), second_(second_to(abilities.problem)), accuracy_(accuracy) {}

/// The screen holds an answer to rounding, and wants all of it.
bool Guide::is_screened(const Contact<double>& answer) const {
  return accuracy_.is_rounding() && abilities_.problem == Problem::common_normal && law::is_whole(answer);
}

Heat Guide::of(const Pair& pair, const Contact<double>& answer, const Contact<double>& second) const {
  if (answer.status != Status::converged) return {FindingKind::nonconverged, wrong_altogether};
  if (!abilities_.is_whole(answer)) return {FindingKind::not_finite, wrong_altogether};
  Heat out;
  std::array<Error, 4> errors{};
  errors[0] = {FindingKind::point_error, is_screened(answer) ? screen(pair, answer, {}).worst : 0};
  if (second.status == Status::converged) {
    out.angle_deg = degrees_between(answer.normal, second.normal);
    out.overlap = relative_difference(pair, answer, second);
    const double depth = std::abs(second.overlap) / size_of(pair);
    const double allowed = accuracy_.overlap + kRoundingOfOverlap * (1 + depth);
    errors[1] = {FindingKind::misaligned, out.angle_deg * kRadiansPerDegree / (accuracy_.normal + kRoundingOfNormal)};
    errors[2] = {FindingKind::overlap_error, out.overlap / allowed};
    if (has_wrong_verdict(answer, second)) errors[3] = {wrong_verdict(answer), depth / allowed};
  }
  const Error worst =
      *std::max_element(errors.begin(), errors.end(), [](const Error& a, const Error& b) { return a.over < b.over; });
  if (worst.over > 1) out.looks_like = worst.kind;
  out.error = std::min(worst.over, wrong_altogether);
  return out;
}

}  // namespace plumb::hunting
