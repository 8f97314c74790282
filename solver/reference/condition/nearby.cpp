#include "solver/reference/condition/nearby.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
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

/// A solution in the numbers in which it is followed, its points also from their bodies' centres in the bodies' axes.
template <class S>
struct Followed {
  S overlap;
  Vec3<S> normal, point1, point2, x1, x2;
};

template <class S>
Followed<S> followed(const Pair& pair, const Solution& found) {
  const PlacedPair<S> placed = place<S>(pair);
  const Vec3<S> point1 = found.point1.cast<S>(), point2 = found.point2.cast<S>();
  return {static_cast<S>(found.overlap),
          found.normal.cast<S>(),
          point1,
          point2,
          placed.body1.to_body(placed.to_pair_point(point1, pair)),
          placed.body2.to_body(placed.to_pair_point(point2, pair))};
}

template <class S>
double distance(const Vec3<S>& a, const Vec3<S>& b) {
  return static_cast<double>(S((a - b).norm()));
}

/// How far the common normal of another pair is from `found`, followed from the same places on the bodies. Nothing where it is
/// another one: `most` is what the change of input can do to an overlap.
template <class S>
std::optional<NearbyAnswers> change_to(const Pair& other, const Followed<S>& found, double most) {
  using std::abs;
  const PlacedPair<S> placed = place<S>(other);
  const ChartPair<S> start{chart_of_point<S>(placed.body1.shape, found.x1),
                           chart_of_point<S>(placed.body2.shape, found.x2)};
  const LocalSolution<S> solution = solve_from_charts<S>(placed, {}, start);
  if (!solution.converged) return {};
  const ChartResidual<S>& at = solution.there;
  const S overlap = placed.to_world_length(S(at.normal1.dot(at.point1 - at.point2)));
  if (abs(S(overlap - found.overlap)) > S(most)) return {};
  return NearbyAnswers{distance<S>(at.normal1, found.normal),
                       std::max(distance<S>(placed.to_world_point(at.point1, other), found.point1),
                                distance<S>(placed.to_world_point(at.point2, other), found.point2))};
}

/// `unknown`: what stands for a neighbour whose answer is not found.
template <class S>
NearbyAnswers sum_of_changes(const Pair& pair, const Solution& found, double k, const NearbyAnswers& unknown) {
  const StandardArithmetic mode;
  const double step = k * std::numeric_limits<double>::epsilon();
  const double most = largest_overlap_condition * step * (size_of(pair) + std::abs(static_cast<double>(found.overlap)));
  const Followed<S> from = followed<S>(pair, found);
  NearbyAnswers out;
  for (const Change& change : all_changes()) {
    NearbyAnswers largest;
    for (const double side : {step, -step}) {
      Pair other = pair;
      change(other, side);
      if (!is_valid(other)) continue;
      const NearbyAnswers one = change_to<S>(other, from, most).value_or(unknown);
      largest = {std::max(largest.normal, one.normal), std::max(largest.points, one.points)};
    }
    out.normal += largest.normal;
    out.points += largest.points;
    if (std::isinf(out.normal)) break;
  }
  return out;
}

/// A solve that counts as done before it is half the way to a neighbour shows less than there is.
bool reaches_neighbours(const Pair& pair, double k) {
  const StandardArithmetic mode;
  return 2 * local_tolerance<long double>(place<long double>(pair)) < k * std::numeric_limits<double>::epsilon();
}

}  // namespace

NearbyAnswers nearby_answers(const Pair& pair, const Solution& found, double k) {
  return sum_of_changes<Real50>(pair, found, k, {});
}

NearbyAnswers more_than_nearby(const Pair& pair, const Solution& found, double k) {
  const double margin = 100, infinity = std::numeric_limits<double>::infinity();
  if (!reaches_neighbours(pair, k)) return {infinity, infinity};
  const NearbyAnswers sum = sum_of_changes<long double>(pair, found, k, {infinity, infinity});
  return {margin * sum.normal, margin * sum.points};
}

}  // namespace plumb::reference
