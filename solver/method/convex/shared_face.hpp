// The points of a contact of two polytopes along a normal that is known: the middle of what their faces share there.
//
// A body's part in it are its points that are farthest along the normal, to rounding: a face, an edge, a corner, or where a face is
// inclined by next to nothing the strip that is as far. Seen along the normal each is a convex polygon; one is cut by the sides of the
// other (Sutherland & Hodgman 1974), where they miss one another by sides moved outwards by rounding: so edges and corners cut as well.
#pragma once

#include "solver/method/convex/edges.hpp"
#include "solver/method/convex/stationary.hpp"
#include "solver/shape/curvature.hpp"

namespace plumb::detail {

/// Seen along the normal.
using Flat = Vec2<double>;

/// A convex polygon, counterclockwise; two points are a segment.
class Polygon {
 public:
  static constexpr int most = 64;

  [[nodiscard]] int size() const { return count_; }
  [[nodiscard]] const Flat& operator[](int k) const { return points_[static_cast<std::size_t>(k % count_)]; }
  [[nodiscard]] bool holds(const Flat& x) const {
    return std::find(points_.begin(), points_.begin() + count_, x) != points_.begin() + count_;
  }
  void add(const Flat& x) { points_[static_cast<std::size_t>(count_++)] = x; }

  /// The convex hull of what was added (Andrew 1979).
  [[nodiscard]] Polygon hull() {
    std::sort(points_.begin(), points_.begin() + count_,
              [](const Flat& a, const Flat& b) { return a[0] < b[0] || (a[0] == b[0] && a[1] < b[1]); });
    Polygon out;
    for (int k = 0; k < count_; ++k) out.turn_left_to((*this)[k], 1);
    const int lower = out.count_;
    for (int k = count_ - 2; k >= 0; --k) out.turn_left_to((*this)[k], lower);
    if (out.count_ > 1) --out.count_;  // the first again
    return out;
  }
  /// The largest outward.x of its corners.
  [[nodiscard]] double farthest(const Flat& outward) const {
    double out = -std::numeric_limits<double>::infinity();
    for (int k = 0; k < count_; ++k) out = std::max(out, outward.dot((*this)[k]));
    return out;
  }
  /// Leaves what lies in outward.x <= bound.
  void cut(const Flat& outward, double bound) {
    std::array<Flat, most> left;
    int count = 0;
    const auto keep = [&](const Flat& x) { left[static_cast<std::size_t>(count++)] = x; };
    for (int k = 0; k < count_; ++k) {
      const Flat &from = (*this)[k], &to = (*this)[k + 1];
      const double before = outward.dot(from) - bound, after = outward.dot(to) - bound;
      if (before <= 0) keep(from);
      if ((before < 0 && after > 0) || (before > 0 && after < 0)) keep(from + before / (before - after) * (to - from));
    }
    std::copy_n(left.begin(), count, points_.begin());
    count_ = count;
  }
  /// The centroid; of what has next to no area that of its corners. There is one at least.
  [[nodiscard]] Flat middle() const {
    double area = 0, extent = 0;
    Flat moment = Flat::Zero(), sum = Flat::Zero();
    for (int k = 0; k < count_; ++k) {
      const Flat a = (*this)[k] - points_[0], b = (*this)[k + 1] - points_[0];
      const double twice = cross(a, b);
      area += twice;
      moment += twice / 3 * (a + b);
      sum += a;
      extent = std::max(extent, a.squaredNorm());
    }
    constexpr double flat = 1e-9;
    return points_[0] + (area > flat * extent ? Flat(moment / area) : Flat(sum / count_));
  }

 private:
  [[nodiscard]] static double cross(const Flat& a, const Flat& b) { return a[0] * b[1] - a[1] * b[0]; }
  void turn_left_to(const Flat& x, int first) {
    while (count_ > first && !(cross(before_end(1) - before_end(2), x - before_end(1)) > 0)) --count_;
    add(x);
  }
  [[nodiscard]] const Flat& before_end(std::size_t k) const { return points_[static_cast<std::size_t>(count_) - k]; }

  std::array<Flat, most> points_;
  int count_ = 0;
};

class SharedFace {
 public:
  SharedFace(const PlacedCores& pair, const Vec3<double>& normal)
      : pair_(pair), normal_(normal), s_(normal.unitOrthogonal()), t_(normal.cross(s_)),
        farthest_(pair.support(normal)) {}

  /// nullopt: they share no point, or have more corners than fit.
  [[nodiscard]] std::optional<CommonNormal> contact() const {
    const auto first = face(pair_.body1, farthest_.point1, 1), second = face(pair_.body2, farthest_.point2, -1);
    if (!first || !second) return std::nullopt;
    Polygon shared = shared_by(*first, *second, 0);
    if (shared.size() == 0) shared = shared_by(*first, *second, pair_.rounding());
    if (shared.size() == 0) return std::nullopt;
    const Flat middle = shared.middle();
    const auto at = [&](const Vec3<double>& x) {
      return Vec3<double>(middle[0] * s_ + middle[1] * t_ + x.dot(normal_) * normal_);
    };
    const Vec3<double> point1 = at(farthest_.point1), point2 = at(farthest_.point2);
    return CommonNormal{normal_, farthest_.w().dot(normal_), point1, point2};
  }

 private:
  static constexpr int most_corners = 24;

  /// What of a polygon lies in `by`, whose sides are moved outwards by `aside`, and in the box about it: where it has no sides.
  [[nodiscard]] static Polygon shared_by(Polygon out, const Polygon& by, double aside) {
    const auto cut_across = [&](const Flat& outward) { out.cut(outward, by.farthest(outward) + aside); };
    for (int k = 0; k < by.size(); ++k) {
      const Flat side = by[k + 1] - by[k];
      if (const double length = side.norm(); length > 0) cut_across(Flat(side[1], -side[0]) / length);
    }
    for (const Flat& outward : {Flat(1, 0), Flat(-1, 0), Flat(0, 1), Flat(0, -1)}) cut_across(outward);
    return out;
  }

  /// A body's points that are as far along sign times the normal as `farthest`, but for rounding.
  [[nodiscard]] std::optional<Polygon> face(const PlacedCore& body, const Vec3<double>& farthest, double sign) const {
    const Mat3<double> to_body = body.rotation.transpose();
    const Vec3<double> u = sign * (to_body * normal_), s = to_body * s_, t = to_body * t_;
    const Flat centre(s_.dot(body.centre), t_.dot(body.centre));
    const double reach = sign * (farthest - body.centre).dot(normal_) - pair_.rounding();
    Polygon corners;
    const auto add = [&](const Vec3<double>& x) {
      const Flat seen = Flat(s.dot(x), t.dot(x)) + centre;
      if (corners.size() <= most_corners && !corners.holds(seen)) corners.add(seen);
    };
    add(to_body * (farthest - body.centre));
    (void)with_edges(body.core, [&](const auto& polytope) {
      const auto below = [&](int corner) { return reach - polytope.core.corner(corner).dot(u); };
      std::array<double, 64>
          known;  // of the corners with the lowest numbers: an edge asks for two, a corner has three edges or more
      const int count = std::min(polytope.core.corners(), static_cast<int>(known.size()));
      for (int k = 0; k < count; ++k) known[static_cast<std::size_t>(k)] = below(k);
      const auto below_of = [&](int corner) {
        return corner < count ? known[static_cast<std::size_t>(corner)] : below(corner);
      };
      for (int k = 0; k < polytope.edges(); ++k) {
        const Ends ends = polytope.ends(k);
        const double before = below_of(ends.from), after = below_of(ends.to);
        if (before > 0 && after > 0) continue;
        const Vec3<double> from = polytope.core.corner(ends.from), to = polytope.core.corner(ends.to);
        add(before > 0 ? to + after / (after - before) * (from - to) : from);
        add(after > 0 ? from + before / (before - after) * (to - from) : to);
      }
    });
    if (corners.size() > most_corners) return std::nullopt;
    return corners.hull();
  }

  const PlacedCores& pair_;
  Vec3<double> normal_, s_, t_;
  Difference farthest_;
};

}  // namespace plumb::detail
