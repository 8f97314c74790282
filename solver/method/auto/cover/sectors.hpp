// A cover of four sectors about a common normal n: the first that a search tries, for most need no more.
//
// c, f, o, s, witnesses and mixtures as in directions.hpp. A direction is a n + d, d across n. Those of a sector have d between two
// diagonals of the convex square about n, and lie between the square's border and the plane n.c = 0: behind it o is higher.
// A sector is wide, but where n is that of a face, one point of the face's rim is high all over it.
//
// Excluded   by a witness at all four corners, or by a mixture of all that were seen
// Divided    by half, across n and along it in turn; the parts of the last divided are looked at first
// Given up   where o is lower than at n, where n.c <= 0, and where so many witnesses do not do: other covers do better then
#pragma once

#include <algorithm>
#include <array>

#include "solver/method/auto/cover/incumbent.hpp"
#include "solver/method/auto/cover/mixture_bound.hpp"

namespace plumb {

template <class S, class Solver>
class SectorCover {
 public:
  using Incumbent = plumb::Incumbent<S, Solver>;

  explicit SectorCover(Incumbent& incumbent) : incumbent_(incumbent) {}

  void start() {
    if (!incumbent_.is_found()) return give_up();
    const Vector3<S> n = incumbent_.best().normal, centre = incumbent_.solver().centre();
    const Vector3<S> c = centre * (S(1) / largest(centre));
    const S along = dot(n, c);
    if (!(along > S(0))) return give_up();
    const DirectionSquare<S> square =
        convex_square<S>(incumbent_.solver().support_shapes(), n, incumbent_.bound(), widest_square);
    if (!(square.reach > S(0))) return give_up();
    see(incumbent_.witness(incumbent_.best()));
    const S beyond = S(tolerance::across_centres) * epsilon<S>() / along;  // of the plane, by its rounding
    std::array<Vector3<S>, sectors> border, plane;                         // of the diagonals
    for (std::size_t k = 0; k < sectors; ++k) {
      const S side0 = k == 0 || k == 3 ? S(1) : S(-1), side1 = k < 2 ? S(1) : S(-1);
      const Vector3<S> d = square.across[0] * side0 + square.across[1] * side1;
      border[k] = unit(n + d * square.reach);
      plane[k] = unit(d * along - n * (dot(d, c) + beyond));
    }
    for (std::size_t k = 0; k < sectors; ++k) {
      const std::size_t next = (k + 1) % sectors;
      push({{border[k], border[next], plane[k], plane[next]}, 0});
    }
  }
  [[nodiscard]] bool is_empty() const { return waiting_count_ == 0; }
  [[nodiscard]] bool has_left_out() const { return has_given_up_; }

  void look_at_next() {
    const Cell cell = waiting_[--waiting_count_];
    if (is_excluded(cell)) return;
    const auto [mixture, place] = mixtures_.solve(cell.corners, incumbent_.excluded_height());
    if (is_excluded(cell, mixture)) return;
    if (seen_count_ == most_witnesses) return give_up();
    const Vector3<S> g = incumbent_.farthest(place);
    if (incumbent_.sees_lower(place, g)) return give_up();
    see(incumbent_.witness(place, g));
    if (is_excluded(cell, seen_[seen_count_ - 1])) return;
    for (const int part : {0, 1}) push(cell.part(part));
  }

 private:
  using Mixtures = MixtureBound<S>;

  struct Cell {
    typename Mixtures::Corners corners;  ///< two near n, then the two on the same sides far from it
    int depth;

    [[nodiscard]] Cell part(int index) const {
      const auto& [near0, near1, far0, far1] = corners;
      if (depth % 2 == 0) {
        const Vector3<S> near = unit(near0 + near1), far = unit(far0 + far1);
        return index == 0 ? Cell{{near0, near, far0, far}, depth + 1} : Cell{{near, near1, far, far1}, depth + 1};
      }
      const Vector3<S> side0 = unit(near0 + far0), side1 = unit(near1 + far1);
      return index == 0 ? Cell{{near0, near1, side0, side1}, depth + 1} : Cell{{side0, side1, far0, far1}, depth + 1};
    }
  };

  static constexpr double widest_square = 1.0 / 16;  // wider ones are seldom convex, and save little
  static constexpr std::size_t sectors = 4, most_witnesses = Mixtures::most_witnesses;

  [[nodiscard]] static Vector3<S> unit(const Vector3<S>& v) { return v * (S(1) / length(v)); }

  void push(const Cell& cell) { waiting_[waiting_count_++] = cell; }
  void see(const Vector3<S>& witness) {
    seen_[seen_count_++] = witness;
    mixtures_.add(witness);
  }

  [[nodiscard]] bool is_excluded(const Cell& cell, const Vector3<S>& witness) const {
    const S height = incumbent_.excluded_height();
    return std::all_of(cell.corners.begin(), cell.corners.end(),
                       [&](const Vector3<S>& v) { return dot(witness, v) >= height; });
  }
  [[nodiscard]] bool is_excluded(const Cell& cell) const {
    return std::any_of(seen_.begin(), seen_.begin() + static_cast<std::ptrdiff_t>(seen_count_),
                       [&](const Vector3<S>& witness) { return is_excluded(cell, witness); });
  }

  void give_up() {
    waiting_count_ = 0;
    has_given_up_ = true;
  }

  Incumbent& incumbent_;
  Mixtures mixtures_;  ///< of all that was seen
  std::array<Vector3<S>, most_witnesses> seen_;
  std::array<Cell, sectors + most_witnesses> waiting_;  ///< a cell that is divided costs a witness
  std::size_t seen_count_ = 0, waiting_count_ = 0;
  bool has_given_up_ = false;
};

}  // namespace plumb
