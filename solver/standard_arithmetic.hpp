// The floating-point mode that plumb computes in, whatever mode its host is in. Game engines and programs linked with -ffast-math
// run with subnormal numbers flushed to zero, interval libraries with another rounding, some with traps; proofs, scaling by
// powers of two and the methods' last digits hold in the standard mode alone.
#pragma once

#include <cfenv>
#include <cstdint>

namespace plumb {

/// While it lives the thread rounds to nearest, keeps subnormal numbers, traps nothing and has the x87's full precision; the
/// host's mode is put back at its end, and its flags with it where it was another. What is computed under it has to go through memory that others see, as
/// references and results of functions that are not inlined do: compilers move other arithmetic past a change of mode.
class StandardArithmetic {
 public:
  StandardArithmetic() : is_hosts_(is_in_force()) {
    if (is_hosts_) return;
    std::fegetenv(&host_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~StandardArithmetic() {
    if (!is_hosts_) std::fesetenv(&host_);
  }
  StandardArithmetic(const StandardArithmetic&) = delete;
  StandardArithmetic& operator=(const StandardArithmetic&) = delete;

 private:
  /// By the control words, in a few instructions; false on machines whose words are not known here, which costs two calls.
  [[nodiscard]] static bool is_in_force() {
#if defined(__x86_64__)
    constexpr std::uint32_t raised_flags = 0x3f, standard_sse = 0x1f80;
    constexpr std::uint16_t standard_x87 = 0x37f;
    std::uint32_t sse = 0;
    std::uint16_t x87 = 0;
    asm volatile("stmxcsr %0\n\tfnstcw %1" : "=m"(sse), "=m"(x87));
    return (sse & ~raised_flags) == standard_sse && x87 == standard_x87;
#else
    return false;
#endif
  }

  std::fenv_t host_;
  bool is_hosts_;
};

}  // namespace plumb
