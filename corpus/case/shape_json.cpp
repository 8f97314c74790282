#include "corpus/case/shape_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "solver/shape/hull.hpp"
#include "solver/shape/shape_fields.hpp"

namespace plumb {
namespace {

template <class S>
void read_numbers(const Field& from, S& to) {
  each_field(to, [&](auto place, const auto& field, const auto& numbers) {
    constexpr std::size_t count = number_count<S, place>;
    if (field.has_default && !from.has(field.name)) return;
    const Field value = from.member(field.name);
    for (std::size_t i = 0; i < count; ++i)
      *numbers[i] = count == 1 ? value.number() : value.element(i, count, "numbers").number();
  });
}

void read_numbers(const Field& from, Polyhedron& to) {
  const Field field = from.member("points");
  std::vector<Vec3<double>> points;
  for (const Field& point : field.elements()) points.push_back(point.vector());
  try {
    to = make_polyhedron(points);
  } catch (const std::invalid_argument& error) {
    field.fail(error.what());
  }
}

template <class S>
S read_fields(const Field& from) {
  S out{};
  from.require_object(field_names<S>);
  read_numbers(from, out);
  return out;
}

template <class S>
Json fields_json(const S& shape) {
  Json out = Json::object();
  each_field(shape, [&](auto place, const auto& field, const auto& numbers) {
    Json& value = out[std::string(field.name)];
    if constexpr (number_count<S, place> == 1)
      value = *numbers[0];
    else
      for (const double* number : numbers) value.push_back(*number);
  });
  return out;
}

Json fields_json(const Polyhedron& polyhedron) {
  Json points = Json::array();
  for (const Vec3<double>& corner : polyhedron.hull->corners) points.push_back(vector_json(corner));
  return {{"points", points}};
}

constexpr std::string_view sweep = "sphere_swept";

/// Of every alternative of Shape, in its order; `read` is null where a shape cannot be written down.
struct ShapeRow {
  std::string_view word;
  Shape (*read)(const Field& fields);
};

template <class S>
ShapeRow row_of() {
  if constexpr (is_value<S>)
    return {RowOf<S>::word, [](const Field& fields) -> Shape { return read_fields<S>(fields); }};
  else
    return {RowOf<S>::word, nullptr};
}

template <class... S>
auto rows_of(const std::variant<S...>* /*list*/) {
  return std::array{row_of<S>()...};
}

const auto& shape_rows() {
  static const auto rows = rows_of(static_cast<const Shape*>(nullptr));
  return rows;
}

/// The sweep's first.
std::vector<std::string_view> shape_words() {
  std::vector<std::string_view> out{sweep};
  for (const ShapeRow& row : shape_rows())
    if (row.read != nullptr) out.push_back(row.word);
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
