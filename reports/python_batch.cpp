// What reports/python_batch.py calls: a batch in C++ over the very memory that Python's batch gets, timed here.
#include <cstddef>
#include <ctime>

#include "solver/batch/batch.hpp"

namespace {

using namespace plumb;

using Columns = const double* const*;

std::array<std::span<const double>, 3> three(Columns from, std::size_t size) {
  return {std::span(from[0], size), std::span(from[1], size), std::span(from[2], size)};
}

/// Semi-axes (3), position (3), quaternion (4), exponents (2, or null pointers: 2 for all).
BodyArrays body(Columns from, std::size_t size) {
  const auto exponents = [&](std::size_t k) {
    return from[k] == nullptr ? std::span<const double>() : std::span(from[k], size);
  };
  const auto quaternion = [&](std::size_t k) { return std::span(from[6 + k], size); };
  return {three(from, size),
          exponents(10),
          exponents(11),
          three(from + 3, size),
          {quaternion(0), quaternion(1), quaternion(2), quaternion(3)}};
}

std::array<std::span<double>, 3> three(double* const* to, std::size_t size) {
  return {std::span(to[0], size), std::span(to[1], size), std::span(to[2], size)};
}

/// Of the processor, as Python's time.thread_time.
double thread_seconds() {
  timespec now{};
  (void)clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

/// Seconds, or -1 where the batch refuses its arrays. `numbers`: overlap, normal, point 1, point 2, contact point; `words`: status, verdict,
/// iterations, evaluations.
extern "C" double plumb_time_batch(std::size_t size, Columns body1, Columns body2, double* const* numbers,
                                   void* const* words) {
  const PairArrays pairs{body(body1, size), body(body2, size)};
  const ContactArrays contacts{{static_cast<Status*>(words[0]), size},
                               {static_cast<Verdict*>(words[1]), size},
                               {numbers[0], size},
                               three(numbers + 1, size),
                               three(numbers + 4, size),
                               three(numbers + 7, size),
                               three(numbers + 10, size),
                               {static_cast<int*>(words[2]), size},
                               {static_cast<int*>(words[3]), size}};
  const double start = thread_seconds();
  const BatchReport report = solve_batch(pairs, {}, contacts);
  const double taken = thread_seconds() - start;
  return report.error == BatchError::none ? taken : -1;
}
