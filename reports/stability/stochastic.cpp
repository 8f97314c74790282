#include "reports/stability/stochastic.hpp"

#include <bit>
#include <cmath>

#include "properties/generators/stream.hpp"

namespace plumb {
namespace {

Stream new_draws(std::uint64_t seed) {
  return {"rounding", seed, 0};
}

thread_local Stream draws = new_draws(0);

/// The neighbour of x, not zero, on the side of x + error.
double neighbour_of(double x, double error) {
  const bool is_outwards = (error > 0) == (x > 0);
  return std::bit_cast<double>(std::bit_cast<std::int64_t>(x) + (is_outwards ? 1 : -1));
}

/// `nearest` or its neighbour. An error of NaN counts as none.
double at_random(double nearest, double error) {
  if (error == 0 || nearest == 0 || !std::isfinite(nearest) || std::isnan(error)) return nearest;
  const double neighbour = neighbour_of(nearest, error);
  const bool moves = draws.uniform() * std::abs(neighbour - nearest) < std::abs(error) && std::isfinite(neighbour);
  return moves ? neighbour : nearest;
}

double at_random(long double result) {
  const auto nearest = static_cast<double>(result);
  return at_random(nearest, static_cast<double>(result - static_cast<long double>(nearest)));
}

}  // namespace

void seed_rounding(std::uint64_t seed) {
  draws = new_draws(seed);
}

Stochastic operator+(Stochastic x, Stochastic y) {
  const double a = x.value_, b = y.value_, sum = a + b, of_b = sum - a;
  return at_random(sum, (a - (sum - of_b)) + (b - of_b));
}

Stochastic operator*(Stochastic x, Stochastic y) {
  const double product = x.value_ * y.value_;
  return at_random(product, std::fma(x.value_, y.value_, -product));
}

Stochastic operator/(Stochastic x, Stochastic y) {
  const double quotient = x.value_ / y.value_;
  return at_random(quotient, std::fma(-quotient, y.value_, x.value_) / y.value_);
}

Stochastic sqrt(Stochastic x) {
  const double root = std::sqrt(x.value_);
  return at_random(root, std::fma(-root, root, x.value_) / (2 * root));
}

Stochastic exp(Stochastic x) {
  return at_random(std::exp(static_cast<long double>(x)));
}

Stochastic log(Stochastic x) {
  return at_random(std::log(static_cast<long double>(x)));
}

Stochastic pow(Stochastic x, Stochastic y) {
  return at_random(std::pow(static_cast<long double>(x), static_cast<long double>(y)));
}

Stochastic sin(Stochastic x) {
  return at_random(std::sin(static_cast<long double>(x)));
}

Stochastic cos(Stochastic x) {
  return at_random(std::cos(static_cast<long double>(x)));
}

}  // namespace plumb
