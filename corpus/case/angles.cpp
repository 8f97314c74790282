#include "corpus/case/angles.hpp"

#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "solver/pose.hpp"

namespace plumb {
namespace {

struct SinCos {
  Real50 sin, cos;
};

// pi to 50 digits would leave cos(90 deg) at 1e-51 where the exact answer is 0, so that bodies meant to be parallel
// would not be: only the rest beyond whole quarter turns, exact in degrees, goes through pi.
SinCos sin_cos_deg(const Real50& degrees) {
  const Real50 quarters = round(degrees / 90);
  const Real50 rest = (degrees - 90 * quarters) * boost::math::constants::pi<Real50>() / 180;
  const Real50 s = sin(rest), c = cos(rest);
  switch ((static_cast<long>(quarters) % 4 + 4) % 4) {
    case 0: return {s, c};
    case 1: return {c, -s};
    case 2: return {-s, -c};
    default: return {-c, s};
  }
}

std::array<double, 4> rounded(const std::array<Real50, 4>& q) {
  std::array<double, 4> out;
  // Adding 0 turns -0 into 0.
  for (std::size_t i = 0; i < 4; ++i) out[i] = static_cast<double>(q[i]) + 0.0;
  return out;
}

// Two full turns bring a quaternion back to itself; fmod is exact.
Real50 reduced(double degrees) {
  return std::fmod(degrees, 720.0);
}

}  // namespace

std::array<double, 4> quaternion_from_euler(const std::array<double, 3>& radians) {
  return rounded(quaternion_from_euler_zxz<Real50>({radians[0], radians[1], radians[2]}));
}

std::array<double, 4> quaternion_from_euler_deg(const std::array<double, 3>& degrees) {
  const Real50 phi = reduced(degrees[0]), psi = reduced(degrees[2]);
  const SinCos theta = sin_cos_deg(reduced(degrees[1]) / 2);
  const SinCos sum = sin_cos_deg((phi + psi) / 2), difference = sin_cos_deg((phi - psi) / 2);
  return rounded({theta.cos * sum.cos, theta.sin * difference.cos, theta.sin * difference.sin, theta.cos * sum.sin});
}

Vec3<Real50> line_direction_deg(double zenith, double azimuth) {
  const SinCos theta = sin_cos_deg(reduced(zenith)), phi = sin_cos_deg(reduced(azimuth));
  return {theta.sin * phi.cos, theta.sin * phi.sin, theta.cos};
}

}  // namespace plumb
