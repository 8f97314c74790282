// A common normal as a certificate states it: in the world's frame, with bounds, radii and condition. Used by the certifier alone.
#pragma once

#include <algorithm>

#include "solver/reference/certify.hpp"
#include "solver/reference/condition/condition.hpp"
#include "solver/reference/interval/digits.hpp"
#include "solver/reference/real.hpp"
#include "solver/reference/search/minimum.hpp"

namespace plumb::reference {

template <class I, class S>
class SolutionWriter {
 public:
  SolutionWriter(const Pair& pair, const Setting<I, S>& setting) : pair_(pair), on_(setting), minimum_at_(setting) {}

  [[nodiscard]] Bounds to_world(const I& least, const I& highest) const {
    return {low_as<Real50>(times_power_of_two<I>(least, on_.enclosed.exponent)),
            high_as<Real50>(times_power_of_two<I>(highest, on_.enclosed.exponent))};
  }

  [[nodiscard]] Solution solution(const StationaryPoint<S>& found) const {
    Solution out;
    out.solved = found.solved;
    if (!found.solved) out.reason = "no local solve converged";
    out.overlap = Real50(on_.fine.to_world_length(found.overlap));
    out.normal = found.normal.template cast<Real50>();
    out.point1 = on_.fine.to_world_point(found.point1, pair_).template cast<Real50>();
    out.point2 = on_.fine.to_world_point(found.point2, pair_).template cast<Real50>();
    out.residual = Real50(found.residual);
    if (found.solved) out.condition = condition_of<S>(on_.fine, {}, found.at);
    return out;
  }

  /// Normal and points over the box of directions that holds the true one.
  [[nodiscard]] Solution solution(const Minimum<I, S>& minimum) const {
    Solution out = solution(minimum.at);
    const DirectionEnclosure<I> at = enclose_direction<I>(on_.framed, minimum.box);
    out.proved = true;
    out.normal = minimum.normal.template cast<Real50>();
    out.bounds = to_world(minimum.least(), minimum.proof.value);
    out.normal_radius = angle_of_chord(farthest(at.normal, out.normal));
    out.points_radius = reach_of_points(out, at.point1, at.point2);
    if constexpr (std::is_same_v<S, Real50>) sharpen(out, minimum);
    return out;
  }

 private:
  /// How far the boxes (pair frame) reach from the solution's points (world frame).
  [[nodiscard]] double reach_of_points(const Solution& from, const IVec3<I>& point1, const IVec3<I>& point2) const {
    return std::max(farthest(on_.enclosed.to_world_point(point1, pair_), from.point1),
                    farthest(on_.enclosed.to_world_point(point2, pair_), from.point2));
  }

  /// On flat faces a direction says little about the points, and the charts all.
  void sharpen(Solution& out, const Minimum<I, S>& minimum) const {
    const double sharp = 1e-30;  // relative to the size; what a regular direction gives
    if (out.points_radius < sharp * size_of(pair_) && out.normal_radius < sharp) return;
    const auto box = minimum_at_.proved_on_charts(minimum);
    if (!box) return;
    const auto &body1 = box->jet.body1, &body2 = box->jet.body2;
    out.normal_radius = std::min(out.normal_radius, angle_of_chord(farthest(body1.normal, out.normal)));
    const IVec3<I> point2 = body2.point + on_.enclosed.centre;
    out.points_radius = std::min(out.points_radius, reach_of_points(out, body1.point, point2));
  }

  const Pair& pair_;
  const Setting<I, S>& on_;
  const MinimumLocator<I, S> minimum_at_;
};

}  // namespace plumb::reference
