// Eight azimuths or rays at once: what goes in and out of the kernels of the patch, and a register's share of it.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "solver/method/per_body.hpp"

namespace plumb::detail {

inline constexpr int eight = 8;

/// A number of each.
using Eight = std::array<double, eight>;

/// Sines and cosines of azimuths.
struct Circle {
  Eight cosine, sine;
};

/// `start` and on, `step` from each to the next.
[[nodiscard]] inline Circle circle(double start, double step) {
  Circle out;
  for (std::size_t k = 0; k < eight; ++k) {
    const double azimuth = start + step * static_cast<double>(k);
    out.cosine[k] = std::cos(azimuth), out.sine[k] = std::sin(azimuth);
  }
  return out;
}

inline void set(Vector3<Eight>& to, std::size_t k, const Vec3<double>& v) {
  to.x[k] = v[0], to.y[k] = v[1], to.z[k] = v[2];
}
/// v and -v, in turn.
[[nodiscard]] inline Vector3<Eight> both_ways(const Vec3<double>& v) {
  Vector3<Eight> out;
  for (std::size_t k = 0; k < eight; k += 2) set(out, k, v), set(out, k + 1, -v);
  return out;
}

/// So many numbers P has.
template <class P>
inline constexpr int lanes_of = sizeof(P) / sizeof(double);

/// Those from `first` on.
template <class P>
[[nodiscard, gnu::always_inline]] inline P load(const Eight& from, int first) {
  std::array<double, lanes_of<P>> out;
  std::memcpy(out.data(), from.data() + first, sizeof(P));
  return std::bit_cast<P>(out);
}
template <class P>
[[nodiscard, gnu::always_inline]] inline Vector3<P> load(const Vector3<Eight>& from, int first) {
  return {load<P>(from.x, first), load<P>(from.y, first), load<P>(from.z, first)};
}

template <class P>
[[gnu::always_inline]] inline void store(const P& from, Eight& to, int first) {
  std::memcpy(to.data() + first, &from, sizeof(P));
}
template <class P>
[[gnu::always_inline]] inline void store(const Vector3<P>& from, Vector3<Eight>& to, int first) {
  store(from.x, to.x, first), store(from.y, to.y, first), store(from.z, to.z, first);
}

}  // namespace plumb::detail
