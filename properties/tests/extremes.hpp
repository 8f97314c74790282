// Pairs at the ends of what doubles can say, drawn by a seed: the same on every machine.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "properties/generators/stream.hpp"
#include "solver/contact.hpp"

namespace plumb {

class Extremes : public Stream {
 public:
  explicit Extremes(std::uint64_t seed) : Stream("extremes", seed, 0) {}

  [[nodiscard]] bool one_in(std::size_t n) { return below(n) == 0; }
  template <class T, std::size_t N>
  [[nodiscard]] T any_of(const T (&values)[N]) {
    return values[below(N)];
  }
  /// 10^low .. 10^high, each power as likely.
  [[nodiscard]] double power_of_ten(double low, double high) { return std::pow(10.0, uniform(low, high)); }
  /// Of either sign, this magnitude.
  [[nodiscard]] double signed_of(double magnitude) { return sign() * magnitude; }
  /// Any double there is, the notorious ones more often.
  [[nodiscard]] double anything() {
    using Limits = std::numeric_limits<double>;
    if (one_in(2)) return std::bit_cast<double>(bits());
    return signed_of(
        any_of({Limits::quiet_NaN(), Limits::infinity(), Limits::max(), Limits::min(), Limits::denorm_min(), 0.0, 1.0,
                1 + Limits::epsilon(), 1e308, 1e-308, 1e300, 1e-300, 1e154, 1e-154, 2.0}));
  }

  [[nodiscard]] Pair legal_pair() {
    const double size = one_in(2) ? 1 : power_of_ten(-300, 300);
    Pair out;
    out.body1 = legal_body(size);
    out.body2 = legal_body(one_in(4) ? power_of_ten(-300, 300) : size);
    if (one_in(4)) out.body1.position = out.body2.position + Vec3<double>(size * sign(), 0, 0);
    for (int k = 0; k < 3; ++k) out.motion[k] = one_in(2) ? 0 : coordinate(1);
    return out;
  }
  /// Ellipsoids of about one size.
  [[nodiscard]] Pair ellipsoids(double distance) {
    Pair out;
    for (Body* body : {&out.body1, &out.body2}) {
      for (int k = 0; k < 3; ++k) body->shape.semi_axes[k] = uniform(0.2, 1);
      for (double& component : body->quaternion) component = uniform(-1, 1);
    }
    for (int k = 0; k < 3; ++k) out.body2.position[k] = distance * uniform(-1, 1);
    return out;
  }
  /// Any doubles in the place of some of a body's.
  void spoil(Body& body) {
    for (int k = 0; k < 3; ++k) {
      if (one_in(6)) body.shape.semi_axes[k] = anything();
      if (one_in(6)) body.position[k] = anything();
      if (one_in(6)) body.quaternion[below(4)] = anything();
    }
    if (one_in(6)) body.shape.n1 = anything();
    if (one_in(6)) body.shape.n2 = anything();
  }

 private:
  static constexpr double most = 1e300;

  [[nodiscard]] double coordinate(double size) {
    switch (below(5)) {
      case 0: return 0;
      case 1: return signed_of(power_of_ten(-300, 300));
      case 2: return signed_of(std::min(size * power_of_ten(0, 30), most));
      default: return signed_of(size * uniform(0, 2));
    }
  }
  [[nodiscard]] double exponent() {
    switch (below(5)) {
      case 0: return 1 + std::numeric_limits<double>::epsilon();
      case 1: return 1 + power_of_ten(-15, 0);
      case 2: return power_of_ten(0.5, 6);
      case 3: return uniform(2, 8);
      default: return 2;
    }
  }
  [[nodiscard]] Body legal_body(double size) {
    Body out;
    const double spread = any_of({0.0, 0.5, 3.0, 12.0, 300.0});
    for (int k = 0; k < 3; ++k)
      out.shape.semi_axes[k] = std::max(size * power_of_ten(-spread, 0), std::numeric_limits<double>::denorm_min());
    if (!one_in(3)) {
      out.shape.n1 = exponent();
      out.shape.n2 = exponent();
    }
    for (int k = 0; k < 3; ++k) out.position[k] = coordinate(size);
    const double length = one_in(4) ? power_of_ten(-300, 300) : 1;
    for (double& component : out.quaternion) component = one_in(4) ? 0 : length * uniform(-1, 1);
    if (out.quaternion == std::array<double, 4>{0, 0, 0, 0}) out.quaternion[below(4)] = length;
    return out;
  }
};

}  // namespace plumb
