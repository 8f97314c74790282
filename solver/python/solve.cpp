#include "solver/method/convex.hpp"
#include "solver/method/methods.hpp"
#include "solver/python/arguments.hpp"
#include "solver/python/bindings.hpp"

namespace plumb::python {
namespace {

[[nodiscard]] const Method& method_of(const py::object& word) {
  const auto name = std::string(py::str(word));
  if (const Method* found = find_method(name)) return *found;
  std::string known;
  for (const Method& method : methods()) known += (known.empty() ? "" : ", ") + std::string(method.name);
  throw py::value_error("method: no '" + name + "' among " + known);
}

[[nodiscard]] bool& flag_of(Want& want, std::string_view word) {
  if (word == "overlap") return want.overlap;
  if (word == "normal") return want.normal;
  if (word == "points") return want.points;
  if (word == "curvature") return want.curvature;
  if (word == "derivatives") return want.derivatives;
  if (word == "patch") return want.patch;
  throw py::value_error("want: no '" + std::string(word) +
                        "' among overlap, normal, points, curvature, derivatives, patch");
}

/// `tolerances`: that of the contact and that of the patch.
[[nodiscard]] Want want_of(const py::sequence& words, const py::object& iteration_limit, const py::tuple& tolerances) {
  Want want{.overlap = false, .normal = false, .points = false};
  for (const py::handle word : words) flag_of(want, std::string(py::str(word))) = true;
  want.iteration_limit = count_of(iteration_limit, "iteration_limit");
  want.tolerance = tolerance_of(tolerances[0], "tolerance");
  want.patch_tolerance = tolerance_of(tolerances[1], "patch_tolerance");
  if (want.patch_tolerance == 0) throw py::value_error("patch_tolerance: must be above 0");
  return want;
}

[[nodiscard]] Vec3<double> motion_of(const py::object& motion) {
  if (motion.is_none()) return Vec3<double>::Zero();
  const Vec3<double> out = vector(motion, "motion");
  if (!out.allFinite()) throw py::value_error("motion: must be finite");
  return out;
}

[[nodiscard]] const Contact<double>* last_of(const py::object& last) {
  if (last.is_none()) return nullptr;
  if (!py::isinstance<Contact<double>>(last)) throw py::type_error("last: must be a plumb.Contact");
  return &last.cast<const Contact<double>&>();
}

/// A pair with a plumb.ConvexBody in it.
[[nodiscard]] Contact<double> solve(const ConvexPair& pair, const Method& chosen, const Want& want,
                                    const Contact<double>* start) {
  if (chosen.name != "auto")
    throw py::value_error("method: '" + std::string(chosen.name) + "' solves two plumb.Body alone, auto any pair");
  const InputError error = find_input_error(pair);
  if (!error.reason.empty()) throw py::value_error("body2: " + std::string(error.reason));
  const py::gil_scoped_release unlocked;
  return solve_convex(pair, want, start);
}

[[nodiscard]] Contact<double> solve_any(const py::object& body1, const py::object& body2, const py::object& method,
                                        const py::sequence& want, const py::object& motion, const py::object& last,
                                        const py::object& iteration_limit, const py::tuple& tolerances) {
  const ConvexPair shapes{convex_body_of(body1, "body1"), convex_body_of(body2, "body2")};
  const Vec3<double> moving = motion_of(motion);
  const Method& chosen = method_of(method);
  const Want asked = want_of(want, iteration_limit, tolerances);
  const Contact<double>* const start = last_of(last);
  if (!py::isinstance<Body>(body1) || !py::isinstance<Body>(body2)) return solve(shapes, chosen, asked, start);
  const Pair pair{body_of(body1, "body1"), body_of(body2, "body2"), moving};
  const py::gil_scoped_release unlocked;
  return chosen.solve(pair, asked, start);
}

[[nodiscard]] py::list list_methods() {
  py::list out;
  for (const Method& method : methods())
    out.append(
        py::make_tuple(std::string(method.name), std::string(name(method.problem)), std::string(method.summary)));
  return out;
}

}  // namespace

void add_solve(py::module_& module) {
  module.def("solve", &solve_any);
  module.def("methods", &list_methods);
}

}  // namespace plumb::python
