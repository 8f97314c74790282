// What Python hands over, as numbers; what is not fit is refused with the argument's name.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "solver/contact.hpp"

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

/// TypeError where it is no plumb.Body.
[[nodiscard]] const Body& body_of(py::handle value, std::string_view argument);
/// At least 1; ValueError below, TypeError where it is no whole number.
[[nodiscard]] int count_of(py::handle value, std::string_view argument);
/// 0 or more; ValueError below, TypeError where it is no number.
[[nodiscard]] double tolerance_of(py::handle value, std::string_view argument);

/// A new array of the numbers, shaped.
[[nodiscard]] py::array_t<double> array_of(std::span<const double> values, const std::vector<py::ssize_t>& shape);
[[nodiscard]] py::array_t<double> array_of(const Vec3<double>& v);
[[nodiscard]] py::array_t<double> array_of(const Mat3<double>& m);  ///< by rows

}  // namespace plumb::python
