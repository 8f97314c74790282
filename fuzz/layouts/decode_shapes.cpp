#include "fuzz/layouts/decode_shapes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "fuzz/layouts/layout_fields.hpp"
#include "properties/generators/shapes.hpp"
#include "solver/pose.hpp"
#include "solver/shape/hull.hpp"

namespace plumb {
namespace {

using namespace layout;

constexpr std::size_t kShapeBodySize = 44;
constexpr std::array<double, 16> kShapeLengths{1,    0.5, 2,    0.25, 1.0 / 3, 3,     0.1, 10,
                                               0.01, 100, 1e-3, 1e-6, 1e-9,    1e-12, 1e3, 0.75};
constexpr std::array<double, 16> kShapeExponents{2,  4,  3,   8,  2.5,       6,         1.5,  20,
                                                 10, 40, 1.1, 50, 2 + 1e-12, 2 - 1e-12, 1.25, 2.1};

Vec3<double> point_of_polyhedron(std::uint32_t arrangement, Stream& stream) {
  if (arrangement == 0) return random_direction(stream);
  std::array<double, 3> whole{};
  for (double& x : whole) x = static_cast<double>(stream.below(5)) - 2;
  if (arrangement == 1) return {whole[0], whole[1], whole[2]};
  if (arrangement == 2) return {whole[0], whole[1], whole[0] - 2 * whole[1]};
  return {whole[0], whole[1], stream.sign()};
}

/// A body's bytes, from its first on, and the unit of lengths.
struct ShapeBytes {
  Bytes bytes;
  double unit;

  [[nodiscard]] double raw_length(std::size_t offset) const {
    return pick(read(bytes, offset, 2), kShapeLengths, 1.0 / 1024, 1024);
  }
  [[nodiscard]] double length(std::size_t offset) const { return unit * raw_length(offset); }
  [[nodiscard]] double length_or_0(std::size_t offset) const { return raw_length(offset) < 1e-3 ? 0 : length(offset); }
  [[nodiscard]] Vec3<double> lengths(std::size_t offset) const {
    return {length(offset), length(offset + 2), length(offset + 4)};
  }
  [[nodiscard]] double exponent(std::size_t offset) const {
    return pick(read(bytes, offset, 2), kShapeExponents, 1.1, 50);
  }
  [[nodiscard]] double swept_radius() const { return read(bytes, 28, 2) < 256 ? 0 : length(28); }
  [[nodiscard]] Polyhedron polyhedron() const {
    Stream stream("shapes-1", read(bytes, 32, 4), 0);
    std::vector<Vec3<double>> points(1 + read(bytes, 30, 1) % 20);
    for (Vec3<double>& x : points) x = point_of_polyhedron(read(bytes, 31, 1) % 4, stream).cwiseProduct(lengths(2));
    return make_polyhedron(points);
  }
  [[nodiscard]] std::array<double, 6> six_half_axes() const {
    const Vec3<double> a = lengths(2), b = lengths(36);
    const double least = std::max(a.maxCoeff(), b.maxCoeff()) / 1000;
    std::array<double, 6> out{a[0], b[0], a[1], b[1], a[2], b[2]};
    for (double& x : out) x = std::max(x, least);
    return out;
  }
  /// Lengths and exponents by themselves. Where they are not legal together the last length is that before it.
  template <class S>
  [[nodiscard]] S by_fields() const {
    constexpr std::array<std::size_t, 6> places{2, 4, 36, 38, 40, 6};
    S out{};
    std::size_t lengths = 0, exponents = 0;
    double *last = nullptr, *before = nullptr;
    each_field(out, [&](auto, const auto& field, const auto& numbers) {
      for (double* number : numbers) {
        if (!field.is_length()) {
          *number = exponent(8 + 2 * (exponents++ % 2));
          continue;
        }
        const std::size_t place = places[lengths++ % places.size()];
        *number = field.legal == Legal::not_below_zero ? length_or_0(place) : length(place);
        before = std::exchange(last, number);
      }
    });
    if (before != nullptr && !is_legal(out)) *last = *before;
    return out;
  }
  [[nodiscard]] Shape shape() const {
    const std::size_t kind = read(bytes, 0, 1) % shape_count;
    const Vec3<double> a = lengths(2);
    switch (kind) {
      case 0: return Superellipsoid<double>{a.cwiseMax(a.maxCoeff() / 1000), exponent(8), exponent(10)};
      case 1: return Capsule{length_or_0(2), a[1]};
      case 2: return Cylinder{a[0], a[1]};
      case 3: return Cone{a[0], a[1]};
      case 4: return Frustum{{length_or_0(36), a[1]}, a[0]};
      case 5: return Box{a};
      case 6: return polyhedron();
      case 7: return PolySuperellipsoid{six_half_axes(), exponent(8), exponent(10)};
      case half_space_kind: return HalfSpace{};
      default: return shape_of_kind(kind, [&]<class S>() { return Shape(by_fields<S>()); });
    }
  }
  /// At the origin.
  [[nodiscard]] ConvexBody body(const Quaternion& turned) const {
    return {shape(), swept_radius(), Vec3<double>::Zero(), turned};
  }
};

double tilt_at(Bytes bytes, std::size_t offset) {
  const std::uint32_t v = read(bytes, offset, 2);
  if (v >= 256) return static_cast<double>(log_magnitude(v));
  return v % 16 == 0 ? 0 : static_cast<double>(std::pow(10.0L, -static_cast<long double>(v % 16)));
}

/// Unit, in body 1's axes.
Vec3<double> direction_at(Bytes bytes) {
  constexpr std::array<int, 3> digit{0, 1, -1};
  const std::uint32_t v = read(bytes, 89, 1);
  const Vec3<double> w(digit[v % 3], digit[v / 3 % 3], digit[v / 9 % 3]);
  const Vec3<double> n = w.isZero() ? Vec3<double>::UnitZ().eval() : w.normalized().eval(), across = n.unitOrthogonal();
  const auto [c, s] = cos_sin_deg(angle(bytes, 92));
  const double by = tilt_at(bytes, 90);
  if (by == 0) return n;
  const Vec3<double> aside = across * static_cast<double>(c) + n.cross(across) * static_cast<double>(s);
  return (n * std::cos(by) + aside * std::sin(by)).normalized();
}

/// The v-th of the turns that take axes to axes.
Quaternion axis_turn(std::uint32_t v) {
  constexpr std::array<Quaternion, 6> tips{
      {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, -1, 0, 0}, {1, 0, 1, 0}, {1, 0, -1, 0}, {0, 1, 0, 0}}};
  constexpr std::array<Quaternion, 4> about_z{{{1, 0, 0, 0}, {1, 0, 0, 1}, {0, 0, 0, 1}, {1, 0, 0, -1}}};
  return product(tips[v % 6], about_z[v / 6 % 4]);
}

Quaternion second_rotation(Bytes bytes, const Quaternion& first) {
  const std::uint32_t mode = read(bytes, 104, 1) % 4;
  if (mode < 2) return read_quaternion(bytes, kShapeBodySize);
  const Quaternion aligned = product(first, axis_turn(read(bytes, 105, 1)));
  if (mode == 2) return aligned;
  const auto [c, s] = cos_sin_deg(angle(bytes, 108));
  return product(aligned, turn({static_cast<double>(c), static_cast<double>(s), 0}, tilt_at(bytes, 106)));
}

void place_second(Bytes bytes, ConvexPair& pair) {
  const Vec3<double> n = rotation<double>(pair.body1.quaternion) * direction_at(bytes);
  const double r1 = bounding_radius(pair.body1), r2 = bounding_radius(pair.body2);
  const double smaller = std::min(r1, r2) > 0 ? std::min(r1, r2) : size_of(pair);
  const auto ratio = static_cast<double>(read_overlap_ratio(bytes, 96));
  if (read(bytes, 88, 1) % 4 < 2) return place_at_contact(pair, n, ratio * smaller);
  pair.body2.position = pair.body1.position + (1 - ratio) * (r1 + r2) * n;
}

}  // namespace

Case decode_shapes(Bytes bytes) {
  Case c;
  c.name = "decoded bytes";
  ConvexPair& pair = c.convex.emplace();
  const double unit = read_unit(bytes, 100);
  const Bytes second = bytes.size() > kShapeBodySize ? bytes.subspan(kShapeBodySize) : Bytes{};
  pair.body1 = ShapeBytes{bytes, unit}.body(read_quaternion(bytes, 0));
  pair.body2 = ShapeBytes{second, unit}.body(second_rotation(bytes, pair.body1.quaternion));
  if (std::holds_alternative<HalfSpace>(pair.body1.shape) && std::holds_alternative<HalfSpace>(pair.body2.shape))
    pair.body2.shape = Capsule{0, unit};
  pair.body1.position = read_origin(bytes, 102, size_of(pair));
  place_second(bytes, pair);
  c.provenance = Json{{"layout", "shapes-1"}, {"bytes", hex(bytes.first(std::min(bytes.size(), kShapesLayoutSize)))}};
  return c;
}

}  // namespace plumb
