#include "solver/python/arguments.hpp"
#include "solver/python/bindings.hpp"

namespace plumb::python {
namespace {

/// The words of find_input_error in the argument's name: "shape.superellipsoid.exponents[0]" is exponents[0] here.
[[nodiscard]] std::string argument_of(std::string_view field) {
  if (field.starts_with("orientation.")) return "quaternion";
  return std::string(field.substr(field.rfind('.') + 1));
}

[[nodiscard]] Body make_body(const py::object& semi_axes, const py::object& position, const py::object& quaternion,
                             const py::object& exponents) {
  const auto [n1, n2] = numbers<2>(exponents, "exponents");
  const Body body{
      {vector(semi_axes, "semi_axes"), n1, n2}, vector(position, "position"), numbers<4>(quaternion, "quaternion")};
  const InputError error = find_input_error({body, {}});
  if (!error.reason.empty()) throw py::value_error(argument_of(error.field) + ": " + std::string(error.reason));
  return body;
}

[[nodiscard]] py::array_t<double> semi_axes(const Body& body) {
  return array_of(body.shape.semi_axes);
}
[[nodiscard]] py::array_t<double> position(const Body& body) {
  return array_of(body.position);
}
[[nodiscard]] py::array_t<double> quaternion(const Body& body) {
  return array_of(body.quaternion, {4});
}
[[nodiscard]] py::array_t<double> exponents(const Body& body) {
  return array_of(std::array{body.shape.n1, body.shape.n2}, {2});
}

[[nodiscard]] py::tuple state(const Body& body) {
  const auto list = [](const py::array_t<double>& array) { return py::tuple(array.attr("tolist")()); };
  return py::make_tuple(list(semi_axes(body)), list(position(body)), list(quaternion(body)), list(exponents(body)));
}

[[nodiscard]] Body from_state(const py::tuple& state) {
  return make_body(state[0], state[1], state[2], state[3]);
}

[[nodiscard]] py::str body_text_of(const Body& body) {
  return py::str("Body(semi_axes={}, position={}, quaternion={}, exponents={})").format(*state(body));
}

[[nodiscard]] bool is_equal(const Body& body, const py::object& other) {
  return py::isinstance<Body>(other) && state(body).equal(state(other.cast<const Body&>()));
}

[[nodiscard]] Body moved(const Body& body, const py::object& position, const py::object& quaternion) {
  const py::tuple old = state(body);
  return make_body(old[0], position.is_none() ? py::object(old[1]) : position,
                   quaternion.is_none() ? py::object(old[2]) : quaternion, old[3]);
}

constexpr auto body_text = R"(Body(semi_axes, position, quaternion=(1, 0, 0, 0), exponents=(2, 2))

A superellipsoid where it stands; immutable.

    (|x/a|^n2 + |y/b|^n2)^(n1/n2) + |z/c|^n1 = 1    in body axes

semi_axes   (3,) a, b, c > 0; a length, in any unit, the same for positions
position    (3,) of the centre, world frame; a length
quaternion  (4,) w, x, y, z of any non-zero length: its direction takes body axes to the world's
exponents   (2,) n1, n2 > 1; n1 pairs the xy-radius with z, n2 pairs x with y; 2, 2 is an ellipsoid

ValueError names the argument that is not legal (a NaN, an axis of 0, another shape), TypeError one whose type a
float64 cannot hold without loss.

    >>> import plumb
    >>> plumb.Body((1, 1, 2), (0, 0, 0)).semi_axes
    array([1., 1., 2.])
)";

}  // namespace

void add_body(py::module_& module) {
  py::class_<Body> body(module, "Body", body_text);
  body.def(py::init(&make_body), py::arg("semi_axes"), py::arg("position"),
           py::arg("quaternion") = py::make_tuple(1, 0, 0, 0), py::arg("exponents") = py::make_tuple(2, 2));
  body.def_property_readonly("semi_axes", &semi_axes, "(3,) a, b, c; a length");
  body.def_property_readonly("position", &position, "(3,) of the centre, world frame; a length");
  body.def_property_readonly("quaternion", &quaternion, "(4,) w, x, y, z as it was given");
  body.def_property_readonly("exponents", &exponents, "(2,) n1, n2");
  body.def("moved", &moved, py::arg("position") = py::none(), py::arg("quaternion") = py::none(),
           "moved(position=None, quaternion=None) -> Body\n\nThe same shape elsewhere; None: as it is.");
  body.def("__repr__", &body_text_of);
  body.def("__eq__", &is_equal);
  body.def("__hash__", [](const Body& self) { return py::hash(state(self)); });
  body.def(py::pickle(&state, &from_state));
  body.attr("__module__") = "plumb";
}

}  // namespace plumb::python
