#include "solver/python/arguments.hpp"
#include "solver/python/bindings.hpp"
#include "solver/python/values.hpp"

namespace plumb::python {
namespace {

void refuse_illegal(const Body& body) {
  refuse(find_input_error(Pair{body, {}}));
}
void refuse_illegal(const ConvexBody& body) {
  refuse(find_input_error(ConvexPair{body, {}}));
}

[[nodiscard]] Body make_body(const py::object& semi_axes, const py::object& position, const py::object& quaternion,
                             const py::object& exponents) {
  const auto [n1, n2] = numbers<2>(exponents, "exponents");
  const Body out{
      {vector(semi_axes, "semi_axes"), n1, n2}, vector(position, "position"), numbers<4>(quaternion, "quaternion")};
  refuse_illegal(out);
  return out;
}

[[nodiscard]] ConvexBody make_convex_body(const py::object& shape, const py::object& position,
                                          const py::object& quaternion, const py::object& swept_radius) {
  const ConvexBody out{shape_of(shape, "shape"), number(swept_radius, "swept_radius"), vector(position, "position"),
                       numbers<4>(quaternion, "quaternion")};
  refuse_illegal(out);
  return out;
}

template <class B>
[[nodiscard]] py::object position(const B& body) {
  return array_of(body.position);
}
template <class B>
[[nodiscard]] py::object quaternion(const B& body) {
  return array_of(body.quaternion, {4});
}

constexpr auto position_text = "(3,) of the body's origin, world frame; a length",
               quaternion_text = "(4,) w, x, y, z as it was given";

[[nodiscard]] std::vector<Part<Body>> parts_of_body() {
  return {{"semi_axes", [](const Body& body) -> py::object { return array_of(body.shape.semi_axes); },
           "(3,) a, b, c; a length"},
          {"position", &position<Body>, "(3,) of the centre, world frame; a length"},
          {"quaternion", &quaternion<Body>, quaternion_text},
          {"exponents",
           [](const Body& body) -> py::object { return array_of(std::array{body.shape.n1, body.shape.n2}, {2}); },
           "(2,) n1, n2"}};
}

[[nodiscard]] std::vector<Part<ConvexBody>> parts_of_convex_body() {
  return {{"shape", [](const ConvexBody& body) { return object_of(body.shape); }, "what stands there"},
          {"position", &position<ConvexBody>, position_text},
          {"quaternion", &quaternion<ConvexBody>, quaternion_text},
          {"swept_radius", [](const ConvexBody& body) -> py::object { return py::float_(body.swept_radius); },
           "all points within this of the shape belong to the body; a length"}};
}

template <class B>
[[nodiscard]] B moved(B body, const py::object& position, const py::object& quaternion) {
  if (!position.is_none()) body.position = vector(position, "position");
  if (!quaternion.is_none()) body.quaternion = numbers<4>(quaternion, "quaternion");
  refuse_illegal(body);
  return body;
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

constexpr auto convex_body_text = R"(ConvexBody(shape, position, quaternion=(1, 0, 0, 0), swept_radius=0)

A convex shape where it stands, with its edges rounded if wanted; immutable.

shape         what stands there: a Box, a Capsule or another of the package's shapes
position      (3,) of the shape's origin, world frame; a length
quaternion    (4,) w, x, y, z of any non-zero length: its direction takes body axes to the world's
swept_radius  all points within this of the shape belong to the body, >= 0; a length

ValueError names the argument that is not legal, TypeError one of another type.

    >>> import plumb
    >>> brick = plumb.ConvexBody(plumb.Box((3, 2, 1)), (0, 0, 1), swept_radius=0.25)
    >>> floor = plumb.ConvexBody(plumb.HalfSpace(), (0, 0, 0))
    >>> plumb.solve(brick, floor).overlap
    0.25
)";

template <class B>
void add_moved(py::class_<B>& bodies, const char* text) {
  bodies.def("moved", &moved<B>, py::arg("position") = py::none(), py::arg("quaternion") = py::none(), text);
}

}  // namespace

void add_body(py::module_& module) {
  py::class_<Body> body(module, "Body", body_text);
  body.def(py::init(&make_body), py::arg("semi_axes"), py::arg("position"),
           py::arg("quaternion") = py::make_tuple(1, 0, 0, 0), py::arg("exponents") = py::make_tuple(2, 2));
  add_parts(body, parts_of_body());
  add_moved(body, "moved(position=None, quaternion=None) -> Body\n\nThe same shape elsewhere; None: as it is.");
  py::class_<ConvexBody> convex(module, "ConvexBody", convex_body_text);
  convex.def(py::init(&make_convex_body), py::arg("shape"), py::arg("position"),
             py::arg("quaternion") = py::make_tuple(1, 0, 0, 0), py::arg("swept_radius") = 0);
  add_parts(convex, parts_of_convex_body());
  add_moved(convex, "moved(position=None, quaternion=None) -> ConvexBody\n\nThe same shape elsewhere; None: as it is.");
}

}  // namespace plumb::python
