// All inputs within a relative change of a pair's own, in intervals: how far its overlap function can move, and the bodies
// themselves. The norm is that of sensitivity.hpp; the bounds are derived in solution_set.hpp.
#pragma once

#include <algorithm>
#include <limits>

#include "solver/reference/interval/enclosure.hpp"
#include "solver/reference/interval/interval_mpfi.hpp"

namespace plumb::reference {

/// A bound of |x| over the body: no exponent up to 2 reaches beyond the longest axis, no other beyond the box's corner.
[[nodiscard]] inline Interval18 circumradius(const EnclosedBody<Interval18>& body) {
  using I = Interval18;
  I longest = body.semi_axes[0];
  for (int i = 1; i < 3; ++i)
    if (high(body.semi_axes[i]) > high(longest)) longest = body.semi_axes[i];
  return high_end<I>(std::max(body.n1, body.n2) <= 2 ? longest : length_of<I>(body.semi_axes));
}

/// The changes of a relative size e, in the pair's frame.
struct InputChange {
  using I = Interval18;

  I e, size;

  InputChange(const EnclosedPair<I>& pair, double k)
      : e(I(k) * I(std::numeric_limits<double>::epsilon())), size(pair.size()) {}
  [[nodiscard]] I both_ways() const { return hull<I>(I(-e), e); }
  [[nodiscard]] bool keeps_exponents(const EnclosedBody<I>& body) const {
    return low(I(I(std::min(body.n1, body.n2)) * (I(1.0) - e))) > 1 && high(e) < 1e-3;
  }

  /// Of a support function.
  [[nodiscard]] I of_body(const EnclosedBody<I>& body) const {
    const I less = I(1.0) - e, rate = -log(less) * log(I(2.0)) / less;
    const I factor = (I(1.0) + e) * exp(I(rate / I(body.n1) + rate / I(body.n2)));
    return circumradius(body) * (factor - I(1.0) + I(2.0) * e * factor);
  }
  [[nodiscard]] I delta(const EnclosedPair<I>& pair) const {
    return high_end<I>(I(of_body(pair.body1) + of_body(pair.body2) + I(2.0) * root<I>(I(3.0)) * e * size));
  }
};

/// Dual exponents of every n within the change: m falls as n grows.
[[nodiscard]] inline DualExponent<Interval18> widened(double n, const InputChange& by) {
  using I = Interval18;
  DualExponent<I> out(n);
  const I all = I(n) * (I(1.0) + by.both_ways()), less = all - I(1.0);
  out.minus_one = I(1.0) / less;
  out.m = I(1.0) + out.minus_one;
  out.minus_two = out.minus_one - I(1.0);
  return out;
}

/// Every body within the change; its exponents stand in m1 and m2 alone.
[[nodiscard]] inline EnclosedBody<Interval18> widened(const EnclosedBody<Interval18>& body, const InputChange& by) {
  using I = Interval18;
  EnclosedBody<I> out = body;
  const I factor = I(1.0) + by.both_ways(), turn = I(2.0) * by.both_ways();
  for (int i = 0; i < 3; ++i) out.semi_axes[i] = body.semi_axes[i] * factor;
  for (int i = 0; i < 9; ++i) out.rotation(i / 3, i % 3) = body.rotation(i / 3, i % 3) + turn;
  out.m1 = widened(body.n1, by);
  out.m2 = widened(body.n2, by);
  out.n1 = out.n2 = std::numeric_limits<double>::quiet_NaN();
  out.axis.reset();
  return out;
}

}  // namespace plumb::reference
