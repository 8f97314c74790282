#include "properties/generators/shapes.hpp"

#include <algorithm>
#include <cmath>

#include "solver/pose.hpp"
#include "solver/reference/convex/placed_cores.hpp"
#include "solver/shape/hull.hpp"
#include "solver/shape/overloaded.hpp"
#include "solver/shape/shape_fields.hpp"

namespace plumb {
namespace {

double draw_length(Stream& stream) {
  return stream.log_uniform(0.1, 1);
}

double draw_convex_exponent(Stream& stream) {
  static constexpr std::array<double, 5> special{1.05, 2, 3, 8, 40};
  return stream.chance(0.5) ? stream.pick(special) : stream.uniform(1.1, 8);
}

/// Points on a sphere, of a prism, or in a plane, which half of the time is no plane of coordinates: there points are off it by rounding.
Polyhedron draw_polyhedron(Stream& stream) {
  std::vector<Vec3<double>> points;
  const bool is_prism = stream.chance(0.3), is_flat = stream.chance(0.1), is_turned = stream.chance(0.5);
  for (int i = 0; i < 12; ++i) {
    Vec3<double> x = random_direction(stream);
    if (is_flat) x[2] = 0;
    points.push_back(x);
    if (is_prism) points.push_back(x + Vec3<double>(0, 0, 0.5));
  }
  if (is_turned) {
    const Mat3<double> turned = rotation<double>(random_rotation(stream));
    for (Vec3<double>& x : points) x = turned * x;
  }
  return make_polyhedron(points);
}

/// A legal one: lengths and exponents as those of other shapes.
template <class S>
Shape draw_fields(Stream& stream) {
  for (;;) {
    S out{};
    each_field(out, [&](auto, const auto& field, const auto& numbers) {
      for (double* number : numbers) {
        const bool is_zero = field.legal == Legal::not_below_zero && stream.chance(0.2);
        *number = is_zero ? 0 : (field.is_length() ? draw_length(stream) : draw_convex_exponent(stream));
      }
    });
    if (is_legal(out)) return out;
  }
}

/// One of its lengths, as long as that is legal.
template <class S>
void shorten(S& shape, double by, std::size_t which) {
  std::vector<double*> lengths;
  each_field(shape, [&](auto, const auto& field, const auto& numbers) {
    if (field.is_length()) lengths.insert(lengths.end(), numbers.begin(), numbers.end());
  });
  if (lengths.empty()) return;
  double& length = *lengths[which % lengths.size()];
  const double before = std::exchange(length, length * by);
  if (!is_legal(shape)) length = before;
}

/// The kinds in an order that ends with it.
std::size_t half_space_last(std::size_t place) {
  return place + 1 == shape_count ? half_space_kind : place < half_space_kind ? place : place + 1;
}

Vec3<double> own_normal(const ConvexBody& half_space) {
  return rotation<double>(half_space.quaternion).col(2);
}

double draw_overlap(Stream& stream, double size) {
  const double way = stream.uniform();
  if (way < 0.4) return size * stream.signed_log_uniform(1e-16, 1e-1);
  if (way < 0.5) return 0;
  return size * stream.uniform(-1, 2);
}

}  // namespace

ShapeKinds shape_kinds(std::size_t number) {
  std::size_t first = 0;
  for (; number >= shape_count - first; ++first) number -= shape_count - first;
  return {half_space_last(first), half_space_last(first + number)};
}

Shape draw_shape(std::size_t kind, Stream& stream) {
  const auto length = [&] { return draw_length(stream); };
  const auto three = [&] {
    const double x = length(), y = length(), z = length();
    return Vec3<double>(x, y, z);
  };
  const auto exponents = [&] {
    const double n1 = draw_convex_exponent(stream), n2 = draw_convex_exponent(stream);
    return std::array{n1, n2};
  };
  switch (kind) {
    case 0: {
      const auto [n1, n2] = exponents();
      return Superellipsoid<double>{three(), n1, n2};
    }
    case 1: return Capsule{stream.chance(0.2) ? 0 : length(), length()};
    case 2: return Cylinder{length(), length()};
    case 3: return Cone{length(), length()};
    case 4: return Frustum{{stream.chance(0.2) ? 0 : length(), length()}, length()};
    case 5: return Box{three()};
    case 6: return draw_polyhedron(stream);
    case 7: {
      const auto [n1, n2] = exponents();
      return PolySuperellipsoid{{length(), length(), length(), length(), length(), length()}, n1, n2};
    }
    case half_space_kind: return HalfSpace{};
    default: return shape_of_kind(kind, [&]<class S>() { return draw_fields<S>(stream); });
  }
}

ConvexBody draw_convex_body(std::size_t kind, Stream& stream) {
  const Shape shape = draw_shape(kind, stream);
  const double swept = stream.chance(0.3) ? stream.uniform(0, 0.3) : 0;
  const Vec3<double> position = random_direction(stream) * 0.1;
  return {shape, swept, position, random_rotation(stream)};
}

Shape flattened(const Shape& shape, double decades, Stream& stream) {
  const double by = std::pow(10.0, -decades);
  const std::size_t axis = stream.below(3);
  const auto i = static_cast<Eigen::Index>(axis);
  const auto round = [&](double& along, double& across) { (axis == 2 ? along : across) *= by; };
  Shape out = shape;
  std::visit(detail::Overloaded{[&](Capsule& s) { s.radius *= by; },
                                [&](Cylinder& s) { round(s.half_length, s.radius); },
                                [&](Cone& s) { round(s.height, s.radius); },
                                [&](Frustum& s) {
                                  round(s.height, s.radii[0]);
                                  if (axis != 2) s.radii[1] *= by;
                                },
                                [&](Polyhedron& s) {
                                  std::vector<Vec3<double>> points = s.hull->corners;
                                  for (Vec3<double>& x : points) x[i] *= by;
                                  s = make_polyhedron(points);
                                },
                                [&](PolySuperellipsoid& s) {
                                  s.semi_axes[2 * axis] *= by;
                                  s.semi_axes[2 * axis + 1] *= by;
                                },
                                [&](Tablet& s) {
                                  round(s.half_length, s.radius);
                                  s.cap_height *= by;
                                },
                                [](ForeignShape&) {}, [&](auto& s) { shorten(s, by, axis); }},
             out);
  return out;
}

void place_at_contact(ConvexPair& pair, const Vec3<double>& normal, double overlap) {
  const bool is_first = std::holds_alternative<HalfSpace>(pair.body1.shape),
             is_second = std::holds_alternative<HalfSpace>(pair.body2.shape);
  const Vec3<double> n = is_first ? own_normal(pair.body1) : is_second ? Vec3<double>(-own_normal(pair.body2)) : normal;
  pair.body2.position = pair.body1.position;
  const reference::cores::PlacedCores cores(pair);
  const Vec3<double> apart = cores.farthest(n).w + high(cores.radii()) * n;
  pair.body2.position += std::ldexp(1.0, cores.exponent()) * apart - overlap * n;
}

ConvexPair draw_shape_pair(const ShapeKinds& kinds, Stream& stream) {
  ConvexPair out{draw_convex_body(kinds.first, stream), draw_convex_body(kinds.second, stream)};
  if (stream.chance(0.1)) {
    const double decades = stream.uniform(1, 4);
    out.body1.shape = flattened(out.body1.shape, decades, stream);
    if (stream.chance(0.5)) out.body2.shape = flattened(out.body2.shape, decades, stream);
  }
  if (stream.chance(0.5)) std::swap(out.body1, out.body2);
  if (stream.chance(0.3)) {
    const Vec3<double> direction = random_direction(stream);
    out.body2.position += direction * stream.uniform(0, 2.5);
    return out;
  }
  const Vec3<double> normal = random_direction(stream);
  const double smaller = std::min(bounding_radius(out.body1), bounding_radius(out.body2));
  place_at_contact(out, normal, draw_overlap(stream, smaller > 0 ? smaller : size_of(out)));
  return out;
}

}  // namespace plumb
