// The search of direction_search.hpp for two bodies of revolution about parallel axes, or all but parallel ones (band_pair.hpp).
//
// The lowest o around a circle of latitude has a closed form, so that latitudes alone are looked at. Where both are of
// revolution about one line that holds both centres (common_axis.hpp) the lowest common normals are a ring, or the line.
//
// Cells     halves of halves of the half circle's four straight pieces: the axis + t across, and across + t the axis, t in [0, 1],
//           and the same of the axis backwards but where o is the same all around a circle: the half towards the other body
//           is the lower one then
// Excluded  where a witness (band_pair.hpp) says so at a cell's two ends, to rounding. In one dimension that is all it takes: cells
//           about the minimum end where they are shorter than the square root of the rounding
// Else      the cell is halved. Where o is lower at its middle, a golden section between its ends gives the start of a local
//           solve: from afar those creep where o is all but constant, for a body 1e5 times the other's size
// Too deep  flats across the axes: o jumps within the tilt, and latitudes do not tell. The search of all directions may
#pragma once

#include <array>

#include "solver/method/band_pair.hpp"
#include "solver/method/lowest.hpp"

namespace plumb {

template <class S, class Form, class Answer>
class MeridianSearch {
 public:
  MeridianSearch(const Form& form, const S& size, const BandPair<S>& bands, const Answer& first)
      : bands_(bands), found_(form, size, first), ball_(bands.is_parallel() ? found_.ball() : S(0)) {}

  [[nodiscard]] Answer lowest() {
    const int pieces = bands_.is_coaxial() ? 2 : 4;
    for (int piece = 0; piece < pieces; ++piece) push({piece, 0, S(0.5), {}});
    while (!is_complete() && found_.may_go_on() && !is_too_deep_) look_at(open_[--open_count_]);
    found_.solve_lower();
    return found_.answer(is_complete() && !is_too_deep_);
  }

  /// The same, whatever is left to be looked at.
  [[nodiscard]] const Answer& best() const { return found_.best(); }

 private:
  static constexpr int deepest = std::numeric_limits<S>::digits - 5;
  static constexpr double near_enough = 1e-6, near_enough_in_float = 1e-3;  // rad, of a start

  using Witness = typename BandPair<S>::Witness;

  struct Cell {
    int piece, level;
    S middle;
    Witness witness;  ///< of the cell above
  };

  [[nodiscard]] static Latitude<S> latitude(int piece, const S& t) {
    const S side = piece < 2 ? S(1) : S(-1);
    return piece % 2 == 0 ? Latitude<S>{t, side} : Latitude<S>{S(1), side * t};
  }

  [[nodiscard]] bool is_complete() const { return open_count_ == 0 || found_.is_settled(); }

  void push(const Cell& cell) { open_[open_count_++] = cell; }

  // NOLINTNEXTLINE(performance-unnecessary-value-param): a copy, for its place is taken by its halves
  void look_at(const Cell cell) {
    using std::ldexp;
    const S half = ldexp(S(0.5), -cell.level);
    const Latitude<S> from = latitude(cell.piece, cell.middle - half), to = latitude(cell.piece, cell.middle + half);
    if (bands_.is_backwards(from, to) || (cell.level > 0 && is_excluded(from, to, cell.witness))) return;
    const Latitude<S> middle = latitude(cell.piece, cell.middle);
    const Witness witness = bands_.witness(middle, ball_);
    const Vector3<S> v = bands_.lowest(middle, witness);
    if (is_excluded(from, to, witness)) return;
    if (found_.sees_lower(v, found_.farthest(v))) {
      const Answer there = found_.solve(descended(cell.piece, cell.middle - half, cell.middle + half), Tries::several);
      if (there.status == Status::converged) found_.take(there);
    }
    if (cell.level == deepest) {
      is_too_deep_ = true;
      return;
    }
    push({cell.piece, cell.level + 1, cell.middle - half / 2, witness});
    push({cell.piece, cell.level + 1, cell.middle + half / 2, witness});
  }

  /// The direction of lowest o at t of a piece, and o there.
  struct Seen {
    Vector3<S> v;
    S overlap;
  };

  [[nodiscard]] Seen seen_at(int piece, const S& t) {
    const Latitude<S> at = latitude(piece, t);
    const Vector3<S> v = bands_.lowest(at, bands_.witness(at, ball_));
    return {v, dot(found_.farthest(v), v) / length(v)};
  }

  /// By golden section.
  [[nodiscard]] Vector3<S> descended(int piece, S from, S to) {
    const S shrink = S(0.6180339887498949);
    S t1 = to - (to - from) * shrink, t2 = from + (to - from) * shrink;
    Seen at1 = seen_at(piece, t1), at2 = seen_at(piece, t2);
    while (to - from > by_precision<S>(near_enough, near_enough_in_float) && found_.may_go_on()) {
      if (at1.overlap < at2.overlap) {
        to = t2, t2 = t1, at2 = at1;
        t1 = to - (to - from) * shrink;
        at1 = seen_at(piece, t1);
      } else {
        from = t1, t1 = t2, at1 = at2;
        t2 = from + (to - from) * shrink;
        at2 = seen_at(piece, t2);
      }
    }
    return at1.overlap < at2.overlap ? at1.v : at2.v;
  }

  [[nodiscard]] bool is_excluded(const Latitude<S>& from, const Latitude<S>& to, const Witness& witness) const {
    const S height = found_.excluded_level() - ball_;
    return witness.height(from) >= height * from.length() && witness.height(to) >= height * to.length();
  }

  const BandPair<S>& bands_;
  Lowest<S, Form, Answer> found_;
  S ball_;
  std::array<Cell, deepest + 5> open_;  ///< depth first: a cell a level, the last two, and the other pieces
  std::size_t open_count_ = 0;
  bool is_too_deep_ = false;
};

}  // namespace plumb
