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

struct MeshQuery {
  const Mesh& mesh;
  const BodyAtWall& body;
  Touches& out;
  double reach = body.radius + body.range;

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
      const double least = parts.is_flat[side] ? -rounding * mesh.extent() * mesh.extent() : 0;  // the neighbour is as good
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
    const auto at_start = body.along(-edge.start), at_end = body.along(-edge.end);
    if (mesh.inwards(edge.sides[0], body.centre + at_start.point) >= 0 ||
        mesh.inwards(edge.sides[1], body.centre + at_end.point) >= 0)
      return;
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
