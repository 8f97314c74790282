// The search of direction_search.hpp for two bodies of revolution about one line that holds both centres (common_axis.hpp).
//
// o depends on the angle to that line alone, so that the lowest common normals are a ring, or the line. A quarter of one
// meridian is looked at: o is the same on the other side of the line, and the half towards the other body is the lower one.
//
// Cells     halves of halves of the quarter's two straight pieces: the line + t across, and across + t the line, t in [0, 1]
// Excluded  where a witness (lowest.hpp) says so at a cell's two ends, to rounding. In one dimension that is all it takes: cells
//           about the minimum end where they are shorter than the square root of the rounding
// Else      the cell is halved. Where o is lower at its middle, a golden section between its ends gives the start of a local
//           solve: from afar those creep where o is all but constant, for a body 1e5 times the other's size
#pragma once

#include <array>

#include "solver/method/lowest.hpp"
#include "solver/shape/tangent.hpp"

namespace plumb {

template <class S, class Form, class Answer>
class MeridianSearch {
 public:
  /// `axis`: unit.
  MeridianSearch(const Form& form, const S& size, const Vector3<S>& axis, const Answer& first)
      : found_(form, size, first) {
    const Vector3<S> along = dot(axis, form.centre()) < S(0) ? axis * S(-1) : axis;
    const auto across = Vector3<S>::of(tangent_basis<S>(axis.eigen()).col(0));
    pieces_ = {Piece{along, across}, Piece{across, along}};
  }

  [[nodiscard]] Answer lowest() {
    for (int piece = 0; piece < 2; ++piece) push({piece, 0, S(0.5), {}});
    while (!is_complete() && found_.may_go_on()) look_at(open_[--open_count_]);
    found_.solve_lower();
    return found_.answer(is_complete() && !is_too_deep_);
  }

 private:
  static constexpr int deepest = std::numeric_limits<S>::digits - 5;
  static constexpr double near_enough = 1e-6, near_enough_in_float = 1e-3;  // rad, of a start

  struct Piece {
    Vector3<S> from, towards;
    [[nodiscard]] Vector3<S> at(const S& t) const { return from + towards * t; }
  };

  struct Cell {
    int piece, level;
    S middle;
    Vector3<S> witness;  ///< of the cell above
  };

  [[nodiscard]] bool is_complete() const { return open_count_ == 0 || found_.is_settled(); }

  void push(const Cell& cell) { open_[open_count_++] = cell; }

  // NOLINTNEXTLINE(performance-unnecessary-value-param): a copy, for its place is taken by its halves
  void look_at(const Cell cell) {
    using std::ldexp;
    const Piece& piece = pieces_[static_cast<std::size_t>(cell.piece)];
    const S half = ldexp(S(0.5), -cell.level);
    const Vector3<S> from = piece.at(cell.middle - half), to = piece.at(cell.middle + half);
    if (cell.level > 0 && is_excluded(from, to, cell.witness)) return;
    const Vector3<S> v = piece.at(cell.middle), g = found_.farthest(v), witness = found_.witness(v, g);
    if (is_excluded(from, to, witness)) return;
    if (found_.sees_lower(v, g)) {
      const Answer there =
          found_.solve(piece.at(descended(piece, cell.middle - half, cell.middle + half)), Tries::several);
      if (there.status == Status::converged) found_.take(there);
    }
    if (cell.level == deepest) {
      is_too_deep_ = true;
      return;
    }
    push({cell.piece, cell.level + 1, cell.middle - half / 2, witness});
    push({cell.piece, cell.level + 1, cell.middle + half / 2, witness});
  }

  /// o along the piece at t.
  [[nodiscard]] S overlap_at(const Piece& piece, const S& t) {
    const Vector3<S> v = piece.at(t);
    return dot(found_.farthest(v), v) / length(v);
  }

  /// By golden section.
  [[nodiscard]] S descended(const Piece& piece, S from, S to) {
    const S shrink = S(0.6180339887498949);
    S t1 = to - (to - from) * shrink, t2 = from + (to - from) * shrink, o1 = overlap_at(piece, t1),
      o2 = overlap_at(piece, t2);
    while (to - from > by_precision<S>(near_enough, near_enough_in_float) && found_.may_go_on()) {
      if (o1 < o2) {
        to = t2, t2 = t1, o2 = o1;
        t1 = to - (to - from) * shrink;
        o1 = overlap_at(piece, t1);
      } else {
        from = t1, t1 = t2, o1 = o2;
        t2 = from + (to - from) * shrink;
        o2 = overlap_at(piece, t2);
      }
    }
    return o1 < o2 ? t1 : t2;
  }

  [[nodiscard]] bool is_excluded(const Vector3<S>& from, const Vector3<S>& to, const Vector3<S>& witness) const {
    const S height = found_.excluded_height();
    return dot(witness, from) >= height * length(from) && dot(witness, to) >= height * length(to);
  }

  Lowest<S, Form, Answer> found_;
  std::array<Piece, 2> pieces_;
  std::array<Cell, deepest + 3> open_;  ///< depth first: a cell a level, and the last two
  std::size_t open_count_ = 0;
  bool is_too_deep_ = false;
};

}  // namespace plumb
