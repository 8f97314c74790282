// RapidCheck generators over the families and over single shapes, directions and poses, with shrinkers that know angles,
// axes, exponents and overlaps. Deterministic: all randomness comes from RapidCheck's seed (tests/main.cpp).
#pragma once

#include <rapidcheck.h>

#include <cmath>
#include <ostream>
#include <string>

#include "properties/generators/draft.hpp"
#include "properties/generators/families.hpp"

namespace plumb {

inline constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// What RapidCheck prints: the line that a case file would hold.
inline void showValue(const Case& c, std::ostream& os) {
  os << format_case(c);
}

inline void showValue(const Superellipsoid<double>& shape, std::ostream& os) {
  os.precision(17);
  os << "semi-axes " << shape.semi_axes.transpose() << ", exponents " << shape.n1 << ' ' << shape.n2;
}

namespace generators {

/// A value drawn from a Stream that RapidCheck's own random number starts.
template <class Draw>
[[nodiscard]] auto drawn(const Draw& draw) {
  return rc::gen::noShrink(rc::gen::map(rc::gen::arbitrary<std::uint64_t>(), [draw](std::uint64_t seed) {
    Stream stream("generators", seed, 0);
    return draw(stream);
  }));
}

[[nodiscard]] inline rc::Gen<Case> shrinking(rc::Gen<Case> gen) {
  return rc::gen::shrink(std::move(gen), [](const Case& c) { return rc::seq::fromContainer(simpler(c)); });
}

/// Cases of one family, shrinking by simpler().
[[nodiscard]] inline rc::Gen<Case> case_of(const std::string& family) {
  return shrinking(drawn([family](Stream& stream) {
    const std::uint64_t seed = stream.bits();
    return generate(family, seed, stream.bits());
  }));
}

/// Cases of one hard generator, shrinking by simpler().
[[nodiscard]] inline rc::Gen<Case> hard_case_of(const std::string& generator) {
  return shrinking(drawn([generator](Stream& stream) { return generate_hard(generator, stream.bits(), 0); }));
}

/// An exponent from just above 1 to 50, the special ones often.
[[nodiscard]] inline double draw_exponent(Stream& stream) {
  static constexpr std::array<double, 10> kSpecial{1.1, 1.5, 2, 2, 2 - 1e-12, 2 + 1e-12, 3, 4, 20, 50};
  if (stream.chance(0.5)) return stream.pick(kSpecial);
  return stream.chance(0.3) ? stream.uniform(1.1, 2) : stream.log_uniform(2, 50);
}

/// A shape of longest semi-axis 1, aspect to 1e3, any exponents; shrinks as the first body of a case.
[[nodiscard]] inline rc::Gen<Superellipsoid<double>> shape() {
  const auto draw = [](Stream& stream) {
    Case c;
    c.pair.body1.shape = random_ellipsoid(stream, stream.chance(0.7) ? 5 : 1e3);
    c.pair.body1.shape.n1 = draw_exponent(stream);
    const double other = draw_exponent(stream);
    c.pair.body1.shape.n2 = stream.chance(0.3) ? c.pair.body1.shape.n1 : other;
    return c;
  };
  return rc::gen::map(shrinking(drawn(draw)), [](const Case& c) { return c.pair.body1.shape; });
}

/// Unit to rounding; a third on a coordinate axis or in a coordinate plane, some one small component off it.
[[nodiscard]] inline Vec3<double> draw_direction(Stream& stream) {
  Vec3<double> u = random_direction(stream);
  const double share = stream.uniform();
  const int changed = share < 0.15 ? 1 : (share < 0.35 ? 2 : 0);
  const auto first = static_cast<int>(stream.below(3));
  for (int i = 0; i < changed; ++i)
    u[(first + i) % 3] = stream.chance(0.7) ? 0.0 : stream.signed_log_uniform(1e-300, 1e-8);
  return u / u.norm();
}

[[nodiscard]] inline rc::Gen<Vec3<double>> direction() {
  return drawn([](Stream& stream) { return draw_direction(stream); });
}

/// A rotation as a quaternion of any length: exact axis rotations, right angles to within an ulp, tiny turns, any turn.
[[nodiscard]] inline Quaternion draw_quaternion(Stream& stream) {
  const double kind = stream.uniform();
  const Vec3<double> axis = draw_direction(stream);
  Quaternion q = random_rotation(stream);
  if (kind < 0.2)
    q = random_axis_rotation(stream);
  else if (kind < 0.4)
    q = turn(axis, std::nextafter(std::acos(-1.0) / 2 * static_cast<double>(stream.below(4)), stream.sign() * 10));
  else if (kind < 0.6)
    q = turn(axis, stream.log_uniform(1e-300, 1e-2));
  const double length = stream.chance(0.5) ? 1 : std::pow(10.0, stream.uniform(-315, 300));
  for (double& x : q) x *= length;
  return q;
}

/// Shrinks as the rotation of a case's first body.
[[nodiscard]] inline rc::Gen<Quaternion> quaternion() {
  const auto draw = [](Stream& stream) {
    Case c;
    c.pair.body1.quaternion = draw_quaternion(stream);
    return c;
  };
  return rc::gen::map(shrinking(drawn(draw)), [](const Case& c) { return c.pair.body1.quaternion; });
}

}  // namespace generators
}  // namespace plumb
