// FCL's box against box, and its GJK and EPA of boxes, capsules and polyhedra. Compiled here and without assertions, as fcl.cpp.
#include <fcl/narrowphase/detail/gjk_solver_libccd.h>
#include <fcl/narrowphase/detail/primitive_shape_algorithm/box_box.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <memory>

#include "fuzz/peers/shape_peers_impl.hpp"
#include "solver/pose.hpp"
#include "solver/shape/hull.hpp"
#include "solver/shape/overloaded.hpp"

namespace plumb::peers {
namespace {

fcl::Transform3d pose_of(const ConvexBody& body) {
  fcl::Transform3d out = fcl::Transform3d::Identity();
  out.linear() = rotation<double>(body.quaternion);
  out.translation() = body.position;
  return out;
}

/// FCL's own, with a fan of triangles for each face; made once for each hull.
const fcl::Convexd& convex_of(const Polyhedron& shape) {
  static std::map<std::shared_ptr<const Hull>, std::unique_ptr<fcl::Convexd>> known;
  std::unique_ptr<fcl::Convexd>& out = known[shape.hull];
  if (out) return *out;
  const auto corners = std::make_shared<std::vector<Vec3<double>>>(shape.hull->corners);
  const auto faces = std::make_shared<std::vector<int>>();
  for (const HullFace& face : shape.hull->faces) {
    faces->push_back(static_cast<int>(face.corners.size()));
    faces->insert(faces->end(), face.corners.begin(), face.corners.end());
  }
  out = std::make_unique<fcl::Convexd>(corners, static_cast<int>(shape.hull->faces.size()), faces);
  return *out;
}

/// What FCL's templates work on: an object, its deleter and its functions.
struct Placed {
  std::unique_ptr<void, void (*)(void*)> object;
  fcl::detail::GJKSupportFunction support;
};

template <class Shape>
Placed placed(const Shape& shape, const ConvexBody& body) {
  using Initializer = fcl::detail::GJKInitializer<double, Shape>;
  return {{Initializer::createGJKObject(shape, pose_of(body)), Initializer::deleteGJKObject},
          Initializer::getSupportFunction()};
}

/// Without an object where the shape is not taken.
Placed placed(const ConvexBody& body) {
  const detail::Overloaded of_shape{
      [&](const Box& s) { return placed(fcl::Boxd(2 * s.half_extents), body); },
      [&](const Capsule& s) { return placed(fcl::Capsuled(s.radius, 2 * s.half_length), body); },
      [&](const Polyhedron& s) { return placed(convex_of(s), body); },
      [](const auto&) { return Placed{{nullptr, [](void*) {}}, nullptr}; }};
  return std::visit(of_shape, body.shape);
}

}  // namespace

Contact<double> fcl_epa(const ConvexPair& pair) {
  constexpr double tolerance = 1e-6;  // FCL's own; at 1e-12 it crashes on capsules
  const Placed body1 = placed(pair.body1), body2 = placed(pair.body2);
  if (!body1.object || !body2.object) return lost();
  double length = 0;
  Vec3<double> point1, point2;
  try {
    fcl::detail::GJKDistanceImpl<double>(body1.object.get(), body1.support, body2.object.get(), body2.support, 1000,
                                         tolerance, fcl::detail::libccd_extension::ccdGJKSignedDist, &length, &point1,
                                         &point2);
  } catch (const std::exception&) {
    return lost();
  }
  const double between = (point1 - point2).norm();
  if (!(length < 0) || !(between > 0)) return lost();
  return found(-length, (point1 - point2) / between, (point1 + point2) / 2);
}

Contact<double> fcl_box_box(const ConvexPair& pair) {
  const auto *first = std::get_if<Box>(&pair.body1.shape), *second = std::get_if<Box>(&pair.body2.shape);
  if (first == nullptr || second == nullptr) return lost();
  std::vector<fcl::ContactPointd> contacts;
  fcl::detail::boxBoxIntersect(fcl::Boxd(2 * first->half_extents), pose_of(pair.body1),
                               fcl::Boxd(2 * second->half_extents), pose_of(pair.body2), &contacts);
  if (contacts.empty()) return lost();
  const auto deepest = std::ranges::max_element(contacts, {}, &fcl::ContactPointd::penetration_depth);
  return found(deepest->penetration_depth, deepest->normal, deepest->pos);
}

}  // namespace plumb::peers
