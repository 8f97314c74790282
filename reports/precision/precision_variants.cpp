#include "reports/precision/precision_variants.hpp"

#include <numbers>

#include "reports/precision/precision_error.hpp"
#include "reports/precision/precision_methods.hpp"
#include "solver/diagnosis.hpp"

namespace plumb::reports {
namespace {

Contact<double> status_of(Status status, int iterations) {
  Contact<double> out;
  out.status = status;
  out.iterations = iterations;
  return out;
}

template <class S>
Variant in_scalar(const Solver& solver, SolveFunction<S> solve, double tolerance) {
  Want want;
  want.tolerance = tolerance;
  const auto timed = [solve, want](const Pair& pair) {
    const Contact<S> answer = solve(pair, want, nullptr);
    return status_of(answer.status, answer.iterations);
  };
  const auto judged = [solve, want](const Pair& pair) { return widened(solve(pair, want, nullptr)); };
  return {solver.name, std::string(name_of_scalar<S>), "", tolerance, solver.abilities.problem, timed, judged};
}

/// The C door asks for no tolerance.
Variant of_peer(const Solver& solver) {
  const auto answer = [solver](const Pair& pair) { return solver.solve(pair, {}, nullptr); };
  return {solver.name,
          std::string(name_of_scalar<double>),
          "",
          0,
          solver.abilities.problem,
          answer,
          [answer](const Pair& pair) { return widened(answer(pair)); }};
}

/// Whether a check of the answer in double holds.
using Check = std::function<bool(const Pair&, const Contact<double>&)>;

Variant checked(const Solver& solver, std::string_view certificate, const Check& check) {
  const auto answer = [solve = solver.solve, check](const Pair& pair) {
    Contact<double> out = solve(pair, {}, nullptr);
    if (out.status == Status::converged && !check(pair, out)) out.status = Status::stalled;
    return out;
  };
  Variant out = of_peer(solver);
  out.certificate = certificate;
  out.timed = answer;
  out.judged = [answer](const Pair& pair) { return widened(answer(pair)); };
  return out;
}

/// What a user can afford: the normals at the two points anew, opposite, and the points on a line along them. Where the points are one
/// to rounding there is no line.
bool has_small_residual(const Pair& pair, const Contact<double>& answer) {
  constexpr double degrees = 0.01;
  const Diagnosis d = diagnose(pair, answer.point1, answer.point2, answer.overlap < 0 ? -1 : 1);
  return d.n1_n2 <= degrees && !(d.d_n1 > degrees) && !(d.d_n2 > degrees);
}

void append_tolerances(const Solver& solver, const Method& method, std::vector<Variant>& out) {
  constexpr std::array digits{1e-14, 1e-30, 0.0};
  for (const double t : tolerances)
    out.push_back(in_scalar<float>(solver, find_method_in<float>(method.name)->solve, t));
  for (const double t : tolerances) out.push_back(in_scalar<double>(solver, method.solve, t));
  for (const double t : tolerances)
    out.push_back(in_scalar<long double>(solver, find_method_in<long double>(method.name)->solve, t));
  const SolveFunction<Real50> solve = find_iteration<Real50>(solver.name);
  if (solve == nullptr) return;
  for (const double t : digits) {
    out.push_back(in_scalar<Real50>(solver, solve, t));
    out.back().timed = nullptr;
  }
}

void append_certificates(const Solver& solver, std::vector<Variant>& out) {
  if (solver.abilities.problem == Problem::common_normal)
    out.push_back(checked(solver, "residual", has_small_residual));
  if (solver.name != "auto") return;
  for (const Effort effort : efforts)
    out.push_back(checked(solver, name(effort), [effort](const Pair& pair, const Contact<double>&) {
      return find_reference(pair, effort).global == Claim::proved;
    }));
}

}  // namespace

std::vector<Variant> variants(const std::vector<Solver>& solvers) {
  std::vector<Variant> out;
  for (const Solver& solver : solvers)
    if (const Method* method = find_method(solver.name)) {
      append_tolerances(solver, *method, out);
      append_certificates(solver, out);
    } else {
      out.push_back(of_peer(solver));
    }
  return out;
}

}  // namespace plumb::reports
