// The rows of methods.hpp in any scalar; included where a scalar's functions are instantiated.
#pragma once

#include <algorithm>
#include <array>

#include "solver/method/automatic.hpp"
#include "solver/method/methods.hpp"
#include "solver/method/published/common_normal.hpp"
#include "solver/method/published/first_touch.hpp"
#include "solver/method/published/geometric_potential.hpp"
#include "solver/method/published/minimum_distance.hpp"
#include "solver/standard_arithmetic.hpp"

namespace plumb {
namespace detail {

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

template <class S, SolveFunction<S> method>
[[nodiscard]] constexpr MethodIn<S> row(std::string_view name, Problem problem, std::string_view summary) {
  return {name, problem, summary, guarded<S, method>, method};
}

}  // namespace detail

template <class S>
[[nodiscard]] constexpr auto method_rows() {
  using detail::row;
  return std::array{
      row<S, automatic_in_callers_mode<S>>(
          "auto", Problem::common_normal,
          "the default: the form that suits the shapes, and a guard that the common normal is the lowest"),
      row<S, original_cn<S>>("original_cn", Problem::common_normal,
                             "Lin & Ng's six equations as published, absolute values and all (Eqs. 1-6)"),
      row<S, corrected_cn<S>>("corrected_cn", Problem::common_normal,
                              "the same with the signs kept, z still not asked for (Eqs. 1-4, 7, 8)"),
      row<S, new_cn<S>>("new_cn", Problem::common_normal,
                        "normals opposite and d along them, all components (Eq. 10), line-search Newton"),
      row<S, minimum_distance<S>>(
          "minimum_distance", Problem::common_normal,
          "the least distance of the points of opposite normals, over all directions (Wellmann et al.)"),
      row<S, geometric_potential<S>>("geometric_potential", Problem::deepest_points,
                                     "the point of each surface that lies deepest in the other body's potential"),
      row<S, geometric_potential_midway<S>>("geometric_potential_midway", Problem::midway,
                                            "equal potentials, opposite gradients (LAMMPS, LIGGGHTS)"),
      row<S, undone_motion<S>>(
          "first_touch", Problem::first_touch,
          "the one point at which the bodies touch where their relative motion is undone (Cleary et al.)"),
  };
}
template <class S>
inline constexpr auto method_table = method_rows<S>();

template <class S>
const MethodIn<S>* find_method_in(std::string_view name) {
  const auto found = std::ranges::find(method_table<S>, name, &MethodIn<S>::name);
  return found == method_table<S>.end() ? nullptr : &*found;
}

}  // namespace plumb
