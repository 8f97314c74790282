#include "solver/method/methods.hpp"

#include <algorithm>
#include <array>

#include "solver/method/automatic.hpp"
#include "solver/method/common_normal.hpp"
#include "solver/method/first_touch.hpp"
#include "solver/method/geometric_potential.hpp"
#include "solver/method/minimum_distance.hpp"
#include "solver/standard_arithmetic.hpp"

namespace plumb {
namespace {

/// Takes away what the method found: where it did not converge, that is no answer.
template <class S>
void withhold(Contact<S>& answer) {
  Contact<S> out;
  out.method = answer.method;
  out.status = answer.status;
  out.iterations = answer.iterations;
  out.evaluations = answer.evaluations;
  answer = out;
}

template <class S>
Contact<S> refusal() {
  Contact<S> out;
  out.status = Status::invalid_input;
  return out;
}

/// What every method does alike: refuse illegal input, and hand out nothing that its status does not vouch for.
template <class S, SolveFunction<S> method>
Contact<S> guarded(const Pair& pair, const Want& want, const Contact<S>* last) {
  const StandardArithmetic mode;
  Contact<S> out = is_valid_in_callers_mode(pair) ? method(pair, want, last)
                                                  : refusal<S>();  // in place: a contact is no small thing
  if (out.status != Status::converged) withhold<S>(out);
  return out;
}

template <SolveFunction<double> method, SolveFunction<float> method_float, SolveFunction<long double> method_long>
constexpr Method row(std::string_view name, Problem problem, std::string_view summary) {
  return {
      name, problem, summary, guarded<double, method>, guarded<float, method_float>, guarded<long double, method_long>};
}

#define PLUMB_ROW(function, problem, summary) \
  row<function<double>, function<float>, function<long double>>(#function, problem, summary)

constexpr std::array all_methods{
    row<automatic_in_callers_mode<double>, automatic_in_callers_mode<float>, automatic_in_callers_mode<long double>>(
        "auto", Problem::common_normal,
        "the default: the form that suits the shapes, and a guard that the common normal is the lowest"),
    PLUMB_ROW(original_cn, Problem::common_normal,
              "Lin & Ng's six equations as published, absolute values and all (Eqs. 1-6)"),
    PLUMB_ROW(corrected_cn, Problem::common_normal,
              "the same with the signs kept, z still not asked for (Eqs. 1-4, 7, 8)"),
    PLUMB_ROW(new_cn, Problem::common_normal,
              "normals opposite and d along them, all components (Eq. 10), line-search Newton"),
    PLUMB_ROW(minimum_distance, Problem::common_normal,
              "the least distance of the points of opposite normals, over all directions (Wellmann et al.)"),
    PLUMB_ROW(geometric_potential, Problem::deepest_points,
              "the point of each surface that lies deepest in the other body's potential"),
    PLUMB_ROW(geometric_potential_midway, Problem::midway, "equal potentials, opposite gradients (LAMMPS, LIGGGHTS)"),
    row<undone_motion<double>, undone_motion<float>, undone_motion<long double>>(
        "first_touch", Problem::first_touch,
        "the one point at which the bodies touch where their relative motion is undone (Cleary et al.)"),
};

}  // namespace

std::span<const Method> methods() {
  return all_methods;
}

const Method* find_method(std::string_view name) {
  const auto found =
      std::find_if(all_methods.begin(), all_methods.end(), [&](const Method& m) { return m.name == name; });
  return found == all_methods.end() ? nullptr : &*found;
}

}  // namespace plumb
