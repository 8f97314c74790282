// The lowest common normal of cores that overlap: branch and bound over directions.
//
// Cells are squares on the faces of a cube, given by the unit vectors to their corners. For any w of M, o(n) >= w.n: a cell has no lower
// direction where one w is high enough at its four corners, for the chords between unit vectors are shorter than 1. Where no w is, the one
// at its middle is looked at, and the cell is divided.
#pragma once

#include "solver/method/auto/cover/mixture_bound.hpp"
#include "solver/method/convex/best_normal.hpp"

namespace plumb::detail {

class DirectionSearch {
 public:
  DirectionSearch(const PlacedCores& pair, const CommonNormal& first, int most_cells)
      : pair_(pair), descent_(pair), best_(pair, descent_, first), most_cells_(most_cells) {}

  /// Whether all directions are excluded but those as low as the lowest that was seen, to rounding.
  [[nodiscard]] bool run() {
    bool is_complete = true;
    for (int face = 0; face < 6; ++face) {
      push({face / 2, face % 2 == 0 ? -1.0 : 1.0, 0, 0, 1, 0}, best_point());
      while (waiting_count_ > 0) {
        if (++cells_ > most_cells_) return false;
        const Waiting next = waiting_[static_cast<std::size_t>(--waiting_count_)];
        is_complete = look_at(next) && is_complete;
      }
    }
    return is_complete;
  }

  [[nodiscard]] const BestNormal& best() const { return best_; }
  [[nodiscard]] int cells() const { return cells_; }

 private:
  static constexpr int deepest = 26;
  static constexpr std::size_t kept = 6;
  static constexpr int first_mixture = 3;            // depth: of wider cells no mixture says more than one w
  static constexpr int few_cuts = 3, most_cuts = 8;  // w that are seen in a cell, in one that can't be divided
  static constexpr double tolerance = 192 * std::numeric_limits<double>::epsilon();

  struct Square {
    int axis;
    double sign, u, v, half;
    int depth;

    [[nodiscard]] Vec3<double> at(double du, double dv) const {
      Vec3<double> out = Vec3<double>::Zero();
      out[axis] = sign;
      out[(axis + 1) % 3] = u + du * half;
      out[(axis + 2) % 3] = v + dv * half;
      return out.normalized();
    }
    [[nodiscard]] Square quarter(int which) const {
      const double h = half / 2;
      return {axis, sign, u + (which % 2 == 0 ? -h : h), v + (which / 2 == 0 ? -h : h), h, depth + 1};
    }
  };
  using Corners = MixtureBound<double>::Corners;
  /// A square, and a w that was seen above it.
  struct Waiting {
    Square square;
    Vector3<double> above;
  };

  void push(const Square& square, const Vector3<double>& above) {
    waiting_[static_cast<std::size_t>(waiting_count_++)] = {square, above};
  }

  /// Cores that are not apart: it is below 0 by the tolerance at most, by which the chords then cost no more than that once more.
  [[nodiscard]] double level() const { return best_.lowest() - tolerance * pair_.size; }
  /// The point of M that the best common normal leads to: a mixture of support points, whatever the normal is worth.
  [[nodiscard]] Vector3<double> best_point() const {
    const CommonNormal& best = best_.normal();
    return Vector3<double>::of(best.point1 - best.point2);
  }

  [[nodiscard]] bool is_excluded(const Corners& corners, const Vector3<double>& w) const {
    return std::all_of(corners.begin(), corners.end(), [&](const Vector3<double>& n) { return dot(w, n) >= level(); });
  }
  [[nodiscard]] const Vector3<double>& last_seen(int back) const {
    return seen_[static_cast<std::size_t>(seen_count_ - 1 - back) % kept];
  }
  [[nodiscard]] int remembered() const { return std::min(seen_count_, static_cast<int>(kept)); }
  [[nodiscard]] bool is_excluded_by_seen(const Corners& corners, const Vector3<double>& above) const {
    if (is_excluded(corners, above) || is_excluded(corners, best_point())) return true;
    for (int back = 0; back < remembered(); ++back)
      if (is_excluded(corners, last_seen(back))) return true;
    return false;
  }

  /// False: a cell is left that can't be divided.
  [[nodiscard]] bool look_at(const Waiting& next) {
    const Square& square = next.square;
    const auto corner = [&](double u, double v) { return Vector3<double>::of(square.at(u, v)); };
    const Corners corners{corner(-1, -1), corner(1, -1), corner(-1, 1), corner(1, 1)};
    if (is_excluded_by_seen(corners, next.above) || becomes_excluded(square, corners, next.above)) return true;
    if (square.depth == deepest) return false;
    const Vector3<double> above = last_seen(0);
    for (int quarter = 3; quarter >= 0; --quarter) push(square.quarter(quarter), above);
    return true;
  }

  /// Sees more of the cell; whether nothing in it is lower then.
  [[nodiscard]] bool becomes_excluded(const Square& square, const Corners& corners, const Vector3<double>& above) {
    if (square.depth < first_mixture) return see(square.at(0, 0)), is_excluded(corners, last_seen(0));
    MixtureBound<double> mixtures;
    mixtures.add(above);
    mixtures.add(best_point());
    for (int back = 0; back < remembered(); ++back) mixtures.add(last_seen(back));
    const int cuts = square.depth == deepest ? most_cuts : few_cuts;
    for (int cut = 0; cut <= cuts; ++cut) {
      const auto [mixture, place] = mixtures.solve(corners, level());
      if (is_excluded(corners, mixture)) return true;
      if (cut == cuts || (cut > 0 && mixtures.reaches(level(), place))) return false;
      see(place.eigen().normalized());
      if (is_excluded(corners, last_seen(0))) return true;
      mixtures.add(last_seen(0));
    }
    return false;
  }

  void see(const Vec3<double>& n) {
    const Vec3<double> w = pair_.support(n).w();
    seen_[static_cast<std::size_t>(seen_count_++) % kept] = Vector3<double>::of(w);
    if (w.dot(n) < level()) best_.take(descent_.from(n));
  }

  const PlacedCores& pair_;
  Descent descent_;
  BestNormal best_;
  int most_cells_;
  std::array<Vector3<double>, kept> seen_;  ///< the last; number k has the place k modulo their number
  int seen_count_ = 0;
  static constexpr std::size_t most_waiting = 4UL * (deepest + 2);
  std::array<Waiting, most_waiting> waiting_;
  int waiting_count_ = 0, cells_ = 0;
};

}  // namespace plumb::detail
