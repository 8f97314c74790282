// The floating-point modes that a host may be in when it calls plumb: what answers and proofs must not depend on, and what a
// call must leave as it found it (solver/standard_arithmetic.hpp).
#pragma once

#include <cfenv>
#include <span>
#include <string_view>

namespace plumb {

/// A mode: the control words, of which there may be none such on this machine.
struct HostMode {
  std::string_view name = {};
  int rounding = FE_TONEAREST;
  unsigned mxcsr = 0;          ///< further bits: flush to zero, subnormal numbers are zero
  unsigned x87_precision = 3;  ///< field of the x87's control word: 0 for 24 bits, 2 for 53, 3 for 64
  bool traps = false;          ///< invalid operations and divisions by zero raise a signal
};

/// Every one but the standard mode; on other machines than x86 those that <cfenv> knows.
[[nodiscard]] std::span<const HostMode> host_modes();

/// While it lives this thread is in that mode.
class InHostMode {
 public:
  explicit InHostMode(const HostMode& mode);
  ~InHostMode();
  InHostMode(const InHostMode&) = delete;
  InHostMode& operator=(const InHostMode&) = delete;

  /// Whether the thread is still in it.
  [[nodiscard]] bool is_in_force() const;

 private:
  std::fenv_t before_;
  HostMode mode_;
};

}  // namespace plumb
