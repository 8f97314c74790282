#include "solver/reference/convex/placed_cores.hpp"

#include <algorithm>
#include <cmath>

#include "solver/power_of_two.hpp"

namespace plumb::reference::cores {
namespace {

Mat3<double> middles(const IMat3<I>& m) {
  Mat3<double> out;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) out(i, j) = (low(m(i, j)) + high(m(i, j))) / 2;
  return out;
}

Vec3<double> middles(const IVec3<I>& v) {
  Vec3<double> out;
  for (int i = 0; i < 3; ++i) out[i] = low(v[i]) + (high(v[i]) - low(v[i])) / 2;
  return out;
}

I radius_of(const ConvexBody& body, int exponent) {
  return radius_about_core(body.shape, exponent) + times_power_of_two<I>(I(body.swept_radius), -exponent);
}

}  // namespace

IMat3<I> enclosed_rotation_of(const std::array<double, 4>& quaternion) {
  Pair turned;
  turned.body1.quaternion = quaternion;
  return enclose<I>(turned).body1.rotation;
}

int exponent_of(const ConvexPair& pair) {
  const Vec3<double> half_distance = pair.body2.position / 2 - pair.body1.position / 2;
  const double largest = std::max(size_of(pair) / 2, half_distance.cwiseAbs().maxCoeff());
  if (!(largest > 0)) return std::numeric_limits<double>::min_exponent;  // two equal points: 0 stays 0
  return std::isfinite(largest) ? detail::exponent_above(largest) + 1 : std::numeric_limits<double>::max_exponent;
}

IVec3<I> enclosed_difference(const Vec3<double>& to, const Vec3<double>& from, int exponent) {
  const int before = std::max(exponent, 0), after = exponent - before;
  IVec3<I> out;
  for (int i = 0; i < 3; ++i) {
    const I difference = times_power_of_two<I>(I(to[i]), -before) - times_power_of_two<I>(I(from[i]), -before);
    out[i] = times_power_of_two<I>(difference, -after);
  }
  return out;
}

IVec3<I> times(const IMat3<I>& m, const IVec3<I>& v) {
  IVec3<I> out;
  for (int i = 0; i < 3; ++i) out[i] = m(i, 0) * v[0] + m(i, 1) * v[1] + m(i, 2) * v[2];
  return out;
}

IVec3<I> times_transpose(const IMat3<I>& m, const IVec3<I>& v) {
  IVec3<I> out;
  for (int i = 0; i < 3; ++i) out[i] = m(0, i) * v[0] + m(1, i) * v[1] + m(2, i) * v[2];
  return out;
}

PlacedCores::PlacedCores(const ConvexPair& pair)
    : exponent_(exponent_of(pair)), core1_(core_of(pair.body1.shape, exponent_)),
      core2_(core_of(pair.body2.shape, exponent_)), rotation1_(enclosed_rotation_of(pair.body1.quaternion)),
      rotation2_(enclosed_rotation_of(pair.body2.quaternion)), rough1_(middles(rotation1_)),
      rough2_(middles(rotation2_)), centre_(enclosed_difference(pair.body2.position, pair.body1.position, exponent_)),
      rough_centre_(middles(centre_)), radii_(radius_of(pair.body1, exponent_) + radius_of(pair.body2, exponent_)) {}

I PlacedCores::support(const IVec3<I>& v) const {
  const IVec3<I> against(-v[0], -v[1], -v[2]);
  return support_of(core1_, times_transpose(rotation1_, v)) + support_of(core2_, times_transpose(rotation2_, against)) -
         dot<I>(centre_, v);
}

I PlacedCores::overlap_at(const Vec3<double>& v) const {
  const IVec3<I> direction = enclosed<I>(v);
  return support(direction) / length_of<I>(direction);
}

IVec3<I> PlacedCores::proved(const Atom& atom) const {
  const IVec3<I> x = times(rotation1_, proved_point(core1_, atom.point1)),
                 y = times(rotation2_, proved_point(core2_, atom.point2));
  IVec3<I> out;
  for (int i = 0; i < 3; ++i) out[i] = x[i] - y[i] - centre_[i];
  return out;
}

Atom PlacedCores::farthest(const Vec3<double>& v) const {
  Atom out{cores::farthest(core1_, rough1_.transpose() * v), cores::farthest(core2_, -(rough2_.transpose() * v)), {}};
  out.w = rough1_ * out.point1.at - rough2_ * out.point2.at - rough_centre_;
  return out;
}

Atom PlacedCores::on_surface(const Vec3<double>& n) const {
  return {near(core1_, rough1_.transpose() * (rough_centre_ - low(radii_) * n)), {Vec3<double>::Zero(), 0}, {}};
}

}  // namespace plumb::reference::cores
