// A cover of latitudes, for two bodies of revolution about parallel axes, or nearly parallel ones (parallel_axes_bound.hpp).
//
// The lowest o around a circle of latitude has a closed form: only latitudes are looked at. Where both are of revolution
// about one line that holds both centres (common_axis.hpp) the lowest common normals are a circle, or the line.
//
// Cells      halves of halves of the half circle's four straight pieces: the axis + t across, across + t the axis, t in [0, 1],
//            and the same with the axis backwards. Coaxial bodies need the first two: the half towards the other body is lower
// Excluded   where a witness (parallel_axes_bound.hpp) says so at a cell's two ends, to rounding. Cells about the minimum end
//            where they are shorter than the square root of the rounding
// Divided    else. Where o is lower at a cell's middle, a local solve starts at the root of o's slope between the cell's ends.
//            From afar such a solve creeps where o is nearly constant, for a body 1e5 times the other's size
// Left out   flats across the axes: o jumps within the tilt, and latitudes do not tell. The search of all directions may
#pragma once

#include <array>

#include "solver/method/auto/cover/incumbent.hpp"
#include "solver/method/auto/cover/parallel_axes_bound.hpp"

namespace plumb {

template <class S, class Solver>
class LatitudeCover {
 public:
  using Incumbent = plumb::Incumbent<S, Solver>;

  LatitudeCover(Incumbent& incumbent, const ParallelAxesBound<S>& bound)
      : incumbent_(incumbent), bound_(bound), rolling_radius_(bound.is_parallel() ? incumbent.rolling_radius() : S(0)) {
  }

  void start() {
    for (int piece = bound_.is_coaxial() ? 2 : 4; piece-- > 0;) push({piece, 0, S(0.5), {}});
  }
  [[nodiscard]] bool is_empty() const { return open_count_ == 0; }
  [[nodiscard]] bool has_left_out() const { return has_left_out_; }

  void look_at_next() { look_at(open_[--open_count_]); }

 private:
  static constexpr int deepest = std::numeric_limits<S>::digits - 5;
  static constexpr int most_cuts = 40;

  using Witness = typename ParallelAxesBound<S>::Witness;

  struct Cell {
    int piece, depth;
    S middle;
    Witness witness;  ///< of the cell above
  };

  [[nodiscard]] static Latitude<S> latitude(int piece, const S& t) {
    const S side = piece < 2 ? S(1) : S(-1);
    return piece % 2 == 0 ? Latitude<S>{S(1), side * t} : Latitude<S>{t, side};
  }

  void push(const Cell& cell) { open_[open_count_++] = cell; }

  // NOLINTNEXTLINE(performance-unnecessary-value-param): a copy, for its place is taken by its halves
  void look_at(const Cell cell) {
    using std::ldexp;
    const S half = ldexp(S(0.5), -cell.depth);
    const Latitude<S> from = latitude(cell.piece, cell.middle - half), to = latitude(cell.piece, cell.middle + half);
    if (bound_.is_backwards(from, to) || (cell.depth > 0 && is_excluded(from, to, cell.witness))) return;
    const Latitude<S> middle = latitude(cell.piece, cell.middle);
    const Witness witness = bound_.witness(middle, rolling_radius_);
    const Vector3<S> v = bound_.lowest(middle, witness);
    if (is_excluded(from, to, witness)) return;
    if (incumbent_.sees_lower(v, incumbent_.farthest(v)))
      if (const auto start = descended(cell.piece, cell.middle - half, cell.middle + half))
        incumbent_.solve_from(*start, Attempts::several);
    if (cell.depth == deepest) return leave_out();
    push({cell.piece, cell.depth + 1, cell.middle - half / 2, witness});
    push({cell.piece, cell.depth + 1, cell.middle + half / 2, witness});
  }

  /// No cell can tell any more.
  void leave_out() {
    has_left_out_ = true;
    open_count_ = 0;
  }

  /// The direction of lowest o at t of a piece, and the slope of that o along t, times any positive factor.
  struct Seen {
    Vector3<S> v;
    S slope;
  };

  [[nodiscard]] Seen seen_at(int piece, const S& t) {
    incumbent_.count();
    const Latitude<S> at = latitude(piece, t), end = latitude(piece, t + S(1));
    const Witness witness = bound_.witness(at, S(0));
    const Latitude<S> gradient = bound_.gradient(at, witness), along{end.x - at.x, end.z - at.z};
    return {bound_.lowest(at, witness), dot(gradient, along) * dot(at, at) - dot(gradient, at) * dot(along, at)};
  }

  /// The direction where o is the lowest of a piece's cell, by regula falsi on its slope, cuts of a tenth at least; none where
  /// that is at an end, for another cell has it then.
  [[nodiscard]] std::optional<Vector3<S>> descended(int piece, S from, S to) {
    Seen at_from = seen_at(piece, from), at_to = seen_at(piece, to);
    if (at_from.slope > S(0) || at_to.slope < S(0)) return std::nullopt;
    for (int cuts = 0; cuts < most_cuts && to - from > epsilon<S>() && incumbent_.may_go_on(); ++cuts) {
      const S share = at_from.slope / (at_from.slope - at_to.slope);
      const S cut = cuts % 3 == 2 ? S(0.5) : share > S(0.1) ? std::min(share, S(0.9)) : S(0.1);
      const S middle = from + (to - from) * cut;
      const Seen seen = seen_at(piece, middle);
      if (seen.slope > S(0))
        to = middle, at_to = seen, at_from.slope /= 2;
      else
        from = middle, at_from = seen, at_to.slope /= 2;
    }
    return at_from.v;
  }

  [[nodiscard]] bool is_excluded(const Latitude<S>& from, const Latitude<S>& to, const Witness& witness) const {
    const S height = incumbent_.excluded_overlap() - rolling_radius_;
    return witness.height(from) >= height * from.length() && witness.height(to) >= height * to.length();
  }

  Incumbent& incumbent_;
  const ParallelAxesBound<S>& bound_;
  S rolling_radius_;  ///< of what rolls inside the bodies' sum, 0 for axes that are not quite parallel
  std::array<Cell, deepest + 5> open_;  ///< depth first: a cell a level, the last two, and the other pieces
  std::size_t open_count_ = 0;
  bool has_left_out_ = false;
};

}  // namespace plumb
