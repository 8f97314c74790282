// A body as a wall sees it, in the wall's axes, and where it touches.
//
// o(u) = h(u) - w.u is how deep a point w (from the body's centre) is in the body along u, h the support function. A contact of a wall is
// a place where o is stationary: u is the only direction on a face, and of least o on an edge or a corner.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <span>

#include "solver/scene/body/columns.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb::scene {

struct BodyAtWall {
  Superellipsoid<double> shape;
  Vec3<double> centre;             ///< from the wall's point
  Eigen::Quaterniond orientation;  ///< unit
  double radius;                   ///< of a ball about the centre that holds the body
  double range;                    ///< what is so far apart touches too

  /// The body's farthest point along a unit u, from its centre, and its height.
  struct Reach {
    double height = 0;
    Vec3<double> point = Vec3<double>::Zero();
  };
  [[nodiscard]] Reach along(const Vec3<double>& u) const {
    const NormValue<double> at = support_point<double>(shape, orientation.conjugate() * u);
    return {at.value, orientation * at.gradient};
  }
  /// Whether a place of the wall is in the body.
  [[nodiscard]] bool holds(const Vec3<double>& place) const {
    constexpr double rounding = 1e-9;
    return gauge<double>(shape, Vec3<double>(orientation.conjugate() * (place - centre))) <= 1 + rounding;
  }
  /// Half of the box about the centre, along the wall's axes.
  [[nodiscard]] Vec3<double> half_extent() const {
    const Vec3<double> box = orientation.toRotationMatrix().cwiseAbs() * shape.semi_axes;
    return box.cwiseMin(radius).array() + range;
  }
};

/// Where a body touches: how deep, into the wall (unit), and its farthest point there, from its centre.
struct Touch {
  double overlap = 0;
  Vec3<double> into = Vec3<double>::Zero(), reach = Vec3<double>::Zero();
};

/// The touches of one body and one wall, at most so many.
class Touches {
 public:
  static constexpr std::size_t most = 64;

  /// On a place of the wall along `into`. Nothing where the body does not come that near; where it overlaps, the place has to be in it: what
  /// is beyond, as a rod's end behind a table, is no contact with the place.
  void add_reach(const BodyAtWall& body, const Vec3<double>& into, const BodyAtWall::Reach& at, double distance) {
    add_if(body, {at.height - distance, into, at.point});
  }
  void add_if(const BodyAtWall& body, const Touch& touch) {
    if (!(touch.overlap > -body.range)) return;
    if (touch.overlap > 0 && !body.holds(body.centre + touch.reach - touch.overlap * touch.into)) return;
    add(touch);
  }
  void add(const Touch& touch) {
    if (count_ < most)
      touches_[count_++] = touch;
    else
      is_complete_ = false;
  }
  /// A solve without an answer.
  void fail() { is_complete_ = false; }

  [[nodiscard]] std::span<const Touch> all() const { return std::span(touches_).first(count_); }
  /// False: some are missing.
  [[nodiscard]] bool is_complete() const { return is_complete_; }

  /// Keeps the deepest of those that are one contact, and no more than `places` of the rest.
  void keep_deepest(const BodyAtWall& body, double smooth, std::size_t places);

 private:
  std::array<Touch, most> touches_;
  std::size_t count_ = 0;
  bool is_complete_ = true;
};

/// g(t) = 0 between g(low) and g(high) of opposite signs, to rounding: secants that are not let stay at one end, halved where they are slow.
template <class G>
[[nodiscard]] double root_between(const G& g, double low, double g_low, double high, double g_high) {
  constexpr int most_steps = 120;
  double at = low;
  for (int step = 0; step < most_steps; ++step) {
    const bool halves = step % 3 == 2;
    at = halves ? (low + high) / 2 : (low * g_high - high * g_low) / (g_high - g_low);
    if (!(at > std::min(low, high) && at < std::max(low, high))) at = (low + high) / 2;
    if (at == low || at == high) break;
    const double g_at = g(at);
    if (g_at == 0) break;
    const bool is_low = (g_at > 0) == (g_low > 0);
    (is_low ? low : high) = at;
    (is_low ? g_low : g_high) = g_at;
    if (!halves) (is_low ? g_high : g_low) /= 2;  // Illinois
    if (std::abs(high - low) <= 4e-16 * std::max(std::abs(low), std::abs(high))) break;
  }
  return at;
}

}  // namespace plumb::scene
