// What of the patch is compiled for each instruction set: eight rays, rims, fans or meridians side by side.
#pragma once

#include <optional>
#include <span>

#include "solver/patch/eight.hpp"
#include "solver/patch/placed_gauge.hpp"

namespace plumb::detail {

struct FramedLens;
struct Rims;
struct Fans;
struct Halves;

/// The same bits with each of them.
struct LensKernel {
  /// The t of `count` rays' exits from each body.
  void (*find_exits)(const std::array<PlacedGauge, 2>& bodies, const Vector3<double>& from, const Vector3<Eight>& along,
                     int count, double accuracy, std::array<Eight, 2>& exits);
  bool (*find_rims)(const FramedLens& lens, const Circle& azimuths, double accuracy, Rims& rims);
  std::optional<Halves> (*add_fans)(const Fans& fans, const Rims& rims);
  Halves (*add_meridians)(const FramedLens& lens, const Circle& azimuths, double accuracy, double share, int panels);
};

extern const LensKernel lens_kernel_baseline, lens_kernel_avx2, lens_kernel_avx512;

/// Those that this build has and this machine runs, the narrowest first.
[[nodiscard]] std::span<const LensKernel* const> lens_kernels();
/// The widest.
[[nodiscard]] inline const LensKernel& lens_kernel() {
  return *lens_kernels().back();
}

}  // namespace plumb::detail
