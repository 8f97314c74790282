// The point of M nearest to a point outside: an active-set method on support points (Wolfe 1976, finding the nearest point in a
// polytope), at most four of which are kept. Of polytopes it ends with the point itself; of smooth bodies its last steps are left to
// stationary.hpp.
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
  /// Unit, of the triangle of three, on the side of `outside`; of two what of that is across their edge: close to M the nearest point's own
  /// direction is known to rounding over the distance, and the edge to rounding.
  [[nodiscard]] std::optional<Vec3<double>> facet_normal(const Vec3<double>& outside) const {
    if (count == 2) {
      const Vec3<double> edge = of[1].w() - of[0].w(), across = outside - outside.dot(edge) / edge.squaredNorm() * edge;
      return across.squaredNorm() > 0 ? std::optional(across.normalized().eval()) : std::nullopt;
    }
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

/// `along`: unit, a guess of the normal. Ends where the gap is gone and no corner is new, or where rounding lets nothing more be gained.
/// A gap is of second order in the normal: a corner that is new is taken in all the same, for the normal's sake.
class NearestPoint {
 public:
  NearestPoint(const PlacedCores& pair, const Vec3<double>& target, const Vec3<double>& along)
      : pair_(pair), target_(target),
        out_{{}, along, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), false} {
    out_.mixture.of[0] = pair.support(along);
    out_.mixture.weight[0] = 1;
    out_.mixture.count = 1;
  }

  [[nodiscard]] Nearest find() {
    constexpr int most_steps = 100, most_idle = 8;
    for (int step = 0, idle = 0; step < most_steps && idle < most_idle; ++step) {
      const Vec3<double> x = out_.mixture.w() - target_;
      out_.distance = x.norm();
      out_.is_inside = out_.mixture.count == Mixture::most || out_.distance <= rounding * pair_.size;
      if (out_.is_inside) break;
      out_.normal = -x / out_.distance;
      const Difference seen = pair_.support(out_.normal);
      out_.gap = std::min(out_.gap, out_.distance + (seen.w() - target_).dot(out_.normal));
      if (out_.gap <= rounding * pair_.size && is_known(seen)) break;
      const double before = x.squaredNorm(), after = take_in(seen, before * (1 + rounding));
      if (!(after <= before * (1 + rounding))) break;
      if (!(after < before)) ++idle;
    }
    return out_;
  }

 private:
  static constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();

  [[nodiscard]] bool is_known(const Difference& seen) const {
    const Mixture& m = out_.mixture;
    return std::any_of(m.of.begin(), m.of.begin() + m.count, [&](const Difference& known) {
      return known.piece1 == seen.piece1 && known.piece2 == seen.piece2;
    });
  }

  /// The mixture nearest to the target of which `seen` is one: the square of its distance, and taken where that is no more than `most`.
  double take_in(const Difference& seen, double most) {
    Mixture& mixture = out_.mixture;
    std::array<Vec3<double>, Mixture::most> y;
    for (int k = 0; k < mixture.count; ++k) y[index(k)] = mixture.of[index(k)].w() - target_;
    y[index(mixture.count)] = seen.w() - target_;
    const SimplexFaces faces(y, mixture.count + 1);
    const NearestInSimplex& nearest = faces.nearest();
    if (nearest.count == 0 || !(nearest.distance2 <= most)) return std::numeric_limits<double>::infinity();
    const Mixture before = mixture;
    mixture.count = nearest.count;
    for (int k = 0; k < nearest.count; ++k) {
      const int from = nearest.corners[index(k)];
      mixture.of[index(k)] = from == before.count ? seen : before.of[index(from)];
      mixture.weight[index(k)] = nearest.weight[index(k)];
    }
    return nearest.distance2;
  }
  [[nodiscard]] static std::size_t index(int k) { return static_cast<std::size_t>(k); }

  const PlacedCores& pair_;
  Vec3<double> target_;
  Nearest out_;
};

}  // namespace plumb::detail
