#include "corpus/case/shape_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "solver/shape/hull.hpp"

namespace plumb {
namespace {

enum class Is { required, optional };

template <class S>
void each_exponent(S& s, auto&& visit) {
  std::array n{s.n1, s.n2};
  visit("exponents", n, Is::optional);
  s.n1 = n[0];
  s.n2 = n[1];
}

// The fields of each shape, for who reads and who writes them: a new shape is one more of these.
void each_field(Superellipsoid<double>& s, auto&& visit) {
  visit("semi_axes", s.semi_axes);
  each_exponent(s, visit);
}
void each_field(Capsule& s, auto&& visit) {
  visit("half_length", s.half_length);
  visit("radius", s.radius);
}
void each_field(Cylinder& s, auto&& visit) {
  visit("half_length", s.half_length);
  visit("radius", s.radius);
}
void each_field(Cone& s, auto&& visit) {
  visit("radius", s.radius);
  visit("height", s.height);
}
void each_field(Frustum& s, auto&& visit) {
  visit("radii", s.radii);
  visit("height", s.height);
}
void each_field(Box& s, auto&& visit) {
  visit("half_extents", s.half_extents);
}
void each_field(Polyhedron& s, auto&& visit) {
  visit("points", s);
}
void each_field(PolySuperellipsoid& s, auto&& visit) {
  visit("semi_axes", s.semi_axes);
  each_exponent(s, visit);
}
void each_field(HalfSpace& /*s*/, auto&& /*visit*/) {}

void read_value(const Field& from, double& to) {
  to = from.number();
}

void read_value(const Field& from, Vec3<double>& to) {
  to = from.vector();
}

template <std::size_t N>
void read_value(const Field& from, std::array<double, N>& to) {
  to = from.numbers<N>();
}

void read_value(const Field& from, Polyhedron& to) {
  std::vector<Vec3<double>> points;
  for (const Field& point : from.elements()) points.push_back(point.vector());
  try {
    to = make_polyhedron(points);
  } catch (const std::invalid_argument& error) {
    from.fail(error.what());
  }
}

Json value_json(double x) {
  return x;
}

Json value_json(const Vec3<double>& v) {
  return vector_json(v);
}

template <std::size_t N>
Json value_json(const std::array<double, N>& x) {
  return x;
}

Json value_json(const Polyhedron& polyhedron) {
  Json points = Json::array();
  for (const Vec3<double>& corner : polyhedron.hull->corners) points.push_back(vector_json(corner));
  return points;
}

template <class S>
S read_fields(const Field& from) {
  S out{};
  std::vector<std::string_view> known;
  each_field(out, [&](std::string_view key, auto&, Is = Is::required) { known.push_back(key); });
  from.require_object(known);
  each_field(out, [&](std::string_view key, auto& to, Is is = Is::required) {
    if (is == Is::required || from.has(key)) read_value(from.member(key), to);
  });
  return out;
}

template <class S>
Json fields_json(S shape) {
  Json out = Json::object();
  each_field(shape, [&](const char* key, const auto& value, Is = Is::required) { out[key] = value_json(value); });
  return out;
}

constexpr std::string_view sweep = "sphere_swept";

/// Of every alternative of Shape, in its order.
struct ShapeRow {
  std::string_view word;
  Shape (*read)(const Field& fields);
};

template <std::size_t... I>
auto rows_of(std::index_sequence<I...> /*alternatives*/) {
  return std::array{ShapeRow{name(Shape(std::in_place_index<I>)), [](const Field& fields) -> Shape {
                               return read_fields<std::variant_alternative_t<I, Shape>>(fields);
                             }}...};
}

const auto& shape_rows() {
  static const auto rows = rows_of(std::make_index_sequence<std::variant_size_v<Shape>>());
  return rows;
}

/// The sweep's first.
std::vector<std::string_view> shape_words() {
  std::vector<std::string_view> out{sweep};
  for (const ShapeRow& row : shape_rows()) out.push_back(row.word);
  return out;
}

SweptShape read_swept(const Field& swept) {
  swept.require_object({"core", "radius"});
  SweptShape out = read_shape(swept.member("core"));
  const Field radius = swept.member("radius");
  if (radius.number() < 0) radius.fail("must not be negative");
  out.swept_radius += radius.number();
  if (!std::isfinite(out.swept_radius)) radius.fail("the radii add up to infinity");
  return out;
}

}  // namespace

void require_a_shape(const Field& shape) {
  const std::vector<std::string_view> words = shape_words();
  const auto held = std::ranges::count_if(words, [&](std::string_view word) { return shape.has(word); });
  if (shape.value().is_object() && held != 1) shape.fail(fmt::format("must hold one of {}", fmt::join(words, ", ")));
  shape.require_object(words);
}

SweptShape read_shape(const Field& shape) {
  require_a_shape(shape);
  if (const auto swept = shape.find(sweep)) return read_swept(*swept);
  const auto row = std::ranges::find_if(shape_rows(), [&](const ShapeRow& r) { return shape.has(r.word); });
  return {row->read(shape.member(row->word)), 0, shape.path()};
}

Superellipsoid<double> read_superellipsoid(const Field& shape) {
  shape.require_object({"superellipsoid"});
  return read_fields<Superellipsoid<double>>(shape.member("superellipsoid"));
}

bool is_other_shape(const Field& shape) {
  return !shape.has("superellipsoid") &&
         std::ranges::any_of(shape_words(), [&](std::string_view word) { return shape.has(word); });
}

Json shape_json(const Shape& shape, double swept_radius) {
  Json out;
  out[std::string(name(shape))] = std::visit([](const auto& s) { return fields_json(s); }, shape);
  if (!(swept_radius > 0)) return out;
  Json swept;
  swept[std::string(sweep)] = {{"core", out}, {"radius", swept_radius}};
  return swept;
}

}  // namespace plumb
