// libccd's GJK and EPA of boxes, capsules and polyhedra.
#include <ccd/ccd.h>

#include <algorithm>
#include <cmath>

#include "fuzz/peers/shape_peers_impl.hpp"
#include "solver/pose.hpp"
#include "solver/shape/hull.hpp"
#include "solver/shape/overloaded.hpp"

namespace plumb::peers {
namespace {

struct PlacedShape {
  const ConvexBody& body;
  Mat3<double> rotation;

  explicit PlacedShape(const ConvexBody& of) : body(of), rotation(plumb::rotation<double>(of.quaternion)) {}

  /// Of those that are taken; the body's position for the others.
  [[nodiscard]] Vec3<double> support(const Vec3<double>& u) const {
    const detail::Overloaded of_shape{
        [&](const Box& s) -> Vec3<double> {
          return s.half_extents.cwiseProduct(u.unaryExpr([](double x) { return x < 0 ? -1.0 : 1.0; }));
        },
        [&](const Capsule& s) -> Vec3<double> {
          return Vec3<double>(0, 0, std::copysign(s.half_length, u[2])) + s.radius * u.normalized();
        },
        [&](const Polyhedron& s) -> Vec3<double> {
          return *std::ranges::max_element(s.hull->corners, {}, [&](const Vec3<double>& x) { return x.dot(u); });
        },
        [](const auto&) -> Vec3<double> { return Vec3<double>::Zero(); }};
    return rotation * std::visit(of_shape, body.shape) + body.position;
  }
};

void find_support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  const PlacedShape& shape = *static_cast<const PlacedShape*>(object);
  const Vec3<double> x = shape.support(shape.rotation.transpose() * Eigen::Map<const Vec3<double>>(direction->v));
  Eigen::Map<Vec3<double>>(point->v) = x;
}

}  // namespace

Contact<double> libccd_epa(const ConvexPair& pair) {
  constexpr double tolerance = 1e-12;  // as peer_libccd_epa's of superellipsoids
  const PlacedShape body1(pair.body1), body2(pair.body2);
  ccd_t settings;
  CCD_INIT(&settings);
  settings.support1 = settings.support2 = find_support;
  settings.max_iterations = 1000;
  settings.epa_tolerance = tolerance;
  double depth = 0;
  ccd_vec3_t direction, position;
  if (ccdGJKPenetration(&body1, &body2, &settings, &depth, &direction, &position) != 0) return lost();
  return found(depth, Vec3<double>(direction.v), Vec3<double>(position.v));
}

}  // namespace plumb::peers
