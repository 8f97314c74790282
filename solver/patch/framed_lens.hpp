// What the quadratures of a lens are given, and what they give back: numbers, for code that is compiled for each instruction set.
#pragma once

#include <bit>

#include "solver/patch/lens_frame.hpp"
#include "solver/patch/lens_moments.hpp"
#include "solver/patch/rays.hpp"

namespace plumb::detail {

/// A lens in its frame (LensFrame).
struct FramedLens {
  std::array<PlacedGauge, 2> bodies;
  Vector3<double> origin, e1, e2, e3;
  Matrix3<double> inverse;
  double determinant;

  FramedLens(const Lens& lens, const LensFrame& frame)
      : bodies(lens.bodies), origin(Vector3<double>::of(frame.origin)), e1(Vector3<double>::of(frame.axes.col(0))),
        e2(Vector3<double>::of(frame.axes.col(1))), e3(Vector3<double>::of(frame.axes.col(2))),
        inverse{Vector3<double>::of(frame.inverse.row(0)), Vector3<double>::of(frame.inverse.row(1)),
                Vector3<double>::of(frame.inverse.row(2))},
        determinant(std::abs(frame.axes.determinant())) {}

  /// Across e3.
  template <class P>
  [[nodiscard, gnu::always_inline]] Vector3<P> across(const P& cosine, const P& sine) const {
    return for_all<P>(e1) * cosine + for_all<P>(e2) * sine;
  }
};

/// Sums over the azimuths 0, 2, 4, 6 of eight, and over the others.
struct Halves {
  Moments<double> even, odd;
};

/// In an order that does not hang on the registers' width.
template <class P>
[[nodiscard, gnu::always_inline]] inline Halves halves(const std::array<Moments<P>, eight / lanes_of<P>>& sums) {
  constexpr std::size_t count = sizeof(Moments<double>) / sizeof(double);
  using Numbers = std::array<P, count>;
  std::array<double, count> even, odd;
  std::array<Numbers, eight / lanes_of<P>> parts;
  for (std::size_t k = 0; k < sums.size(); ++k) parts[k] = std::bit_cast<Numbers>(sums[k]);
  for (std::size_t i = 0; i < even.size(); ++i) {
    Eight all;
    for (std::size_t k = 0; k < sums.size(); ++k) store(parts[k][i], all, static_cast<int>(k) * lanes_of<P>);
    even[i] = (all[0] + all[2]) + (all[4] + all[6]);
    odd[i] = (all[1] + all[3]) + (all[5] + all[7]);
  }
  return {std::bit_cast<Moments<double>>(even), std::bit_cast<Moments<double>>(odd)};
}

}  // namespace plumb::detail
