// The common normal of two ellipsoids: start, Newton's iteration, proof that it is the lowest, and what a search asks.
#pragma once

#include "solver/method/auto/cover/branch_and_bound.hpp"
#include "solver/method/auto/ellipsoid/ellipsoid_guard.hpp"
#include "solver/method/auto/ellipsoid/ellipsoid_newton.hpp"

namespace plumb {

template <class S>
struct EllipsoidSolver {
  using Answer = EllipsoidContact<S>;
  /// 50 digits are without: cells would be divided too often, and Eigen has no eigenvectors.
  static constexpr LastCover last_cover = std::is_floating_point_v<S> ? LastCover::heights : LastCover::none;

  const EllipsoidPair<S>& pair;
  const Want& want;
  Vector3<S> axis{S(0), S(0), S(0)};  ///< as for EllipsoidNewton

  // What a search asks (incumbent.hpp).
  [[nodiscard]] S inner_rolling_radius() const { return plumb::inner_rolling_radius(pair); }
  [[nodiscard]] Vector3<S> centre() const { return pair.c; }
  [[nodiscard]] S size() const { return pair.reach; }
  [[nodiscard]] Vector3<S> farthest(const Vector3<S>& v) const { return sum(touch(pair, v).p) - pair.c; }
  [[nodiscard]] Vector3<PerBody<S>> farthest_points(const Vector3<S>& v) const {
    const Vector3<PerBody<S>> p = touch(pair, v).p;
    return per_body(first(p), second(p) * S(-1));
  }
  [[nodiscard]] PerBody<S> inner_rolling_radii() const { return plumb::inner_rolling_radii(pair); }
  [[nodiscard]] Vector3<PerBody<S>> to_gauge(const Vector3<PerBody<S>>& points) const {
    const Vector3<PerBody<S>>&q = pair.map * points, &a = pair.semi_axes;
    return {q.x / a.x / a.x, q.y / a.y / a.y, q.z / a.z / a.z};
  }
  [[nodiscard]] Vector3<PerBody<S>> from_gauge(const Vector3<PerBody<S>>& points) const {
    return pair.map.transposed_times(points);
  }
  [[nodiscard]] std::array<SupportShape<S>, 2> support_shapes() const {
    return {SupportShape<S>{first(pair.map), S(2), S(2)}, SupportShape<S>{second(pair.map), S(2), S(2)}};
  }
  [[nodiscard]] EllipsoidSolver without_rotation(const Vector3<S>& about) const { return {pair, want, about}; }
  [[nodiscard]] Answer solve(const Vector3<S>& start, Attempts /*attempts*/ = Attempts::all) const {
    Answer out;
    EllipsoidNewton<S>(pair, want, axis).solve(out, start);
    return out;
  }

  // What `auto` asks (automatic_impl.hpp).
  [[nodiscard]] Answer local(const Pair& /*bodies*/, const Contact<S>* last) const {
    const Vector3<S> warm = warm_direction(last);
    return is_direction(warm) ? solve(warm) : cold();
  }
  [[nodiscard]] bool is_surely_lowest(const Answer& found) const {
    if (found.status != Status::converged) return false;
    return found.overlap <= S(0) || is_within_rolling_radius<S>(pair, found.overlap) ||
           is_inner_lowest<S>(pair, found.at.touch, found.normal, found.overlap);
  }
  [[nodiscard]] bool is_asked_to_stop(const Answer& found) const {
    return found.status != Status::converged && want.iteration_limit < budget::first_steps;
  }
  /// By witnesses of an earlier contact, or by the cold start, should `found` be from a warm one; then by a search.
  [[nodiscard, gnu::noinline]] Answer searched(const Pair& bodies, Answer found, const Contact<S>* last,
                                               std::optional<Witnesses<S>>& witnesses) const {
    if (is_direction(warm_direction(last))) {
      if (witnesses) {
        const Answer proved = proved_by_sectors<S>(*this, found, witnesses);
        if (proved.status == Status::converged) return proved;
        found.evaluations = proved.evaluations;
      }
      found = or_cold(found);
      if (is_surely_lowest(found)) return found;
    }
    return lowest_by_search(*this, bodies, found, witnesses);
  }

  [[nodiscard]] static Vector3<S> point1(const Answer& found) { return first(found.at.touch.p); }
  [[nodiscard]] Vector3<S> point2(const Answer& found) const { return pair.c - second(found.at.touch.p); }
  [[nodiscard]] static Vector3<S> chart1(const Answer& found) { return first(found.at.touch.u); }
  [[nodiscard]] static Vector3<S> chart2(const Answer& found) { return second(found.at.touch.u) * S(-1); }

 private:
  /// Of the last points; zero, or short, where there is none.
  [[nodiscard]] Vector3<S> warm_direction(const Contact<S>* last) const {
    if (!has_charts(last)) return {S(0), S(0), S(0)};
    return direction_of_charts(pair, charts_ahead(*last));
  }

  [[nodiscard]] Answer cold() const {
    Answer out = solve(cold_start(pair, ellipsoid_start(pair)));
    out.evaluations += start_corrections;
    return out;
  }

  /// The lower of a warm start's contact and of the cold start's. A body that has left a circle of minima leaves the warm
  /// start on a saddle, a place from which a search takes long.
  [[nodiscard]] Answer or_cold(const Answer& warm) const {
    Answer out = cold();
    const int evaluations = warm.evaluations + out.evaluations;
    const bool is_found = warm.status == Status::converged;
    if (out.status != Status::converged || (is_found && warm.overlap <= out.overlap)) out = warm;
    out.evaluations = evaluations;
    return out;
  }
};

}  // namespace plumb
