#include <algorithm>
#include <cmath>

#include "solver/diagnosis.hpp"
#include "solver/patch/patch.hpp"
#include "solver/python/arguments.hpp"
#include "solver/python/bindings.hpp"

namespace plumb::python {
namespace {

using Answer = Contact<double>;
using Derivative = PoseDerivative<double>;
using Axes = std::array<double, 9>;

/// Members of the package's own enumeration, by the numbers of the library's; they live as long as the process.
template <class Word, std::size_t N>
class Words {
 public:
  void load(const char* enumeration) {
    const py::object words = py::module_::import("plumb._words").attr(enumeration);
    for (std::size_t i = 0; i < N; ++i) {
      const py::object member = words[py::str(std::string(name(static_cast<Word>(i))))];
      if (member.cast<std::size_t>() != i)
        throw py::import_error("plumb._words is of another build than plumb._native");
      members_[i] = member.inc_ref();
    }
  }
  [[nodiscard]] py::object operator()(Word word) const {
    return py::reinterpret_borrow<py::object>(members_[static_cast<std::size_t>(word)]);
  }

 private:
  std::array<py::handle, N> members_{};
};

Words<Status, 6> status_words;
Words<Verdict, 3> verdict_words;

[[nodiscard]] py::object status(const Answer& answer) {
  return status_words(answer.status);
}
[[nodiscard]] py::object verdict(const Answer& answer) {
  return verdict_words(answer.verdict);
}

[[nodiscard]] py::array_t<double> points(const Answer& answer) {
  std::array<double, 6> out{};
  std::ranges::copy_n(answer.point1.data(), 3, out.begin());
  std::ranges::copy_n(answer.point2.data(), 3, out.begin() + 3);
  return array_of(out, {2, 3});
}

[[nodiscard]] py::array_t<double> radii(const Answer& answer) {
  const auto& [first, second] = answer.curvature;
  return array_of(std::array{first.radius1, first.radius2, second.radius1, second.radius2}, {2, 2});
}

[[nodiscard]] py::array_t<double> directions(const Answer& answer) {
  std::array<double, 12> out{};
  auto to = out.begin();
  for (const auto& one : answer.curvature)
    for (const Vec3<double>& direction : {one.direction1, one.direction2})
      to = std::ranges::copy_n(direction.data(), 3, to).out;
  return array_of(out, {2, 2, 3});
}

[[nodiscard]] py::object derivatives(const Answer& answer) {
  if (!answer.derivatives) return py::none();
  return py::make_tuple((*answer.derivatives)[0], (*answer.derivatives)[1]);
}

[[nodiscard]] py::array_t<double> axes(const Patch& patch) {
  Axes out{};
  std::ranges::copy_n(patch.axes.data(), 9, out.begin());  // by columns: an axis after the other
  return array_of(out, {3, 3});
}

[[nodiscard]] py::array_t<double> patch_points(const Patch& patch) {
  std::array<double, 12> out{};
  auto to = out.begin();
  for (const Vec3<double>& point : points_of(patch)) to = std::ranges::copy_n(point.data(), 3, to).out;
  return array_of(out, {4, 3});
}

[[nodiscard]] py::object patch(const Answer& answer) {
  return answer.patch ? py::cast(*answer.patch) : py::object(py::none());
}

[[nodiscard]] py::str contact_text_of(const Answer& answer) {
  return py::str("<Contact {}: {}, {}, overlap {:.6g}>")
      .format(std::string(answer.method), status(answer), verdict(answer), answer.overlap);
}

[[nodiscard]] py::tuple diagnosis(const py::object& body1, const py::object& body2, const py::object& contact) {
  if (!py::isinstance<Answer>(contact)) throw py::type_error("contact: must be a plumb.Contact");
  const auto& answer = contact.cast<const Answer&>();
  const Pair pair{body_of(body1, "body1"), body_of(body2, "body2")};
  const Diagnosis found = diagnose(pair, answer.point1, answer.point2, answer.overlap < 0 ? -1 : 1);
  return py::make_tuple(found.d_n1, found.d_n2, found.n1_n2, array_of(found.residues, {5}));
}

constexpr auto contact_text = R"(The answer for one pair, made by plumb.solve; immutable.

A number that was not asked for, or that the method could not find, is NaN - never 0.)";

void add_numbers(py::class_<Answer>& contact) {
  const auto vector = [&](const char* name, Vec3<double> Answer::* member, const char* text) {
    contact.def_property_readonly(name, [member](const Answer& answer) { return array_of(answer.*member); }, text);
  };
  contact.def_readonly("overlap", &Answer::overlap,
                       "a length; > 0: the bodies penetrate by it, < 0: they are -overlap apart");
  vector("normal", &Answer::normal, "(3,) unit, from body 1 to body 2");
  contact.def_property_readonly("points", &points, "(2, 3) on body 1's and on body 2's surface, world frame");
  vector("contact_point", &Answer::contact_point, "(3,) where a force would act, world frame");
  contact.def_property_readonly("curvature_radii", &radii,
                                "(2, 2) principal radii of body 1's and body 2's surface at their points; a length, "
                                "infinite on a flat, 0 on an edge");
  contact.def_property_readonly("curvature_directions", &directions,
                                "(2, 2, 3) the unit tangents to which these radii belong, world frame");
}

void add_derivative(py::module_& module) {
  py::class_<Derivative> derivative(module, "PoseDerivative",
                                    "How overlap and normal follow a body that is shifted by dx and turned by the "
                                    "rotation vector dw (rad) about its centre, world axes.");
  const auto add = [&](const char* name, auto member, const char* text) {
    derivative.def_property_readonly(name, [member](const Derivative& self) { return array_of(self.*member); }, text);
  };
  add("overlap_by_shift", &Derivative::overlap_by_shift, "(3,) d overlap = . dx");
  add("overlap_by_turn", &Derivative::overlap_by_turn, "(3,) d overlap = . dw; a length");
  add("normal_by_shift", &Derivative::normal_by_shift, "(3, 3) d normal = . dx; 1/length");
  add("normal_by_turn", &Derivative::normal_by_turn, "(3, 3) d normal = . dw");
  derivative.attr("__module__") = "plumb";
}

void add_patch(py::module_& module) {
  py::class_<Patch> patch(module, "Patch",
                          "The part that two overlapping bodies have in common: no number of it jumps, whatever the "
                          "contact's point and normal do. Of bodies apart volume and area are 0 and the rest NaN.");
  const auto vector = [&](const char* name, Vec3<double> Patch::* member, const char* text) {
    patch.def_property_readonly(name, [member](const Patch& self) { return array_of(self.*member); }, text);
  };
  patch.def_readonly("volume", &Patch::volume, "V, length^3");
  patch.def_readonly("area", &Patch::area, "|a|, a the area vector of body 1's surface inside body 2; length^2");
  vector("normal", &Patch::normal, "(3,) a/|a|, from body 1 to body 2: dV = -a . dx, body 2 shifted; NaN where a is 0");
  vector("centre", &Patch::centre, "(3,) of the volume, world frame");
  vector("area_moment", &Patch::area_moment, "(3,) dV = -. dw, body 2 turned by dw about the centre; length^3");
  vector("second_moments", &Patch::second_moments,
         "(3,) principal, about the centre, divided by V: length^2, the largest first");
  patch.def_property_readonly("axes", &axes, "(3, 3) theirs by rows: unit, the third from body 1 to body 2");
  patch.def_property_readonly("points", &patch_points,
                              "(4, 3) a quarter of the weight each: together the patch's centre and second moments");
  patch.def_readonly("error", &Patch::error,
                     "estimate of the largest relative error; above patch_tolerance where that was not reached");
  patch.attr("__module__") = "plumb";
}

}  // namespace

void add_contact(py::module_& module) {
  status_words.load("Status");
  verdict_words.load("Verdict");
  add_derivative(module);
  add_patch(module);
  py::class_<Answer> contact(module, "Contact", contact_text);
  contact.def_property_readonly(
      "method", [](const Answer& answer) { return std::string(answer.method); }, "the method that answered");
  contact.def_property_readonly("status", &status, "plumb.Status: how the solve ended");
  contact.def_property_readonly("verdict", &verdict, "plumb.Verdict: overlapping, separated or undecided");
  add_numbers(contact);
  contact.def_property_readonly("derivatives", &derivatives,
                                "two PoseDerivative, by the pose of body 1 and of body 2; None if not asked for");
  contact.def_property_readonly("patch", &patch, "the Patch; None if not asked for");
  contact.def_readonly("iterations", &Answer::iterations, "steps of the solve that answered");
  contact.def_readonly("evaluations", &Answer::evaluations, "of the residual, over all there was");
  contact.def("__repr__", &contact_text_of);
  contact.attr("__module__") = "plumb";
  module.def("diagnose", &diagnosis);
}

}  // namespace plumb::python
