// From a direction to the common normal that it leads to.
//
// A target just outside of M on the line along n has a nearest point on M; the normal there is the next n. o falls from one to the next: where
// M's surface is curved with radius R the angle to the common normal becomes (o + h)/(R + h) times what it was, h the target's height above
// the surface, and on a face it is gone at once. Newton takes over where the pieces are known.
#pragma once

#include <initializer_list>

#include "solver/method/convex/stationary.hpp"

namespace plumb::detail {

class Descent {
 public:
  /// Patient: by every step of Newton's, which takes a tenth longer.
  explicit Descent(const PlacedCores& pair, bool is_patient = false) : pair_(pair), is_patient_(is_patient) {}

  /// Of cores that are not apart, from a unit n on. The overlap is no higher than o(n), but for rounding.
  [[nodiscard]] CommonNormal from(const Vec3<double>& n) const {
    constexpr int most_steps = 60;
    CommonNormal best = seen(n);
    for (int step = 0; step < most_steps; ++step) {
      const CommonNormal next = after(best, std::ldexp(pair_.size, step < 2 ? -6 : -10));
      const bool is_nearer = is_lower(next, best);
      if (is_nearer || (is_as_low(next, best) && (is_exact(next) || defect(next) <= defect(best)))) best = next;
      if (!is_nearer) break;
    }
    return settled(best);
  }

  /// A direction that is lower, where a step leads to one.
  [[nodiscard]] Vec3<double> a_step_from(const Vec3<double>& n) const {
    const CommonNormal at = seen(n);
    const Vec3<double> next = target_above(at, std::ldexp(pair_.size, -6)).normal;
    return pair_.overlap(next) < at.overlap ? next : n;
  }

  /// The contact of a normal that is known.
  [[nodiscard]] CommonNormal along(const Vec3<double>& n) const {
    const CommonNormal at = seen(n);
    const Mixture points = target_above(at, std::ldexp(pair_.size, -3)).mixture;
    return {n, at.overlap, points.point1(), points.point2()};
  }

  /// Of cores apart: the nearest points, sharpened.
  [[nodiscard]] CommonNormal sharpened(const Nearest& nearest) const { return settled(best_of(nearest)); }

  /// Whether a is lower than b by more than rounding.
  [[nodiscard]] bool is_lower(const CommonNormal& a, const CommonNormal& b) const {
    return a.overlap < b.overlap - pair_.rounding();
  }
  /// Whether b is not exact, and a less far from it.
  [[nodiscard]] bool is_more_exact(const CommonNormal& a, const CommonNormal& b) const {
    return !is_exact(b) && defect(a) < defect(b);
  }

  /// Whether the points are those of the normal, to rounding.
  [[nodiscard]] bool is_exact(const CommonNormal& of) const { return defect(of) <= exact(); }

  /// The greatest defect of points that are those of the normal, to rounding.
  [[nodiscard]] static double exact(const PlacedCores& pair) { return 16 * pair.rounding(); }

 private:
  [[nodiscard]] CommonNormal seen(const Vec3<double>& n) const {
    const Difference at = pair_.support(n);
    return {n, at.w().dot(n), at.point1, at.point2};
  }

  [[nodiscard]] Nearest target_above(const CommonNormal& at, double height) const {
    return NearestPoint(pair_, (at.overlap + height) * at.normal, at.normal).find();
  }

  /// A step, with the target that high above M. Of what it may lead to the one that is a common normal, among those that are lowest.
  [[nodiscard]] CommonNormal after(const CommonNormal& at, double height) const {
    return best_of(target_above(at, height));
  }

  /// The same contact with its points, where a step ended beside it: rounding turns the normal of a target close to M the most.
  [[nodiscard]] CommonNormal settled(const CommonNormal& best) const {
    return beside_an_edge(seen_from_near(drawn_near(best, {-3, -6, -14}, exact())));
  }

  /// False: a step from there leads to nothing better.
  [[nodiscard]] bool draws_near(CommonNormal& best, double height) const {
    const CommonNormal next = after(best, height);
    if (!is_as_low(next, best) || !(defect(next) < defect(best))) return false;
    best = next;
    return true;
  }

  /// After a few steps from each height, the size times 2 to it, until the defect is no more than `enough`.
  [[nodiscard]] CommonNormal drawn_near(CommonNormal best, std::initializer_list<int> heights, double enough) const {
    constexpr int most_steps = 6;
    for (const int height : heights)
      for (int step = 0; step < most_steps && !(defect(best) <= enough); ++step)
        if (!draws_near(best, std::ldexp(pair_.size, height))) break;
    return best;
  }

  /// Of bodies that overlap by next to nothing all normals of the fan of a corner are as low but for rounding, and what lies about the corner
  /// is seen from as near as that alone.
  [[nodiscard]] CommonNormal seen_from_near(const CommonNormal& best) const {
    return drawn_near(best, {-36, -38, -40, -42, -44}, pair_.all_but_touch(best.overlap) ? pair_.rounding() : exact());
  }

  /// Of points within a hair's breadth of an edge the pieces beyond it are seen from targets about as near to M as that: from others the
  /// distance to the edge is of second order, and from nearer ones all is rounding.
  [[nodiscard]] CommonNormal beside_an_edge(CommonNormal best) const {
    for (const double farther : {4.0, 64.0, 1024.0, 4.0, 64.0}) {
      if (is_exact(best)) break;
      (void)draws_near(best, farther * defect(best));
    }
    return is_exact(best) ? best : slid(best);
  }

  /// One of the points moved so that both lie along the normal, where its core holds it to rounding: of surfaces that are all but flat, and of
  /// what a normal does not tell.
  [[nodiscard]] CommonNormal slid(const CommonNormal& best) const {
    // By little: at a sharp edge a point may lie farther outside than it lies beyond the faces.
    if (!(defect(best) <= 64 * exact())) return best;
    CommonNormal first = best, second = best;
    first.point1 = best.point2 + best.overlap * best.normal;
    second.point2 = best.point1 - best.overlap * best.normal;
    if (pair_.body1.holds(first.point1, pair_.rounding()) && is_exact(first)) return first;
    return pair_.body2.holds(second.point2, pair_.rounding()) && is_exact(second) ? second : best;
  }

  [[nodiscard]] CommonNormal best_of(const Nearest& nearest) const {
    const Mixture& mixture = nearest.mixture;
    const auto along = [&](const Vec3<double>& n) {
      return CommonNormal{n, pair_.overlap(n), mixture.point1(), mixture.point2()};
    };
    CommonNormal best = along(nearest.normal);
    const auto consider = [&](const CommonNormal& other) {
      if (is_lower(other, best) || (is_as_low(other, best) && defect(other) < defect(best))) best = other;
    };
    if (const auto n = mixture.facet_normal(nearest.normal)) consider(along(*n));
    if (pair_.are_polytopes() && mixture.count == 3) return best;  // what Newton would find
    const StationaryNewton newton(pair_, mixture, nearest.normal);
    using enum Described;
    for (const NewtonStep step : {NewtonStep::only, NewtonStep::shortest, NewtonStep::far}) {
      if (step == NewtonStep::far && !is_patient_) break;
      for (const Described first : {by_support, from_normal, from_point})
        for (const Described second : {by_support, from_normal, from_point})
          if (const auto solved = newton.solve(first, second, step)) {
            // Sooner than another as exact: a defect is of second order in the normal, and Newton's is of first.
            if (is_exact(*solved) && is_as_low(*solved, best)) return *solved;
            consider(*solved);
            if (is_exact(best)) return best;
          }
      if (is_exact(best)) break;
    }
    return best;
  }

  /// But for rounding.
  [[nodiscard]] bool is_as_low(const CommonNormal& a, const CommonNormal& b) const {
    return a.overlap <= b.overlap + pair_.rounding();
  }
  [[nodiscard]] double exact() const { return exact(pair_); }
  /// By how much the points are not those of the normal, a length: off the planes that touch the cores, or off the line along it.
  [[nodiscard]] double defect(const CommonNormal& of) const {
    const Difference farthest = pair_.support(of.normal);
    return std::max({(farthest.point1 - of.point1).dot(of.normal), (of.point2 - farthest.point2).dot(of.normal),
                     (of.point1 - of.point2 - of.overlap * of.normal).norm()});
  }

  const PlacedCores& pair_;
  bool is_patient_;
};

}  // namespace plumb::detail
