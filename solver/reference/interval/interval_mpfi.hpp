// MPFI's intervals: every operation, exp and log included, is rounded outwards. The trusted base of a stored proof is therefore MPFI,
// MPFR and GMP, and nothing of the machine's own arithmetic; Interval18 trusts that too.
#pragma once

#include <mpfi.h>

#include <array>
#include <type_traits>

#include "solver/reference/interval/interval.hpp"
#include "solver/reference/meter.hpp"

namespace plumb::reference {

/// An MPFI number that keeps its digits inside itself. Boost.Multiprecision's mpfi_float_backend allocates every temporary,
/// which took half of a proof's time; MPFR's custom interface is made for memory of one's own. MPFI may exchange the two
/// ends' digits (mpfi_revert_if_needed), so that a copy asks MPFR where they are.
template <int Bits>
class Interval {
 public:
  static constexpr int bits = Bits;

  Interval() { zero(); }
  Interval(double x) : Interval() { mpfi_set_d(&x_, x); }
  Interval(const Interval& other) { copy(other); }
  Interval& operator=(const Interval& other) {
    if (this != &other) copy(other);
    return *this;
  }
  ~Interval() = default;

  [[nodiscard]] mpfi_ptr data() { return &x_; }
  [[nodiscard]] mpfi_srcptr data() const { return &x_; }

  Interval operator-() const { return by(mpfi_neg, *this); }
  Interval& operator+=(const Interval& b) { return *this = *this + b; }
  Interval& operator-=(const Interval& b) { return *this = *this - b; }
  Interval& operator*=(const Interval& b) { return *this = *this * b; }
  Interval& operator/=(const Interval& b) { return *this = *this / b; }
  friend Interval operator+(const Interval& a, const Interval& b) { return by(mpfi_add, a, b); }
  friend Interval operator-(const Interval& a, const Interval& b) { return by(mpfi_sub, a, b); }
  friend Interval operator*(const Interval& a, const Interval& b) { return by(mpfi_mul, a, b); }
  friend Interval operator/(const Interval& a, const Interval& b) { return by(mpfi_div, a, b); }
  friend Interval exp(const Interval& a) { return by_series(mpfi_exp, a); }
  friend Interval log(const Interval& a) { return by_series(mpfi_log, a); }
  friend Interval abs(const Interval& a) { return by(mpfi_abs, a); }
  friend Interval sqrt(const Interval& a) { return by(mpfi_sqrt, a); }
  friend Interval sqr(const Interval& a) { return by(mpfi_sqr, a); }
  friend Interval atan2(const Interval& y, const Interval& x) { return by_series(mpfi_atan2, y, x); }

 private:
  using Digits = std::array<mp_limb_t, (Bits + GMP_NUMB_BITS - 1) / GMP_NUMB_BITS>;

  [[nodiscard]] static Interval by(int (*operation)(mpfi_ptr, mpfi_srcptr), const Interval& a) {
    count_operation<Bits>();
    Interval out;
    operation(&out.x_, &a.x_);
    return out;
  }
  [[nodiscard]] static Interval by_series(int (*operation)(mpfi_ptr, mpfi_srcptr), const Interval& a) {
    count_series<Bits>();
    return by(operation, a);
  }
  [[nodiscard]] static Interval by_series(int (*operation)(mpfi_ptr, mpfi_srcptr, mpfi_srcptr), const Interval& a,
                                          const Interval& b) {
    count_series<Bits>();
    return by(operation, a, b);
  }
  [[nodiscard]] static Interval by(int (*operation)(mpfi_ptr, mpfi_srcptr, mpfi_srcptr), const Interval& a,
                                   const Interval& b) {
    count_operation<Bits>();
    Interval out;
    operation(&out.x_, &a.x_, &b.x_);
    return out;
  }

  void zero() {
    mpfr_custom_init_set(&x_.left, MPFR_ZERO_KIND, 0, Bits, left_.data());
    mpfr_custom_init_set(&x_.right, MPFR_ZERO_KIND, 0, Bits, right_.data());
  }
  void copy(const Interval& other) {
    x_ = other.x_;
    left_ = *static_cast<const Digits*>(mpfr_custom_get_significand(&other.x_.left));
    right_ = *static_cast<const Digits*>(mpfr_custom_get_significand(&other.x_.right));
    mpfr_custom_move(&x_.left, left_.data());
    mpfr_custom_move(&x_.right, right_.data());
  }

  Digits left_, right_;
  __mpfi_struct x_;
};

using Interval18 = Interval<63>;   ///< one machine word; its powers are those of double_power.hpp
using Interval19 = Interval<64>;   ///< the same by MPFI alone: for the covers of stored proofs
using Interval80 = Interval<268>;  ///< for the digits of one solution

template <class I>
[[nodiscard]] double low(const I& x) {
  return mpfr_get_d(&x.data()->left, MPFR_RNDD);
}
template <class I>
[[nodiscard]] double high(const I& x) {
  return mpfr_get_d(&x.data()->right, MPFR_RNDU);
}

template <class I>
[[nodiscard]] bool is_lower(const I& a, const I& b) {
  return mpfr_less_p(&a.data()->left, &b.data()->left) != 0;
}

template <class I>
[[nodiscard]] bool is_below(const I& a, const I& b) {
  return mpfr_less_p(&a.data()->right, &b.data()->left) != 0;
}

template <class I>
[[nodiscard]] I low_end(const I& x) {
  I out;
  mpfi_set_fr(out.data(), &x.data()->left);
  return out;
}
template <class I>
[[nodiscard]] I high_end(const I& x) {
  I out;
  mpfi_set_fr(out.data(), &x.data()->right);
  return out;
}

template <class R, class I>
[[nodiscard]] R low_as(const I& x) {
  R out;
  mpfr_set(out.backend().data(), &x.data()->left, MPFR_RNDD);
  return out;
}
template <class R, class I>
[[nodiscard]] R high_as(const I& x) {
  R out;
  mpfr_set(out.backend().data(), &x.data()->right, MPFR_RNDU);
  return out;
}
template <class R, class I>
[[nodiscard]] R middle(const I& x) {
  R out;
  mpfi_mid(out.backend().data(), x.data());
  return out;
}

template <class I, class R>
[[nodiscard]] I enclosing(const R& x) {
  if constexpr (std::is_same_v<R, double>) {
    return I(x);
  } else {
    I out;
    if constexpr (std::is_same_v<R, long double>) {
      mpfr_set_ld(&out.data()->left, x, MPFR_RNDD);
      mpfr_set_ld(&out.data()->right, x, MPFR_RNDU);
    } else {
      mpfi_set_fr(out.data(), x.backend().data());
    }
    return out;
  }
}

template <class I>
[[nodiscard]] I hull(const I& a, const I& b) {
  I out;
  mpfi_union(out.data(), a.data(), b.data());
  return out;
}

template <class I>
[[nodiscard]] I magnitude(const I& x) {
  return abs(x);
}

template <class I>
[[nodiscard]] I square(const I& x) {
  return sqr(x);
}

template <class I>
[[nodiscard]] I root(const I& x) {
  return sqrt(x);
}

template <class I>
[[nodiscard]] bool is_positive(const I& x) {
  return mpfi_is_strictly_pos(x.data()) > 0;
}

/// Angle (rad) between a vector and an axis, from its parts across and along it.
template <class I>
[[nodiscard]] I angle_of(const I& across, const I& along) {
  return atan2(across, along);
}

template <class I>
[[nodiscard]] I times_power_of_two(const I& x, int e) {
  I out;
  mpfi_mul_2si(out.data(), x.data(), e);
  return out;
}

template <class I>
[[nodiscard]] I positive_power(const I& x, const I& e) {
  return exp(I(e * log(x)));
}
template <>
[[nodiscard]] Interval18 positive_power(const Interval18& x, const Interval18& e);

template <class I>
[[nodiscard]] I positive_power_from_above(const I& x, const I& e) {
  I out(0.0);
  count_series<I::bits>();
  const mpfr_ptr top = &out.data()->right;
  mpfr_log(top, &x.data()->right, MPFR_RNDU);
  mpfr_mul(top, top, mpfr_sgn(top) < 0 ? &e.data()->left : &e.data()->right, MPFR_RNDU);
  mpfr_exp(top, top, MPFR_RNDU);
  return out;
}

}  // namespace plumb::reference
