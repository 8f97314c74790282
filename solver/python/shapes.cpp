// The shapes' classes, all of them made of their rows (shape/shapes.hpp).
#include <pybind11/stl.h>

#include <algorithm>
#include <cctype>

#include "solver/python/arguments.hpp"
#include "solver/python/bindings.hpp"
#include "solver/python/values.hpp"
#include "solver/shape/hull.hpp"
#include "solver/shape/shape_fields.hpp"

namespace plumb::python {
namespace {

/// The shape, where its numbers are legal. `arguments`: all of them, for what none alone is to blame for.
template <class S>
[[nodiscard]] S legal(S shape, std::string_view arguments) {
  InputError error = find_input_error(ConvexPair{ConvexBody{shape}, {}});
  if (error.field.substr(error.field.find('.') + 1) == name(shape)) error.field = arguments;
  refuse(error);
  return shape;
}

/// "PolySuperellipsoid", of the word poly_superellipsoid.
[[nodiscard]] std::string class_name(std::string_view word) {
  std::string out;
  bool is_first = true;
  for (const char c : word) {
    if (c != '_') out += is_first ? static_cast<char>(std::toupper(c)) : c;
    is_first = c == '_';
  }
  return out;
}

template <class S, std::size_t place>
[[nodiscard]] constexpr const auto& field_of() {
  return std::get<place>(RowOf<S>::fields);
}

/// The numbers of a field.
template <class S, std::size_t place>
[[nodiscard]] auto values_of(const S& shape) {
  std::array<double, number_count<S, place>> out;
  const auto from = numbers_of(field_of<S, place>(), shape);
  std::transform(from.begin(), from.end(), out.begin(), [](const double* number) { return *number; });
  return out;
}

/// A field as a property: a number, or an array.
template <class S, std::size_t place>
[[nodiscard]] py::object property_of(const S& shape) {
  const auto values = values_of<S, place>(shape);
  if constexpr (values.size() == 1)
    return py::float_(values[0]);
  else
    return array_of(values, {static_cast<py::ssize_t>(values.size())});
}
template <>
py::object property_of<Polyhedron, 0>(const Polyhedron& shape) {
  const std::vector<Vec3<double>>& from = shape.hull->corners;
  return array_of(std::span(from.front().data(), 3 * from.size()), {static_cast<py::ssize_t>(from.size()), 3});
}

[[nodiscard]] Polyhedron hull_of(const std::vector<Vec3<double>>& points) {
  const py::gil_scoped_release unlocked;
  return make_polyhedron(points);
}

/// Of its arguments, one a field.
template <class S, std::size_t size>
[[nodiscard]] S shape_from(const std::array<py::object, size>& arguments) {
  S out{};
  std::string names;
  each_field(out, [&](auto place, const auto& field, const auto& numbers) {
    constexpr std::size_t count = number_count<S, place>;
    std::array<double, count> given;
    if constexpr (count == 1)
      given[0] = number(arguments[place], field.name);
    else
      read_numbers(arguments[place], field.name, given);
    for (std::size_t i = 0; i < count; ++i) *numbers[i] = given[i];
    names += (names.empty() ? "" : ", ") + std::string(field.name);
  });
  return legal(out, names);
}
template <>
Polyhedron shape_from(const std::array<py::object, 1>& arguments) {
  return legal(hull_of(vectors(arguments[0], "points")), "points");
}

/// "(3,) " of a list, "(n, 3) " of points.
template <class S, std::size_t place>
[[nodiscard]] std::string layout_of() {
  if constexpr (std::is_same_v<S, Polyhedron>)
    return "(n, 3) ";
  else
    return number_count<S, place> == 1 ? "" : "(" + std::to_string(number_count<S, place>) + ",) ";
}

/// "(3,) along x, y, z, > 0; a length"; of a property without the limit.
template <class S, std::size_t place>
[[nodiscard]] std::string text_of_field(bool has_limit) {
  const auto& field = field_of<S, place>();
  std::string out(field.what);
  if (has_limit && !std::is_same_v<S, Polyhedron>)
    out += std::string(out.empty() ? "" : ", ") +
           (field.legal == Legal::not_below_zero ? ">= 0" : (field.is_length() ? "> 0" : "> 1"));
  if (field.is_length()) out += std::string(out.empty() ? "" : "; ") + "a length";
  return layout_of<S, place>() + out;
}

template <class S, std::size_t... place>
[[nodiscard]] std::vector<Part<S>> parts_of(std::index_sequence<place...> /*fields*/) {
  return {Part<S>{field_of<S, place>().name.data(), &property_of<S, place>, text_of_field<S, place>(false)}...};
}

/// As the row has it where it is left out.
template <class S, std::size_t place>
[[nodiscard]] auto argument_of() {
  const py::arg out(field_of<S, place>().name.data());
  if constexpr (field_of<S, place>().has_default)
    return out = py::tuple(py::cast(values_of<S, place>(S{})));
  else
    return out;
}

template <class S>
[[nodiscard]] S example_of() {
  if constexpr (std::is_same_v<S, Polyhedron>)
    return make_polyhedron(std::vector<Vec3<double>>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  else
    return sample_of<S>();
}

/// The class's text but for its example: the call, what the row says, a line an argument.
template <class S, std::size_t... place>
[[nodiscard]] std::string head_of(const std::string& called, std::index_sequence<place...> /*fields*/) {
  std::string call, rows;
  std::size_t width = 0;
  ((width = std::max(width, field_of<S, place>().name.size() + 2)), ...);
  [[maybe_unused]] const auto add = [&](const auto& field, const std::string& text) {
    call += (call.empty() ? "" : ", ") + std::string(field.name) + (field.has_default ? "=(2, 2)" : "");
    rows += std::string(field.name) + std::string(width - field.name.size(), ' ') + text + "\n";
  };
  (add(field_of<S, place>(), text_of_field<S, place>(true)), ...);
  const std::string errors = "\n\nValueError and TypeError name the argument that is not legal.";
  return called + "(" + call + ")\n\n" + std::string(RowOf<S>::text) + " Immutable." +
         (rows.empty() ? "" : "\n\n" + rows.substr(0, rows.size() - 1) + errors);
}

template <class S, std::size_t... place>
void add_shape(py::module_& module, std::index_sequence<place...> fields) {
  const std::string name = class_name(RowOf<S>::word);
  const std::vector<Part<S>> parts = parts_of<S>(fields);
  py::class_<S> shape(module, name.c_str());
  shape.def(py::init([](decltype((void(place), py::object()))... argument) {
              return shape_from<S>(std::array<py::object, sizeof...(place)>{argument...});
            }),
            argument_of<S, place>()...);
  add_parts<S>(shape, parts);
  const std::string example = text_of<S>(py::cast(example_of<S>()), parts);
  shape.attr("__doc__") =
      head_of<S>(name, fields) + "\n\n    >>> import plumb\n    >>> plumb." + example + "\n    " + example + "\n";
}

template <class S>
void add_value(py::module_& module, py::list& names) {
  if constexpr (is_value<S>) {
    add_shape<S>(module, std::make_index_sequence<field_count<S>>());
    names.append(class_name(RowOf<S>::word));
  }
}

template <class... S>
void add_each(py::module_& module, const std::variant<S...>* /*list*/) {
  py::list names;
  (add_value<S>(module, names), ...);
  module.attr("shapes") = py::tuple(names);
}

/// Whether the object is a shape of this class, which is then written.
template <class S>
[[nodiscard]] bool is_read(py::handle from, Shape& to) {
  if (!is_value<S> || !py::isinstance<S>(from)) return false;
  to = from.cast<const S&>();
  return true;
}

template <class... S>
[[nodiscard]] bool is_any_read(py::handle from, std::variant<S...>& to) {
  return (is_read<S>(from, to) || ...);
}

}  // namespace

Shape shape_of(py::handle value, std::string_view argument) {
  Shape out;
  if (!is_any_read(value, out)) refuse_type(value, argument, "a shape, as plumb.Box or plumb.Capsule");
  return out;
}

py::object object_of(const Shape& shape) {
  return std::visit([](const auto& one) -> py::object { return py::cast(one); }, shape);
}

void add_shapes(py::module_& module) {
  add_each(module, static_cast<const Shape*>(nullptr));
}

}  // namespace plumb::python
