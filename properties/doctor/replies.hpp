// What a solver answers to the questions, and how far that is from another answer.
#pragma once

#include <span>
#include <vector>

#include "corpus/solvers/solver.hpp"
#include "properties/doctor/mistakes.hpp"
#include "properties/doctor/questions.hpp"

namespace plumb::doctor {

/// How far one answer is from another in what the solver claims. Lengths are relative to the size.
struct Miss {
  bool verdict = false;
  double overlap = 0;
  double normal = 0;  ///< of vectors, relative to the other's length: rad while it is small
  double points = 0;
};
/// The greater of each.
[[nodiscard]] Miss worse(const Miss& a, const Miss& b);

/// What of a miss is no mistake of an adapter's: its solver may be coarse. Mistakes are ten times that and more.
struct Allowance {
  double overlap, normal, points;
};
/// `tolerance`: the solver's own. A depth that is off by it leaves normal and points off by its root.
[[nodiscard]] Allowance allowance_of(double tolerance);

/// Against the allowance: up to 1 where it is none to speak of, infinite where the verdict is another or a number is missing.
[[nodiscard]] double severity_of(const Miss& miss, const Allowance& allowance);

[[nodiscard]] Miss miss_between(const Contact<double>& given, const Told& told, const Abilities& abilities);

/// Says apart and no more.
[[nodiscard]] bool is_bare_verdict(const Contact<double>& given, const Abilities& abilities);

struct Reply {
  Contact<double> contact;  ///< what it claims of the answer
  Contact<double> raw;      ///< as it came
  bool answered = false;    ///< converged, or says apart where that is all that it claims
  Miss miss;                ///< from the truth
  bool right = false;
};

/// The answer to one question. Throws NoAnswer.
[[nodiscard]] Reply ask(const Solver& solver, const Question& question);

/// The same, where the answer is there; `vouched`: whatever its status.
[[nodiscard]] Reply reply_of(const Abilities& abilities, const Question& question, Contact<double> answer,
                             bool vouched);

/// Between the answers and the truths.
[[nodiscard]] Fit fit_to(std::span<const Question> questions, std::span<const Reply> replies);

/// From a point to the segment between two others.
[[nodiscard]] double distance_to_segment(const Vec3<double>& x, const Vec3<double>& a, const Vec3<double>& b);

}  // namespace plumb::doctor
