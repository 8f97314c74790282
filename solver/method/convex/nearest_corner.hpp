// The nearest points of two polytopes that are apart by next to nothing, where they are a corner and a point of an edge.
//
// Edges that are parallel but for as little as they are apart make M a sliver beside the origin, whose nearest point is not seen by its
// support points. A corner and an edge are no face and no crossing of edges, and so PolytopeMinimum has no normal of them.
#pragma once

#include "solver/method/convex/edges.hpp"
#include "solver/method/convex/stationary.hpp"

namespace plumb::detail {

class NearestCorner {
 public:
  explicit NearestCorner(const PlacedCores& pair) {
    look_at(pair.body1, pair.body2, [&](const Vec3<double>& n, const Vec3<double>& corner, const Vec3<double>& point) {
      best_ = {n, -distance_, corner, point};
    });
    look_at(pair.body2, pair.body1, [&](const Vec3<double>& n, const Vec3<double>& corner, const Vec3<double>& point) {
      best_ = {-n, -distance_, point, corner};
    });
  }

  /// Of the corners and edges that are apart; nullopt: there are none. The overlap is less their distance, which need not be that along the normal.
  [[nodiscard]] std::optional<CommonNormal> contact() const { return best_; }

 private:
  /// take(n, corner, point), n from the corner to the point, where they are nearer than all before.
  template <class Take>
  void look_at(const PlacedCore& of_corners, const PlacedCore& of_edges, const Take& take) {
    (void)with_edges(of_corners.core, [&](const auto& first) {
      (void)with_edges(of_edges.core, [&](const auto& second) {
        for (int k = 0; k < first.core.corners(); ++k)
          for (int j = 0; j < second.edges(); ++j)
            look_at(of_corners.rotation * first.core.corner(k) + of_corners.centre, placed(of_edges, second.edge(j), 1),
                    take);
      });
    });
  }

  template <class Take>
  void look_at(const Vec3<double>& corner, const EdgeOfCore& edge, const Take& take) {
    const Vec3<double> along = edge.direction();
    const double share = std::clamp((corner - edge.from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    const Vec3<double> point = edge.from + share * along, apart = point - corner;
    const double distance = apart.norm();
    if (!(distance > 0 && distance < distance_)) return;
    distance_ = distance;
    // Rounding of a short distance turns n: but not along the edge, which lies across it.
    const bool is_within = share > 0 && share < 1;
    const Vec3<double> n = apart / distance;
    take(is_within ? (n - n.dot(along) / along.squaredNorm() * along).normalized().eval() : n, corner, point);
  }

  double distance_ = std::numeric_limits<double>::infinity();
  std::optional<CommonNormal> best_;
};

}  // namespace plumb::detail
