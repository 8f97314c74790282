#include "solver/reference/convex/core.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>
#include <vector>

#include "solver/reference/convex/norms.hpp"
#include "solver/shape/hull.hpp"
#include "solver/shape/overloaded.hpp"

namespace plumb::reference::cores {

/// Octants of superellipsoids; of a superellipsoid all alike.
struct OctantsCore {
  std::array<I, 6> semi_axes;  ///< in PolySuperellipsoid's order
  double n1, n2;
};

/// The hull of two discs at z = bottom and z = top. The origin lies inside.
struct DiscsCore {
  I bottom, top, bottom_radius, top_radius;
};

/// Points within both balls that a tablet's caps are of, and within its radius of the axis. The origin lies inside.
struct TabletCore {
  I half_length, radius, cap_height;
  I ball;  ///< the radius of the balls
};

/// A body by functions, whose enclosures are believed, and that no point of it is beyond the bound.
struct ForeignCore {
  ForeignShape shape;
  int exponent;
  I bound;
};

/// Half-extents that may be 0: a segment or a point as well.
struct BoxCore {
  IVec3<I> half_extents;
};

/// The hull of points.
struct CornersCore {
  std::vector<IVec3<I>> corners;
  std::vector<Vec3<double>> rough;
};

using Kind = std::variant<OctantsCore, DiscsCore, TabletCore, BoxCore, CornersCore, ForeignCore>;
struct KindOfCore {
  Kind kind;
};

namespace {

using detail::Overloaded;

I scaled(double x, int exponent) {
  return times_power_of_two<I>(I(x), -exponent);
}

IVec3<I> scaled(const Vec3<double>& v, int exponent) {
  return {scaled(v[0], exponent), scaled(v[1], exponent), scaled(v[2], exponent)};
}

double rough(const I& x) {
  return low(x) + (high(x) - low(x)) / 2;
}

Kind octants(const std::array<double, 6>& semi_axes, double n1, double n2, int exponent) {
  OctantsCore out{{}, n1, n2};
  for (std::size_t i = 0; i < 6; ++i) out.semi_axes[i] = scaled(semi_axes[i], exponent);
  return out;
}

/// The centroid lies (R^2 + 2 R r + 3 r^2) / (4 (R^2 + R r + r^2)) of the height above the bottom. R and r are over the larger:
/// squares of slender ones underflow.
Kind frustum(const Frustum& s, int exponent) {
  const I larger(std::max(s.radii[0], s.radii[1])), from = I(s.radii[0]) / larger, to = I(s.radii[1]) / larger;
  const I ends = square<I>(from) + square<I>(to), mixed = from * to;
  const I share = (ends + I(2.0) * (mixed + square<I>(to))) / (I(4.0) * (ends + mixed));
  const I height = scaled(s.height, exponent);
  return DiscsCore{-(height * share), height * (I(1.0) - share), scaled(s.radii[0], exponent),
                   scaled(s.radii[1], exponent)};
}

/// The ball over the rim of radius r with the height e has the radius r^2/(2 e) + e/2.
Kind tablet(const Tablet& s, int exponent) {
  const I l = scaled(s.half_length, exponent), r = scaled(s.radius, exponent), e = scaled(s.cap_height, exponent);
  return TabletCore{l, r, e, r * (I(s.radius) / (I(2.0) * I(s.cap_height))) + I(0.5) * e};
}

Kind corners(const plumb::Hull& hull, int exponent) {
  CornersCore out;
  for (const Vec3<double>& corner : hull.corners) {
    out.corners.push_back(scaled(corner, exponent));
    const IVec3<I>& box = out.corners.back();
    out.rough.emplace_back(rough(box[0]), rough(box[1]), rough(box[2]));
  }
  return out;
}

bool is_sphere(const Superellipsoid<double>& s) {
  return s.n1 == 2 && s.n2 == 2 && (s.semi_axes.array() == s.semi_axes[0]).all();
}

I support_in(const OctantsCore& core, const IVec3<I>& u) {
  IVec3<I> q;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    q[k] = greatest_product(u[k], core.semi_axes[2 * i], core.semi_axes[2 * i + 1]);
  }
  return dual_norm_of(dual_norm_of(q[0], q[1], core.n2), q[2], core.n1);
}
I support_in(const DiscsCore& core, const IVec3<I>& u) {
  const I across = root<I>(square<I>(u[0]) + square<I>(u[1]));
  return greatest(core.bottom * u[2] + core.bottom_radius * across, core.top * u[2] + core.top_radius * across);
}
/// With a = |(u_x, u_y)| and z = |u_z| the ball reaches (l + e) z + R a^2 / (|u| + z), the rim l z + r a. The ball's is the tablet's where its
/// point lies on the cap: a (R - e) <= z r. The rim's is nowhere above the tablet's, the ball's nowhere below it, nor that of the cylinder about it.
I support_in(const TabletCore& core, const IVec3<I>& u) {
  const I square_across = square<I>(u[0]) + square<I>(u[1]), across = root<I>(square_across), z = magnitude<I>(u[2]);
  const I slant = root<I>(square_across + square<I>(u[2])) + z;
  const I share = is_positive(slant) ? I(square_across / slant) : across;
  const I rim = core.half_length * z + core.radius * across,
          ball = (core.half_length + core.cap_height) * z + core.ball * share;
  const double most = std::min(high(ball), high(I(core.half_length + core.cap_height) * z + core.radius * across));
  const I towards_rim = across * (core.ball - core.cap_height), towards_pole = z * core.radius;
  if (high(towards_rim) <= low(towards_pole)) return {std::min(low(ball), most), most};
  if (low(towards_rim) >= high(towards_pole)) return rim;
  return {low(rim), std::max(high(rim), most)};
}
I support_in(const BoxCore& core, const IVec3<I>& u) {
  I out(0.0);
  for (int i = 0; i < 3; ++i) out += core.half_extents[i] * magnitude<I>(u[i]);
  return out;
}
I support_in(const CornersCore& core, const IVec3<I>& u) {
  I out = dot<I>(core.corners[0], u);
  for (const IVec3<I>& corner : core.corners) out = greatest(out, dot<I>(corner, u));
  return out;
}

/// A box that holds a point of the core that is farthest along n: the one about the whole core, where no other is told.
IVec3<I> enclosure_of(const ForeignCore& core, const Vec3<double>& n) {
  Vec3<double> lower = -Vec3<double>::Constant(infinity), upper = -lower;
  if (core.shape.enclose != nullptr && n.allFinite() && !n.isZero(0))
    core.shape.enclose(core.shape.data, n.data(), lower.data(), upper.data());
  const double bound = high(core.bound);
  IVec3<I> out(I(-bound, bound), I(-bound, bound), I(-bound, bound));
  if (!lower.allFinite() || !upper.allFinite() || !(lower.array() <= upper.array()).all()) return out;
  for (int i = 0; i < 3; ++i) out[i] = I(low(scaled(lower[i], core.exponent)), high(scaled(upper[i], core.exponent)));
  return out;
}

/// h(v) for the middle v of the box, and what |u - v| may add: h rises by the bound a unit at most.
I support_in(const ForeignCore& core, const IVec3<I>& u) {
  const Vec3<double> v(rough(u[0]), rough(u[1]), rough(u[2]));
  IVec3<I> aside;
  for (int i = 0; i < 3; ++i) aside[i] = u[i] - I(v[i]);
  const I more = core.bound * length_of<I>(aside), at = dot<I>(enclosure_of(core, v), enclosed<I>(v));
  return at + I(-high(more), high(more));
}

/// By the gauge: sums of powers underflow beside the tips, where |x/a|^n is next to nothing.
bool is_proved(const OctantsCore& core, const Vec3<double>& x) {
  IVec3<I> over;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const I& semi_axis = core.semi_axes[x[k] >= 0 ? 2 * i : 2 * i + 1];
    if (!is_positive(semi_axis)) return false;
    over[k] = magnitude<I>(I(I(x[k]) / semi_axis));
  }
  return high(norm_of(norm_of(over[0], over[1], I(core.n2)), over[2], I(core.n1))) <= 1;
}
bool is_proved(const DiscsCore& core, const Vec3<double>& x) {
  if (!(x[2] >= high(core.bottom) && x[2] <= low(core.top))) return false;
  const I above = I(x[2]) - core.bottom, below = core.top - I(x[2]);
  const I height = core.top - core.bottom;
  if (!is_positive(height)) return false;
  const I radius = (core.bottom_radius * below + core.top_radius * above) / height;
  if (!(low(radius) >= 0)) return false;
  return high(I(square<I>(I(x[0])) + square<I>(I(x[1])))) <= low(square<I>(low_end<I>(radius)));
}
/// Above the rim by t the cap has the radius of the square (e - t) (r^2/e + t).
bool is_proved(const TabletCore& core, const Vec3<double>& x) {
  const I square_across = square<I>(I(x[0])) + square<I>(I(x[1]));
  if (std::abs(x[2]) <= low(core.half_length)) return high(square_across) <= low(square<I>(low_end<I>(core.radius)));
  const I above = I(std::abs(x[2])) - core.half_length, below = core.cap_height - above;
  if (!(low(below) >= 0 && is_positive(core.cap_height))) return false;
  const I most = below * (core.radius * (core.radius / core.cap_height) + above);
  return high(square_across) <= std::min(low(most), low(square<I>(low_end<I>(core.radius))));
}
bool is_proved(const BoxCore& core, const Vec3<double>& x) {
  for (int i = 0; i < 3; ++i)
    if (!(std::abs(x[i]) <= low(core.half_extents[i]))) return false;
  return true;
}

/// Of a core that holds the origin.
template <class C>
IVec3<I> drawn_in(const C& core, const Vec3<double>& x) {
  if (is_proved(core, x)) return enclosed<I>(x);
  constexpr int least = -51, greatest_draw = -2;
  for (int e = least; e <= greatest_draw; ++e) {
    const Vec3<double> y = x * (1 - std::ldexp(1.0, e));
    if (is_proved(core, y)) return enclosed<I>(y);
  }
  return enclosed<I>(Vec3<double>(0, 0, 0));
}

/// The gradient of |(|(a x, b y)|_m2, c z)|_m1.
CorePoint farthest_in(const OctantsCore& core, const Vec3<double>& u) {
  const double scale = u.cwiseAbs().maxCoeff();
  Vec3<double> reach, q;  // along the axes on the side of u
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    reach[k] = u[k] >= 0 ? rough(core.semi_axes[2 * i]) : -rough(core.semi_axes[2 * i + 1]);
    q[k] = reach[k] * (u[k] / scale);
  }
  const double e1 = 1 / (core.n1 - 1), e2 = 1 / (core.n2 - 1);  // m - 1
  const RoughNorm inner(q[0], q[1], 1 + e2), outer(inner.value, q[2], 1 + e1);
  const double level = std::pow(outer.first, e1);
  return {reach.cwiseProduct(
      Vec3<double>(level * std::pow(inner.first, e2), level * std::pow(inner.second, e2), std::pow(outer.second, e1)))};
}
CorePoint farthest_in(const DiscsCore& core, const Vec3<double>& u) {
  const double across = std::hypot(u[0], u[1]);
  const double bottom = rough(core.bottom) * u[2] + rough(core.bottom_radius) * across;
  const double top = rough(core.top) * u[2] + rough(core.top_radius) * across;
  const bool is_top = top > bottom;
  const double radius = rough(is_top ? core.top_radius : core.bottom_radius),
               z = rough(is_top ? core.top : core.bottom);
  if (!(across > 0)) return {{0, 0, z}};
  return {{radius * (u[0] / across), radius * (u[1] / across), z}};
}
CorePoint farthest_in(const TabletCore& core, const Vec3<double>& u) {
  const double l = rough(core.half_length), r = rough(core.radius), e = rough(core.cap_height), ball = rough(core.ball);
  const double across = std::hypot(u[0], u[1]), z = std::abs(u[2]), length = u.norm();
  if (across * (ball - e) <= z * r && length > 0)
    return {{ball * (u[0] / length), ball * (u[1] / length),
             std::copysign(l + e - ball * (across / length) * (across / (length + z)), u[2])}};
  if (!(across > 0)) return {{0, 0, std::copysign(l, u[2])}};
  return {{r * (u[0] / across), r * (u[1] / across), std::copysign(l, u[2])}};
}
CorePoint farthest_in(const BoxCore& core, const Vec3<double>& u) {
  CorePoint out;
  for (int i = 0; i < 3; ++i) out.at[i] = std::copysign(low(core.half_extents[i]), u[i]);
  return out;
}
CorePoint farthest_in(const CornersCore& core, const Vec3<double>& u) {
  std::size_t best = 0;
  double most = core.rough[0].dot(u);
  for (std::size_t i = 1; i < core.rough.size(); ++i) {
    const double reach = core.rough[i].dot(u);
    if (!(reach > most)) continue;
    most = reach;
    best = i;
  }
  return {core.rough[best], static_cast<int>(best)};
}

/// No finite number: the origin, which belongs to every core.
CorePoint farthest_in(const ForeignCore& core, const Vec3<double>& u) {
  const double length = u.stableNorm();
  if (!(length > 0 && length < infinity)) return {Vec3<double>::Zero()};
  const Vec3<double> n = u / length;
  Vec3<double> x = Vec3<double>::Constant(infinity);
  core.shape.support(core.shape.data, n.data(), x.data());
  if (!x.allFinite()) return {Vec3<double>::Zero()};
  return {Vec3<double>(rough(scaled(x[0], core.exponent)), rough(scaled(x[1], core.exponent)),
                       rough(scaled(x[2], core.exponent))),
          -1, n};
}

/// What is outside is left to drawn_in.
CorePoint near_in(const OctantsCore& /*core*/, const Vec3<double>& x) {
  return {x};
}
/// drawn_in moves along a slender cone's axis by much more than its side is away, and across a flat one's: what is beyond the side goes to the
/// nearest point of it here.
CorePoint near_in(const DiscsCore& core, const Vec3<double>& x) {
  constexpr double less = 1 - 0x1p-50;  // of rounding
  const double bottom = high(core.bottom), height = std::max(low(core.top) - bottom, 0.0);
  const double first = low(core.bottom_radius), wider = low(core.top_radius) - first;
  const double z = std::clamp(x[2] - bottom, 0.0, height), across = std::hypot(x[0], x[1]);
  if (!(across > less * (first + (height > 0 ? wider * (z / height) : 0)))) return {{x[0], x[1], bottom + z}};
  const double unit = std::max(std::abs(wider), height), w = unit > 0 ? wider / unit : 0,
               h = unit > 0 ? height / unit : 1;
  const double share = std::clamp(((across - first) * w + z * h) /
                                      (std::max(unit, std::numeric_limits<double>::min()) * (w * w + h * h)),
                                  0.0, 1.0);
  const double radius = less * (first + share * wider);
  return {{radius * (x[0] / across), radius * (x[1] / across), bottom + share * height}};
}
/// The side is cut off as a cone's is; what is near a pole is left to drawn_in.
CorePoint near_in(const TabletCore& core, const Vec3<double>& x) {
  constexpr double less = 1 - 0x1p-50;  // of rounding
  const double r = low(core.radius), e = low(core.cap_height), above = std::abs(x[2]) - low(core.half_length);
  if (!(above <= e / 2)) return {x};
  const double radius = less * (above <= 0 ? r : std::sqrt((e - above) * (r * (r / e) + above)));
  const double across = std::hypot(x[0], x[1]);
  if (!(across > radius)) return {x};
  return {{radius * (x[0] / across), radius * (x[1] / across), x[2]}};
}
CorePoint near_in(const BoxCore& core, const Vec3<double>& x) {
  CorePoint out;
  for (int i = 0; i < 3; ++i) out.at[i] = std::copysign(std::min(std::abs(x[i]), low(core.half_extents[i])), x[i]);
  return out;
}
CorePoint near_in(const CornersCore& core, const Vec3<double>& x) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < core.rough.size(); ++i)
    if ((core.rough[i] - x).squaredNorm() < (core.rough[best] - x).squaredNorm()) best = i;
  return {core.rough[best], static_cast<int>(best)};
}

/// The point is not drawn in: the farthest one on its side is taken.
CorePoint near_in(const ForeignCore& core, const Vec3<double>& x) {
  return farthest_in(core, x);
}

Kind kind_of(const Shape& shape, int exponent) {
  const auto box = [&](double x, double y, double z) -> Kind {
    return BoxCore{scaled(Vec3<double>(x, y, z), exponent)};
  };
  return std::visit(
      Overloaded{
          [&](const Superellipsoid<double>& s) {
            const Vec3<double>& a = s.semi_axes;
            if (is_sphere(s)) return box(0, 0, 0);
            return octants({a[0], a[0], a[1], a[1], a[2], a[2]}, s.n1, s.n2, exponent);
          },
          [&](const Capsule& s) { return box(0, 0, s.half_length); },
          [&](const Cylinder& s) -> Kind {
            const I half = scaled(s.half_length, exponent), radius = scaled(s.radius, exponent);
            return DiscsCore{-half, half, radius, radius};
          },
          [&](const Cone& s) { return frustum({{s.radius, 0}, s.height}, exponent); },
          [&](const Frustum& s) { return frustum(s, exponent); },
          [&](const ForeignShape& s) -> Kind { return ForeignCore{s, exponent, scaled(s.bounding_radius, exponent)}; },
          [&](const Tablet& s) { return tablet(s, exponent); },
          [&](const Box& s) { return box(s.half_extents[0], s.half_extents[1], s.half_extents[2]); },
          [&](const Polyhedron& s) { return corners(*s.hull, exponent); },
          [&](const PolySuperellipsoid& s) { return octants(s.semi_axes, s.n1, s.n2, exponent); },
          [&](const HalfSpace&) { return box(0, 0, 0); }},
      shape);
}

}  // namespace

Core core_of(const Shape& shape, int exponent) {
  return std::make_shared<KindOfCore>(KindOfCore{kind_of(shape, exponent)});
}

I radius_about_core(const Shape& shape, int exponent) {
  if (const auto* capsule = std::get_if<Capsule>(&shape)) return scaled(capsule->radius, exponent);
  const auto* round = std::get_if<Superellipsoid<double>>(&shape);
  return round != nullptr && is_sphere(*round) ? scaled(round->semi_axes[0], exponent) : I(0.0);
}

bool is_enclosed(const ConvexBody& body) {
  const auto* foreign = std::get_if<ForeignShape>(&body.shape);
  return foreign == nullptr || foreign->enclose != nullptr;
}

I support_of(const Core& core, const IVec3<I>& u) {
  return std::visit([&](const auto& c) { return support_in(c, u); }, core->kind);
}

IVec3<I> proved_point(const Core& core, const CorePoint& point) {
  return std::visit(Overloaded{[&](const CornersCore& c) { return c.corners[static_cast<std::size_t>(point.corner)]; },
                               [&](const ForeignCore& c) { return enclosure_of(c, point.along); },
                               [&](const auto& c) { return drawn_in(c, point.at); }},
                    core->kind);
}

CorePoint farthest(const Core& core, const Vec3<double>& u) {
  return std::visit([&](const auto& c) { return farthest_in(c, u); }, core->kind);
}

CorePoint near(const Core& core, const Vec3<double>& x) {
  return std::visit([&](const auto& c) { return near_in(c, x); }, core->kind);
}

}  // namespace plumb::reference::cores
