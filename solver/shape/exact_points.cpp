#include "solver/shape/exact_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/power_of_two.hpp"

namespace plumb::detail {
namespace {

constexpr int digits = std::numeric_limits<double>::digits;
constexpr double half_epsilon = std::numeric_limits<double>::epsilon() / 2;
// Shewchuk, Discrete & Computational Geometry 18, 1997, section 4: of determinants of rounded differences, over their permanents.
constexpr double turn_error = (3 + 16 * half_epsilon) * half_epsilon;
constexpr double orientation_error = (7 + 56 * half_epsilon) * half_epsilon;
// Of coordinates up to 1 all that underflow can lose, in the scaling and in the products, is far below this.
constexpr double underflow_error = 0x1p-1000;

int sign_of(double x) {
  return (x > 0) - (x < 0);
}

double cross(const Vec3<double>& u, const Vec3<double>& v, int axis) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  return u[i] * v[j] - u[j] * v[i];
}

/// |u_i v_j| + |u_j v_i|
double permanent(const Vec3<double>& u, const Vec3<double>& v, int axis) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  return std::abs(u[i] * v[j]) + std::abs(u[j] * v[i]);
}

/// x 2^-lowest, x being 0 or a multiple of 2^lowest.
boost::multiprecision::cpp_int whole(double x, int lowest) {
  int exponent = 0;
  const double mantissa = std::ldexp(std::frexp(x, &exponent), digits);
  boost::multiprecision::cpp_int out(static_cast<long long>(mantissa));
  if (x != 0) out <<= static_cast<unsigned>(exponent - digits - lowest);
  return out;
}

}  // namespace

ExactPoints::ExactPoints(std::vector<Vec3<double>> points) : points_(std::move(points)) {
  double largest = 0;
  int lowest = std::numeric_limits<int>::max();
  for (const Vec3<double>& p : points_)
    for (const double x : p) {
      largest = std::max(largest, std::abs(x));
      if (x != 0) lowest = std::min(lowest, exponent_above(std::abs(x)) - digits);
    }
  const PowerOfTwo<double> unit(-exponent_above(largest));
  for (const Vec3<double>& p : points_) {
    scaled_.push_back(unit(p));
    integers_.push_back({whole(p[0], lowest), whole(p[1], lowest), whole(p[2], lowest)});
  }
}

int ExactPoints::turn(int axis, int a, int b, int c) const {
  const auto at = [&](int i) -> const Vec3<double>& { return scaled_[static_cast<std::size_t>(i)]; };
  const Vec3<double> u = at(b) - at(a), v = at(c) - at(a);
  const double rough = cross(u, v, axis);
  if (std::abs(rough) > turn_error * permanent(u, v, axis) + underflow_error) return sign_of(rough);
  return component(axis, a, b, c).sign();
}

int ExactPoints::orientation(int a, int b, int c, int d) const {
  const auto at = [&](int i) -> const Vec3<double>& { return scaled_[static_cast<std::size_t>(i)]; };
  const Vec3<double> u = at(b) - at(a), v = at(c) - at(a), w = at(d) - at(a);
  double rough = 0, size = 0;
  for (int axis = 0; axis < 3; ++axis) {
    rough += cross(u, v, axis) * w[axis];
    size += permanent(u, v, axis) * std::abs(w[axis]);
  }
  if (std::abs(rough) > orientation_error * size + underflow_error) return sign_of(rough);
  const Integers n = normal(a, b, c), e = difference(d, a);
  return Integer(n[0] * e[0] + n[1] * e[1] + n[2] * e[2]).sign();
}

bool ExactPoints::are_collinear(int a, int b, int c) const {
  return turn(0, a, b, c) == 0 && turn(1, a, b, c) == 0 && turn(2, a, b, c) == 0;
}

Vec3<double> ExactPoints::unit_normal(int a, int b, int c) const {
  const Integers n = normal(a, b, c);
  const Integer square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
  const unsigned bits = square == 0 ? 0 : static_cast<unsigned>(msb(square)) / 2;
  constexpr unsigned kept = 400;  // squares stay finite, and what is cut is far below rounding
  Vec3<double> out;
  for (std::size_t i = 0; i < 3; ++i)
    out[static_cast<int>(i)] = Integer(bits > kept ? n[i] >> (bits - kept) : n[i]).convert_to<double>();
  return out / out.norm();
}

ExactPoints::Integers ExactPoints::difference(int to, int from) const {
  const Integers &p = integers_[static_cast<std::size_t>(to)], &q = integers_[static_cast<std::size_t>(from)];
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

ExactPoints::Integer ExactPoints::component(int axis, int a, int b, int c) const {
  const auto i = static_cast<std::size_t>((axis + 1) % 3), j = static_cast<std::size_t>((axis + 2) % 3);
  const Integers u = difference(b, a), v = difference(c, a);
  return u[i] * v[j] - u[j] * v[i];
}

ExactPoints::Integers ExactPoints::normal(int a, int b, int c) const {
  return {component(0, a, b, c), component(1, a, b, c), component(2, a, b, c)};
}

}  // namespace plumb::detail
