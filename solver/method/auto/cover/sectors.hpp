// A cover of four sectors about a common normal n, the first that a search tries: it mostly shows that n is the lowest.
//
// c, f, o, s, witnesses and mixtures as in directions.hpp. A direction is a n + d, d across n. Those of a sector have d between
// two diagonals of the convex square about n, and lie between the square's border and the plane v.c = 0: the mirror image of a
// direction behind it is lower (Half, directions.hpp). A sector is wide, but where n is the normal of a face, one point of the
// face's rim is high all over it.
//
// Excluded   by a witness at all four corners, or by a mixture of all that were seen
// Divided    by half, across n and along it in turn; the parts of the last divided are looked at first
// Given up   where o is lower than at n, where n.c <= 0, and where 15 evaluations do not do: other covers do better then
#pragma once

#include <algorithm>
#include <array>

#include "solver/method/auto/cover/incumbent.hpp"
#include "solver/method/auto/cover/mixture_bound.hpp"

namespace plumb {

/// The corners of the four sectors about square.n, unit: two on the square's border, then the two on the same sides of the plane
/// v.c = 0. n.c > 0; c of any length that has a square.
template <class S>
[[nodiscard]] inline std::array<typename MixtureBound<S>::Corners, 4> sectors_about(const DirectionSquare<S>& square,
                                                                                    const Vector3<S>& c) {
  const S along = dot(square.n, c);
  // The plane's corners lie behind it by more than d.c / n.c rounds: a direction short of it might be in no sector.
  const S beyond = S(tolerance::behind_centre) * epsilon<S>() * dot(c, c) / along;
  std::array<Vector3<S>, 4> border, plane;  // of the diagonals
  for (std::size_t k = 0; k < 4; ++k) {
    const S side0 = k == 0 || k == 3 ? S(1) : S(-1), side1 = k < 2 ? S(1) : S(-1);
    const Vector3<S> d = square.across[0] * side0 + square.across[1] * side1;
    border[k] = unit(square.n + d * square.reach);
    plane[k] = unit(d * along - square.n * (dot(d, c) + beyond));
  }
  return {{{border[0], border[1], plane[0], plane[1]},
           {border[1], border[2], plane[1], plane[2]},
           {border[2], border[3], plane[2], plane[3]},
           {border[3], border[0], plane[3], plane[0]}}};
}

template <class S, class Solver>
class SectorCover {
 public:
  using Incumbent = plumb::Incumbent<S, Solver>;

  explicit SectorCover(Incumbent& incumbent) : incumbent_(incumbent) {}

  void start() {
    if (!incumbent_.is_found()) return give_up();
    const Vector3<S> n = incumbent_.best().normal;
    const std::optional<Vector3<S>> c = incumbent_.forwards();
    if (!c || !(dot(n, *c) > S(0))) return give_up();
    const DirectionSquare<S> square =
        convex_square<S>(incumbent_.solver().support_shapes(), n, incumbent_.bound(), widest_square);
    if (!(square.reach > S(0))) return give_up();
    witnesses_.add(incumbent_.witness(incumbent_.best()));
    for (const Corners& corners : sectors_about(square, *c)) push({corners, 0});
  }
  [[nodiscard]] bool is_empty() const { return waiting_count_ == 0; }
  /// Whether it has given up.
  [[nodiscard]] bool has_left_out() const { return has_given_up_; }

  void look_at_next() {
    const Cell cell = waiting_[--waiting_count_];
    const S height = incumbent_.excluded_height();
    if (witnesses_.one_reaches(height, cell.corners)) return;
    const auto [mixture, place] = witnesses_.solve(cell.corners, height);
    if (reaches(mixture, height, cell.corners)) return;
    if (witnesses_.is_full()) return give_up();
    const Vector3<S> g = incumbent_.farthest(place);
    if (incumbent_.sees_lower(place, g)) return give_up();
    const Vector3<S> witness = incumbent_.witness(place, g);
    witnesses_.add(witness);
    if (reaches(witness, height, cell.corners)) return;
    for (const int part : {0, 1}) push(cell.part(part));
  }

 private:
  using Corners = typename MixtureBound<S>::Corners;

  struct Cell {
    Corners corners;  ///< two near n, then the two on the same sides far from it
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

  void push(const Cell& cell) { waiting_[waiting_count_++] = cell; }

  void give_up() {
    waiting_count_ = 0;
    has_given_up_ = true;
  }

  Incumbent& incumbent_;
  MixtureBound<S> witnesses_;  ///< all that were seen
  /// A cell that is divided costs a witness, and is one more.
  std::array<Cell, 4 + MixtureBound<S>::most_witnesses> waiting_;
  std::size_t waiting_count_ = 0;
  bool has_given_up_ = false;
};

}  // namespace plumb
