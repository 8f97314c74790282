#include "properties/generators/described.hpp"

#include <algorithm>
#include <cmath>

#include "corpus/json/fields.hpp"
#include "properties/generators/draft.hpp"
#include "solver/pose.hpp"
#include "solver/reference/reference.hpp"

namespace plumb {
namespace {

constexpr double kDegree = kTurn / 360;

Quaternion inverse(const Quaternion& q) {
  return {q[0], -q[1], -q[2], -q[3]};
}

/// X-convention; where body z is world z the turn is all in phi.
Vec3<double> euler_deg_of(const Quaternion& q) {
  const Mat3<double> r = rotation<double>(q);
  const double sine = std::hypot(r(2, 0), r(2, 1));
  const bool upright = sine < 1e-12;
  const double phi = upright ? std::atan2(r(1, 0), r(0, 0)) : std::atan2(r(0, 2), -r(1, 2));
  const double psi = upright ? 0 : std::atan2(r(2, 0), r(2, 1));
  return Vec3<double>(phi, std::atan2(sine, r(2, 2)), psi) / kDegree;
}

std::optional<Vec3<double>> place_of(const Pair& pair) {
  const Vec3<double> line = pair.body2.position - pair.body1.position;
  const double distance = line.norm();
  if (!(distance > 0) || !std::isfinite(distance)) return std::nullopt;
  const FirstTouch<long double> touch =
      first_touch<long double>(pair, Vec3<long double>(line.cast<long double>().normalized()));
  const double zenith = std::atan2(std::hypot(line[0], line[1]), line[2]), azimuth = std::atan2(line[1], line[0]);
  const double ratio = static_cast<double>(1 - distance / touch.distance);
  if (!touch.solved || !(ratio < 1)) return std::nullopt;
  return Vec3<double>(zenith / kDegree, azimuth / kDegree, ratio);
}

}  // namespace

Pair in_axes_of_body1(const Pair& pair) {
  Pair out = pair;
  const Quaternion back = inverse(pair.body1.quaternion);
  out.body1.position.setZero();
  out.body1.quaternion = {1, 0, 0, 0};
  out.body2.position = rotation<double>(back) * (pair.body2.position - pair.body1.position);
  out.body2.quaternion = product(back, pair.body2.quaternion);
  out.motion = rotation<double>(back) * pair.motion;
  return out;
}

Described describe(const Pair& pair) {
  Described out{pair, {}, {}};
  out.pair.body1.position.setZero();
  out.pair.body2.position -= pair.body1.position;
  out.euler_deg = {euler_deg_of(pair.body1.quaternion), euler_deg_of(pair.body2.quaternion)};
  if (is_valid(out.pair)) out.place = place_of(out.pair);
  return out;
}

Json described_json(const Described& described) {
  Json out;
  out["bodies"] = bodies_json(described.pair);
  if (!described.pair.motion.isZero(0)) out["motion"] = vector_json(described.pair.motion);
  for (std::size_t i = 0; i < 2 && described.euler_deg; ++i) {
    const Vec3<double>& angles = (*described.euler_deg)[i];
    out["bodies"][i]["orientation"] = {{"euler_zxz_deg", {angles[0], angles[1], angles[2]}}};
  }
  if (!described.place) return out;
  out["bodies"][1].erase("position");
  const Vec3<double>& place = *described.place;
  out["placement"] = {{"line_deg", {place[0], place[1]}}, {"overlap_ratio", place[2]}};
  return out;
}

std::optional<Pair> pair_of(const Described& described) {
  if (!described.euler_deg && !described.place)
    return is_valid(described.pair) ? std::optional(described.pair) : std::nullopt;
  if (!is_valid(described.pair)) return std::nullopt;
  Json text = {{"format", "plumb/case-1"}, {"name", "described"}};
  text.update(described_json(described));
  try {
    return parse_case(write_json(text), "described").pair;
  } catch (const InputFailure&) {
    return std::nullopt;  // no first touch along that line
  }
}

bool in_domain(const Pair& pair) {
  const auto inside = [](const Superellipsoid<double>& shape) {
    const double few_ulps = 1 + 1e-12;
    return shape.semi_axes.maxCoeff() <= 1000 * few_ulps * shape.semi_axes.minCoeff() &&
           std::min(shape.n1, shape.n2) >= 1.1 && std::max(shape.n1, shape.n2) <= 50;
  };
  return is_valid(pair) && inside(pair.body1.shape) && inside(pair.body2.shape);
}

}  // namespace plumb
