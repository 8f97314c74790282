// solve_batch over columns with any stride, as numpy's arrays have them, by several threads.
//
// A column whose values stand side by side is read and written where it is; any other goes through a block of a few hundred
// pairs, which stays in the cache.
#pragma once

#include <array>
#include <cstddef>
#include <functional>

#include "solver/batch/batch.hpp"

namespace plumb::python {

/// One number of each pair; `stride` counts in numbers. Without data: of the input 2 for all, of the answers not wanted.
template <class T>
struct Column {
  T* data = nullptr;
  std::ptrdiff_t stride = 1;
};

/// Semi-axes (3), position (3), quaternion (4), exponents (2).
using BodyColumns = std::array<Column<const double>, 12>;

/// Where the local solve ended, on body 1 (3) and body 2 (3), then where that of the step before did.
template <class T>
using ChartColumns = std::array<Column<T>, 12>;

struct ContactColumns {
  Column<Status> status;
  Column<Verdict> verdict;
  std::array<Column<double>, 13> numbers;  ///< overlap, normal (3), point 1 (3), point 2 (3), contact point (3)
  std::array<Column<int>, 2> counts;       ///< iterations, evaluations
  ChartColumns<double> charts;
};

struct StridedBatch {
  std::size_t size = 0;
  BodyColumns body1, body2;
  ContactColumns contacts;
  Want want;
  ChartColumns<const double> last{};  ///< warm starts; may be the charts of `contacts`
};

struct BatchRun {
  bool complete = true;
  std::size_t alone = 0;  ///< pairs that were handed to `auto` one by one
};

/// The caller's thread and threads - 1 more share the pairs, or as many as the system gives; the answers do not depend on it. The caller's asks
/// `goes_on` between its parts and ends all of them when that is false.
[[nodiscard]] BatchRun solve_strided(const StridedBatch& batch, int threads, const std::function<bool()>& goes_on);

}  // namespace plumb::python
