// What one effort of the reference knows of low overlaps: the lowest direction so far, and the minima met on the way. Used by
// the certifier alone.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "solver/reference/search/cover_search.hpp"
#include "solver/reference/search/minimum.hpp"
#include "solver/reference/search/stationary.hpp"

namespace plumb::reference {

template <class I, class S>
class KnownMinima {
 public:
  using Min = Minimum<I, S>;

  StationaryPoint<S> best;                               ///< the lowest direction
  I value = I(std::numeric_limits<double>::infinity());  ///< o there
  std::vector<Min> minima;

  explicit KnownMinima(const Setting<I, S>& setting) : best(setting.first), on_(setting), minimum_at_(setting) {}

  [[nodiscard]] bool is_separated() const { return high(value) < 0; }
  /// A separating common normal is the only one.
  [[nodiscard]] bool is_done() const { return is_separated() && best.solved; }

  /// Whether a direction becomes the best: o is lower there.
  bool look_at(const StationaryPoint<S>& found) {
    const I here = overlap_at<I>(on_.framed, chart_point<I, S>(on_.frame, found.normal).v);
    if (!is_lower<I>(high_end<I>(here), high_end<I>(value))) return false;
    value = here;
    best = found;
    return true;
  }

  /// Looks at a stationary point, and keeps it where it is new and a minimum, or the lowest.
  std::optional<KnownMinimum> know(const StationaryPoint<S>& found) {
    const bool is_lowest = look_at(found);
    if (!found.solved || is_known(found)) return {};
    Min minimum = minimum_at_.locate(found);
    if (!is_lowest && !minimum.proof.convex) return {};
    minima.push_back(std::move(minimum));
    return for_search(minima.back());
  }

  /// As a search of the cover takes it.
  [[nodiscard]] KnownMinimum for_search(const Min& minimum) const {
    return {minimum.region, minimum.is_tight(), witness(minimum.at)};
  }

  [[nodiscard]] bool is_known(const StationaryPoint<S>& found) const {
    const double same = 1e-9;
    return std::any_of(minima.begin(), minima.end(), [&](const Min& other) {
      return static_cast<double>((other.at.normal - found.normal).norm()) < same;
    });
  }

  [[nodiscard]] Witness witness(const StationaryPoint<S>& at) const {
    return witness_of(on_.rough, at.point1.template cast<double>(), at.point2.template cast<double>());
  }

  void look_at(const StationaryPair& pair) {
    const Vec3<S> n = pair.normal.template cast<S>();
    know(point_from<S>(on_.rough, on_.fine, n.template cast<double>()));
    if (!is_below<I>(to_pair(pair.overlap_upper), value)) return;
    const ChartPair<S> at = charts_of_direction<S>(on_.fine, n);  // no local solve leads there
    look_at(point_at<S>(chart_residual<S>(on_.fine, {}, at), at, std::numeric_limits<S>::infinity()));
  }

  /// The minimum that a proved stationary direction is, located by it where it is not; null where none is known to be.
  const Min* locate_by(const StationaryPair& pair) {
    const double same = 1e-9, rounding = 1e-45;  // the latter of a chart point in fifty digits
    ChartPoint<I> at = chart_point<I, Real50>(on_.frame, pair.normal);
    const I reach(8 * pair.normal_radius + rounding);
    for (const int step : {1, 2}) at.v[(at.face.axis + step) % 3] += hull<I>(I(-reach), reach);
    for (Min& m : minima) {
      const bool is_in_region = is_in_cell<I>(m.region, at.face, at.v);
      if (m.exists && is_in_region) return &m;
      const bool is_near = static_cast<double>((m.at.normal.template cast<Real50>() - pair.normal).norm()) < same;
      const bool is_on_face = at.face.axis == m.region.axis && at.face.sign == m.region.sign;
      if (m.exists || !is_near || !is_on_face || !(is_in_region || m.region.half == 0)) continue;
      m.exists = m.proof.located = m.proof.convex = true;
      m.proof.value = hull<I>(to_pair(pair.overlap_lower), to_pair(pair.overlap_upper));
      m.proof.deficit = I(0.0);
      m.box = at.v;
      return &m;
    }
    return nullptr;
  }

  [[nodiscard]] I to_pair(const Real50& world) const {
    return times_power_of_two<I>(enclosing<I>(world), -on_.enclosed.exponent);
  }

 private:
  const Setting<I, S>& on_;
  const MinimumLocator<I, S> minimum_at_;
};

}  // namespace plumb::reference
