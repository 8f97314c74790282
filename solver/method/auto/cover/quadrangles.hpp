// A cover of quadrangles of latitude and longitude, for two bodies of revolution about axes that are nearly parallel.
//
// Around a circle of latitude o is level to the tilt, and a groove in latitude is as narrow as the tilt: squares would be as many as
// 1 / tilt. tilted_axes_bound.hpp loses the square of a quadrangle's latitudes, and of the tilt times its longitudes: those are
// divided that lose more.
//
// Cells      from latitude to latitude, a straight piece of (x, z) each from the axis to across it; longitudes the same
// Excluded   where the bound of the cell above says so; the cell of the lowest bound comes first
// Solved     once, at the end, from the lowest o seen. On the way a local solve would start too far from the groove's floor
#pragma once

#include <algorithm>

#include "solver/method/auto/budgets.hpp"
#include "solver/method/auto/cover/cell_heap.hpp"
#include "solver/method/auto/cover/incumbent.hpp"
#include "solver/method/auto/cover/tilted_axes_bound.hpp"

namespace plumb {

template <class S, class Solver>
class QuadrangleCover {
 public:
  using Incumbent = plumb::Incumbent<S, Solver>;

  QuadrangleCover(Incumbent& incumbent, const TiltedAxesBound<S>& bound) : incumbent_(incumbent), bound_(bound) {}

  void start() {
    for (const double latitude : {0.5, 1.5}) cells_.push({S(0), {S(latitude), S(0.5)}, {S(2), S(2)}, {S(1), S(0)}});
  }
  [[nodiscard]] bool is_empty() const { return cells_.is_above(incumbent_.excluded_overlap()); }
  [[nodiscard]] bool has_left_out() const { return has_left_out_; }

  void look_at_next() { look_at(cells_.pop()); }

 private:
  static constexpr std::size_t most_cells = budget::quadrangles + 2;

  struct Range {
    S middle, half;

    [[nodiscard]] S from() const { return middle - half; }
    [[nodiscard]] S to() const { return middle + half; }
    [[nodiscard]] Range part(int side) const { return {middle + half * S(0.5 * side), half / 2}; }
  };

  /// Latitudes from 0, the axis, to 2, the axis backwards; longitudes from 0 to 4.
  struct Cell {
    S bound;
    Range latitudes, longitudes;
    Across<S> lowest;  ///< the longitude where the bound is
  };

  [[nodiscard]] static Latitude<S> latitude(const S& t) {
    const Latitude<S> at = t < S(1) ? Latitude<S>{t, S(1) - t} : Latitude<S>{S(2) - t, S(1) - t};
    return {at.x / at.length(), at.z / at.length()};
  }

  [[nodiscard]] static Across<S> longitude(const S& t) {
    using std::sqrt;
    const bool is_half = !(t < S(2));
    const S of_half = is_half ? t - S(2) : t;
    const Across<S> at =
        of_half < S(1) ? Across<S>{S(1) - of_half, of_half} : Across<S>{S(1) - of_half, S(2) - of_half};
    const S scale = (is_half ? S(-1) : S(1)) / sqrt(dot(at, at));
    return {at.e * scale, at.f * scale};
  }

  [[nodiscard]] static Arc<S> arc(const Range& longitudes) {
    return {longitude(longitudes.from()), longitude(longitudes.to()), longitudes.half > S(1)};
  }

  using Witness = typename TiltedAxesBound<S>::Witness;

  void look_at(const Cell& cell) {
    const Latitude<S> at = latitude(cell.latitudes.middle);
    const Witness witness = is_around(cell) ? bound_.witness_around(at) : bound_.witness(at, cell.lowest);
    const Vector3<S> v = bound_.direction(at, cell.lowest);
    (void)incumbent_.sees_lower(v, incumbent_.farthest(v));
    const bool by_latitudes = loses_by_latitudes(cell, at, witness);
    if ((by_latitudes ? cell.latitudes : cell.longitudes).half < S(4) * epsilon<S>()) {
      has_left_out_ = true;
      return;
    }
    for (const int side : {-1, 1}) {
      Cell part = cell;
      Range& divided = by_latitudes ? part.latitudes : part.longitudes;
      divided = divided.part(side);
      push(part, witness);
    }
  }

  [[nodiscard]] static bool is_around(const Cell& cell) { return cell.longitudes.half > S(1); }

  /// Whether the witness loses more at the ends of the latitudes than at those of the longitudes.
  [[nodiscard]] bool loses_by_latitudes(const Cell& cell, const Latitude<S>& at, const Witness& witness) const {
    if (is_around(cell)) return cell.latitudes.half > cell.longitudes.half * std::min(bound_.tilt(), at.x);
    const auto loss = [&](const Latitude<S>& l, const Across<S>& u) {
      return bound_.witness(l, u).height(l, {u, u, false}) - witness.height(l, {u, u, false});
    };
    const Arc<S> ends = arc(cell.longitudes);
    return std::max(loss(latitude(cell.latitudes.from()), cell.lowest),
                    loss(latitude(cell.latitudes.to()), cell.lowest)) >=
           std::max(loss(at, ends.from), loss(at, ends.to));
  }

  void push(Cell cell, const Witness& witness) {
    const Latitude<S> from = latitude(cell.latitudes.from()), to = latitude(cell.latitudes.to());
    const Arc<S> around = arc(cell.longitudes);
    if (bound_.is_backwards(from, to, around)) return;
    cell.bound = std::max(cell.bound, std::min(witness.height(from, around), witness.height(to, around)));
    if (cell.bound >= incumbent_.excluded_overlap()) return;
    cell.lowest = around.nearest(witness.sideways(latitude(cell.latitudes.middle)));
    cells_.push(cell);
  }

  Incumbent& incumbent_;
  const TiltedAxesBound<S>& bound_;
  CellHeap<Cell, most_cells> cells_;
  bool has_left_out_ = false;
};

}  // namespace plumb
