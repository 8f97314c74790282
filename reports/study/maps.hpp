// The misalignment over all orientations: maps over the line's zenith and body 2's tilt, and shares of random orientations.
//
// Two equal spheroids, overlapping, have three degrees of freedom of orientation: theta_L, theta and phi - phi_L. A map has the first
// two on its axes.
#pragma once

#include "reports/study/bed.hpp"

namespace plumb::reports {

struct MisalignmentMap {
  double aspect, phi, ratio;
  std::string_view method;
  std::vector<double> theta_L, theta;  ///< degrees
  std::vector<std::vector<double>>
      off;                ///< degrees, a row for each theta_L; NaN: no answer, or nothing to hold it against
  int not_certified = 0;  ///< pairs whose common normal is not proved
};

struct MisalignedShare {
  double aspect, ratio;
  std::string_view method;
  int pairs = 0;             ///< whose common normal is proved
  int answers = 0;           ///< converged
  int off = 0;               ///< of these, by more than off_by
  double low = 0, high = 0;  ///< of the share of `off` in `answers`: exact 95 % interval
  double median = 0;         ///< of off, degrees
};

inline constexpr std::array map_aspects{0.5, 2.0};
inline constexpr std::array map_phis{0.0, 45.0, 90.0}, map_ratios{1e-3, 1e-2, 5e-2};

[[nodiscard]] std::vector<MisalignmentMap> find_maps(unsigned threads);
[[nodiscard]] std::vector<MisalignedShare> find_shares(int pairs, std::uint64_t seed, unsigned threads);

}  // namespace plumb::reports
