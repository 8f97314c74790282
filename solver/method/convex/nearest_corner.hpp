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
    look_at(pair.body1, pair.body2, true);
    look_at(pair.body2, pair.body1, false);
  }

  /// Of the corners and edges that are apart; nullopt: there are none. The overlap is less their distance, which need not be that along the normal.
  [[nodiscard]] std::optional<CommonNormal> contact() const { return best_; }

 private:
  void look_at(const PlacedCore& of_corners, const PlacedCore& of_edges, bool is_corner_first) {
    (void)with_edges(of_corners.core, [&](const auto& first) {
      (void)with_edges(of_edges.core, [&](const auto& second) {
        for (int k = 0; k < first.core.corners(); ++k) {
          const Vec3<double> corner = of_corners.rotation * first.core.corner(k) + of_corners.centre;
          for (int j = 0; j < second.edges(); ++j)
            look_at(corner, placed(of_edges, second.edge(j), 1), is_corner_first);
        }
      });
    });
  }

  void look_at(const Vec3<double>& corner, const EdgeOfCore& edge, bool is_corner_first) {
    const Vec3<double> along = edge.direction();
    const double share = std::clamp((corner - edge.from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    const Vec3<double> point = edge.from + share * along, apart = point - corner;
    const double distance = apart.norm();
    if (!(distance > 0 && distance < distance_)) return;
    distance_ = distance;
    Vec3<double> n = apart / distance;
    // Rounding of a short distance turns n: but not along the edge, which lies across it.
    if (share > 0 && share < 1) n = (n - n.dot(along) / along.squaredNorm() * along).normalized();
    best_ = is_corner_first ? CommonNormal{n, -distance, corner, point} : CommonNormal{-n, -distance, point, corner};
  }

  double distance_ = std::numeric_limits<double>::infinity();
  std::optional<CommonNormal> best_;
};

}  // namespace plumb::detail
