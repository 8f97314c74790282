#include "solver/python/arguments.hpp"

#include <algorithm>

namespace plumb::python {
namespace {

[[nodiscard]] std::string shape_of(const py::array& array) {
  return py::str(array.attr("shape"));
}

/// Every value of the type is a double: real, of 64 bits at most.
[[nodiscard]] bool is_held_by_double(const py::dtype& type) {
  return std::string_view("fiu").find(type.kind()) != std::string_view::npos && type.itemsize() <= 8;
}

[[nodiscard]] std::string type_of(py::handle value) {
  return std::string(py::str(py::type::handle_of(value).attr("__name__")));
}

/// What Python itself would raise, with the argument's name.
[[noreturn]] void refuse_type(py::handle value, std::string_view argument, const char* wanted) {
  PyErr_Clear();
  throw py::type_error(std::string(argument) + ": must be " + wanted + ", not " + type_of(value));
}

}  // namespace

const Body& body_of(py::handle value, std::string_view argument) {
  if (!py::isinstance<Body>(value)) refuse_type(value, argument, "a plumb.Body");
  return value.cast<const Body&>();
}

int count_of(py::handle value, std::string_view argument) {
  if (PyIndex_Check(value.ptr()) == 0) refuse_type(value, argument, "a whole number");
  const py::ssize_t count = PyNumber_AsSsize_t(value.ptr(), nullptr);  // without an exception: clipped
  if (count < 1) throw py::value_error(std::string(argument) + ": must be at least 1");
  return static_cast<int>(std::min<py::ssize_t>(count, std::numeric_limits<int>::max()));
}

double tolerance_of(py::handle value, std::string_view argument) {
  const double tolerance = PyFloat_AsDouble(value.ptr());
  if (PyErr_Occurred() != nullptr) refuse_type(value, argument, "a number");
  if (!(tolerance >= 0)) throw py::value_error(std::string(argument) + ": must be 0 or more");
  return tolerance;
}

void read_numbers(py::handle value, std::string_view argument, std::span<double> to) {
  const std::string name(argument), wanted = "(" + std::to_string(to.size()) + ",)";
  const py::array given = py::array::ensure(value);
  if (!given) throw py::value_error(name + ": must be an array of shape " + wanted);
  if (!is_held_by_double(given.dtype()))
    throw py::type_error(name + ": must be of real numbers that fit in float64, not of " +
                         std::string(py::str(given.dtype())));
  if (given.ndim() != 1 || static_cast<std::size_t>(given.shape(0)) != to.size())
    throw py::value_error(name + ": must have shape " + wanted + ", not " + shape_of(given));
  const py::array_t<double, py::array::c_style | py::array::forcecast> doubles(given);
  std::ranges::copy_n(doubles.data(), static_cast<std::ptrdiff_t>(to.size()), to.begin());
}

py::array_t<double> array_of(std::span<const double> values, const std::vector<py::ssize_t>& shape) {
  py::array_t<double> out(shape);
  std::ranges::copy(values, out.mutable_data());
  return out;
}

py::array_t<double> array_of(const Vec3<double>& v) {
  return array_of(std::span(v.data(), 3), {3});
}

py::array_t<double> array_of(const Mat3<double>& m) {
  const Mat3<double> by_rows = m.transpose();
  return array_of(std::span(by_rows.data(), 9), {3, 3});
}

}  // namespace plumb::python
