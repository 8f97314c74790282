// Which numbers of a failing case matter, and how far each can be changed, alone, until the finding is gone.
#pragma once

#include <optional>
#include <vector>

#include "fuzz/shrink/shrink.hpp"

namespace plumb {

/// One number, the others as they are. At every value that was tried from low to high the finding is there, low and high
/// among them.
struct Range {
  Number number;
  double low = 0, high = 0;
  std::optional<double> gone_below, gone_above;  ///< the nearest values where it is not
  bool open_low = false, open_high = false;  ///< there up to the probed end; neither gone nor open: not tried so far
  std::size_t tried = 0;                     ///< values, the case's own among them
  bool finished = true;                      ///< false: Trials::is_over came first

  [[nodiscard]] bool matters() const { return gone_below || gone_above; }
};

/// Of all numbers of the description; the finding's kind counts, whatever its severity. Lengths are probed from a tenth to
/// ten times, exponents over the domain, angles all round, an overlap ratio from a thousandth to 0.9, other numbers as far as
/// a size off; all within the domain.
[[nodiscard]] std::vector<Range> find_ranges(const Shrunk& shrunk, const Solver& solver, TrialCounts& counts);

}  // namespace plumb
