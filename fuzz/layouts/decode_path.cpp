#include "fuzz/layouts/decode_path.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "fuzz/layouts/layout_fields.hpp"
#include "properties/generators/paths.hpp"
#include "solver/pose.hpp"

namespace plumb {
namespace {

using layout::read;
using Vec = Vec3<long double>;
using Turn = Eigen::Quaternion<long double>;

constexpr std::array<double, 16> kLengths{0.1,  1,     0.01,  0,     1e-3,  1e-4, 1e-6, 1e-8,
                                          1e-9, 1e-10, 1e-12, 1e-14, 1e-16, 0.5,  2,    4};

struct Motion {
  std::uint32_t kind = 0;
  Pair start;
  Vec u, w, t;
  long double length = 0;
  long double degrees = 0;
  Vec axis1, axis2;        ///< unit, world axes: about which the bodies turn
  Vec along;               ///< unit: body 1's axis for kind 5
  long double radius = 0;  ///< from body 2's centre to the plane on which it rolls
};

/// Any unit vector across u, the same for the same u.
Vec across(const Vec& u) {
  Eigen::Index least = 0;
  u.cwiseAbs().minCoeff(&least);
  return u.cross(Vec::Unit(least)).normalized();
}

Vec turned(const Vec& v, const Vec& axis, long double degrees) {
  const auto [c, s] = layout::cos_sin_deg(degrees);
  return c * v + s * axis.cross(v) + (1 - c) * axis.dot(v) * axis;
}

Vec axis_of(std::uint32_t choice, const Body& body, const Motion& motion) {
  const Eigen::Index k = choice % 8;
  if (k < 3) return rotation<long double>(body.quaternion).col(k);
  if (k < 6) return Vec::Unit(k - 3);
  return k == 6 ? motion.u : motion.w;
}

/// In long double by way of log scale: layout_fields.hpp.
long double length_in_bodies(std::uint32_t v) {
  return v < 256 ? static_cast<long double>(kLengths[v % kLengths.size()]) : layout::log_magnitude(v);
}

long double smaller_size(const Pair& pair) {
  return std::min(pair.body1.shape.semi_axes.maxCoeff(), pair.body2.shape.semi_axes.maxCoeff());
}

Motion read_motion(layout::Bytes bytes, const Pair& start) {
  Motion motion;
  motion.kind = read(bytes, 72, 1) % 8;
  motion.start = start;
  motion.u = decode_recipe(bytes).line;
  motion.w = turned(across(motion.u), motion.u, layout::angle(bytes, 84));
  motion.t = motion.u.cross(motion.w);
  motion.length = length_in_bodies(read(bytes, 76, 2)) * smaller_size(start);
  motion.degrees = layout::angle(bytes, 80);
  motion.axis1 = axis_of(read(bytes, 78, 1), start.body1, motion);
  motion.axis2 = axis_of(read(bytes, 78, 1), start.body2, motion);
  motion.along = rotation<long double>(start.body1.quaternion).col(read(bytes, 79, 1) % 3);
  motion.radius = reach(start.body2, -motion.u);
  return motion;
}

void shift(Body& body, const Vec& by) {
  body.position = (body.position.cast<long double>() + by).cast<double>();
}

void turn_body(Body& body, const Vec& axis, long double degrees) {
  const auto& q = body.quaternion;
  const auto [c, s] = layout::cos_sin_deg(degrees / 2);
  const Turn by(c, s * axis[0], s * axis[1], s * axis[2]);
  const Turn now = by * Turn(q[0], q[1], q[2], q[3]);
  body.quaternion = {static_cast<double>(now.w()), static_cast<double>(now.x()), static_cast<double>(now.y()),
                     static_cast<double>(now.z())};
}

/// Body 2's centre, about body 1's.
Vec orbited(const Motion& motion, long double s) {
  const Vec from = motion.start.body2.position.cast<long double>() - motion.start.body1.position.cast<long double>();
  return turned(from, motion.t, s * motion.degrees) - from;
}

Pair pose(const Motion& motion, long double s) {
  Pair pair = motion.start;
  Body& body2 = pair.body2;
  const long double turn = s * motion.degrees, way = s * motion.length;
  switch (motion.kind) {
    case 0: shift(body2, way * motion.u); break;
    case 1: shift(body2, way * motion.w); break;
    case 2: turn_body(body2, motion.axis2, turn); break;
    case 3:
      shift(body2, turn * std::numbers::pi_v<long double> / 180 * motion.radius * motion.w);
      turn_body(body2, motion.t, turn);
      break;
    case 4: shift(body2, orbited(motion, s)); break;
    case 5: shift(body2, way * motion.along); break;
    case 6:
      turn_body(pair.body1, motion.axis1, -turn);
      turn_body(body2, motion.axis2, turn);
      break;
    default: shift(body2, way * motion.u); turn_body(body2, motion.axis2, turn);
  }
  return pair;
}

/// s at step k of n, from 1 down to 10^-decades and, past 0 where n is odd, on to -1.
long double through_small(int k, int n, int decades) {
  const int half = n / 2;
  if (k >= half && k < n - half) return 0;
  const int from_end = std::min(k, n - 1 - k);
  const long double size = half < 2 ? 1 : std::pow(10.0L, -decades * static_cast<long double>(from_end) / (half - 1));
  return k < half ? size : -size;
}

long double spaced(std::uint32_t spacing, int k, int n, int decades) {
  const long double part = static_cast<long double>(k) / (n - 1);
  switch (spacing % 4) {
    case 0: return 2 * part - 1;
    case 1: return through_small(k, n, decades);
    case 2: return 1 - std::abs(1 - 2 * part);
    default: return k % 2 == 0 ? part : -part;
  }
}

}  // namespace

std::vector<Case> decode_path(layout::Bytes bytes) {
  const Motion motion = read_motion(bytes, decode(bytes).pair);
  const int steps = 2 + static_cast<int>(read(bytes, 73, 1) % 39), decades = static_cast<int>(read(bytes, 75, 1) % 17);
  std::vector<Draft> drafts;
  for (int k = 0; k < steps; ++k) {
    const long double s = spaced(read(bytes, 74, 1), k, steps, decades);
    drafts.push_back({pose(motion, s), Json{{"s", static_cast<double>(s)}}});
  }
  drafts.front().facts["layout"] = "path-1";
  drafts.front().facts["bytes"] = layout::hex(bytes.first(std::min(bytes.size(), kPathLayoutSize)));
  return steps_of("decoded bytes", drafts);
}

}  // namespace plumb
