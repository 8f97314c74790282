// NLopt's SLSQP on the common normal as a minimum: the overlap h1(n) + h2(-n) - n.c over directions with |n| = 1. Its gradient
// is p1 - p2, so a stationary direction is along the line through the two points: a common normal.
#include <nlopt.h>

#include <memory>
#include <string>

#include "solver/plumb_adapter.hpp"

namespace plumb::board {
namespace {

using namespace adapter;

const char* version() {
  static const std::string text = [] {
    int major = 0, minor = 0, bugfix = 0;
    nlopt_version(&major, &minor, &bugfix);
    return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(bugfix);
  }();
  return text.c_str();
}

// The step that ends the search, of the components of a unit vector, and evaluations of a pair that takes about thirty.
constexpr double kStep = 1e-12;
constexpr int kEvaluationLimit = 500;
// The overlap is flat at its minimum: the line search sees the direction to the root of rounding only.
constexpr double kTolerance = 1e-8;

void claim(plumb_abilities& abilities) {
  abilities.name = "nlopt-slsqp";
  abilities.version = version();
  abilities.licence = "LGPL-2.1-or-later";
  abilities.tolerance = kTolerance;
}

struct Search {
  const Frame& frame;
  int evaluations = 0;
};

Answer answer_along(const Frame& frame, const Vector& n) {
  const Support one = frame.bodies[0].support(n), two = frame.bodies[1].support(-n);
  return {one.height + two.height, n, one.point, two.point};
}

// The support function is of degree 1: |n| times the heights.
double overlap(unsigned, const double* x, double* gradient, void* data) {
  Search& search = *static_cast<Search*>(data);
  ++search.evaluations;
  const Answer found = answer_along(search.frame, {x[0], x[1], x[2]});
  const Vector between = found.point1 - found.point2;
  if (gradient != nullptr) std::copy(between.begin(), between.end(), gradient);
  return dot(found.normal, between);
}

double unit_length(unsigned, const double* x, double* gradient, void*) {
  for (int i = 0; gradient != nullptr && i < 3; ++i) gradient[i] = 2 * x[i];
  return x[0] * x[0] + x[1] * x[1] + x[2] * x[2] - 1;
}

void solve(const Frame& frame, plumb_contact& contact) {
  const std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt)> search(nlopt_create(NLOPT_LD_SLSQP, 3), nlopt_destroy);
  Search data{frame};
  nlopt_set_min_objective(search.get(), overlap, &data);
  nlopt_add_equality_constraint(search.get(), unit_length, nullptr, kStep);
  nlopt_set_xtol_rel(search.get(), kStep);
  nlopt_set_maxeval(search.get(), kEvaluationLimit);
  const Vector& centre = frame.bodies[1].centre;
  Vector n = dot(centre, centre) > 0 ? normalised(centre) : Vector{1, 0, 0};
  double least = 0;
  const nlopt_result ended = nlopt_optimize(search.get(), n.data(), &least);
  contact.evaluations = data.evaluations;
  contact.status = PLUMB_STALLED;
  if (ended > 0 || ended == NLOPT_ROUNDOFF_LIMITED) frame.write(answer_along(frame, n), contact);
  if (ended == NLOPT_MAXEVAL_REACHED) contact.status = PLUMB_ITERATION_LIMIT;
}

}  // namespace
}  // namespace plumb::board

PLUMB_ADAPTER(plumb::board::claim, plumb::board::solve)
