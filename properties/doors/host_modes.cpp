#include "properties/doors/host_modes.hpp"

#include <array>
#include <cstdint>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace plumb {
namespace {

#if defined(__x86_64__)
constexpr unsigned flush_to_zero = 0x8000, subnormals_are_zero = 0x40, raised_flags = 0x3f;
constexpr unsigned precision_shift = 8, precision_field = 3U << precision_shift;
constexpr unsigned trapped = FE_INVALID | FE_DIVBYZERO, mask_shift = 7;

constexpr std::array modes{
    HostMode{"flush to zero", FE_TONEAREST, flush_to_zero},
    HostMode{"subnormals are zero", FE_TONEAREST, subnormals_are_zero},
    HostMode{"flush to zero, subnormals are zero", FE_TONEAREST, flush_to_zero | subnormals_are_zero},
    HostMode{"down", FE_DOWNWARD},
    HostMode{"up", FE_UPWARD},
    HostMode{"towards zero", FE_TOWARDZERO},
    HostMode{"down, flush to zero, subnormals are zero", FE_DOWNWARD, flush_to_zero | subnormals_are_zero},
    HostMode{"x87 of 24 bits", FE_TONEAREST, 0, 0},
    HostMode{"x87 of 53 bits", FE_TONEAREST, 0, 2},
    HostMode{"traps", FE_TONEAREST, 0, 3, true},
};

std::uint16_t x87_control() {
  std::uint16_t out = 0;
  asm volatile("fnstcw %0" : "=m"(out));
  return out;
}

unsigned sse_control() {
  return _mm_getcsr() & ~raised_flags;
}

void set_further(const HostMode& mode) {
  const unsigned traps = mode.traps ? trapped : 0U;
  std::feclearexcept(FE_ALL_EXCEPT);  // a flag that is up would trap at once
  const unsigned sse = (sse_control() | mode.mxcsr) & ~(traps << mask_shift);
  const auto x87 = static_cast<std::uint16_t>(
      ((x87_control() & ~precision_field) | (mode.x87_precision << precision_shift)) & ~traps);
  asm volatile("ldmxcsr %0\n\tfldcw %1" : : "m"(sse), "m"(x87) : "memory");
}

/// Whether the control words are those that `mode` sets in a thread that was in the standard mode.
bool is_set(const HostMode& mode) {
  const unsigned traps = mode.traps ? trapped : 0U;
  const unsigned rounding = static_cast<unsigned>(mode.rounding);  // as the x87 has it
  constexpr unsigned standard_sse = 0x1f80, standard_x87 = 0x07f, sse_rounding_shift = 3;
  const unsigned sse = ((standard_sse | mode.mxcsr) & ~(traps << mask_shift)) | (rounding << sse_rounding_shift);
  const unsigned x87 = ((standard_x87 | (mode.x87_precision << precision_shift)) & ~traps) | rounding;
  return sse_control() == sse && x87_control() == x87;
}
#else
constexpr std::array modes{HostMode{"down", FE_DOWNWARD}, HostMode{"up", FE_UPWARD},
                           HostMode{"towards zero", FE_TOWARDZERO}};

void set_further(const HostMode& /*mode*/) {}

bool is_set(const HostMode& mode) {
  return std::fegetround() == mode.rounding;
}
#endif

}  // namespace

std::span<const HostMode> host_modes() {
  return modes;
}

InHostMode::InHostMode(const HostMode& mode) : before_(), mode_(mode) {
  std::fegetenv(&before_);
  std::fesetround(mode.rounding);
  set_further(mode);
}

InHostMode::~InHostMode() {
  std::fesetenv(&before_);
}

bool InHostMode::is_in_force() const {
  return is_set(mode_);
}

}  // namespace plumb
