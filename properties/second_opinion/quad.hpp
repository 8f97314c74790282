// 128-bit numbers (113 binary digits) and columns of three; the search runs the same formulas in doubles.
#pragma once

#include <quadmath.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace second_opinion {

using Quad = __float128;

inline double root(double x) {
  return std::sqrt(x);
}
inline Quad root(Quad x) {
  return sqrtq(x);
}
inline double magnitude(double x) {
  return std::fabs(x);
}
inline Quad magnitude(Quad x) {
  return fabsq(x);
}
/// Of a positive base.
inline double power(double base, double exponent) {
  return std::pow(base, exponent);
}
/// Within |exponent log base| roundings, and a third faster than powq.
inline Quad power(Quad base, Quad exponent) {
  return expq(exponent * logq(base));
}

template <class T>
struct Vec {
  T x, y, z;
};
template <class T>
Vec<T> operator+(const Vec<T>& a, const Vec<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
Vec<T> operator-(const Vec<T>& a, const Vec<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
Vec<T> operator-(const Vec<T>& a) {
  return {-a.x, -a.y, -a.z};
}
template <class T>
Vec<T> operator*(T s, const Vec<T>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class T>
T dot(const Vec<T>& a, const Vec<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
Vec<T> cross(const Vec<T>& a, const Vec<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
T largest(const Vec<T>& a) {
  return std::max(std::max(magnitude(a.x), magnitude(a.y)), magnitude(a.z));
}
/// Safe from overflow and underflow of the squares.
template <class T>
T length(const Vec<T>& a) {
  const T most = largest(a);
  if (!(most > T(0))) return most;
  const Vec<T> b = (T(1) / most) * a;
  return most * root(dot(b, b));
}
template <class T>
Vec<T> unit(const Vec<T>& a) {
  const Vec<T> b = (T(1) / largest(a)) * a;
  return (T(1) / root(dot(b, b))) * b;
}

inline Vec<double> narrow(const Vec<Quad>& a) {
  return {static_cast<double>(a.x), static_cast<double>(a.y), static_cast<double>(a.z)};
}
inline Vec<Quad> widen(const Vec<double>& a) {
  return {a.x, a.y, a.z};
}

/// rad, good at 0 and at pi.
inline double angle(const Vec<Quad>& a, const Vec<Quad>& b) {
  return 2 * std::atan2(static_cast<double>(length(unit(a) - unit(b))), static_cast<double>(length(unit(a) + unit(b))));
}

/// Two unit vectors across n, and across each other.
template <class T>
std::array<Vec<T>, 2> across(const Vec<T>& n) {
  const T x = magnitude(n.x), y = magnitude(n.y), z = magnitude(n.z);
  const Vec<T> least = x <= y && x <= z ? Vec<T>{1, 0, 0} : y <= z ? Vec<T>{0, 1, 0} : Vec<T>{0, 0, 1};
  const Vec<T> first = unit(cross(n, least));
  return {first, cross(n, first)};
}

}  // namespace second_opinion
