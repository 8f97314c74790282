// The gauges of bodies at their places, as the quadratures of the patch need them.
//
// g(x) = N(M (x - c)), M = diag(1/a, 1/b, 1/c) R' (superellipsoid.hpp). P is a number, or a register that holds one of each of several
// points: exponents cost a chain of eight exponentials and logarithms, each of which waits for the one before.
// Lengths and axes are those of the pair's frame.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "solver/method/elementary.hpp"
#include "solver/method/per_body.hpp"
#include "solver/pose.hpp"

namespace plumb::detail {

struct PlacedGauge {
  explicit PlacedGauge(const PlacedBody<double>& body)
      : PlacedGauge(body.centre, body.shape.semi_axes.cwiseInverse().asDiagonal() * body.rotation.transpose(),
                    body.shape.n1, body.shape.n2) {}

  /// All within `half` of a plane, of which the face on the side of the unit `normal` is meant: an ellipsoid with two axes without end.
  [[nodiscard]] static PlacedGauge slab(const Vec3<double>& centre, const Vec3<double>& normal, double half) {
    Mat3<double> rows = Mat3<double>::Zero();
    rows.row(2) = normal / half;
    return PlacedGauge(centre, rows, 2, 2);
  }

  Matrix3<double> to_gauge;
  Vector3<double> centre;
  double n1, n2;

  [[nodiscard, gnu::always_inline]] bool is_ellipsoid() const { return n1 == 2 && n2 == 2; }

 private:
  PlacedGauge(const Vec3<double>& at, const Mat3<double>& rows, double of_meridian, double of_equator)
      : to_gauge{Vector3<double>::of(rows.row(0)), Vector3<double>::of(rows.row(1)), Vector3<double>::of(rows.row(2))},
        centre(Vector3<double>::of(at)), n1(of_meridian), n2(of_equator) {}
};

/// An exponent of each of P's norms.
template <class P>
struct Exponent {
  P p, inverse;
  bool is_two;  ///< all are
};

/// N = (x^p + y^p)^(1/p) of x, y >= 0, and its derivatives. With t = (small/large)^p the exponential's error, |log t| epsilon, comes into
/// N times t/p: no digit of it is lost.
template <class P>
struct PairNorm {
  P value, by_x, by_y;

  [[nodiscard, gnu::always_inline]] static PairNorm of(const P& x, const P& y, const Exponent<P>& n) {
    using std::max;
    using std::min;
    using std::sqrt;
    const P one(1.0), none(0.0), large = max(x, y);
    const P ratio = blend(large > none, min(x, y) / large, none);
    const P power = n.is_two ? ratio * ratio : power_of(ratio, n.p);
    const P root = n.is_two ? sqrt(one + power) : detail::exp_to_normal(P(detail::log_above_1(power) * n.inverse));
    // (large/N)^(p-1) = root / sum, and (small/N)^(p-1) is (small/large)^(p-1) times that.
    const P by_large = root / (one + power), by_small = blend(ratio > none, by_large * (power / ratio), none);
    const auto is_x_larger = x >= y;
    return {large * root, blend(is_x_larger, by_large, by_small), blend(is_x_larger, by_small, by_large)};
  }

 private:
  /// Of a ratio up to 1; 0 where the power is no normal number.
  [[nodiscard, gnu::always_inline]] static P power_of(const P& ratio, const P& exponent) {
    using std::max;
    const P least(std::numeric_limits<double>::min()), lowest(-700.0), none(0.0);
    const P logarithm = detail::log_of_normal(P(max(ratio, least))) * exponent;
    return blend(logarithm > lowest, detail::exp_to_normal(P(max(logarithm, lowest))), none);
  }
};

/// The same vector for all of P.
template <class P>
[[nodiscard, gnu::always_inline]] inline Vector3<P> for_all(const Vector3<double>& v) {
  return {P(v.x), P(v.y), P(v.z)};
}
template <class P>
[[nodiscard, gnu::always_inline]] inline Matrix3<P> for_all(const Matrix3<double>& m) {
  return {for_all<P>(m.row0), for_all<P>(m.row1), for_all<P>(m.row2)};
}
/// One vector of the bodies 1, one of the bodies 2.
template <class P>
[[nodiscard, gnu::always_inline]] inline Vector3<TwoNumbers<P>> of_each(const Vector3<P>& a, const Vector3<P>& b) {
  return {{a.x, b.x}, {a.y, b.y}, {a.z, b.z}};
}

/// g and its gradient (1/length).
template <class P>
struct GaugeAt {
  P value;
  Vector3<P> gradient;
};

/// The gauge of one body at as many points as P has numbers, or of two bodies.
template <class P>
struct Gauge {
  Matrix3<P> to_gauge;
  Vector3<P> centre;
  Exponent<P> n1, n2;

  [[nodiscard, gnu::always_inline]] static Gauge of(const PlacedGauge& body) {
    const auto exponent = [](double n) { return Exponent<P>{P(n), P(1 / n), n == 2}; };
    return {for_all<P>(body.to_gauge), for_all<P>(body.centre), exponent(body.n1), exponent(body.n2)};
  }

  /// The gradient is zero at the centre, where there is none.
  [[nodiscard, gnu::always_inline]] GaugeAt<P> at(const Vector3<P>& x) const { return from_centre(x - centre); }
  [[nodiscard, gnu::always_inline]] GaugeAt<P> from_centre(const Vector3<P>& v) const {
    using std::abs;
    using std::copysign;
    const Vector3<P> u = to_gauge * v;
    if (n1.is_two && n2.is_two) {
      const P value = length(u), none(0.0);
      return {value, to_gauge.transposed_times(u * blend(value > none, P(1.0) / value, none))};
    }
    const PairNorm<P> inner = PairNorm<P>::of(abs(u.x), abs(u.y), n2),
                      outer = PairNorm<P>::of(inner.value, abs(u.z), n1);
    const Vector3<P> by_u{copysign(outer.by_x * inner.by_x, u.x), copysign(outer.by_x * inner.by_y, u.y),
                          copysign(outer.by_y, u.z)};
    return {outer.value, to_gauge.transposed_times(by_u)};
  }
};

/// Of both bodies, a point each.
template <class P>
using BothGauges = Gauge<TwoNumbers<P>>;

template <class P>
[[nodiscard, gnu::always_inline]] inline BothGauges<P> gauges_of(const std::array<PlacedGauge, 2>& bodies) {
  const Gauge<P> a = Gauge<P>::of(bodies[0]), b = Gauge<P>::of(bodies[1]);
  const auto both = [](const Exponent<P>& m, const Exponent<P>& n) {
    return Exponent<TwoNumbers<P>>{{m.p, n.p}, {m.inverse, n.inverse}, m.is_two && n.is_two};
  };
  return {{of_each(a.to_gauge.row0, b.to_gauge.row0), of_each(a.to_gauge.row1, b.to_gauge.row1),
           of_each(a.to_gauge.row2, b.to_gauge.row2)},
          of_each(a.centre, b.centre),
          both(a.n1, b.n1),
          both(a.n2, b.n2)};
}

}  // namespace plumb::detail
