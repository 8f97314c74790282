// A body against a sheet of triangles.
//
// Face     the farthest point towards the facet's plane, from the side of the body's centre, lies over one of its triangles: the same
//          numbers as against a plane wall, whichever triangle it is. A facet has one such point
// Edge     o is stationary inside the arc of its normals: at its ends the farthest points towards the faces lie beyond them, by the same
//          numbers by which a face says so. So a body that slides from a face over an edge is never without a contact and never has two
// Corner   o is least over all directions (by `auto`, against a ball about it), at a normal that is away from all edges there
#include <cmath>

#include "solver/method/automatic.hpp"
#include "solver/scene/wall/mesh.hpp"
#include "solver/scene/wall/touches.hpp"

namespace plumb::scene {
namespace {

/// Along an edge and about a corner both are looked at where rounding leaves it open.
constexpr double slack = 1e-9;
/// Of how far a point is beyond a side, times its length.
constexpr double rounding = 2e-14;

/// The square of a triangle's distance from the origin (Ericson, Real-Time Collision Detection, 2005, section 5.1.5).
double distance2_of(const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& c) {
  const Vec3<double> ab = b - a, ac = c - a;
  const double d1 = -ab.dot(a), d2 = -ac.dot(a), d3 = -ab.dot(b), d4 = -ac.dot(b), d5 = -ab.dot(c), d6 = -ac.dot(c);
  if (d1 <= 0 && d2 <= 0) return a.squaredNorm();
  if (d3 >= 0 && d4 <= d3) return b.squaredNorm();
  if (d6 >= 0 && d5 <= d6) return c.squaredNorm();
  const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return (a + d1 / (d1 - d3) * ab).squaredNorm();
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return (a + d2 / (d2 - d6) * ac).squaredNorm();
  if (va <= 0 && d4 >= d3 && d5 >= d6) return (b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b)).squaredNorm();
  return (a + vb / (va + vb + vc) * ab + vc / (va + vb + vc) * ac).squaredNorm();
}

/// Space in the body's axes over its semi-axes, where it lies in a ball about the origin.
class ScaledSpace {
 public:
  explicit ScaledSpace(const BodyAtWall& body)
      : to_(body.shape.semi_axes.cwiseInverse().asDiagonal() * body.orientation.toRotationMatrix().transpose()),
        centre_(body.centre),
        radius_(radius_of(body.shape) * (1 + slack) + body.range / body.shape.semi_axes.minCoeff()) {}

  [[nodiscard]] bool may_meet(const Triangle& t) const {
    const auto at = [&](const Vec3<double>& x) -> Vec3<double> { return to_ * (x - centre_); };
    return distance2_of(at(t[0]), at(t[1]), at(t[2])) <= radius_ * radius_;
  }

 private:
  /// max of (x^2 + y^2 + z^2)^(1/2) where (|x|^n2 + |y|^n2)^(n1/n2) + |z|^n1 = 1 (Hoelder's inequality, twice).
  static double radius_of(const Superellipsoid<double>& shape) {
    const double n1 = std::max(2.0, shape.n1), n2 = std::max(2.0, shape.n2);
    const double across = std::exp2(0.5 - 1 / n2);
    if (n1 == 2) return across;
    const double q = 1 / (0.5 - 1 / n1);
    return std::pow(std::pow(across, q) + 1, 1 / q);
  }

  Mat3<double> to_;
  Vec3<double> centre_;
  double radius_;
};

struct MeshQuery {
  const Mesh& mesh;
  const BodyAtWall& body;
  Touches& out;
  double reach = body.radius + body.range;
  ScaledSpace scaled{body};

  /// The body towards the facet that was looked at last: its triangles follow each other.
  struct Towards {
    std::uint32_t facet = Mesh::none;
    Vec3<double> into = Vec3<double>::Zero();
    double distance = 0;
    BodyAtWall::Reach at{};
    bool is_near = false, is_touched = false;
  };
  Towards towards{};

  void look_at(std::uint32_t triangle) {
    const auto& [a, b, c] = mesh.triangles()[triangle];
    const Vec3<double> low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    if ((body.centre - body.centre.cwiseMax(low).cwiseMin(high)).squaredNorm() >= reach * reach) return;
    if (!scaled.may_meet(mesh.triangles()[triangle])) return;
    const Mesh::Parts& parts = mesh.parts(triangle);
    look_at_face(triangle, parts);
    for (const std::uint32_t edge : parts.edges)
      if (edge != Mesh::none) look_at_edge(mesh.edges()[edge]);
    for (const std::uint32_t corner : parts.corners)
      if (corner != Mesh::none) look_at_corner(mesh.corners()[corner]);
  }

 private:
  [[nodiscard]] bool is_over(std::uint32_t triangle, const Mesh::Parts& parts, const Vec3<double>& point) const {
    for (std::uint32_t side = 0; side < 3; ++side) {
      const double inwards = mesh.inwards({triangle, side}, point);
      const double least =
          parts.is_flat[side] ? -rounding * mesh.extent() * mesh.extent() : 0;  // the neighbour is as good
      if (!(inwards >= least)) return false;
    }
    return true;
  }

  [[nodiscard]] Towards towards_facet(std::uint32_t index) const {
    const MeshFacet& facet = mesh.facets()[index];
    Towards to;
    to.facet = index;
    to.into = facet.normal.dot(facet.point - body.centre) < 0 ? Vec3<double>(-facet.normal) : facet.normal;
    to.distance = to.into.dot(facet.point - body.centre);
    if (to.distance >= reach) return to;
    to.at = body.along(to.into);
    to.is_near = to.at.height - to.distance > -body.range;
    return to;
  }

  void look_at_face(std::uint32_t triangle, const Mesh::Parts& parts) {
    if (parts.facet != towards.facet) towards = towards_facet(parts.facet);
    if (!towards.is_near || towards.is_touched || !is_over(triangle, parts, body.centre + towards.at.point)) return;
    out.add_reach(body, towards.into, towards.at, towards.distance);
    towards.is_touched = true;
  }

  void look_at_edge(const MeshEdge& edge) {
    const Vec3<double> way = edge.to - edge.from, w = edge.from - body.centre;
    const double length2 = way.squaredNorm(), nearest = std::clamp(-w.dot(way) / length2, 0.0, 1.0);
    if ((w + nearest * way).squaredNorm() >= reach * reach) return;
    if (mesh.inwards(edge.sides[0], body.centre + body.along(-edge.start).point) >= 0) return;
    if (mesh.inwards(edge.sides[1], body.centre + body.along(-edge.end).point) >= 0) return;
    const auto into_at = [&](double t) -> Vec3<double> { return std::sin(t) * edge.inward - std::cos(t) * edge.start; };
    const auto slope = [&](double t) {
      const Vec3<double> turned = std::cos(t) * edge.inward + std::sin(t) * edge.start;
      return (body.along(into_at(t)).point - w).dot(turned);
    };
    const double first = slope(0), last = slope(edge.width);
    if (!(first < 0 && last > 0)) return;
    const Vec3<double> into = into_at(root_between(slope, 0, first, edge.width, last));
    const BodyAtWall::Reach at = body.along(into);
    const double along = (at.point - w).dot(way) / length2, distance = w.dot(into);
    if (!(along >= -slack && along <= 1 + slack) || !(distance > 0)) return;
    out.add_reach(body, into, at, distance);
  }

  /// A ball about the corner has its common normal with the body, whatever its radius.
  void look_at_corner(const MeshCorner& corner) {
    const Vec3<double> w = corner.point - body.centre;
    if (w.squaredNorm() >= reach * reach || (body.range == 0 && !body.holds(corner.point))) return;
    const double ball = body.shape.semi_axes.minCoeff();
    const Eigen::Quaterniond& q = body.orientation;
    Pair pair;
    pair.body1 = {body.shape, Vec3<double>::Zero(), {q.w(), q.x(), q.y(), q.z()}};
    pair.body2 = {{Vec3<double>::Constant(ball)}, w, {1, 0, 0, 0}};
    const Contact<double> contact = automatic<double>(pair, Want{}, nullptr);
    if (contact.status != Status::converged) return out.fail();
    const Vec3<double>& into = contact.normal;
    for (const Vec3<double>& d : mesh.directions_from(corner))
      if (!(into.dot(d) >= -slack)) return;
    if (w.dot(into) > 0) out.add_if(body, {contact.overlap - ball, into, contact.point1});
  }
};

}  // namespace

void touch_mesh(const MeshWall& wall, const BodyAtWall& body, std::vector<std::uint32_t>& scratch, Touches& out) {
  const Vec3<double> half = body.half_extent();
  scratch.clear();
  wall.mesh->near(body.centre - half, body.centre + half, scratch);
  MeshQuery query{*wall.mesh, body, out};
  for (const std::uint32_t triangle : scratch) query.look_at(triangle);
}

}  // namespace plumb::scene
