#include "solver/method/methods.hpp"
#include "solver/python/arguments.hpp"
#include "solver/python/bindings.hpp"

namespace plumb::python {
namespace {

[[nodiscard]] const Method& method_of(const std::string& name) {
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
  throw py::value_error("want: no '" + std::string(word) + "' among overlap, normal, points, curvature, derivatives");
}

[[nodiscard]] Want want_of(const py::sequence& words, int iteration_limit, double tolerance) {
  Want want{.overlap = false, .normal = false, .points = false};
  for (const py::handle word : words) flag_of(want, word.cast<std::string>()) = true;
  if (iteration_limit < 1) throw py::value_error("iteration_limit: must be at least 1");
  if (!(tolerance >= 0)) throw py::value_error("tolerance: must be 0 or more");
  want.iteration_limit = iteration_limit;
  want.tolerance = tolerance;
  return want;
}

[[nodiscard]] Contact<double> solve(const Body& body1, const Body& body2, const std::string& method,
                                    const py::sequence& want, const py::object& motion, const Contact<double>* last,
                                    int iteration_limit, double tolerance) {
  const Method& chosen = method_of(method);
  const Want asked = want_of(want, iteration_limit, tolerance);
  const Vec3<double> moved = motion.is_none() ? Vec3<double>(Vec3<double>::Zero()) : vector(motion, "motion");
  if (!moved.allFinite()) throw py::value_error("motion: must be finite");
  const py::gil_scoped_release unlocked;
  return chosen.solve({body1, body2, moved}, asked, last);
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
  module.def("solve", &solve);
  module.def("methods", &list_methods);
}

}  // namespace plumb::python
