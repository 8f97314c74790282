// How far the other systems' contacts are from the common normal, certified answer against certified answer: as the overlap goes to
// zero, by aspect and by exponent.
#pragma once

#include "reports/study/bed.hpp"

namespace plumb::reports {

inline constexpr std::array limit_systems{Problem::deepest_points, Problem::midway, Problem::first_touch};
inline constexpr std::array limit_ratios{1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6};

/// Medians over random orientations of one shape at one overlap ratio.
struct Limit {
  std::string_view sweep;   ///< "ratio", "aspect" or "exponent"
  std::string shape;        ///< "aspect 2"
  double x;                 ///< the value of what is swept
  std::string_view system;  ///< the method of the list that answers the problem
  int pairs = 0, certified = 0;
  double angle, angle_max;  ///< between the normals, degrees
  double point;             ///< between the middles of the two points, over the size
  double overlap;           ///< of the overlaps' difference to the common normal's, over that
};

/// d ~ ratio^order, from the two smallest ratios.
struct Order {
  std::string shape;
  std::string_view system;
  double angle, point, overlap;
  double limit;  ///< the angle at the smallest ratio, degrees
};

struct Limits {
  std::vector<Limit> limits;
  std::vector<Order> orders;
};
[[nodiscard]] Limits find_limits(int pairs, std::uint64_t seed, unsigned threads);

[[nodiscard]] Order order_of(const Limit& larger, const Limit& smaller);

/// Of one shape at one ratio, by system.
[[nodiscard]] std::vector<Limit> limits_of(std::string_view sweep, const std::string& shape, const Bed& bed, double x,
                                           double ratio, int pairs, std::uint64_t seed, unsigned threads);

}  // namespace plumb::reports
