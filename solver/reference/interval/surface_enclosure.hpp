// The surface's charts (shape/chart.hpp) and its gauge in interval arithmetic.
//
// The charts are Lipschitz, and differentiable except at the pole rho = 0 of an outer power 1 and another inner one; there
// the intervals hold every limit of the derivatives, which is what the mean value theorem (and so Krawczyk's test) asks for.
#pragma once

#include "solver/reference/condition/sensitivity.hpp"
#include "solver/reference/interval/enclosure.hpp"
#include "solver/reference/interval/interval_mpfi.hpp"
#include "solver/reference/real.hpp"

namespace plumb::reference {

/// Chart coordinates: component `major` of w is +-1, the two that follow it are the unknowns.
template <class I>
struct SurfaceBox {
  int major = 2;
  IVec3<I> w;

  [[nodiscard]] int minor(int which) const { return (major + 1 + which) % 3; }
};

/// The box of half-width `radius` about a chart point.
[[nodiscard]] SurfaceBox<Interval80> chart_box(const CubePoint<Real50>& at, const Interval80& radius);

/// The surface points that a box of charts stands for, about the body's centre, and a normal of each (the gauge's gradient
/// but for a positive factor), with their derivatives by the two unknowns.
template <class I>
struct SurfaceEnclosure {
  IVec3<I> point, gradient;
  ChartMap<I> dpoint, dgradient;

  [[nodiscard]] SurfaceEnclosure turned(const IMat3<I>& r) const {
    return {r * point, r * gradient, r * dpoint, r * dgradient};
  }
};
/// In the pair's axes. I: Interval80, like all that follows.
template <class I>
[[nodiscard]] SurfaceEnclosure<I> enclose_surface(const EnclosedBody<I>& body, const SurfaceBox<I>& at);

/// Point, unit normal and all their derivatives over the box, body axes. Zero coordinates and any legal exponents.
template <class I>
[[nodiscard]] SurfaceJet<I> surface_jet(const EnclosedBody<I>& body, const SurfaceBox<I>& at);

/// The gauge at x (about the body's centre, the pair's axes) and its gradient.
template <class I>
struct GaugeEnclosure {
  I value;
  IVec3<I> gradient;
};
template <class I>
[[nodiscard]] GaugeEnclosure<I> enclose_gauge(const EnclosedBody<I>& body, const IVec3<I>& x);

}  // namespace plumb::reference
