#include "fuzz/judging.hpp"

#include <chrono>
#include <cmath>
#include <exception>

#include "properties/screen.hpp"

namespace plumb {
namespace {

Judgement crashed(const std::string& what) {
  Judgement judgement;
  judgement.finding = {FindingKind::crash, std::numeric_limits<double>::infinity(), "returns", what};
  judgement.judged = true;
  return judgement;
}

}  // namespace

JudgedAnswer solve_and_judge(Judge& judge, const Pair& pair, const Solver& solver) {
  using Clock = std::chrono::steady_clock;
  JudgedAnswer out;
  const Want want;
  try {
    const auto start = Clock::now();
    out.answer = solver.solve(pair, want, nullptr);
    out.nanoseconds = std::chrono::duration<double, std::nano>(Clock::now() - start).count();
    out.judgement = judge.judge(
        solver.problem, out.answer, [&](const Pair& related) { return solver.solve(related, want, nullptr); },
        solver.unit_keeps_bits);
  } catch (const std::exception& e) {
    out.judgement = crashed(e.what());
  }
  return out;
}

double beats_reference(const Pair& pair, const Contact<double>& answer, const Reference& reference) {
  if (!answer.normal.allFinite()) return 0;
  const Vec3<long double> normal = answer.normal.cast<long double>();
  const long double length = normal.norm();
  if (!(length > 0.5L && length < 2)) return 0;
  constexpr long double rounding = 1e-15L;  // of depth_along, which knows nothing of intervals
  const long double size = size_of(pair), lowest = reference.overlap.lower.convert_to<long double>();
  const long double better = lowest - depth_along(pair, normal / length);
  return better > rounding * (size + std::abs(lowest)) ? static_cast<double>(better / size) : 0;
}

}  // namespace plumb
