// What reports/bench/python_batch.py calls: a batch in C++ over the very memory that Python's batch gets, timed here.
#include <algorithm>
#include <cstddef>
#include <ctime>
#include <memory>
#include <vector>

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

/// Answers in memory asked for when they are made, and not cleared.
class NewContacts {
 public:
  explicit NewContacts(std::size_t size) : numbers_(13), words_(4) {
    for (auto& column : numbers_) column = std::make_unique_for_overwrite<double[]>(size);
    for (auto& column : words_) column = std::make_unique_for_overwrite<int[]>(size);
  }
  [[nodiscard]] std::array<double*, 13> numbers() const {
    std::array<double*, 13> out{};
    std::ranges::transform(numbers_, out.begin(), [](const auto& column) { return column.get(); });
    return out;
  }
  [[nodiscard]] std::array<void*, 4> words() const {
    std::array<void*, 4> out{};
    std::ranges::transform(words_, out.begin(), [](const auto& column) { return column.get(); });
    return out;
  }

 private:
  std::vector<std::unique_ptr<double[]>> numbers_;
  std::vector<std::unique_ptr<int[]>> words_;
};

ContactArrays contact_arrays(std::size_t size, double* const* numbers, void* const* words) {
  return {{static_cast<Status*>(words[0]), size},
          {static_cast<Verdict*>(words[1]), size},
          {numbers[0], size},
          three(numbers + 1, size),
          three(numbers + 4, size),
          three(numbers + 7, size),
          three(numbers + 10, size),
          {static_cast<int*>(words[2]), size},
          {static_cast<int*>(words[3]), size}};
}

BatchReport solve_into_new(const PairArrays& pairs) {
  const NewContacts contacts(pairs.size());
  return solve_batch(pairs, {}, contact_arrays(pairs.size(), contacts.numbers().data(), contacts.words().data()));
}

}  // namespace

/// Seconds, or -1 where the batch refuses its arrays. `numbers`: overlap, normal, point 1, point 2, contact point; `words`: status,
/// verdict, iterations, evaluations; null: into memory that is asked for here.
extern "C" double plumb_time_batch(std::size_t size, Columns body1, Columns body2, double* const* numbers,
                                   void* const* words) {
  const PairArrays pairs{body(body1, size), body(body2, size)};
  const double start = thread_seconds();
  const BatchReport report =
      numbers == nullptr ? solve_into_new(pairs) : solve_batch(pairs, {}, contact_arrays(size, numbers, words));
  const double taken = thread_seconds() - start;
  return report.error == BatchError::none ? taken : -1;
}
