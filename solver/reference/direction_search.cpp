#include "solver/reference/direction_search.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

#include "solver/shape/superellipsoid.hpp"

namespace plumb::reference {
namespace {

/// A square [u - half, u + half] x [v - half, v + half] on the cube face where component `axis` is `sign`.
struct Cell {
  int axis;
  double sign, u, v, half;
  double bound = 0;  ///< no direction of the cell has a lower overlap

  [[nodiscard]] Vec3<double> at(double du, double dv) const {
    Vec3<double> out;
    out[axis] = sign;
    out[(axis + 1) % 3] = u + du * half;
    out[(axis + 2) % 3] = v + dv * half;
    return out;
  }
  [[nodiscard]] double smallest_norm() const {
    const double nearest_u = std::max(0.0, std::abs(u) - half), nearest_v = std::max(0.0, std::abs(v) - half);
    return std::sqrt(1 + nearest_u * nearest_u + nearest_v * nearest_v);
  }
};

struct HigherBound {
  bool operator()(const Cell& a, const Cell& b) const { return a.bound > b.bound; }
};

double lower_bound(const Cell& cell, const Vec3<double>& gradient) {
  double lowest_quotient = std::numeric_limits<double>::infinity();
  double lowest_value = std::numeric_limits<double>::infinity();
  for (const double du : {-1.0, 1.0})
    for (const double dv : {-1.0, 1.0}) {
      const Vec3<double> corner = cell.at(du, dv);
      const double value = gradient.dot(corner);
      lowest_value = std::min(lowest_value, value);
      lowest_quotient = std::min(lowest_quotient, value / corner.norm());
    }
  return lowest_value >= 0 ? lowest_quotient : lowest_value / cell.smallest_norm();
}

class Search {
 public:
  Search(const PlacedPair<double>& pair, const Probe& start, const SearchLimits& limits,
         const std::function<Probe(const Probe&)>& improve)
      : pair_(pair), limits_(limits), improve_(improve) {
    result_.best = start;
  }

  SearchResult run() {
    for (int axis = 0; axis < 3; ++axis)
      for (const double sign : {-1.0, 1.0}) look_at({axis, sign, 0, 0, 1}, -std::numeric_limits<double>::infinity());
    while (!cells_.empty() && result_.best.overlap >= 0 && result_.cells < limits_.cells) {
      const Cell cell = cells_.top();
      if (cell.bound >= result_.best.overlap - limits_.gap) break;
      cells_.pop();
      split(cell);
    }
    result_.complete =
        result_.best.overlap < 0 || cells_.empty() || cells_.top().bound >= result_.best.overlap - limits_.gap;
    keep_near_best();
    return std::move(result_);
  }

 private:
  void split(const Cell& cell) {
    const double half = cell.half / 2;
    for (const double du : {-half, half})
      for (const double dv : {-half, half}) look_at({cell.axis, cell.sign, cell.u + du, cell.v + dv, half}, cell.bound);
  }

  void look_at(Cell cell, double parent_bound) {
    ++result_.cells;
    const Vec3<double> centre = cell.at(0, 0);
    const Vec3<double> gradient = overlap_gradient(pair_, centre);
    const Probe probe{gradient.dot(centre) / centre.norm(), centre.normalized()};
    if (probe.overlap < result_.best.overlap + limits_.keep) near_.push_back(probe);
    if (probe.overlap < result_.best.overlap - limits_.gap) result_.best = improve_(probe);
    cell.bound = std::max(parent_bound, lower_bound(cell, gradient));
    if (cell.bound < result_.best.overlap - limits_.gap) cells_.push(cell);
  }

  void keep_near_best() {
    for (const Probe& probe : near_)
      if (probe.overlap < result_.best.overlap + limits_.keep) result_.near_best.push_back(probe);
    std::stable_sort(result_.near_best.begin(), result_.near_best.end(),
                     [](const Probe& a, const Probe& b) { return a.overlap < b.overlap; });
  }

  const PlacedPair<double>& pair_;
  const SearchLimits limits_;
  const std::function<Probe(const Probe&)>& improve_;
  SearchResult result_;
  std::vector<Probe> near_;
  std::priority_queue<Cell, std::vector<Cell>, HigherBound> cells_;
};

}  // namespace

Vec3<double> overlap_gradient(const PlacedPair<double>& pair, const Vec3<double>& direction) {
  const auto support = [](const PlacedBody<double>& body, const Vec3<double>& u) -> Vec3<double> {
    return body.to_pair(support_point<double>(body.shape, body.to_body_direction(u)).gradient);
  };
  return support(pair.body1, direction) - support(pair.body2, -direction);
}

SearchResult search_directions(const PlacedPair<double>& pair, const Probe& start, const SearchLimits& limits,
                               const std::function<Probe(const Probe&)>& improve) {
  return Search(pair, start, limits, improve).run();
}

}  // namespace plumb::reference
