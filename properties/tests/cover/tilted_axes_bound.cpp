// The lower bound of the overlap on quadrangles of latitudes and longitudes, against directions of theirs.
#include "solver/method/auto/cover/tilted_axes_bound.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <optional>

#include "properties/tests/cover/turned_pairs.hpp"

namespace plumb::parallel_axes_tests {
namespace {

using Tilted = TiltedAxesBound<double>;

/// Both of the same half: a quadrangle's latitudes are.
std::array<Latitude<double>, 2> draw_latitudes(Stream& stream) {
  const double half = stream.sign();
  const auto one = [&] {
    const double angle = stream.uniform(0, std::numbers::pi / 2);
    return Latitude<double>{std::sin(angle), half * std::cos(angle)};
  };
  return {one(), one()};
}

Across<double> at_longitude(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

double overlap_at(const PlacedPair<double>& placed, const Vector3<double>& v) {
  return static_cast<double>(overlap_along(placed, v.eigen().normalized().cast<long double>()));
}

/// A pair with its bound, where there is one: neither body is a sphere.
struct Bounded {
  PlacedPair<double> placed;
  std::optional<Tilted> bound;
  double rounding;

  Bounded(Stream& stream, double tilt)
      : placed(place<double>(draw_parallel(stream, tilt).pair)),
        bound(Tilted::is_for(placed) ? std::optional<Tilted>(placed) : std::nullopt),
        rounding(1e-15 * (4 + placed.body2.shape.semi_axes.maxCoeff())) {}
};

/// A witness of one direction bounds all directions of the latitudes of its half, on any arc that holds their longitude.
TEST(TiltedAxesBound, NoDirectionIsLowerThanAWitnessSays) {
  int bounds = 0;
  for (const double tilt : {1e-12, 1e-8, 1e-4, 1e-2, 4e-2}) {
    Stream stream("tilted axes", 1, static_cast<std::uint64_t>(-std::log10(tilt)));
    for (int draw = 0; draw < 100; ++draw) {
      const Bounded on(stream, tilt);
      if (!on.bound) continue;
      ++bounds;
      for (int k = 0; k < 10; ++k) {
        const auto [own, other] = draw_latitudes(stream);
        const double from = stream.uniform(0, 2 * std::numbers::pi), width = stream.uniform(0, std::numbers::pi);
        const Across<double> u = at_longitude(from + width * stream.uniform());
        const Arc<double> arc{at_longitude(from), at_longitude(from + width), false}, around{u, u, true};
        const double here = overlap_at(on.placed, on.bound->direction(other, u));
        const auto near = on.bound->witness(own, at_longitude(stream.uniform(0, 2 * std::numbers::pi)));
        ASSERT_LE(near.height(other, arc), here + on.rounding) << tilt << ' ' << draw;
        ASSERT_LE(on.bound->witness_around(own).height(other, around), here + on.rounding) << tilt << ' ' << draw;
      }
    }
  }
  EXPECT_GT(bounds, 200);
}

/// At its own direction a witness says o itself.
TEST(TiltedAxesBound, AWitnessIsSharpAtItsOwnDirection) {
  Stream stream("tilted axes", 2, 0);
  for (int draw = 0; draw < 200; ++draw) {
    const Bounded on(stream, stream.log_uniform(1e-10, 4e-2));
    if (!on.bound) continue;
    const Latitude<double> at = draw_latitudes(stream)[0];
    const Across<double> u = at_longitude(stream.uniform(0, 2 * std::numbers::pi));
    EXPECT_NEAR(on.bound->witness(at, u).height(at, {u, u, false}), overlap_at(on.placed, on.bound->direction(at, u)),
                4 * on.rounding)
        << draw;
  }
}

}  // namespace
}  // namespace plumb::parallel_axes_tests
