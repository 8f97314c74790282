// Ceres on the common normal's equations as published, all of them: both points on their surfaces, n1 + n2 = 0, and the line
// through the points along n1, which has no sign to lose. Levenberg-Marquardt from the support points along the line of centres.
#include <ceres/ceres.h>

#include "solver/plumb_adapter.hpp"

namespace plumb::board {
namespace {

using namespace adapter;

constexpr double kTolerance = 1e-10;  // what central differences of the normals leave
constexpr int kIterationLimit = 200;

void claim(plumb_abilities& abilities) {
  abilities.name = "ceres-equations";
  abilities.version = CERES_VERSION_STRING;
  abilities.licence = "BSD-3-Clause";
  abilities.tolerance = kTolerance;
}

constexpr int kUnknowns = 6, kEquations = 8;

struct Equations {
  const Frame* frame;

  bool operator()(const double* x, double* residuals) const {
    const Vector point1{x[0], x[1], x[2]}, point2{x[3], x[4], x[5]};
    const Gauge one = frame->bodies[0].gauge(point1), two = frame->bodies[1].gauge(point2);
    const Vector n1 = normalised(one.gradient), n2 = normalised(two.gradient);
    const Vector sum = n1 + n2, across = cross(point2 - point1, n1);
    residuals[0] = one.value - 1;
    residuals[1] = two.value - 1;
    std::copy(sum.begin(), sum.end(), residuals + 2);
    std::copy(across.begin(), across.end(), residuals + 5);
    return std::all_of(residuals, residuals + kEquations, [](double residual) { return std::isfinite(residual); });
  }
};

ceres::Solver::Options options() {
  ceres::Solver::Options out;
  out.linear_solver_type = ceres::DENSE_QR;
  out.logging_type = ceres::SILENT;
  out.max_num_iterations = kIterationLimit;
  out.function_tolerance = out.gradient_tolerance = out.parameter_tolerance = std::numeric_limits<double>::epsilon();
  return out;
}

void solve(const Frame& frame, plumb_contact& contact) {
  const Vector& line = frame.bodies[1].centre;
  const Vector start1 = frame.bodies[0].support(line).point, start2 = frame.bodies[1].support(-line).point;
  std::array<double, kUnknowns> x{start1[0], start1[1], start1[2], start2[0], start2[1], start2[2]};
  ceres::Problem problem;
  using Cost = ceres::NumericDiffCostFunction<Equations, ceres::CENTRAL, kEquations, kUnknowns>;
  problem.AddResidualBlock(new Cost(new Equations{&frame}), nullptr, x.data());  // the problem deletes both
  ceres::Solver::Summary summary;
  ceres::Solve(options(), &problem, &summary);
  contact.iterations = static_cast<int>(summary.iterations.size());
  contact.status = summary.termination_type == ceres::NO_CONVERGENCE ? PLUMB_ITERATION_LIMIT : PLUMB_STALLED;
  if (!(std::sqrt(summary.final_cost) < kTolerance)) return;
  const Vector point1{x[0], x[1], x[2]}, point2{x[3], x[4], x[5]};
  const Vector normal = normalised(frame.bodies[0].gauge(point1).gradient);
  frame.write({dot(point1 - point2, normal), normal, point1, point2}, contact);
}

}  // namespace
}  // namespace plumb::board

PLUMB_ADAPTER(plumb::board::claim, plumb::board::solve)
