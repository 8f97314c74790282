#include "solver/diagnosis.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "solver/pose.hpp"
#include "solver/shape/superellipsoid.hpp"
#include "solver/standard_arithmetic.hpp"

namespace plumb {
namespace {

using Wide = long double;

Vec3<Wide> normal_at(const Body& body, const Vec3<double>& point) {
  const Superellipsoid<Wide> shape{body.shape.semi_axes.cast<Wide>(), body.shape.n1, body.shape.n2};
  const Mat3<Wide> r = rotation<Wide>(body.quaternion);
  const Vec3<Wide> x = r.transpose() * (point.cast<Wide>() - body.position.cast<Wide>());
  return r * outward_normal<Wide>(shape, x);
}

template <class S>
S angle_between(const Vec3<S>& a, const Vec3<S>& b) {
  const Vec3<S> u = a / a.stableNorm(), v = b / b.stableNorm();
  return std::atan2(u.cross(v).norm(), u.dot(v)) * (S(180) / std::acos(S(-1)));
}

}  // namespace

double angle_deg(const Vec3<double>& a, const Vec3<double>& b) {
  return static_cast<double>(angle_between<Wide>(a.cast<Wide>(), b.cast<Wide>()));
}

ContactNormals normals_at(const Pair& pair, const Vec3<double>& point1, const Vec3<double>& point2) {
  const StandardArithmetic mode;
  return {normal_at(pair.body1, point1).cast<double>(), normal_at(pair.body2, point2).cast<double>()};
}

Diagnosis diagnose(const Pair& pair, const Vec3<double>& point1, const Vec3<double>& point2, int overlap_sign) {
  const StandardArithmetic mode;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Diagnosis out{{nan, nan, nan, nan, nan}, nan, nan, nan};
  if (!point1.allFinite() || !point2.allFinite()) return out;
  const Vec3<Wide> n1 = normal_at(pair.body1, point1), n2 = normal_at(pair.body2, point2);
  out.n1_n2 = static_cast<double>(angle_between<Wide>(n1, -n2));
  const Vec3<Wide> d = point2.cast<Wide>() - point1.cast<Wide>();
  const Wide length = d.stableNorm();
  const double magnitude = size_of(pair) + point1.lpNorm<Eigen::Infinity>() + point2.lpNorm<Eigen::Infinity>();
  if (!(length > 4 * epsilon<double>() * magnitude)) return out;
  const Vec3<Wide> u = d / length;
  const auto narrow = [](Wide x) { return static_cast<double>(x); };
  out.residues = {narrow(std::abs(u[0]) - std::abs(n1[0])), narrow(std::abs(u[1]) - std::abs(n2[1])),
                  narrow(u[0] + n1[0]), narrow(u[1] - n2[1]), narrow(u[2] + n1[2])};
  out.d_n1 = narrow(angle_between<Wide>(-u * overlap_sign, n1));
  out.d_n2 = narrow(angle_between<Wide>(u * overlap_sign, n2));
  return out;
}

std::string_view name(Fails fails) {
  constexpr std::array<std::string_view, 4> names{"signs", "z", "both", "nothing"};
  return names[static_cast<std::size_t>(fails)];
}

Fails fails_of(const Diagnosis& d) {
  const double zero = 1e-6;
  const bool signs = !(std::max(std::abs(d.residues[2]), std::abs(d.residues[3])) <= zero);
  const bool z = !(std::max(std::abs(d.residues[4]), d.n1_n2) <= zero);
  if (signs) return z ? Fails::both : Fails::signs;
  return z ? Fails::z : Fails::nothing;
}

}  // namespace plumb
