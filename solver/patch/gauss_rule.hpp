// Gauss rules on [0, 1], made by the compiler from the recurrence of their orthogonal polynomials.
//
// Source  Golub & Welsch, Math. Comp. 23 (1969): with p_k orthonormal, the weight at a root x of p_n is 1 / sum_{k<n} p_k(x)^2.
//         The recurrence of the Jacobi polynomials P^(0,beta): Abramowitz & Stegun 22.7.1. Roots of p_n and p_(n-1) interlace.
#pragma once

#include <array>
#include <cstddef>

namespace plumb::detail {

/// Exact for polynomials of degree 2n-1 times the weight s^Beta.
template <std::size_t n>
struct GaussRule {
  std::array<double, n> nodes{}, weights{};
};

/// A monic orthogonal polynomial at x in [-1, 1] and the squared norm that it is divided by, both up to one common factor.
template <int Beta>
class JacobiRecurrence {
 public:
  explicit constexpr JacobiRecurrence(double x) : x_(x) {}

  [[nodiscard]] constexpr double value() const { return value_; }
  [[nodiscard]] constexpr double norm() const { return norm_; }
  /// From degree k to k + 1.
  constexpr void raise() {
    const double next = (x_ - diagonal(degree_)) * value_ - square(degree_) * last_;
    last_ = value_;
    value_ = next;
    ++degree_;
    norm_ *= square(degree_);
  }

 private:
  [[nodiscard]] static constexpr double diagonal(int k) { return Beta == 0 ? 0 : 1.0 / ((2 * k + 1) * (2 * k + 3)); }
  [[nodiscard]] static constexpr double square(int k) {
    return Beta == 0 ? k * k / (4.0 * k * k - 1) : k * (k + 1) / double((2 * k + 1) * (2 * k + 1));
  }

  double x_, value_ = 1, last_ = 0, norm_ = 1;
  int degree_ = 0;
};

/// The rule of n points for the weight s^Beta, Beta 0 or 1.
template <std::size_t n, int Beta>
[[nodiscard]] consteval GaussRule<n> gauss_rule() {
  const auto polynomial = [](std::size_t degree, double x) {
    JacobiRecurrence<Beta> p(x);
    for (std::size_t k = 0; k < degree; ++k) p.raise();
    return p.value();
  };
  std::array<double, n + 1> ends{-1, 1};
  for (std::size_t degree = 1; degree <= n; ++degree) {
    std::array<double, n + 1> roots{-1};
    for (std::size_t i = 0; i < degree; ++i) {
      double low = ends[i], high = ends[i + 1];
      const bool rises = polynomial(degree, high) > 0;
      const int halvings = degree < n ? 20 : 54;  // enough to tell neighbours apart; to the last bit
      for (int k = 0; k < halvings; ++k) {
        const double middle = (low + high) / 2;
        ((polynomial(degree, middle) > 0) == rises ? high : low) = middle;
      }
      roots[i + 1] = (low + high) / 2;
    }
    ends = roots;
    if (degree < n) ends[degree + 1] = 1;
  }
  GaussRule<n> out;
  for (std::size_t i = 0; i < n; ++i) {
    JacobiRecurrence<Beta> p(ends[i + 1]);
    double sum = 0;
    for (std::size_t k = 0; k < n; ++k, p.raise()) sum += p.value() * p.value() / p.norm();
    out.nodes[i] = (1 + ends[i + 1]) / 2;
    out.weights[i] = 1 / (sum * (1 + Beta));
  }
  return out;
}

}  // namespace plumb::detail
