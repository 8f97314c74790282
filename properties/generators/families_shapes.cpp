#include "properties/generators/families_shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "solver/pose.hpp"
#include "solver/shape/hull.hpp"

namespace plumb {
namespace {

using Kinds = std::span<const std::size_t>;
constexpr std::size_t kEllipsoid = 0, kCapsule = 1, kCylinder = 2, kCone = 3, kFrustum = 4, kBox = 5, kHull = 6;
constexpr std::array kRound{kEllipsoid, kCapsule, kCylinder, kCone, kFrustum},
    kFlat{kCylinder, kCone, kFrustum, kBox, kHull};

constexpr std::array kShapeTilts{1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 1e-15, 1e-16, 0.0};
constexpr std::array kShapeGaps{1e-1, 1e-3, 1e-5, 1e-7, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15, 1e-16, 0.0};
constexpr std::array kThicknesses{1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12};

/// Of revolution about z, and a prism in the place of a hull.
Shape upright(std::size_t kind, Stream& stream) {
  if (kind == kEllipsoid) {
    const double across = stream.uniform(0.3, 1);
    return Superellipsoid<double>{{across, across, stream.uniform(0.3, 1)}, 2, 2};
  }
  if (kind != kHull) return draw_shape(kind, stream);
  std::vector<Vec3<double>> points;
  for (int i = 0; i < 6; ++i) {
    const double angle = stream.uniform(0, kTurn);
    for (const double z : {-0.5, 0.5}) points.emplace_back(std::cos(angle), std::sin(angle), z);
  }
  return make_polyhedron(points);
}

std::size_t pick_kind(Stream& stream, Kinds kinds) {
  return kinds[stream.below(kinds.size())];
}

/// Both upright, body 2 turned by the tilt about a direction across.
ConvexPair stacked(Stream& stream, Kinds kinds, double tilt) {
  ConvexPair out;
  out.body1.shape = upright(pick_kind(stream, kinds), stream);
  out.body2.shape = upright(pick_kind(stream, kinds), stream);
  const double azimuth = stream.uniform(0, kTurn), spin = stream.uniform(0, kTurn);
  const Quaternion tilted = turn({std::cos(azimuth), std::sin(azimuth), 0}, tilt);
  out.body2.quaternion = product(tilted, turn(Vec3<double>::UnitZ(), spin));
  return out;
}

/// The whole pair turned, in half of the draws: what is aligned is so to rounding then.
ConvexPair turned(Stream& stream, ConvexPair pair) {
  if (stream.chance(0.5)) return pair;
  const Quaternion by = random_rotation(stream);
  const Mat3<double> r = rotation<double>(by);
  for (ConvexBody* body : {&pair.body1, &pair.body2}) {
    body->position = r * body->position;
    body->quaternion = product(by, body->quaternion);
  }
  return pair;
}

ConvexPair any_two(Stream& stream, std::uint64_t index, double /*none*/) {
  return draw_shape_pair(shape_kinds(index % shape_pair_count), stream);
}

/// In contact to that share of the smaller body, in or apart, along any direction.
ConvexPair touching(Stream& stream, std::uint64_t index, double ratio) {
  const ShapeKinds kinds = shape_kinds(index % shape_pair_count);
  ConvexPair out{draw_convex_body(kinds.first, stream), draw_convex_body(kinds.second, stream)};
  const Vec3<double> normal = random_direction(stream);
  const double overlap = stream.sign() * ratio;
  place_at_contact(out, normal, overlap * (kinds.second == half_space_kind ? size_of(out) : 1));
  return out;
}

/// Axes through one point but for the tilt, one body in the other.
ConvexPair tilted_axes(Stream& stream, std::uint64_t /*index*/, double tilt) {
  ConvexPair out = stacked(stream, kRound, tilt);
  out.body2.position = Vec3<double>::UnitZ() * stream.uniform(-0.3, 0.3);
  return turned(stream, out);
}

ConvexPair face_on_face(Stream& stream, std::uint64_t /*index*/, double tilt) {
  ConvexPair out = stacked(stream, kFlat, tilt);
  const double overlap = stream.signed_log_uniform(1e-6, 1e-1);
  place_at_contact(out, Vec3<double>::UnitZ(), overlap);
  const double x = stream.uniform(-0.1, 0.1), y = stream.uniform(-0.1, 0.1);
  out.body2.position[0] = x;
  out.body2.position[1] = y;
  return turned(stream, out);
}

/// Two boxes turned by an eighth about their long edges, the upper one turned by the tilt about the vertical.
ConvexPair edge_on_edge(Stream& stream, std::uint64_t /*index*/, double tilt) {
  ConvexPair out;
  for (ConvexBody* body : {&out.body1, &out.body2}) {
    const double a = stream.uniform(0.3, 1), b = stream.uniform(0.3, 1);
    *body = {Box{{1, a, b}}, 0, Vec3<double>::Zero(), turn(Vec3<double>::UnitX(), stream.uniform(0.5, 1))};
  }
  out.body2.quaternion = product(turn(Vec3<double>::UnitZ(), tilt), out.body2.quaternion);
  const double overlap = stream.signed_log_uniform(1e-9, 1e-1);
  place_at_contact(out, Vec3<double>::UnitZ(), overlap);
  out.body2.position[0] = stream.uniform(-0.5, 0.5);
  return turned(stream, out);
}

/// A plate that thick against any shape or another plate.
ConvexPair plates(Stream& stream, std::uint64_t index, double thickness) {
  const double a = stream.uniform(0.3, 1), b = stream.uniform(0.3, 1);
  const Shape box = Box{{a, b, thickness}}, disc = Cylinder{thickness, a};
  ConvexPair out{draw_convex_body(kBox, stream), draw_convex_body(1 + index % kHull, stream)};
  out.body1.shape = stream.chance(0.5) ? box : disc;
  if (stream.chance(0.5)) out.body2.shape = box;
  const Vec3<double> normal = random_direction(stream);
  const double share = stream.signed_log_uniform(1e-3, 1);
  place_at_contact(out, normal, share * (stream.chance(0.5) ? thickness : 0.1));
  return out;
}

constexpr std::array kShapeFamilies = std::to_array<ShapeFamily>({
    {"shapes", "any two shapes, touching to deep and apart, a tenth plates and needles", "", {}, any_two},
    {"shapes_touching", "any two shapes that touch but for a share of their size", "overlap_ratio", kShapeGaps,
     touching},
    {"shapes_tilted_axes", "round bodies in one another, axes through one point", "tilt", kShapeTilts, tilted_axes},
    {"shapes_face_on_face", "flat ends and faces that lie on one another", "tilt", kShapeTilts, face_on_face},
    {"shapes_edge_on_edge", "two boxes by edges that are parallel but for a tilt", "tilt", kShapeTilts, edge_on_edge},
    {"shapes_plates", "plates and discs against shapes and plates", "thickness", kThicknesses, plates},
});

}  // namespace

std::span<const ShapeFamily> shape_families() {
  return kShapeFamilies;
}

const ShapeFamily* find_shape_family(std::string_view name) {
  const auto row = std::ranges::find(kShapeFamilies, name, &ShapeFamily::name);
  return row == kShapeFamilies.end() ? nullptr : &*row;
}

Case generate(const ShapeFamily& family, std::uint64_t seed, std::uint64_t index) {
  const std::uint64_t steps = std::max<std::uint64_t>(1, family.steps.size()), draw = index / steps;
  Stream stream(family.name, seed, draw);
  const double knob = family.steps.empty() ? 0 : family.steps[index % steps];
  Case out;
  out.name = std::string(family.name) + " seed " + std::to_string(seed) + " index " + std::to_string(index);
  out.convex = family.draw(stream, draw, knob);
  out.provenance = Json{{"family", family.name}, {"seed", seed}, {"index", index}};
  if (!family.steps.empty()) out.provenance["knob"] = {{"name", family.knob}, {"value", knob}};
  return out;
}

}  // namespace plumb
