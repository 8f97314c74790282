#include "solver/batch/batch.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "solver/batch/chunk.hpp"
#include "solver/instruction_set.hpp"
#include "solver/method/methods.hpp"
#include "solver/standard_arithmetic.hpp"

namespace plumb {
namespace {

struct Kernel {
  std::string_view name;
  int lanes;
  bool (*is_available)();
  SolveChunk solve;
};

/// In the order of instruction_sets.
constexpr std::array<Kernel, instruction_sets.size()> kernels{
    Kernel{"baseline", 2, [] { return true; }, solve_chunk_baseline},
#if defined(PLUMB_WIDE_REGISTERS)
    Kernel{"avx2", 4, runs_avx2, solve_chunk_avx2},
    Kernel{"avx512", 8, runs_avx512, solve_chunk_avx512},
#else
    Kernel{"avx2", 4, [] { return false; }, nullptr},
    Kernel{"avx512", 8, [] { return false; }, nullptr},
#endif
};

[[nodiscard]] const Kernel& kernel(InstructionSet set) {
  const InstructionSet chosen = set == InstructionSet::best ? best_instruction_set() : set;
  return kernels[static_cast<std::size_t>(chosen) - 1];
}

/// Whether `check` holds for every span.
template <class Check>
[[nodiscard]] bool each_input(const BodyArrays& body, const Check& check) {
  return std::ranges::all_of(body.semi_axes, check) && std::ranges::all_of(body.position, check) &&
         std::ranges::all_of(body.quaternion, check) && (body.n1.empty() || check(body.n1)) &&
         (body.n2.empty() || check(body.n2));
}

template <class Check>
[[nodiscard]] bool each_output(const ContactArrays& to, const Check& check) {
  return check(to.status) && check(to.verdict) && check(to.overlap) && std::ranges::all_of(to.normal, check) &&
         std::ranges::all_of(to.point1, check) && std::ranges::all_of(to.point2, check) &&
         std::ranges::all_of(to.contact_point, check) && std::ranges::all_of(to.chart1, check) &&
         std::ranges::all_of(to.chart2, check) && std::ranges::all_of(to.separating, check) && check(to.iterations) &&
         check(to.evaluations);
}

template <class Check>
[[nodiscard]] bool each_of(const ChartArrays& charts, const Check& check) {
  return std::ranges::all_of(charts.chart1, check) && std::ranges::all_of(charts.chart2, check);
}
template <class Check>
[[nodiscard]] bool each_of(const BendArrays& bends, const Check& check) {
  return std::ranges::all_of(bends.bend1, check) && std::ranges::all_of(bends.bend2, check);
}

[[nodiscard]] BatchError find_error(const PairArrays& pairs, const ContactArrays& to, InstructionSet set) {
  const auto fits = [&](const auto& span) { return span.size() == pairs.size(); };
  const auto fits_or_empty = [&](const auto& span) { return span.empty() || fits(span); };
  const auto has_all_or_none = [&](const auto& arrays) {
    return each_of(arrays, fits) || each_of(arrays, [](const auto& span) { return span.empty(); });
  };
  if (!each_input(pairs.body1, fits) || !each_input(pairs.body2, fits)) return BatchError::input_lengths;
  if (!has_all_or_none(pairs.last) || !has_all_or_none(pairs.before_last) || !has_all_or_none(pairs.bend))
    return BatchError::input_lengths;
  if (!each_output(to, fits_or_empty)) return BatchError::output_lengths;
  return is_available(set) ? BatchError::none : BatchError::instruction_set;
}

template <class T>
[[nodiscard]] Vec3<T> vector_at(const std::array<std::span<const T>, 3>& spans, std::size_t i) {
  return {spans[0][i], spans[1][i], spans[2][i]};
}

[[nodiscard]] Body body_at(const BodyArrays& from, std::size_t i) {
  const auto exponent = [&](const auto& span) { return span.empty() ? 2 : span[i]; };
  const auto& q = from.quaternion;
  return {{vector_at(from.semi_axes, i), exponent(from.n1), exponent(from.n2)},
          vector_at(from.position, i),
          {q[0][i], q[1][i], q[2][i], q[3][i]}};
}

[[nodiscard]] Contact<double> start_at(const PairArrays& from, std::size_t i) {
  Contact<double> out;
  out.chart1 = vector_at(from.last.chart1, i);
  out.chart2 = vector_at(from.last.chart2, i);
  if (from.before_last.chart1[0].empty()) return out;
  out.last_chart1 = vector_at(from.before_last.chart1, i);
  out.last_chart2 = vector_at(from.before_last.chart2, i);
  if (from.bend.bend1[0].empty()) return out;
  out.bend1 = vector_at(from.bend.bend1, i);
  out.bend2 = vector_at(from.bend.bend2, i);
  return out;
}

template <class T>
void store(const T& value, const std::span<T>& to, std::size_t i) {
  if (!to.empty()) to[i] = value;
}
void store(const Vec3<double>& value, const std::array<std::span<double>, 3>& to, std::size_t i) {
  for (int k = 0; k < 3; ++k) store(value[k], to[static_cast<std::size_t>(k)], i);
}

[[nodiscard]] bool is_asked_for(const std::array<std::span<double>, 3>& spans) {
  return !spans[0].empty() || !spans[1].empty() || !spans[2].empty();
}

/// With what the arrays ask for.
[[nodiscard]] Want wanted(Want want, const ContactArrays& contacts) {
  want.overlap = !contacts.overlap.empty();
  want.normal = is_asked_for(contacts.normal);
  want.points = is_asked_for(contacts.point1) || is_asked_for(contacts.point2) || is_asked_for(contacts.contact_point);
  want.curvature = want.derivatives = want.patch = false;
  return want;
}

void solve_alone(const PairArrays& pairs, Want want, const ContactArrays& to, std::size_t i,
                 const Contact<double>* last) {
  want.normal = want.normal || is_asked_for(to.separating);
  const Pair pair{body_at(pairs.body1, i), body_at(pairs.body2, i)};
  const Contact<double> found = find_method("auto")->solve(pair, want, last);
  store(found.status, to.status, i);
  store(found.verdict, to.verdict, i);
  store(found.overlap, to.overlap, i);
  store(found.normal, to.normal, i);
  store(found.normal, to.separating, i);
  store(found.point1, to.point1, i);
  store(found.point2, to.point2, i);
  store(found.contact_point, to.contact_point, i);
  store(found.chart1, to.chart1, i);
  store(found.chart2, to.chart2, i);
  store(found.iterations, to.iterations, i);
  store(found.evaluations, to.evaluations, i);
}

/// Not inlined: a cold start has no room for an earlier contact on its stack.
[[gnu::noinline]] void solve_warm(const PairArrays& pairs, const Want& want, const ContactArrays& to, std::size_t i) {
  const Contact<double> last = start_at(pairs, i);
  solve_alone(pairs, want, to, i, &last);
}

void solve_from_start(const PairArrays& pairs, const Want& want, const ContactArrays& to, std::size_t i) {
  if (pairs.last.chart1[0].empty())
    solve_alone(pairs, want, to, i, nullptr);
  else
    solve_warm(pairs, want, to, i);
}

}  // namespace

std::string_view name(InstructionSet set) {
  return kernel(set).name;
}

bool is_available(InstructionSet set) {
  return kernel(set).is_available();
}

InstructionSet best_instruction_set() {
  return *std::find_if(instruction_sets.rbegin(), instruction_sets.rend(), is_available);
}

int lanes(InstructionSet set) {
  return kernel(set).lanes;
}

Unsettled solve_together(const Chunk& chunk, InstructionSet set) {
  return kernel(set).solve(chunk);
}

BatchReport solve_batch(const PairArrays& pairs, const Want& want, const ContactArrays& contacts, InstructionSet set) {
  const StandardArithmetic mode;
  BatchReport report{find_error(pairs, contacts, set), 0};
  if (report.error != BatchError::none) return report;
  const Want all = wanted(want, contacts);
  for (std::size_t first = 0; first < pairs.size(); first += Chunk::capacity) {
    const std::size_t count = std::min(Chunk::capacity, pairs.size() - first);
    each_unsettled(solve_together({pairs, all, contacts, first, count}, set), [&](std::size_t k) {
      solve_from_start(pairs, all, contacts, first + k);
      ++report.alone;
    });
  }
  return report;
}

}  // namespace plumb
