#include "reports/stability/arithmetic.hpp"

#include <algorithm>
#include <cfenv>
#include <filesystem>

#include "corpus/command/program_folder.hpp"
#include "corpus/solvers/solver.hpp"
#include "properties/doors/host_modes.hpp"
#include "reports/precision/precision_error.hpp"
#include "reports/precision/precision_methods.hpp"
#include "reports/stability/stochastic_methods.hpp"
#include "solver/scalar.hpp"

namespace plumb::reports {
namespace {

using Answer = std::optional<Contact<Real50>>;

template <class S>
Answer solve_in(std::string_view method, const Pair& pair) {
  const SolveFunction<S> solve = find_iteration<S>(method);
  if (solve == nullptr) return std::nullopt;
  return widened(solve(pair, {}, nullptr));
}

template <class S>
Arithmetic scalar(bool may_lose) {
  return {std::string(name_of_scalar<S>), static_cast<double>(std::numeric_limits<S>::epsilon()), 1, may_lose,
          [](std::string_view method, const Pair& pair, std::uint64_t) { return solve_in<S>(method, pair); }};
}

Arithmetic rounded(const char* name, int mode) {
  return {name, epsilon<double>(), 1, false,
          [mode](std::string_view method, const Pair& pair, std::uint64_t) -> Answer {
            const SolveFunction<double> solve = find_iteration<double>(method);
            if (solve == nullptr) return std::nullopt;
            Contact<double> answer;
            {
              const InHostMode rounding({.rounding = mode});
              answer = solve(pair, {}, nullptr);
            }
            return widened(answer);
          }};
}

/// What it holds are doubles.
Contact<double> plain(const Contact<Stochastic>& from) {
  const auto vector = [](const Vec3<Stochastic>& v) {
    return Vec3<double>(static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2]));
  };
  Contact<double> out;
  out.status = from.status;
  out.verdict = from.verdict;
  out.overlap = static_cast<double>(from.overlap);
  out.normal = vector(from.normal);
  out.point1 = vector(from.point1);
  out.point2 = vector(from.point2);
  return out;
}

Arithmetic stochastic(std::uint64_t samples) {
  return {std::string(name_of_scalar<Stochastic>), static_cast<double>(epsilon<Stochastic>()), samples, false,
          [](std::string_view method, const Pair& pair, std::uint64_t sample) -> Answer {
            const SolveFunction<Stochastic> solve = find_iteration<Stochastic>(method);
            if (solve == nullptr) return std::nullopt;
            seed_rounding(sample);
            return widened(plain(solve(pair, {}, nullptr)));
          }};
}

/// `auto`, compiled as the file's name says (reports/stability/variants.cmake).
Arithmetic compiled(const std::filesystem::path& library) {
  std::string name = library.stem().string();
  std::replace(name.begin(), name.end(), '_', ' ');
  const Solver solver = load_solver_in_process(library.string());
  return {name, epsilon<double>(), 1, false,
          [solver](std::string_view method, const Pair& pair, std::uint64_t) -> Answer {
            if (method != "auto") return std::nullopt;
            return widened(solver.solve(pair, {}, nullptr));
          }};
}

std::vector<std::filesystem::path> variants_built() {
  std::vector<std::filesystem::path> out;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(program_folder() / "variants", none))
    if (entry.path().extension() == ".so") out.push_back(entry.path());
  std::sort(out.begin(), out.end());
  return out;
}

Answer answer_of(const Solver& solver, const Pair& pair) {
  if (!solver.abilities.takes(pair)) return std::nullopt;
  try {
    return widened(solver.abilities.claimed(solver.solve(pair, {}, nullptr)));
  } catch (const NoAnswer&) {
    return Contact<Real50>{};
  }
}

}  // namespace

Arithmetic with_foreign(Arithmetic arithmetic, std::vector<Solver> foreign) {
  const auto ours = arithmetic.solve;
  arithmetic.solve = [ours, foreign = std::move(foreign)](std::string_view method, const Pair& pair,
                                                          std::uint64_t sample) -> Answer {
    for (const Solver& solver : foreign)
      if (solver.name == method) return answer_of(solver, pair);
    return ours(method, pair, sample);
  };
  return arithmetic;
}

std::vector<Arithmetic> arithmetics(std::uint64_t samples) {
  std::vector<Arithmetic> out{scalar<double>(false),
                              rounded("double, down", FE_DOWNWARD),
                              rounded("double, up", FE_UPWARD),
                              rounded("double, to zero", FE_TOWARDZERO),
                              stochastic(samples),
                              scalar<float>(true),
                              scalar<long double>(false),
                              scalar<Real50>(true)};
  for (const auto& library : variants_built()) out.push_back(compiled(library));
  return out;
}

}  // namespace plumb::reports
