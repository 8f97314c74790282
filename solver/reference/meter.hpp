// What references take, counted and not timed, so that who must stop in time stops alike under any load: the operations of
// MPFI's intervals, the points and steps of 50 digits, the cells of a search. Left out is what is nothing beside them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <exception>
#include <limits>
#include <type_traits>

namespace plumb::reference {

/// Of this thread since it began, in nanoseconds as one machine took them, within a factor of two mostly, of five
/// for blocks all but concentric: what a call took is the difference.
inline thread_local std::int64_t work_counted = 0;
/// Where work_counted must stop.
inline thread_local std::int64_t work_allowed = std::numeric_limits<std::int64_t>::max();

/// Thrown out of a reference that would take more than it may; nothing of it is kept.
struct WorkExceeded : std::exception {
  [[nodiscard]] const char* what() const noexcept override { return "the reference takes more work than it may"; }
};

/// While it lives, references of this thread may take that much more, or what one around it leaves.
class WorkAllowance {
 public:
  explicit WorkAllowance(std::int64_t nanoseconds) : before_(work_allowed) {
    work_allowed = std::min(before_, work_counted + nanoseconds);
  }
  ~WorkAllowance() { work_allowed = before_; }
  WorkAllowance(const WorkAllowance&) = delete;
  WorkAllowance& operator=(const WorkAllowance&) = delete;

 private:
  std::int64_t before_;
};

inline void count_work(int nanoseconds) {
  work_counted += nanoseconds;
  if (work_counted > work_allowed) throw WorkExceeded();
}

inline constexpr int nanoseconds_of_a_node = 3000;  ///< of a cover's search
inline constexpr int nanoseconds_of_a_stationary_cell = 40'000, nanoseconds_of_a_slice = 3000,
                     nanoseconds_of_a_local_solve =
                         200'000;                       ///< of the search for stationary directions, in rough intervals
inline constexpr int nanoseconds_of_a_power = 500;      ///< of Interval18, by double_power.hpp
inline constexpr int nanoseconds_of_a_comparison = 10;  ///< of a proof's valleys, as many as its maker liked
/// In 50 digits: a surface point with its derivatives, of an ellipsoid without powers; a step of the solver's on charts.
inline constexpr int nanoseconds_of_a_point = 200'000, nanoseconds_of_a_round_point = 10'000,
                     nanoseconds_of_a_step = 60'000;

/// An operation of MPFI, or one that sums a series.
template <int bits>
inline void count_operation() {
  count_work(bits > 64 ? 65 : 30);
}
template <int bits>
inline void count_series() {
  count_work(bits > 64 ? 6000 : 2000);
}

/// In 50 digits; what the solvers of machine numbers take is nothing beside it.
template <class S>
inline void count_digits(int nanoseconds) {
  if constexpr (!std::is_floating_point_v<S>) count_work(nanoseconds);
}

}  // namespace plumb::reference
