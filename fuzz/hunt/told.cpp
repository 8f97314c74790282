#include "fuzz/hunt/told.hpp"

#include <fmt/format.h>

namespace plumb::hunting {
namespace {

std::string text_of(const Vec3<double>& v) {
  return fmt::format("({}, {}, {})", v[0], v[1], v[2]);
}

std::string numbers(double overlap, const Vec3<double>& normal, const Vec3<double>& point1,
                    const Vec3<double>& point2) {
  return fmt::format("overlap {}, normal {}, points {} and {}", overlap, text_of(normal), text_of(point1),
                     text_of(point2));
}

std::string expected(const Pair& pair, Problem problem) {
  Judge judge(pair);
  const Solution& found = judge.solution(problem);
  const std::string verdict(name(judge.reference().verdict));
  if (!found.solved) return verdict;
  return verdict + ", " +
         numbers(static_cast<double>(found.overlap), found.normal.cast<double>(), found.point1.cast<double>(),
                 found.point2.cast<double>());
}

std::string got(const JudgedAnswer& judged) {
  const Contact<double>& answer = judged.answer;
  if (answer.method.empty()) return judged.judgement.finding.detail;
  return fmt::format("{}, {}, {}", name(answer.status), name(answer.verdict),
                     numbers(answer.overlap, answer.normal, answer.point1, answer.point2));
}

}  // namespace

std::string nothing_text(const Hunted& hunted, const std::string& solver) {
  return fmt::format(
      "{}: no finding in {} inputs, {} of them pairs that it takes, {} judged; worst from plumb's own answers: normal "
      "{:.3g} degrees, overlap {:.3g} of the size",
      solver, hunted.inputs, hunted.answered, hunted.judged_pairs, hunted.worst_angle_deg, hunted.worst_overlap);
}

std::string expected_and_got(const Explained& explained, const Solver& solver) {
  const Shrunk& shrunk = explained.shrunk;
  return fmt::format("  expected  {}\n  got       {}\n", expected(shrunk.pair, solver.abilities.problem),
                     got(shrunk.found));
}

}  // namespace plumb::hunting
