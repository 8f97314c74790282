// Ipopt on the common normal as Wellmann et al. pose it: the squared distance of two points is least, each is on its surface and
// the normals are opposite there. Where the bodies overlap the last is what keeps the points from meeting.
#include <coin/IpStdCInterface.h>
#include <coin/IpoptConfig.h>

#include <memory>

#include "solver/plumb_adapter.hpp"

namespace plumb::board {
namespace {

using namespace adapter;

// Asked of it; Ipopt's default is 1e-8.
constexpr double kTolerance = 1e-10;
constexpr int kIterationLimit = 300;

void claim(plumb_abilities& abilities) {
  abilities.name = "ipopt-distance";
  abilities.version = IPOPT_VERSION;
  abilities.licence = "EPL-1.0";
  abilities.tolerance = kTolerance;
}

// Both surfaces, and the sum of the normals across the line of centres: along it the sum is then 0 too, or the normals mirrored.
constexpr std::size_t kUnknowns = 6, kEquations = 4;
using Unknowns = std::array<double, kUnknowns>;
using Residuals = std::array<double, kEquations>;

struct Search {
  const Frame& frame;
  Vector across1, across2;
};

Vector point(const double* x, std::size_t body) {
  return {x[3 * body], x[3 * body + 1], x[3 * body + 2]};
}

Residuals equations(const Search& search, const double* x) {
  const Gauge one = search.frame.bodies[0].gauge(point(x, 0)), two = search.frame.bodies[1].gauge(point(x, 1));
  const Vector sum = normalised(one.gradient) + normalised(two.gradient);
  return {one.value - 1, two.value - 1, dot(search.across1, sum), dot(search.across2, sum)};
}

Bool objective(Index, Number* x, Bool, Number* value, UserDataPtr) {
  const Vector between = point(x, 1) - point(x, 0);
  *value = dot(between, between) / 2;
  return TRUE;
}

Bool objective_gradient(Index, Number* x, Bool, Number* gradient, UserDataPtr) {
  const Vector between = point(x, 1) - point(x, 0);
  for (std::size_t i = 0; i < 3; ++i) gradient[i] = -between[i], gradient[i + 3] = between[i];
  return TRUE;
}

Bool constraints(Index, Number* x, Bool, Index, Number* values, UserDataPtr data) {
  const Residuals found = equations(*static_cast<const Search*>(data), x);
  std::copy(found.begin(), found.end(), values);
  return TRUE;
}

// Dense, by rows; by central differences, good to about 1e-10.
// NOLINTNEXTLINE(readability-function-size): Ipopt's signature, as the next
Bool jacobian(Index, Number* x, Bool, Index, Index, Index* rows, Index* columns, Number* values, UserDataPtr data) {
  constexpr double step = 6e-6;  // the cube root of rounding
  for (std::size_t i = 0; i < kUnknowns; ++i) {
    if (values == nullptr) {
      for (std::size_t j = 0; j < kEquations; ++j) {
        rows[j * kUnknowns + i] = static_cast<Index>(j);
        columns[j * kUnknowns + i] = static_cast<Index>(i);
      }
      continue;
    }
    Unknowns before, after;
    std::copy_n(x, kUnknowns, before.begin());
    after = before;
    before[i] -= step;
    after[i] += step;
    const Residuals low = equations(*static_cast<const Search*>(data), before.data());
    const Residuals high = equations(*static_cast<const Search*>(data), after.data());
    for (std::size_t j = 0; j < kEquations; ++j) values[j * kUnknowns + i] = (high[j] - low[j]) / (2 * step);
  }
  return TRUE;
}

// Not asked for with limited memory.
// NOLINTNEXTLINE(readability-function-size)
Bool hessian(Index, Number*, Bool, Number, Index, Number*, Bool, Index, Index*, Index*, Number*, UserDataPtr) {
  return FALSE;
}

using Problem = std::unique_ptr<IpoptProblemInfo, void (*)(IpoptProblem)>;

Problem make_problem() {
  Unknowns least, greatest;
  least.fill(-2e19);  // Ipopt's infinity
  greatest.fill(2e19);
  Residuals zero{};
  IpoptProblem out =
      CreateIpoptProblem(kUnknowns, least.data(), greatest.data(), kEquations, zero.data(), zero.data(),
                         kUnknowns * kEquations, 0, 0, objective, constraints, objective_gradient, jacobian, hessian);
  const auto text = [](const char* words) { return const_cast<char*>(words); };  // its C header has no const
  AddIpoptStrOption(out, text("hessian_approximation"), text("limited-memory"));
  AddIpoptStrOption(out, text("sb"), text("yes"));
  AddIpoptIntOption(out, text("print_level"), 0);
  AddIpoptIntOption(out, text("max_iter"), kIterationLimit);
  AddIpoptNumOption(out, text("tol"), kTolerance);
  return {out, FreeIpoptProblem};
}

Search across(const Frame& frame, const Vector& line) {
  const Vector least = std::abs(line[0]) < 0.5 ? Vector{1, 0, 0} : Vector{0, 1, 0};
  const Vector first = normalised(cross(line, least));
  return {frame, first, cross(line, first)};
}

void solve(const Frame& frame, plumb_contact& contact) {
  const Vector& centre = frame.bodies[1].centre;
  const Vector line = dot(centre, centre) > 0 ? normalised(centre) : Vector{1, 0, 0};
  Search search = across(frame, line);
  const Vector start1 = frame.bodies[0].support(line).point, start2 = frame.bodies[1].support(-line).point;
  Unknowns x{start1[0], start1[1], start1[2], start2[0], start2[1], start2[2]};
  double value = 0;
  const Problem problem = make_problem();
  const int ended = IpoptSolve(problem.get(), x.data(), nullptr, &value, nullptr, nullptr, nullptr, &search);
  contact.status = ended == Maximum_Iterations_Exceeded ? PLUMB_ITERATION_LIMIT : PLUMB_STALLED;
  if (ended != Solve_Succeeded) return;
  const Vector point1 = point(x.data(), 0), point2 = point(x.data(), 1);
  const Vector normal = normalised(frame.bodies[0].gauge(point1).gradient);
  if (dot(normal, frame.bodies[1].gauge(point2).gradient) > 0) return;  // the mirrored normals
  frame.write({dot(point1 - point2, normal), normal, point1, point2}, contact);
}

}  // namespace
}  // namespace plumb::board

PLUMB_ADAPTER(plumb::board::claim, plumb::board::solve)
