// A class of Python whose objects are values: made of their arguments, which are its properties, immutable.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <string>
#include <vector>

namespace plumb::python {

namespace py = pybind11;

/// An argument of the class by its name, what it is of an object (a float, a new array, another value), and its text.
template <class V>
struct Part {
  const char* name;
  py::object (*get)(const V&);
  std::string text;
};

/// Arrays as tuples, which can be compared and hashed.
[[nodiscard]] inline py::object plain(const py::object& part) {
  if (!py::isinstance<py::array>(part)) return part;
  py::list out;
  for (const py::handle row : part.attr("tolist")())
    out.append(py::isinstance<py::list>(row) ? py::object(py::tuple(row.cast<py::list>()))
                                             : py::reinterpret_borrow<py::object>(row));
  return py::tuple(out);
}

/// All parts in their order: a value is equal to another of its class where this is, and is made from it.
template <class V>
[[nodiscard]] py::tuple state_of(const V& value, const std::vector<Part<V>>& parts) {
  py::list out;
  for (const Part<V>& part : parts) out.append(plain(part.get(value)));
  return py::tuple(out);
}

/// "Name(part=.., part=..)", as it is called.
template <class V>
[[nodiscard]] std::string text_of(const py::object& self, const std::vector<Part<V>>& parts) {
  std::string out;
  for (const Part<V>& part : parts)
    out += std::string(out.empty() ? "" : ", ") + part.name + "=" +
           std::string(py::repr(plain(part.get(self.cast<const V&>()))));
  return std::string(py::str(py::type::of(self).attr("__name__"))) + "(" + out + ")";
}

/// The properties, and what every value can: repr, ==, hash, copies, pickles.
template <class V>
void add_parts(py::class_<V>& values, const std::vector<Part<V>>& parts) {
  for (const auto& [name, get, text] : parts) values.def_property_readonly(name, get, text.c_str());
  values.def("__repr__", [parts](const py::object& self) { return text_of<V>(self, parts); });
  values.def("__eq__", [parts](const V& self, const py::object& other) {
    return py::isinstance<V>(other) && state_of(self, parts).equal(state_of(other.cast<const V&>(), parts));
  });
  values.def("__hash__", [parts](const V& self) { return py::hash(state_of(self, parts)); });
  values.def("__reduce__", [parts](const py::object& self) {
    return py::make_tuple(py::type::of(self), state_of(self.cast<const V&>(), parts));
  });
  values.attr("__module__") = "plumb";
}

}  // namespace plumb::python
