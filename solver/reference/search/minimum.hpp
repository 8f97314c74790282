// Where a common normal of low overlap is: a region of directions in which it is the only one, and a bound of how low o is
// there. Used by the certifier alone.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>

#include "solver/reference/frame.hpp"
#include "solver/reference/interval/chart_interval.hpp"
#include "solver/reference/interval/digits.hpp"
#include "solver/reference/interval/interval_double.hpp"
#include "solver/reference/proof/verify.hpp"
#include "solver/reference/search/stationary_point.hpp"

namespace plumb::reference {

inline constexpr double widest_region = 1.0 / 8, narrowest_region = 1e-15;
inline constexpr double bounds_gap = 1e-12;  ///< relative to the size

/// The chart point v with F v parallel to n, to the digits of n, and its face; the half-width is not set.
template <class I>
struct ChartPoint {
  Cell face;
  IVec3<I> v;
};

template <class I, class S>
[[nodiscard]] ChartPoint<I> chart_point(const Mat3<double>& frame, const Vec3<S>& n) {
  Vec3<S> v = in_frame<S>(frame, n);
  int axis = 0;
  v.template cast<double>().cwiseAbs().maxCoeff(&axis);
  const double sign = v[axis] < S(0) ? -1 : 1;
  using std::abs;
  v /= abs(v[axis]);
  ChartPoint<I> out{{axis, sign, static_cast<double>(v[(axis + 1) % 3]), static_cast<double>(v[(axis + 2) % 3]), 0},
                    {}};
  for (int i = 0; i < 3; ++i) out.v[i] = i == axis ? I(sign) : enclosing<I>(v[i]);
  return out;
}

/// A pair in the numbers and intervals of one effort, and in the frame of its cover. The rough intervals, of doubles, prove
/// what needs few digits.
template <class I, class S>
struct Setting {
  const PlacedPair<double> rough;
  const PlacedPair<S> fine;
  const EnclosedPair<I> enclosed;
  const StationaryPoint<S> first;  ///< where a local solve leads from the line of centres: the frame's third axis
  const Mat3<double> frame;
  const FramedPair<DoubleInterval> rough_framed;
  const FramedPair<I> framed;

  /// `earlier`: the frame of a cover that there is already; null where there is none.
  Setting(const Pair& pair, const Mat3<double>* earlier)
      : rough(place<double>(pair)), fine(place<S>(pair)), enclosed(enclose<I>(pair)),
        first(point_from<S>(rough, fine, start_direction<double>(rough, rough.body2.centre))),
        frame(earlier ? *earlier : frame_about(first.normal.template cast<double>())),
        rough_framed(enclose<DoubleInterval>(pair), frame), framed(enclosed, frame) {}

  static constexpr bool in_doubles = std::is_same_v<I, DoubleInterval>;
};

/// Whether all of some chart points of a face lie in a cell.
template <class I>
[[nodiscard]] bool is_in_cell(const Cell& cell, const Cell& face, const IVec3<I>& v) {
  if (face.axis != cell.axis || face.sign != cell.sign) return false;
  const Vec3<double> middle = cell.at(0, 0);
  const auto is_within = [&](int i) { return high(magnitude<I>(I(v[i] - I(middle[i])))) < cell.half; };
  return is_within((cell.axis + 1) % 3) && is_within((cell.axis + 2) % 3);
}

/// A solution, and the region in which it is the only one.
template <class I, class S>
struct Minimum {
  Cell region;  ///< of half-width 0 where none is proved
  RegionProof<I> proof;
  IVec3<I> box;  ///< directions (chart) among which the true one is, if `exists`
  StationaryPoint<S> at;
  Vec3<S> normal;  ///< that of `at`, or an axis of body 1 beside it; the region's middle
  bool exists;
  std::shared_ptr<const ProvedBox> on_charts;  ///< where Krawczyk's test had to say where it is

  [[nodiscard]] bool is_tight() const { return proof.located && high(proof.deficit) < bounds_gap / 2; }
  [[nodiscard]] I least() const { return low_end<I>(I(proof.value - proof.deficit)); }
  /// Whether the true one does.
  [[nodiscard]] bool lies_in(const Cell& other) const { return is_in_cell<I>(other, region, box); }

  void widen(const I& reach) {
    for (const int step : {1, 2}) box[(region.axis + step) % 3] += hull<I>(I(-reach), reach);
  }
};

/// A region about a chart point with its proof.
template <class I>
struct ProvedRegion {
  Cell region;
  RegionProof<I> proof;
};

/// The regions about a chart point that are tried, each half as wide as the one before, with the curvature on them. C: its
/// intervals, which need fewer digits than the slope. A region within a convex one is convex.
template <class C, class I>
class NestedRegions {
 public:
  NestedRegions(const FramedPair<C>& coarse, const FramedPair<I>& pair, const ChartPoint<I>& at, const Slope<I>& slope)
      : coarse_(coarse), pair_(pair), at_(at), slope_(slope) {}

  struct Found {
    int first_convex = count;  ///< of the regions, `count` where there is none
    ProvedRegion<I> best;      ///< the widest on which the solution is located, or else the widest on which o is convex
  };

  static constexpr int count = 47;  ///< the next would be narrower than narrowest_region

  /// `likely`: where the first convex one may be.
  [[nodiscard]] Found find(int likely) const {
    Found out = first_convex(std::min(likely, count - 1));
    if (out.first_convex == count || out.best.proof.located) return out;
    const double least_radius = least_radius_anywhere();
    for (int i = out.first_convex + 1; i < count && half(i) > least_radius; ++i)
      if (ProvedRegion<I> here = at(i); here.proof.located) return {out.first_convex, std::move(here)};
    return out;
  }

 private:
  [[nodiscard]] static double half(int i) { return std::ldexp(widest_region, -i); }

  [[nodiscard]] Cell region(int i) const {
    Cell out = at_.face;
    out.half = half(i);
    return out;
  }

  [[nodiscard]] ProvedRegion<I> at(int i) const {
    const I curvature(low(curvature_on<C>(coarse_, region(i))));
    return {region(i), proof_on<I>(region(i), curvature, at_.v, slope_, pair_.shortest)};
  }

  /// From the likely place in growing steps to where convex ones meet others, and between.
  [[nodiscard]] Found first_convex(int likely) const {
    Found out{count, {at_.face, {}}};
    int below = -1;
    for (int i = likely, step = 1; out.first_convex - below > 1; step *= 2) {
      ProvedRegion<I> here = at(i);
      if (here.proof.convex)
        out = {i, std::move(here)};
      else
        below = i;
      if (out.first_convex == count)
        i = std::min(below + step, count - 1);
      else
        i = below < 0 ? std::max(i - step, 0) : (below + out.first_convex) / 2;
    }
    return out;
  }

  /// The curvature is nowhere higher than on the narrowest: a region within this of its middle does not locate the solution.
  [[nodiscard]] double least_radius_anywhere() const {
    const I curvature(high(highest_curvature_on<C>(coarse_, region(count - 1))));
    return low(I(I(2.0) * slope_.gradient / curvature));
  }

  const FramedPair<C>& coarse_;
  const FramedPair<I>& pair_;
  const ChartPoint<I>& at_;
  const Slope<I>& slope_;
};

/// A solution located in a region is so in a small part about it too, where the curvature bounds its place better.
template <class C, class I>
[[nodiscard]] ProvedRegion<I> sharpened(const ProvedRegion<I>& found, const FramedPair<C>& coarse,
                                        const FramedPair<I>& pair, const ChartPoint<I>& at, const Slope<I>& slope) {
  if (!found.proof.located) return found;
  Cell part = found.region;
  part.half = std::clamp(4 * high(found.proof.radius), narrowest_region, found.region.half);
  const I curvature(low(curvature_on<C>(coarse, part)));
  const RegionProof<I> proof = proof_on<I>(part, curvature, at.v, slope, pair.shortest);
  return {found.region, proof.located ? proof : found.proof};
}

template <class I, class S>
class MinimumLocator {
 public:
  explicit MinimumLocator(const Setting<I, S>& setting) : on_(setting) {}

  [[nodiscard]] Minimum<I, S> locate(const StationaryPoint<S>& found) const {
    Minimum<I, S> out = about(found, found.normal);
    if (out.is_tight() || !out.proof.convex) return out;
    if (const auto axis = axis_of_body1_beside(found.normal)) {
      Minimum<I, S> there = about(found, *axis);
      if (there.exists) out = std::move(there);
    }
    if constexpr (std::is_same_v<S, Real50>) locate_on_charts(out);
    return out;
  }

  /// Krawczyk's test on the charts: a common normal exists, its points and its overlap. Nothing where the region might not
  /// hold it: chart points v, v0 of one face are |v x v0| / (|v| |v0|) >= |v - v0| / 4 apart in the sine of their angle, and
  /// the region's middle is the solution.
  [[nodiscard]] std::shared_ptr<const ProvedBox> proved_on_charts(const Minimum<I, S>& minimum) const {
    if (minimum.on_charts) return minimum.on_charts;
    auto box = std::make_shared<const ProvedBox>(
        prove_solution(on_.enclosed, square_form(on_.fine, minimum.at.at), minimum.at.at));
    if (!box->proof.exists) return {};
    return farthest(box->jet.body1.normal, minimum.normal) < minimum.region.half / 16 ? box : nullptr;
  }

 private:
  [[nodiscard]] ProvedRegion<I> proved_region(const ChartPoint<I>& at) const {
    const Slope<I> slope = slope_at<I>(on_.framed, at.face.axis, at.v);
    const auto rough = NestedRegions<DoubleInterval, I>(on_.rough_framed, on_.framed, at, slope).find(0);
    if (on_.in_doubles || rough.best.proof.located)
      return sharpened(rough.best, on_.rough_framed, on_.framed, at, slope);
    const auto fine = NestedRegions<I, I>(on_.framed, on_.framed, at, slope).find(rough.first_convex);
    return sharpened(fine.best, on_.framed, on_.framed, at, slope);
  }

  [[nodiscard]] Minimum<I, S> about(const StationaryPoint<S>& found, const Vec3<S>& normal) const {
    const ChartPoint<I> at = chart_point<I, S>(on_.frame, normal);
    const ProvedRegion<I> proved = proved_region(at);
    Minimum<I, S> out{proved.region, proved.proof, at.v, found, normal, proved.proof.located, nullptr};
    if (out.exists) out.widen(out.proof.radius);
    return out;
  }

  /// On a flat face the points follow digits of the direction that no computation has: 1e-49 off the face's normal they are a
  /// 500th of the body apart (exponent 19). Nearly along a face's normal, it is that; nothing elsewhere.
  [[nodiscard]] std::optional<Vec3<S>> axis_of_body1_beside(const Vec3<S>& normal) const {
    using std::abs;
    using std::pow;
    const S rounding = pow(epsilon<S>(), S(0.9));
    Vec3<S> own = on_.fine.body1.to_body_direction(normal);
    bool is_near = false;
    for (S& component : own) {
      if (component == S(0) || !(abs(component) < rounding)) continue;
      component = S(0);
      is_near = true;
    }
    if (!is_near) return {};
    return on_.fine.body1.to_pair_direction(own).normalized();
  }

  /// Where the direction form is singular or nearly so, its gradient says little of where in the region the minimum is.
  void locate_on_charts(Minimum<I, S>& minimum) const {
    if (minimum.is_tight() || !minimum.proof.convex) return;
    minimum.on_charts = proved_on_charts(minimum);
    if (!minimum.on_charts) return;
    const auto &body1 = minimum.on_charts->jet.body1, &body2 = minimum.on_charts->jet.body2;
    const IVec3<I> apart = body1.point - body2.point - on_.enclosed.centre;
    const I overlap = dot<I>(body1.normal, apart);
    minimum.exists = minimum.proof.located = true;
    minimum.proof.deficit = high_end<I>(I(minimum.proof.value - low_end<I>(overlap)));
    minimum.box = chart_point<I, S>(on_.frame, minimum.normal).v;
    minimum.widen(I(8 * farthest(body1.normal, minimum.normal)));
  }

  const Setting<I, S>& on_;
};

}  // namespace plumb::reference
