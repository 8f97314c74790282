#include "truth.hpp"

namespace second_opinion {
namespace {

/// What the search leaves open; refinement decides between what is nearer than this.
constexpr double slack = 1e-9;
/// Other minima that are refined: each may take a tenth of a second.
constexpr std::size_t most_minima = 4;
constexpr unsigned nudges = 3;

std::optional<Minimum> solve(const Pair<Quad>& pair, Problem problem) {
  return problem == Problem::midway ? midway(pair) : deepest_points(pair);
}

void widen_by(Sensitivity& out, const Minimum& moved, const Minimum& from) {
  out.normal = std::max(out.normal, angle(moved.normal, from.normal));
  out.overlap = std::max(out.overlap, static_cast<double>(fabsq(moved.value - from.value)));
  out.points =
      std::max(out.points,
               static_cast<double>(std::max(length(moved.point1 - from.point1), length(moved.point2 - from.point2))));
}

}  // namespace

Truth::Truth(const GivenPair& given, Problem problem) : given_(given), problem_(problem), pair_(placed(given)) {
  if (problem == Problem::common_normal) {
    find_common_normal();
  } else {
    find_single();
  }
}

void Truth::find_common_normal() {
  const Directions found = search(narrow(pair_), Question::common_normal, slack);
  proven_ = found.proven;
  lowest_ = minima(pair_, Question::common_normal, found, most_minima);
  const double gap = static_cast<double>(lowest_.front().value) - proven_, too_much = 1e-6;
  if (gap > too_much * std::max(1.0, std::fabs(proven_)))
    doubt_ = "the search was given up: a direction may be lower by " + std::to_string(gap) + " of the size";
}

void Truth::find_single() {
  if (const auto found = solve(pair_, problem_)) {
    lowest_ = {*found};
  } else {
    doubt_ = "this program finds no single solution of that problem";
  }
}

const Sensitivity& Truth::sensitivity() {
  if (sensitivity_) return *sensitivity_;
  sensitivity_.emplace();
  for (unsigned draw = 0; draw < nudges; ++draw) {
    const Pair<Quad> moved = nudged(given_, draw);
    if (problem_ == Problem::common_normal) {
      const double near = 1e-9;
      widen_by(*sensitivity_, refine(moved, Question::common_normal, lowest_.front().normal, near), lowest_.front());
    } else if (const auto found = solve(moved, problem_)) {
      widen_by(*sensitivity_, *found, lowest_.front());
    }
  }
  if (problem_ == Problem::deepest_points) {
    // Its normal is the direction between two points, each of which is rounded.
    const double between = static_cast<double>(fabsq(lowest_.front().value));
    sensitivity_->normal += std::numeric_limits<double>::epsilon() / between;
  }
  return *sensitivity_;
}

void Truth::look_from(const Vec<Quad>& normal) {
  const double near = 1e-9;
  const Quad same = 1e-12;
  const Minimum found = refine(pair_, Question::common_normal, normal, near);
  for (const Minimum& m : lowest_)
    if (length(m.normal - found.normal) < same) return;
  lowest_.push_back(found);
  std::sort(lowest_.begin(), lowest_.end(), [](const Minimum& a, const Minimum& b) { return a.value < b.value; });
}

}  // namespace second_opinion
