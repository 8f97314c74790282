#include "solver/reference/condition/nearby.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "solver/reference/search/refine.hpp"
#include "solver/standard_arithmetic.hpp"

namespace plumb::reference {
namespace {

/// Changes one number of a pair by a relative step, in the norm of sensitivity.hpp.
using Change = std::function<void(Pair&, double step)>;

void append_shape_changes(Body Pair::* body, std::vector<Change>& out) {
  for (int i = 0; i < 3; ++i)
    out.emplace_back([=](Pair& pair, double step) { (pair.*body).shape.semi_axes[i] *= 1 + step; });
  for (double Superellipsoid<double>::* n : {&Superellipsoid<double>::n1, &Superellipsoid<double>::n2})
    out.emplace_back([=](Pair& pair, double step) {
      double& exponent = (pair.*body).shape.*n;
      exponent = std::max(exponent * (1 + step), std::nextafter(1.0, 2.0));
    });
}

void append_pose_changes(Body Pair::* body, std::vector<Change>& out) {
  for (std::size_t i = 0; i < 4; ++i)
    out.emplace_back([=](Pair& pair, double step) {
      auto& q = (pair.*body).quaternion;
      q[i] += step * std::max({std::abs(q[0]), std::abs(q[1]), std::abs(q[2]), std::abs(q[3])});
    });
  for (int i = 0; i < 3; ++i)
    out.emplace_back([=](Pair& pair, double step) { (pair.*body).position[i] += step * size_of(pair); });
}

std::vector<Change> all_changes() {
  std::vector<Change> out;
  for (Body Pair::* body : {&Pair::body1, &Pair::body2}) {
    append_shape_changes(body, out);
    append_pose_changes(body, out);
  }
  return out;
}

/// The points of a solution from its bodies' centres, in their axes.
struct BodyPoints {
  Vec3<Real50> x1, x2;
};

BodyPoints on_bodies(const Pair& pair, const Solution& found) {
  const PlacedPair<Real50> placed = place<Real50>(pair);
  return {placed.body1.to_body(placed.to_pair_point(found.point1, pair)),
          placed.body2.to_body(placed.to_pair_point(found.point2, pair))};
}

double distance(const Vec3<Real50>& a, const Vec3<Real50>& b) {
  return static_cast<double>(Real50((a - b).norm()));
}

/// How far the common normal of another pair is from `found`, followed from the same places on the bodies. Nothing where it is
/// another one: `most` is what the change of input can do to an overlap.
NearbyAnswers change_to(const Pair& other, const BodyPoints& from, const Solution& found, double most) {
  const PlacedPair<Real50> placed = place<Real50>(other);
  const ChartPair<Real50> start{chart_of_point<Real50>(placed.body1.shape, from.x1),
                                chart_of_point<Real50>(placed.body2.shape, from.x2)};
  const LocalSolution<Real50> solution = solve_from_charts<Real50>(placed, {}, start);
  if (!solution.converged) return {};
  const ChartResidual<Real50> at = chart_residual<Real50>(placed, {}, solution.at);
  const Real50 overlap = placed.to_world_length(Real50(at.normal1.dot(at.point1 - at.point2)));
  if (abs(Real50(overlap - found.overlap)) > most) return {};
  return {distance(at.normal1, found.normal),
          std::max(distance(placed.to_world_point(at.point1, other), found.point1),
                   distance(placed.to_world_point(at.point2, other), found.point2))};
}

}  // namespace

NearbyAnswers nearby_answers(const Pair& pair, const Solution& found, double k) {
  const StandardArithmetic mode;
  const double step = k * std::numeric_limits<double>::epsilon();
  const double most = largest_overlap_condition * step * (size_of(pair) + std::abs(static_cast<double>(found.overlap)));
  const BodyPoints from = on_bodies(pair, found);
  NearbyAnswers out;
  for (const Change& change : all_changes()) {
    NearbyAnswers largest;
    for (const double side : {step, -step}) {
      Pair other = pair;
      change(other, side);
      if (!is_valid(other)) continue;
      const NearbyAnswers one = change_to(other, from, found, most);
      largest = {std::max(largest.normal, one.normal), std::max(largest.points, one.points)};
    }
    out.normal += largest.normal;
    out.points += largest.points;
  }
  return out;
}

}  // namespace plumb::reference
