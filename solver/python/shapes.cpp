#include "solver/python/arguments.hpp"
#include "solver/python/bindings.hpp"
#include "solver/python/values.hpp"
#include "solver/shape/hull.hpp"

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

/// A number of S as a property.
template <auto member, class S>
[[nodiscard]] py::object length(const S& shape) {
  return py::float_(shape.*member);
}
/// Numbers of S as a property.
template <auto member, class S>
[[nodiscard]] py::object lengths(const S& shape) {
  const auto& numbers = shape.*member;
  return array_of(std::span<const double>(numbers.data(), numbers.size()), {static_cast<py::ssize_t>(numbers.size())});
}
template <class S>
[[nodiscard]] py::object exponents(const S& shape) {
  return array_of(std::array{shape.n1, shape.n2}, {2});
}
[[nodiscard]] py::object corners(const Polyhedron& shape) {
  const std::vector<Vec3<double>>& from = shape.hull->corners;
  return array_of(std::span(from.front().data(), 3 * from.size()), {static_cast<py::ssize_t>(from.size()), 3});
}

[[nodiscard]] Superellipsoid<double> make_superellipsoid(const py::object& semi_axes, const py::object& exponents) {
  const auto [n1, n2] = numbers<2>(exponents, "exponents");
  return legal(Superellipsoid<double>{vector(semi_axes, "semi_axes"), n1, n2}, "semi_axes, exponents");
}
[[nodiscard]] Capsule make_capsule(const py::object& half_length, const py::object& radius) {
  return legal(Capsule{number(half_length, "half_length"), number(radius, "radius")}, "half_length, radius");
}
[[nodiscard]] Cylinder make_cylinder(const py::object& half_length, const py::object& radius) {
  return legal(Cylinder{number(half_length, "half_length"), number(radius, "radius")}, "half_length, radius");
}
[[nodiscard]] Cone make_cone(const py::object& radius, const py::object& height) {
  return legal(Cone{number(radius, "radius"), number(height, "height")}, "radius, height");
}
[[nodiscard]] Frustum make_frustum(const py::object& radii, const py::object& height) {
  return legal(Frustum{numbers<2>(radii, "radii"), number(height, "height")}, "radii, height");
}
[[nodiscard]] Box make_box(const py::object& half_extents) {
  return legal(Box{vector(half_extents, "half_extents")}, "half_extents");
}
[[nodiscard]] Polyhedron hull_of(const std::vector<Vec3<double>>& points) {
  const py::gil_scoped_release unlocked;
  return make_polyhedron(points);
}
[[nodiscard]] Polyhedron make_hull(const py::object& points) {
  return legal(hull_of(vectors(points, "points")), "points");
}
[[nodiscard]] PolySuperellipsoid make_poly_superellipsoid(const py::object& semi_axes, const py::object& exponents) {
  const auto [n1, n2] = numbers<2>(exponents, "exponents");
  return legal(PolySuperellipsoid{numbers<6>(semi_axes, "semi_axes"), n1, n2}, "semi_axes, exponents");
}

constexpr auto superellipsoid_text = R"(Superellipsoid(semi_axes, exponents=(2, 2))

A superellipsoid, for a ConvexBody; a Body has one with less ado. Immutable.

    (|x/a|^n2 + |y/b|^n2)^(n1/n2) + |z/c|^n1 = 1    in body axes

semi_axes  (3,) a, b, c > 0; a length
exponents  (2,) n1, n2 > 1; 2, 2 is an ellipsoid

ValueError and TypeError name the argument that is not legal.

    >>> import plumb
    >>> plumb.Superellipsoid((1, 1, 2)).exponents
    array([2., 2.])
)";

constexpr auto capsule_text = R"(Capsule(half_length, radius)

All points within the radius of the segment abs(z) <= half_length; immutable.

half_length  of the segment, >= 0; a length
radius       > 0; a length

ValueError and TypeError name the argument that is not legal.

    >>> import plumb
    >>> plumb.Capsule(1, 0.5)
    Capsule(half_length=1.0, radius=0.5)
)";

constexpr auto cylinder_text = R"(Cylinder(half_length, radius)

x^2 + y^2 <= radius^2, abs(z) <= half_length: two flat ends with sharp rims; immutable.

half_length  > 0; a length
radius       > 0; a length

ValueError and TypeError name the argument that is not legal.

    >>> import plumb
    >>> plumb.Cylinder(1, 0.5).radius
    0.5
)";

constexpr auto cone_text = R"(Cone(radius, height)

A flat end below, the apex above; the centroid, a quarter of the height above the end, is the origin. Immutable.

radius  of the end, > 0; a length
height  > 0; a length

ValueError and TypeError name the argument that is not legal.

    >>> import plumb
    >>> plumb.Cone(1, 2).height
    2.0
)";

constexpr auto frustum_text = R"(Frustum(radii, height)

A cone cut parallel to its end; the centroid is the origin. Immutable.

radii   (2,) of the bottom and of the top, >= 0, not both 0; a length
height  > 0; a length

ValueError and TypeError name the argument that is not legal.

    >>> import plumb
    >>> plumb.Frustum((2, 1), 1).radii
    array([2., 1.])
)";

constexpr auto box_text = R"(Box(half_extents)

abs(x) <= half_extents[0] and so on: sharp edges and corners; immutable.

half_extents  (3,) along x, y, z, > 0; a length

ValueError and TypeError name the argument that is not legal.

    >>> import plumb
    >>> plumb.Box((3, 2, 1)).half_extents
    array([3., 2., 1.])
)";

constexpr auto polyhedron_text = R"(Polyhedron(points)

The convex hull of points, decided exactly, which takes longer than a solve: make it once. It may be a polygon, a
segment or a point. Immutable.

points  (n, 3) at least one, in body axes; a length

ValueError and TypeError name the argument that is not legal.

    >>> import plumb
    >>> plumb.Polyhedron([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0.25, 0.25, 0)]).points
    array([[0., 0., 0.],
           [1., 0., 0.],
           [0., 1., 0.]])
)";

constexpr auto poly_superellipsoid_text = R"(PolySuperellipsoid(semi_axes, exponents=(2, 2))

Eight octants of superellipsoids that meet smoothly; immutable.

semi_axes  (6,) to +x, -x, +y, -y, +z, -z, > 0; a length
exponents  (2,) n1, n2 > 1, as a Superellipsoid's

ValueError and TypeError name the argument that is not legal.

    >>> import plumb
    >>> plumb.PolySuperellipsoid((1, 2, 1, 1, 3, 1)).semi_axes
    array([1., 2., 1., 1., 3., 1.])
)";

constexpr auto half_space_text = R"(HalfSpace()

z <= 0: a wall without end, below the body's position; immutable. Two of them are no pair.

    >>> import plumb
    >>> plumb.HalfSpace()
    HalfSpace()
)";

constexpr auto exponents_text = "(2,) n1, n2";

void add_round(py::module_& module) {
  using Ellipsoid = Superellipsoid<double>;
  py::class_<Ellipsoid> one(module, "Superellipsoid", superellipsoid_text);
  one.def(py::init(&make_superellipsoid), py::arg("semi_axes"), py::arg("exponents") = py::make_tuple(2, 2));
  add_parts<Ellipsoid>(one, {{"semi_axes", &lengths<&Ellipsoid::semi_axes, Ellipsoid>, "(3,) a, b, c; a length"},
                             {"exponents", &exponents<Ellipsoid>, exponents_text}});
  py::class_<PolySuperellipsoid> poly(module, "PolySuperellipsoid", poly_superellipsoid_text);
  poly.def(py::init(&make_poly_superellipsoid), py::arg("semi_axes"), py::arg("exponents") = py::make_tuple(2, 2));
  add_parts<PolySuperellipsoid>(poly, {{"semi_axes", &lengths<&PolySuperellipsoid::semi_axes, PolySuperellipsoid>,
                                        "(6,) to +x, -x, +y, -y, +z, -z; a length"},
                                       {"exponents", &exponents<PolySuperellipsoid>, exponents_text}});
  py::class_<Capsule> capsule(module, "Capsule", capsule_text);
  capsule.def(py::init(&make_capsule), py::arg("half_length"), py::arg("radius"));
  add_parts<Capsule>(capsule, {{"half_length", &length<&Capsule::half_length, Capsule>, "of the segment; a length"},
                               {"radius", &length<&Capsule::radius, Capsule>, "a length"}});
}

void add_with_ends(py::module_& module) {
  py::class_<Cylinder> cylinder(module, "Cylinder", cylinder_text);
  cylinder.def(py::init(&make_cylinder), py::arg("half_length"), py::arg("radius"));
  add_parts<Cylinder>(cylinder, {{"half_length", &length<&Cylinder::half_length, Cylinder>, "a length"},
                                 {"radius", &length<&Cylinder::radius, Cylinder>, "a length"}});
  py::class_<Cone> cone(module, "Cone", cone_text);
  cone.def(py::init(&make_cone), py::arg("radius"), py::arg("height"));
  add_parts<Cone>(cone, {{"radius", &length<&Cone::radius, Cone>, "of the end; a length"},
                         {"height", &length<&Cone::height, Cone>, "a length"}});
  py::class_<Frustum> frustum(module, "Frustum", frustum_text);
  frustum.def(py::init(&make_frustum), py::arg("radii"), py::arg("height"));
  add_parts<Frustum>(frustum,
                     {{"radii", &lengths<&Frustum::radii, Frustum>, "(2,) of the bottom and of the top; a length"},
                      {"height", &length<&Frustum::height, Frustum>, "a length"}});
}

void add_with_faces(py::module_& module) {
  py::class_<Box> box(module, "Box", box_text);
  box.def(py::init(&make_box), py::arg("half_extents"));
  add_parts<Box>(box, {{"half_extents", &lengths<&Box::half_extents, Box>, "(3,) along x, y, z; a length"}});
  py::class_<Polyhedron> polyhedron(module, "Polyhedron", polyhedron_text);
  polyhedron.def(py::init(&make_hull), py::arg("points"));
  add_parts<Polyhedron>(
      polyhedron, {{"points", &corners, "(k, 3) those that are corners of the hull, as they were given; a length"}});
  py::class_<HalfSpace> half_space(module, "HalfSpace", half_space_text);
  half_space.def(py::init<>());
  add_parts<HalfSpace>(half_space, {});
}

/// Whether the object is a shape of this class, which is then written.
template <class S>
[[nodiscard]] bool is_read(py::handle from, Shape& to) {
  if (!py::isinstance<S>(from)) return false;
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
  add_round(module);
  add_with_ends(module);
  add_with_faces(module);
}

}  // namespace plumb::python
