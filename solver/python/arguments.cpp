#include "solver/python/arguments.hpp"

#include <algorithm>

namespace plumb::python {
namespace {

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

[[nodiscard]] std::string dimensions_of(const py::array& array) {
  return py::str(array.attr("shape"));
}

/// Every value of the type is a double: real, of 64 bits at most.
[[nodiscard]] bool is_held_by_double(const py::dtype& type) {
  return std::string_view("fiu").find(type.kind()) != std::string_view::npos && type.itemsize() <= 8;
}

[[nodiscard]] std::string type_of(py::handle value) {
  return std::string(py::str(py::type::handle_of(value).attr("__name__")));
}

/// As an array of doubles, of any shape; `wanted`: what it should be, in words.
[[nodiscard]] Doubles doubles_of(py::handle value, std::string_view argument, const std::string& wanted) {
  const std::string name(argument);
  const py::array given = py::array::ensure(value);
  if (!given) throw py::value_error(name + ": must be " + wanted);
  if (!is_held_by_double(given.dtype()))
    throw py::type_error(name + ": must be of real numbers that fit in float64, not of " +
                         std::string(py::str(given.dtype())));
  return Doubles(given);
}

/// The words of find_input_error in the argument's name: "shape.superellipsoid.exponents[0]" is exponents[0] here.
[[nodiscard]] std::string argument_of(std::string_view field) {
  if (field.starts_with("orientation.")) return "quaternion";
  if (field.starts_with("shape.sphere_swept.")) return "swept_radius";
  return std::string(field.substr(field.rfind('.') + 1));
}

}  // namespace

const Body& body_of(py::handle value, std::string_view argument) {
  if (!py::isinstance<Body>(value)) refuse_type(value, argument, "a plumb.Body");
  return value.cast<const Body&>();
}

ConvexBody convex_body_of(py::handle value, std::string_view argument) {
  if (py::isinstance<ConvexBody>(value)) return value.cast<const ConvexBody&>();
  if (!py::isinstance<Body>(value)) refuse_type(value, argument, "a plumb.Body or a plumb.ConvexBody");
  const auto& body = value.cast<const Body&>();
  return {body.shape, 0, body.position, body.quaternion};
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
  const std::string wanted = "(" + std::to_string(to.size()) + ",)";
  const Doubles given = doubles_of(value, argument, "an array of shape " + wanted);
  if (given.ndim() != 1 || static_cast<std::size_t>(given.shape(0)) != to.size())
    throw py::value_error(std::string(argument) + ": must have shape " + wanted + ", not " + dimensions_of(given));
  std::ranges::copy_n(given.data(), static_cast<std::ptrdiff_t>(to.size()), to.begin());
}

double number(py::handle value, std::string_view argument) {
  const Doubles given = doubles_of(value, argument, "a number");
  if (given.ndim() != 0)
    throw py::value_error(std::string(argument) + ": must be a number, not of shape " + dimensions_of(given));
  return *given.data();
}

std::vector<Vec3<double>> vectors(py::handle value, std::string_view argument) {
  const std::string name(argument);
  const Doubles given = doubles_of(value, argument, "an array of shape (n, 3)");
  if (given.ndim() != 2 || given.shape(1) != 3)
    throw py::value_error(name + ": must have shape (n, 3), not " + dimensions_of(given));
  if (given.shape(0) == 0) throw py::value_error(name + ": must be a point at least");
  std::vector<Vec3<double>> out;
  for (py::ssize_t row = 0; row < given.shape(0); ++row) out.emplace_back(Vec3<double>::Map(given.data(row)));
  if (!std::ranges::all_of(out, [](const Vec3<double>& x) { return x.allFinite(); }))
    throw py::value_error(name + ": must be finite");
  return out;
}

void refuse(const InputError& error) {
  if (!error.reason.empty()) throw py::value_error(argument_of(error.field) + ": " + std::string(error.reason));
}

void refuse_type(py::handle value, std::string_view argument, const char* wanted) {
  PyErr_Clear();
  throw py::type_error(std::string(argument) + ": must be " + wanted + ", not " + type_of(value));
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
