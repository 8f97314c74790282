// A double whose every operation that is not exact is rounded up or down at random: stochastic rounding, with probabilities by
// which the mean is exact. Solved several times in it, a problem shows how far rounding moves its answer.
//
// Source     M. Croci, M. Fasi, N. J. Higham, T. Mary, M. Mikaitis: Stochastic rounding: implementation, error analysis and
//            applications. Royal Society Open Science 9: 211631 (2022). Random rounding is older: CESTAC (Vignes 1974), CADNA,
//            Verificarlo
// + - * /    the error of the result rounded to nearest is a double, found by Knuth's TwoSum and by fused multiply-adds, as
// sqrt       that of / and sqrt is to 53 bits; with the probability |error| / (distance to the neighbour on that side) the
//            neighbour is taken
// exp pow .. in x87's long double, rounded to double in the same way: probabilities to 1 / 2048
// Exact      what a double holds: comparisons, signs, powers of two, integers, and conversions
// To nearest where an error is no double: beside the largest numbers, and below 1e-290, the nearer to 1e-308 the more
// Bits       of the rounding are the seed's, for one build: in which order the operands of an expression are evaluated is the
//            compiler's choice
#pragma once

#include <Eigen/Core>
#include <compare>
#include <concepts>
#include <cstdint>
#include <limits>

#include "solver/scalar.hpp"

namespace plumb {

/// Of this thread, from here on.
void seed_rounding(std::uint64_t seed);

class Stochastic {
 public:
  constexpr Stochastic() = default;
  // NOLINTNEXTLINE(google-explicit-constructor,hicpp-explicit-conversions): as double takes them
  constexpr Stochastic(double value) : value_(value) {}
  template <std::floating_point T>
  explicit constexpr operator T() const {
    return static_cast<T>(value_);
  }

  constexpr Stochastic operator-() const { return -value_; }
  Stochastic& operator+=(Stochastic y) { return *this = *this + y; }
  Stochastic& operator-=(Stochastic y) { return *this = *this - y; }
  Stochastic& operator*=(Stochastic y) { return *this = *this * y; }
  Stochastic& operator/=(Stochastic y) { return *this = *this / y; }

  friend Stochastic operator+(Stochastic x, Stochastic y);
  friend Stochastic operator-(Stochastic x, Stochastic y) { return x + -y; }
  friend Stochastic operator*(Stochastic x, Stochastic y);
  friend Stochastic operator/(Stochastic x, Stochastic y);
  friend Stochastic sqrt(Stochastic x);
  friend Stochastic exp(Stochastic x);
  friend Stochastic log(Stochastic x);
  friend Stochastic pow(Stochastic x, Stochastic y);
  friend Stochastic sin(Stochastic x);
  friend Stochastic cos(Stochastic x);

  friend constexpr bool operator==(Stochastic x, Stochastic y) { return x.value_ == y.value_; }
  friend constexpr auto operator<=>(Stochastic x, Stochastic y) { return x.value_ <=> y.value_; }
  friend Stochastic abs(Stochastic x) { return std::abs(x.value_); }
  friend bool isfinite(Stochastic x) { return std::isfinite(x.value_); }
  friend bool isinf(Stochastic x) { return std::isinf(x.value_); }
  friend bool isnan(Stochastic x) { return std::isnan(x.value_); }
  friend Stochastic frexp(Stochastic x, int* exponent) { return std::frexp(x.value_, exponent); }
  friend Stochastic ldexp(Stochastic x, int exponent) { return std::ldexp(x.value_, exponent); }

 private:
  double value_ = 0;
};

/// The unit roundoff is twice that of rounding to nearest: a result may be a whole distance of neighbours from the exact one.
template <>
[[nodiscard]] inline Stochastic epsilon<Stochastic>() {
  return 2 * std::numeric_limits<double>::epsilon();
}

}  // namespace plumb

template <>
class std::numeric_limits<plumb::Stochastic> : public std::numeric_limits<double> {
  using Double = std::numeric_limits<double>;

 public:
  static constexpr plumb::Stochastic min() noexcept { return Double::min(); }
  static constexpr plumb::Stochastic max() noexcept { return Double::max(); }
  static constexpr plumb::Stochastic lowest() noexcept { return Double::lowest(); }
  static constexpr plumb::Stochastic epsilon() noexcept { return Double::epsilon(); }
  static constexpr plumb::Stochastic round_error() noexcept { return 1.0; }
  static constexpr plumb::Stochastic infinity() noexcept { return Double::infinity(); }
  static constexpr plumb::Stochastic quiet_NaN() noexcept { return Double::quiet_NaN(); }
  static constexpr plumb::Stochastic signaling_NaN() noexcept { return Double::signaling_NaN(); }
  static constexpr plumb::Stochastic denorm_min() noexcept { return Double::denorm_min(); }
};

template <>
struct Eigen::NumTraits<plumb::Stochastic> : Eigen::GenericNumTraits<plumb::Stochastic> {
  enum { RequireInitialization = 0, ReadCost = 1, AddCost = 10, MulCost = 10 };
};
