// The point of M nearest to a point outside: an active-set method on support points (Wolfe 1976, finding the nearest point in a
// polytope), at most four of which are kept. Of polytopes it ends with the point itself; of smooth bodies its last steps are left to
// common_normal.hpp.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>

#include "solver/method/convex/placed_cores.hpp"

namespace plumb::detail {

/// A point of M as a mixture of support points: so its points on the bodies are known as well.
struct Mixture {
  static constexpr int most = 4;
  std::array<Difference, most> of;
  std::array<double, most> weight{};
  int count = 0;

  [[nodiscard]] Vec3<double> point1() const {
    return sum([](const Difference& d) { return d.point1; });
  }
  [[nodiscard]] Vec3<double> point2() const {
    return sum([](const Difference& d) { return d.point2; });
  }
  [[nodiscard]] Vec3<double> w() const {
    return sum([](const Difference& d) { return d.w(); });
  }
  /// Unit, of the triangle of three, on the side of `outside`.
  [[nodiscard]] std::optional<Vec3<double>> facet_normal(const Vec3<double>& outside) const {
    if (count != 3) return std::nullopt;
    const Vec3<double> n = (of[1].w() - of[0].w()).cross(of[2].w() - of[0].w());
    if (!(n.squaredNorm() > 0)) return std::nullopt;
    return n.dot(outside) < 0 ? (-n.normalized()).eval() : n.normalized().eval();
  }

 private:
  template <class F>
  [[nodiscard]] Vec3<double> sum(const F& of_one) const {
    Vec3<double> out = Vec3<double>::Zero();
    for (int k = 0; k < count; ++k)
      out += weight[static_cast<std::size_t>(k)] * of_one(of[static_cast<std::size_t>(k)]);
    return out;
  }
};

/// The point of a simplex nearest to the origin: which corners it is a mixture of, and their weights.
struct NearestInSimplex {
  std::array<int, 4> corners;
  std::array<double, 4> weight;
  int count;
  double distance2;
};

/// Of the faces that hold the last corner: the others' nearest point is known not to be the nearest.
class SimplexFaces {
 public:
  explicit SimplexFaces(const std::array<Vec3<double>, 4>& corners, int count) : y_(corners) {
    const int last = count - 1;
    consider({last}, {1}, 1);
    for (int i = 0; i < last; ++i) edge(i, last);
    for (int i = 0; i < last; ++i)
      for (int j = i + 1; j < last; ++j) triangle(i, j, last);
    if (count == 4) tetrahedron();
  }
  [[nodiscard]] const NearestInSimplex& nearest() const { return nearest_; }

 private:
  [[nodiscard]] const Vec3<double>& at(int k) const { return y_[static_cast<std::size_t>(k)]; }

  /// Weights of any sign and sum: nothing, where one is negative.
  void consider(const std::array<int, 4>& corners, std::array<double, 4> weight, int count) {
    double sum = 0;
    for (int k = 0; k < count; ++k) {
      if (!(weight[static_cast<std::size_t>(k)] >= 0)) return;
      sum += weight[static_cast<std::size_t>(k)];
    }
    if (!(sum > 0)) return;
    Vec3<double> x = Vec3<double>::Zero();
    for (int k = 0; k < count; ++k) {
      weight[static_cast<std::size_t>(k)] /= sum;
      x += weight[static_cast<std::size_t>(k)] * at(corners[static_cast<std::size_t>(k)]);
    }
    if (x.squaredNorm() < nearest_.distance2) nearest_ = {corners, weight, count, x.squaredNorm()};
  }
  void edge(int i, int j) {
    const Vec3<double> d = at(j) - at(i);
    consider({i, j}, {at(j).dot(d), -at(i).dot(d)}, 2);
  }
  void triangle(int i, int j, int k) {
    const Vec3<double> n = (at(j) - at(i)).cross(at(k) - at(i));
    const auto area = [&](int a, int b) { return n.dot(at(a).cross(at(b))); };
    consider({i, j, k}, {area(j, k), area(k, i), area(i, j)}, 3);
  }
  void tetrahedron() {
    const auto volume = [&](int a, int b, int c) { return at(a).dot(at(b).cross(at(c))); };
    const double all = (at(1) - at(0)).dot((at(2) - at(0)).cross(at(3) - at(0)));
    const double s = all < 0 ? -1 : 1;
    consider({0, 1, 2, 3}, {s * volume(1, 2, 3), -s * volume(0, 2, 3), s * volume(0, 1, 3), -s * volume(0, 1, 2)}, 4);
  }

  const std::array<Vec3<double>, 4>& y_;
  NearestInSimplex nearest_{{}, {}, 0, std::numeric_limits<double>::infinity()};
};

/// The nearest point to a target outside of M.
struct Nearest {
  Mixture mixture;
  Vec3<double> normal;  ///< unit, from M to the target; of a target inside the last direction that was looked along
  double distance;      ///< of the mixture from the target; 0 to rounding: it lies inside
  double gap;           ///< the true distance is less by this at most
  bool is_inside;
};

/// `along`: unit, a guess of the normal. Ends where the gap is `tolerance`, or where rounding lets nothing more be gained.
[[nodiscard]] inline Nearest nearest_point(const PlacedCores& pair, const Vec3<double>& target,
                                           const Vec3<double>& along, double tolerance) {
  constexpr int most_steps = 100;
  constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
  Nearest out{{}, along, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), false};
  Mixture& mixture = out.mixture;
  mixture.of[0] = pair.support(along);
  mixture.weight[0] = 1;
  mixture.count = 1;
  for (int step = 0; step < most_steps; ++step) {
    const Vec3<double> x = mixture.w() - target;
    out.distance = x.norm();
    if (mixture.count == Mixture::most || out.distance <= rounding * pair.size) return out.is_inside = true, out;
    out.normal = -x / out.distance;
    const Difference seen = pair.support(out.normal);
    out.gap = std::min(out.gap, out.distance + (seen.w() - target).dot(out.normal));
    if (out.gap <= std::max(tolerance, rounding * pair.size)) return out;
    std::array<Vec3<double>, 4> y;
    for (int k = 0; k < mixture.count; ++k)
      y[static_cast<std::size_t>(k)] = mixture.of[static_cast<std::size_t>(k)].w() - target;
    y[static_cast<std::size_t>(mixture.count)] = seen.w() - target;
    const SimplexFaces faces(y, mixture.count + 1);
    if (!(faces.nearest().distance2 < x.squaredNorm())) return out;
    const Mixture before = mixture;
    const auto& nearest = faces.nearest();
    mixture.count = nearest.count;
    for (int k = 0; k < nearest.count; ++k) {
      const auto from = static_cast<std::size_t>(nearest.corners[static_cast<std::size_t>(k)]);
      mixture.of[static_cast<std::size_t>(k)] = static_cast<int>(from) == before.count ? seen : before.of[from];
      mixture.weight[static_cast<std::size_t>(k)] = nearest.weight[static_cast<std::size_t>(k)];
    }
  }
  return out;
}

}  // namespace plumb::detail
