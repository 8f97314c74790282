#include "opinion.hpp"

#include <cstdio>
#include <functional>

#include "measured.hpp"

namespace second_opinion {
namespace {

/// A flagged answer is wrong where its error is above this many epsilons of what the input's rounding does; a passed one right where it is below
/// that many. Between the two either word is right: how much rounding a solver may add up is a convention.
constexpr double least_error = 2, most_error = 256;

std::string number(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", x);
  return text.data();
}

class Judging {
 public:
  Judging(const Claim& claim, Truth& truth) : claim_(claim), truth_(truth), m_(claim, truth) {}

  Opinion passed() {
    for (const auto& wrong : {&Judging::wrong_verdict, &Judging::wrong_overlap, &Judging::wrong_normal,
                              &Judging::wrong_surface, &Judging::wrong_points, &Judging::wrong_contact_point})
      if (const std::string why = (this->*wrong)(); !why.empty()) return {Verdict::refuted, why + ": " + m_.figures()};
    return {Verdict::confirmed, m_.figures()};
  }

  Opinion flagged() {
    const std::string& finding = claim_.finding;
    if (finding == "missed_contact" || finding == "false_contact") return says_the_other_sign();
    if (finding == "wrong_branch")
      return told(is_off(m_.overlap_error(), claim_.accuracy.overlap, &Sensitivity::overlap));
    if (finding == "overlap_error") return overlap_is_off();
    if (finding == "misaligned") return is_misaligned();
    if (finding == "off_surface") return told(is_off_surface());
    if (finding == "point_error") return points_are_off();
    return {Verdict::unsure, finding + " is not seen in one answer: it takes the solver"};
  }

 private:
  [[nodiscard]] double moved(double Sensitivity::* what) { return truth_.sensitivity().*what; }
  [[nodiscard]] double scale(double Sensitivity::* what) const {
    if (what == &Sensitivity::normal) return 1;
    if (what == &Sensitivity::points) return m_.far();
    return 1 + m_.step() + std::fabs(static_cast<double>(m_.expected().value));
  }

  /// Wrong, whatever rounding is granted to a solver.
  [[nodiscard]] bool is_wrong(double error, double accuracy, double Sensitivity::* what) {
    const double allowed = 1.001 * accuracy + 64 * epsilon * scale(what);
    return error > allowed && error > allowed + most_error * moved(what);
  }
  /// Off by more than the accuracy, or than the rounding of the input explains.
  [[nodiscard]] bool is_off(double error, double accuracy, double Sensitivity::* what) {
    if (accuracy > 0) return error > 0.999 * accuracy;
    const double least = least_error * epsilon * scale(what);
    return error > least && error > least + least_error * moved(what);
  }

  /// A finding that is not confirmed is refuted, unless the input's rounding alone moves the answer by much.
  [[nodiscard]] Opinion told(bool is_confirmed) {
    if (is_confirmed) return {Verdict::confirmed, m_.figures()};
    const double wild = 1e-4;
    if (claim_.accuracy.normal == 0 && std::max(moved(&Sensitivity::normal), moved(&Sensitivity::points)) > wild)
      return {Verdict::unsure, "within rounding of the input the normal turns by " +
                                   number(moved(&Sensitivity::normal)) + " rad: " + m_.figures()};
    return {Verdict::refuted, "not seen: " + m_.figures()};
  }

  [[nodiscard]] std::string wrong_verdict() {
    const auto truth = static_cast<double>(m_.expected().value);
    if (claim_.problem != Problem::common_normal) return "";
    const double allowed = claim_.accuracy.overlap + 64 * epsilon * scale(&Sensitivity::overlap);
    if (std::fabs(truth) <= allowed || claim_.answer.verdict == "undecided") return "";
    const bool says_overlapping = claim_.answer.verdict == "overlapping";
    return says_overlapping == (truth > 0) ? "" : "the verdict is wrong";
  }
  [[nodiscard]] std::string wrong_overlap() {
    const bool wrong = is_wrong(std::fabs(m_.overlap_error()), claim_.accuracy.overlap, &Sensitivity::overlap);
    return wrong ? "the overlap is not the lowest" : "";
  }
  [[nodiscard]] std::string wrong_normal() {
    if (m_.length_error() > 64 * epsilon + claim_.accuracy.normal) return "the normal is no unit vector";
    return is_wrong(m_.normal_error(), claim_.accuracy.normal, &Sensitivity::normal) ? "the normal is another" : "";
  }
  [[nodiscard]] std::string wrong_surface() {
    const double rounding = 64 + claim_.accuracy.points / (epsilon * m_.far());
    return m_.is_on_surfaces(rounding) ? "" : "a point is off its surface by " + number(m_.surface_error());
  }
  /// On a face as good as flat the points are not determined: any pair of them will do.
  [[nodiscard]] std::string wrong_points() {
    const double error = m_.points_error() - 2 * m_.expected().loose, flat = 1e-12;
    if (!is_wrong(error, claim_.accuracy.points, &Sensitivity::points)) return "";
    const bool undetermined = std::max(m_.expected().loose, moved(&Sensitivity::points)) > flat;
    const double allowed = claim_.accuracy.points + most_error * moved(&Sensitivity::normal);
    return undetermined && m_.are_a_pair(most_error, allowed) ? "" : "a point is elsewhere";
  }
  [[nodiscard]] std::string wrong_contact_point() {
    const bool wrong = is_wrong(m_.contact_error(), claim_.accuracy.points, &Sensitivity::points);
    return wrong ? "the contact point is off by " + number(m_.contact_error()) : "";
  }

  /// Of bodies apart a direction proves it, and of overlapping ones that no direction parts them, or a point inside both.
  [[nodiscard]] Opinion says_the_other_sign() {
    const auto truth = static_cast<double>(m_.expected().value);
    const double rounding = least_error * epsilon * scale(&Sensitivity::overlap);
    if (claim_.finding == "false_contact") return told(truth < -rounding && claim_.answer.verdict == "overlapping");
    const Vec<Quad> middle = Quad(0.5) * (m_.expected().point1 + m_.expected().point2);
    const bool is_in_both = truth_.pair().first.gauge(middle).value < 1 &&
                            truth_.pair().second.gauge(middle - truth_.pair().apart).value < 1;
    // In slender bodies that lie deep in each other the middle may be in neither; the search's bound is in doubles.
    const double bound_rounding = 1e-12;
    const bool is_proved = is_in_both || truth_.proven() > bound_rounding;
    if (truth > rounding && !is_proved) return {Verdict::unsure, "not proved to overlap: " + m_.figures()};
    return told(truth > rounding && claim_.answer.verdict != "overlapping");
  }

  [[nodiscard]] Opinion overlap_is_off() {
    const double rounding = least_error * epsilon * (m_.far() + scale(&Sensitivity::overlap));
    const bool contradicts_itself = m_.gap_error() > std::max(rounding, claim_.accuracy.overlap);
    return told(contradicts_itself ||
                is_off(std::fabs(m_.overlap_error()), claim_.accuracy.overlap, &Sensitivity::overlap));
  }

  [[nodiscard]] Opinion is_misaligned() {
    if (is_off(m_.normal_error(), claim_.accuracy.normal, &Sensitivity::normal)) return told(true);
    if (m_.length_error() > std::max(least_error * epsilon, claim_.accuracy.normal))
      return {Verdict::confirmed, "the normal is no unit vector: " + m_.figures()};
    const double most = std::max(least_error * epsilon, 0.999 * claim_.accuracy.normal);
    if (claim_.problem == Problem::common_normal && m_.turned(8) > most)
      return {Verdict::confirmed,
              "the surfaces' normals at the points are not opposite, or not along the line between, by " +
                  number(m_.turned(8)) + " rad: " + m_.figures()};
    const double rounding = 2 * least_error * epsilon * m_.far();
    if (m_.inconsistency() > rounding + claim_.accuracy.points)
      return {Verdict::confirmed,
              "p1 - p2 is not overlap times normal by " + number(m_.inconsistency()) + ": " + m_.figures()};
    return told(claim_.problem == Problem::midway &&
                is_off(m_.contact_error(), claim_.accuracy.points, &Sensitivity::points));
  }

  [[nodiscard]] bool is_off_surface() const {
    return !m_.is_on_surfaces(least_error + 0.999 * claim_.accuracy.points / (epsilon * m_.far()));
  }

  [[nodiscard]] Opinion points_are_off() {
    if (is_off(m_.contact_error(), claim_.accuracy.points, &Sensitivity::points)) return told(true);
    const double error = m_.points_error() - m_.expected().loose;
    return told(is_off(error, claim_.accuracy.points, &Sensitivity::points));
  }

  const Claim& claim_;
  Truth& truth_;
  Measured m_;
};

/// Infinite numbers do not come through JSON: a field that is missing is all that is seen.
bool is_whole(const Answer& a) {
  return a.overlap && a.normal && a.point1 && a.point2;
}

/// Of findings that the answer shows by itself.
std::optional<Opinion> seen_at_once(const Claim& claim) {
  const Answer& a = claim.answer;
  const auto told = [&](bool is_confirmed) {
    return Opinion{is_confirmed ? Verdict::confirmed : Verdict::refuted, "status " + a.status};
  };
  const bool has_answer = a.status == "converged" || claim.is_bare;
  if (claim.finding == "nonconverged") return told(!has_answer);
  if (claim.finding == "not_finite") return told(a.status == "not_finite" || !is_whole(a));
  if (claim.finding == "slow" && a.evaluations > 2000) return told(true);
  for (const char* word : {"crash", "slow", "asymmetric", "nondeterministic"})
    if (claim.finding == word)
      return Opinion{Verdict::unsure, claim.finding + " is not seen in one answer: it takes the solver"};
  if (claim.finding == "none" && !has_answer) return told(false);
  return std::nullopt;
}

}  // namespace

Opinion opinion(const Claim& claim, Truth& truth) {
  if (auto at_once = seen_at_once(claim)) return *at_once;
  if (!claim.is_known_problem) return {Verdict::unsure, "this program does not know that problem"};
  if (!truth.doubt().empty()) return {Verdict::unsure, truth.doubt()};
  Judging judging(claim, truth);
  return claim.finding == "none" ? judging.passed() : judging.flagged();
}

}  // namespace second_opinion
