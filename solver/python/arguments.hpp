// What Python hands over, as numbers; what is not fit is refused with the argument's name.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "solver/shape/convex.hpp"

namespace plumb::python {

namespace py = pybind11;

/// The numbers of a sequence or an array of one dimension. ValueError for another shape, TypeError for a type that a double cannot
/// hold without loss (numpy's long double, complex, objects).
void read_numbers(py::handle value, std::string_view argument, std::span<double> to);

template <std::size_t N>
[[nodiscard]] std::array<double, N> numbers(py::handle value, std::string_view argument) {
  std::array<double, N> out{};
  read_numbers(value, argument, out);
  return out;
}

[[nodiscard]] inline Vec3<double> vector(py::handle value, std::string_view argument) {
  const std::array<double, 3> v = numbers<3>(value, argument);
  return {v[0], v[1], v[2]};
}

/// A number: ValueError for an array of more, TypeError for a type as above.
[[nodiscard]] double number(py::handle value, std::string_view argument);
/// The rows of an array (n, 3) of finite numbers, at least one: refused as above.
[[nodiscard]] std::vector<Vec3<double>> vectors(py::handle value, std::string_view argument);

/// ValueError with the argument's name, where something is wrong.
void refuse(const InputError& error);
/// What Python itself would raise, with the argument's name; `wanted`: "a plumb.Body".
[[noreturn]] void refuse_type(py::handle value, std::string_view argument, const char* wanted);

/// TypeError where it is none of the package's shapes.
[[nodiscard]] Shape shape_of(py::handle value, std::string_view argument);
/// The package's own.
[[nodiscard]] py::object object_of(const Shape& shape);

/// TypeError where it is no plumb.Body.
[[nodiscard]] const Body& body_of(py::handle value, std::string_view argument);
/// A plumb.ConvexBody, or a plumb.Body as one; TypeError for another.
[[nodiscard]] ConvexBody convex_body_of(py::handle value, std::string_view argument);
/// At least 1; ValueError below, TypeError where it is no whole number.
[[nodiscard]] int count_of(py::handle value, std::string_view argument);
/// 0 or more; ValueError below, TypeError where it is no number.
[[nodiscard]] double tolerance_of(py::handle value, std::string_view argument);

/// A new array of the numbers, shaped.
[[nodiscard]] py::array_t<double> array_of(std::span<const double> values, const std::vector<py::ssize_t>& shape);
[[nodiscard]] py::array_t<double> array_of(const Vec3<double>& v);
[[nodiscard]] py::array_t<double> array_of(const Mat3<double>& m);  ///< by rows

}  // namespace plumb::python
