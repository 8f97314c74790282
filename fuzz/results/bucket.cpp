#include "fuzz/results/bucket.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <vector>

#include "corpus/case/case.hpp"
#include "corpus/case/shape_class.hpp"
#include "solver/pose.hpp"

namespace plumb {
namespace {

double size_of_body(const Body& body) {
  return body.shape.semi_axes.maxCoeff();
}

std::string depth(const Pair& pair, const Reference& reference) {
  if (!reference.common_normal.solved) return "unknown";
  const double smaller = std::min(size_of_body(pair.body1), size_of_body(pair.body2));
  const double ratio = static_cast<double>(reference.common_normal.overlap) / smaller;
  if (std::abs(ratio) < 1e-9) return "touching";
  if (ratio < 0) return "separated";
  return ratio < 1e-2 ? "shallow" : (ratio < 1e-1 ? "moderate" : "deep");
}

/// World directions that mean something for the shape: none of a sphere, one of a spheroid, three of the others.
std::vector<Vec3<double>> axes_of(const Body& body) {
  const Mat3<double> r = rotation<double>(body.quaternion);
  const Vec3<double>& a = body.shape.semi_axes;
  switch (shape_kind(body.shape)) {
    case ShapeKind::sphere: return {};
    case ShapeKind::spheroid: return {r.col(a[0] == a[1] ? 2 : (a[0] == a[2] ? 1 : 0))};
    default: return {r.col(0), r.col(1), r.col(2)};
  }
}

bool along(const Vec3<double>& u, const Vec3<double>& v) {
  return u.cross(v).norm() <= 1e-3 * u.norm() * v.norm();
}

bool parallel(const Pair& pair) {
  for (const auto& u : axes_of(pair.body1))
    for (const auto& v : axes_of(pair.body2))
      if (along(u, v)) return true;
  return false;
}

bool on_axis(const Pair& pair) {
  const Vec3<double> line = pair.body2.position - pair.body1.position;
  for (const Body* body : {&pair.body1, &pair.body2})
    for (const auto& axis : axes_of(*body))
      if (along(axis, line)) return true;
  return false;
}

std::string special(const Pair& pair) {
  if (pair.body1.position.cwiseAbs().maxCoeff() > 1e3 * size_of(pair)) return "-far";
  const double ratio = size_of_body(pair.body1) / size_of_body(pair.body2);
  if (std::max(ratio, 1 / ratio) >= 100) return "-unequal";
  if (parallel(pair)) return "-parallel";
  return on_axis(pair) ? "-on_axis" : "";
}

std::array<double, 12> numbers_of(const Body& body) {
  const auto& [shape, position, q] = body;
  return {shape.semi_axes[0],
          shape.semi_axes[1],
          shape.semi_axes[2],
          shape.n1,
          shape.n2,
          position[0],
          position[1],
          position[2],
          q[0],
          q[1],
          q[2],
          q[3]};
}

int digits(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return static_cast<int>(end - text.data());
}

std::string text_of(const ConvexPair& pair) {
  Case c;
  c.convex = pair;
  return format_case(c);
}

int swept_bodies(const ConvexPair& pair) {
  return (pair.body1.swept_radius > 0 ? 1 : 0) + (pair.body2.swept_radius > 0 ? 1 : 0);
}

}  // namespace

std::string regime(const Pair& pair, const Reference& reference) {
  return depth(pair, reference) + special(pair);
}

std::string bucket(std::string_view finding, std::string_view method, const Pair& pair, const Reference& reference) {
  return fmt::format("{}-{}-{}-{}", finding, method, shape_class(pair), regime(pair, reference));
}

std::uint64_t digest(const Pair& pair) {
  std::uint64_t hash = 14695981039346656037u;  // FNV-1a, by whole numbers and with a shift to spread the high bits
  for (const auto& numbers : {numbers_of(pair.body1), numbers_of(pair.body2)})
    for (const double number : numbers) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(number)) * 1099511628211u;
      hash ^= hash >> 32;
    }
  return hash;
}

Simplicity simplicity(const Pair& pair) {
  const auto one = numbers_of(pair.body1), two = numbers_of(pair.body2);
  Simplicity key{static_cast<int>(shape_kind(pair.body1.shape)) + static_cast<int>(shape_kind(pair.body2.shape)),
                 std::equal(one.begin(), one.begin() + 5, two.begin()) ? 0 : 1, 0, 0};
  for (const auto& numbers : {one, two})
    for (const double value : numbers) {
      key[2] += value == 0 || value == 1 ? 0 : 1;
      key[3] += digits(value);
    }
  return key;
}

std::string bucket(std::string_view finding, std::string_view method, const ConvexPair& pair) {
  return fmt::format("{}-{}-{}-{}{}", finding, method, name(pair.body1.shape), name(pair.body2.shape),
                     swept_bodies(pair) > 0 ? "-swept" : "");
}

std::uint64_t digest(const ConvexPair& pair) {
  std::uint64_t hash = 14695981039346656037u;
  for (const char c : text_of(pair)) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return hash;
}

Simplicity simplicity(const ConvexPair& pair) {
  const auto first = static_cast<int>(pair.body1.shape.index()), second = static_cast<int>(pair.body2.shape.index());
  return {first + second, first == second ? 0 : 1, swept_bodies(pair), static_cast<int>(text_of(pair).size())};
}

}  // namespace plumb
