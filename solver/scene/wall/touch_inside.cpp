// A body in a cylinder or a cone: a straight line turned about the z axis, solid beyond it.
//
// Side   into the wall is u(phi) = c e(phi) + s z, e(phi) the radial direction, and o(phi) = h(u) + x.u - d has a local maximum where the
//        farthest point has no component along e'(phi). Where the body is narrower than the wall there is one; a body that is wide, or long,
//        may touch at several. Each is looked for from a round of directions: where G = (x + p).e' changes from + to -.
// Rim    of an open end: o(phi, a) with u turned by a from the side's, least in a (an edge), then as above in phi: for each phi the inner
//        minimum, and the envelope's slope is G again times the cosine of u to e: + to - is a maximum where u points outwards,
//        a minimum where it points inwards
// End    flat: a plane. A closed end's joint is concave: neither has an edge there
#include <cmath>
#include <numbers>

#include "solver/scene/wall/touches.hpp"

namespace plumb::scene {
namespace {

struct MeridianPoint {
  double radius, height;
};

/// From the lower end to the upper.
struct Meridian {
  std::array<MeridianPoint, 2> ends;
  std::array<End, 2> kinds;

  [[nodiscard]] double length() const {
    return std::hypot(ends[1].radius - ends[0].radius, ends[1].height - ends[0].height);
  }
  /// Into the wall, radial and along z.
  [[nodiscard]] MeridianPoint into() const {
    return {(ends[1].height - ends[0].height) / length(), -(ends[1].radius - ends[0].radius) / length()};
  }
};

Vec3<double> radial(double phi) {
  return {std::cos(phi), std::sin(phi), 0};
}
Vec3<double> around(double phi) {
  return {-std::sin(phi), std::cos(phi), 0};
}

/// Of a direction: G, and how deep the body is.
struct Round {
  double g, overlap;
};

/// Calls found(phi) for each phi where G changes from + to -. Between two directions it is looked at more closely where the body may reach
/// the wall: two contacts of which neither is seen are nearer to each other than a degree. Below `least` G is rounding: a ball on the axis
/// touches all round, and has no contact of its own.
template <class At, class Found>
class RoundSearch {
 public:
  RoundSearch(const At& at, double least, double curvature, const Found& found)
      : at_(at), found_(found), least_(least), curvature_(curvature) {}

  /// Of `directions` all round, those within `half` of the middle.
  void search(double middle, double half, int directions) {
    constexpr int least = 6;
    constexpr double aside =
        0.3;  // all round no direction that a scene's author would choose: there G is 0 to rounding
    const bool is_round = half >= std::numbers::pi;
    const int steps = std::max(least, static_cast<int>(std::ceil(directions * half / std::numbers::pi)));
    const double first = is_round ? aside : middle - half, step = 2 * half / steps;
    const Round start = at_(first);
    Round before = start;
    for (int k = 1; k <= steps; ++k) {
      const Round after = is_round && k == steps ? start : at_(first + step * k);
      look_between(first + step * (k - 1), before, first + step * k, after);
      before = after;
    }
  }

 private:
  void look_between(double low, const Round& at_low, double high, const Round& at_high) {
    constexpr int pieces = 8;
    const double step = high - low, slope = std::max(std::abs(at_low.g), std::abs(at_high.g)) + curvature_ * step;
    if (!(std::max(at_low.overlap, at_high.overlap) + slope * step > 0)) return;
    Round before = at_low;
    for (int k = 1; k <= pieces; ++k) {
      const double from = low + step * (k - 1) / pieces, to = k < pieces ? low + step * k / pieces : high;
      const Round after = k < pieces ? at_(to) : at_high;
      if (before.g > 0 && after.g <= 0 && before.g - after.g > least_ / pieces)
        found_(root_between([&](double phi) { return at_(phi).g; }, from, before.g, to, after.g));
      before = after;
    }
  }

  const At& at_;
  const Found& found_;
  double least_, curvature_;
};

class InsideQuery {
 public:
  InsideQuery(const Meridian& meridian, const BodyAtWall& body, Touches& out)
      : meridian_(meridian), body_(body), out_(out), into_(meridian.into()),
        across_(std::hypot(body.centre.x(), body.centre.y())), reach_(body.radius + body.range) {}

  void find() {
    const double outermost = std::max(meridian_.ends[0].radius, meridian_.ends[1].radius);
    if (!(across_ <= outermost + reach_)) return;
    find_side();
    for (const std::size_t end : {0, 1}) {
      if (meridian_.kinds[end] == End::closed) find_end(end);
      if (meridian_.kinds[end] == End::open) find_rim(end);
    }
  }

 private:
  static constexpr int side_directions = 48, rim_directions = 32;

  /// In directions within `half` of the middle.
  template <class At, class Found>
  void search(const At& at, double middle, double half, int directions, const Found& found) const {
    constexpr double rounding = 1e-13, slack = 1e-6;
    RoundSearch<At, Found>(at, rounding * body_.radius, body_.radius + across_, found)
        .search(middle, std::min(half + slack, std::numbers::pi), directions);
  }

  [[nodiscard]] Vec3<double> into_at(double phi) const {
    return into_.radius * radial(phi) + Vec3<double>(0, 0, into_.height);
  }

  /// Times into_.radius the part of a point along e'(phi), of u's own phi.
  [[nodiscard]] double across(const Vec3<double>& point, const Vec3<double>& u) const {
    return (u.x() * point.y() - u.y() * point.x()) / into_.radius;
  }

  void find_side() {
    const double offset = into_.radius * meridian_.ends[0].radius + into_.height * meridian_.ends[0].height;
    if (!is_beside()) return;
    const double left =
        offset - into_.height * body_.centre.z() - reach_;  // of the centre's way along e: it takes so much
    const double most = into_.radius * across_;
    if (!(left < most)) return;
    const auto at_phi = [&](double phi) -> Round {
      const Vec3<double> u = into_at(phi);
      const BodyAtWall::Reach at = body_.along(u);
      return {across(at.point + body_.centre, u), at.height + u.dot(body_.centre) - offset + body_.range};
    };
    const double half = left > -most ? std::acos(left / most) : std::numbers::pi;
    search(at_phi, std::atan2(body_.centre.y(), body_.centre.x()), half, side_directions, [&](double phi) {
      const Vec3<double> u = into_at(phi);
      const BodyAtWall::Reach at = body_.along(u);
      if (is_on_side(at.point + body_.centre, radial(phi)) && offset > u.dot(body_.centre))
        out_.add_reach(body_, u, at, offset - u.dot(body_.centre));
    });
  }

  /// Whether the body is as high as some of the side: beyond it a cone's surface would go on to its apex, where all is deep.
  [[nodiscard]] bool is_beside() const {
    const double half = body_.half_extent().z(), z = body_.centre.z();
    const bool is_above = meridian_.kinds[0] == End::closed || z + half >= meridian_.ends[0].height;
    return is_above && (meridian_.kinds[1] == End::closed || z - half <= meridian_.ends[1].height);
  }

  [[nodiscard]] bool is_on_side(const Vec3<double>& point, const Vec3<double>& outwards) const {
    const auto& [low, high] = meridian_.ends;
    const double along = (point.dot(outwards) - low.radius) * (high.radius - low.radius) +
                         (point.z() - low.height) * (high.height - low.height);
    const double length = meridian_.length();
    const bool is_above = meridian_.kinds[0] == End::closed || along >= 0;
    return is_above && (meridian_.kinds[1] == End::closed || along <= length * length);
  }

  void find_end(std::size_t end) {
    const Vec3<double> into(0, 0, end == 0 ? -1 : 1);
    const double distance = into.z() * (meridian_.ends[end].height - body_.centre.z());
    const BodyAtWall::Reach at = body_.along(into);
    if (distance > 0) out_.add_reach(body_, into, at, distance);
  }

  /// u turned by `angle` from the side's into the sheet.
  [[nodiscard]] Vec3<double> into_rim(std::size_t end, double phi, double angle) const {
    const double sign =
        end == 0 ? 1 : -1;  // into the sheet, along the meridian: (-into.height, into.radius) times that
    const double c = std::cos(angle), s = sign * std::sin(angle);
    return (c * into_.radius - s * into_.height) * radial(phi) +
           Vec3<double>(0, 0, c * into_.height + s * into_.radius);
  }

  /// The angle of least o; negative where it is on no edge: the body lies on the side, or beyond.
  [[nodiscard]] double rim_angle(std::size_t end, double phi) const {
    constexpr double most = std::numbers::pi;
    const Vec3<double> w = rim_point(end, phi) - body_.centre;
    const auto slope = [&](double angle) {
      const Vec3<double> turned = into_rim(end, phi, angle + std::numbers::pi / 2);
      return (body_.along(into_rim(end, phi, angle)).point - w).dot(turned);
    };
    const double first = slope(0), last = slope(most);
    return first < 0 && last > 0 ? root_between(slope, 0, first, most, last) : -1;
  }
  [[nodiscard]] Vec3<double> rim_point(std::size_t end, double phi) const {
    return meridian_.ends[end].radius * radial(phi) + Vec3<double>(0, 0, meridian_.ends[end].height);
  }

  /// A contact that overlaps is at a place of the rim in the body: there the gauge is below 1, and it is looked for first.
  void find_rim(std::size_t end) {
    const MeridianPoint& rim = meridian_.ends[end];
    const double below = body_.centre.z() - rim.height;
    if (rim.radius == 0 || std::hypot(across_ - rim.radius, below) >= reach_) return;
    const double left = rim.radius * rim.radius + across_ * across_ + below * below - reach_ * reach_;
    const double most = 2 * rim.radius * across_, least_cosine = most > 0 ? left / most : -2;
    if (least_cosine > 1) return;
    const double half = least_cosine > -1 ? std::acos(least_cosine) : std::numbers::pi;
    const double middle = std::atan2(body_.centre.y(), body_.centre.x());
    if (body_.range > 0) return search_rim(end, middle, half);
    const int steps = std::max(8, static_cast<int>(std::ceil(rim_directions * half / std::numbers::pi)));
    const double step = 2 * half / steps;
    for (int k = 0; k <= steps; ++k) look_for_rim(end, middle - half + step * k, step);
  }

  /// How far out of the body the rim is: 0 on its surface.
  [[nodiscard]] double outside(std::size_t end, double phi) const {
    return gauge<double>(body_.shape,
                         Vec3<double>(body_.orientation.conjugate() * (rim_point(end, phi) - body_.centre))) -
           1;
  }

  /// Where the gauge is least between two directions about this one.
  void look_for_rim(std::size_t end, double phi, double step) {
    constexpr int most_steps = 40;
    constexpr double section = 0.3819660112501051;
    const double here = outside(end, phi), before = outside(end, phi - step), after = outside(end, phi + step);
    if (!(here <= before && here < after)) return;
    double low = phi - step, high = phi + step, at = phi, least = here;
    for (int k = 0; k < most_steps && least > 0; ++k) {
      const bool is_low = at - low > high - at;
      const double next = is_low ? at - section * (at - low) : at + section * (high - at);
      const double value = outside(end, next);
      if (value < least) {
        (is_low ? high : low) = at;
        at = next, least = value;
      } else {
        (is_low ? low : high) = next;
      }
    }
    if (least > 0) return;
    while (outside(end, low) < 0 && low > phi - std::numbers::pi) low -= step;
    while (outside(end, high) < 0 && high < phi + std::numbers::pi) high += step;
    search_rim(end, (low + high) / 2, (high - low) / 2);
  }

  void search_rim(std::size_t end, double middle, double half) {
    const auto at_phi = [&](double phi) -> Round {
      const Vec3<double> u = into_rim(end, phi, std::max(0.0, rim_angle(end, phi)));
      const BodyAtWall::Reach at = body_.along(u);
      const Vec3<double> w = rim_point(end, phi) - body_.centre;
      return {(at.point + body_.centre).dot(around(phi)), at.height - w.dot(u) + body_.range};
    };
    search(at_phi, middle, half, rim_directions, [&](double phi) {
      const double angle = rim_angle(end, phi);
      if (angle < 0) return;
      const Vec3<double> u = into_rim(end, phi, angle);
      const double distance = u.dot(rim_point(end, phi) - body_.centre);
      if (distance > 0) out_.add_reach(body_, u, body_.along(u), distance);
    });
  }

  const Meridian& meridian_;
  const BodyAtWall& body_;
  Touches& out_;
  MeridianPoint into_;
  double across_, reach_;  ///< of the centre from the axis; of the body from its centre
};

}  // namespace

void touch_inside(const CylinderWall& wall, const BodyAtWall& body, Touches& out) {
  const Meridian meridian{{{{wall.radius, -wall.half_length}, {wall.radius, wall.half_length}}}, wall.ends};
  InsideQuery(meridian, body, out).find();
}

void touch_inside(const ConeWall& wall, const BodyAtWall& body, Touches& out) {
  const Meridian meridian{{{{wall.radii[0], 0}, {wall.radii[1], wall.height}}}, wall.ends};
  InsideQuery(meridian, body, out).find();
}

}  // namespace plumb::scene
