// What this machine runs beyond the baseline of its kind.
#pragma once

namespace plumb {

#if defined(__x86_64__)
[[nodiscard]] inline bool runs_avx2() {
  return __builtin_cpu_supports("avx2") != 0;
}
/// With the kin that builds ask for: F, DQ, BW and VL.
[[nodiscard]] inline bool runs_avx512() {
  return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
         __builtin_cpu_supports("avx512bw") != 0 && __builtin_cpu_supports("avx512vl") != 0;
}
#endif

}  // namespace plumb
