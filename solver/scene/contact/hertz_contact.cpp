#include "solver/scene/contact/hertz_contact.hpp"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <cmath>
#include <numbers>

namespace plumb::scene {
namespace {

/// Complete elliptic integrals of a patch with semi-axes 1 and `ratio`.
struct Patch {
  double ratio, k, e;

  explicit Patch(double shorter)
      : ratio(shorter), k(boost::math::ellint_1(std::sqrt((1 - shorter) * (1 + shorter)))),
        e(boost::math::ellint_2(std::sqrt((1 - shorter) * (1 + shorter)))) {}

  /// The two parts of eq. 4.28, B/A = outer / inner.
  [[nodiscard]] double outer() const { return e / (ratio * ratio) - k; }
  [[nodiscard]] double inner() const { return k - e; }
};

/// Nearly round patches follow from round ones: the error is of second order in B/A - 1.
constexpr double round = 1e-5;

/// log(B/A) of a patch less the one sought.
double excess(double log_ratio, double sought) {
  const Patch patch(std::exp(log_ratio));
  return std::log(patch.outer() / patch.inner()) - sought;
}

/// log of the ratio, by secants from Hamrock & Brewe's fit; it falls with B/A, and almost as its power -2/3.
double solve_ratio(double sought) {
  double x0 = -0.6366 * sought, f0 = excess(x0, sought);
  double x1 = x0 + f0 * 0.64, f1 = excess(x1, sought);
  for (int i = 0; i < 20 && std::abs(f1) > 1e-11 && f1 != f0; ++i) {
    const double x2 = std::fmin(x1 - f1 * (x1 - x0) / (f1 - f0), 0.5 * x1);
    x0 = x1;
    f0 = f1;
    x1 = x2;
    f1 = excess(x1, sought);
  }
  return x1;
}

}  // namespace

HertzContact hertz_contact(double a, double b) {
  const double radius = 1 / (2 * std::sqrt(a * b));
  const double sought = std::log(b / a);
  if (sought < round) return {4.0 / 3 * std::sqrt(radius), 1};
  const Patch patch(std::exp(solve_ratio(sought)));
  const double square = (1 - patch.ratio) * (1 + patch.ratio);
  const double f1 = std::cbrt(4 / (std::numbers::pi * square)) * std::sqrt(patch.ratio) *
                    std::pow(patch.outer() * patch.inner(), 1.0 / 6);
  const double f2 = 2 / std::numbers::pi * std::sqrt(patch.ratio) * patch.k / f1;
  return {4.0 / 3 * std::sqrt(radius) / std::pow(f2, 1.5), patch.ratio};
}

}  // namespace plumb::scene
