// A cover of four sectors about a common normal n, the first that a search tries: it mostly shows that n is the lowest.
//
// c, f, o, s, witnesses and mixtures as in directions.hpp. A direction is a n + d, d across n. Those of a sector have d between
// two diagonals of the convex square about n, and lie between the square's border and the plane v.c = 0: the mirror image of a
// direction behind it is lower (Half, directions.hpp). A sector is wide, but where n is the normal of a face, one point of the
// face's rim is high all over it.
//
// Excluded   by a witness at all four corners, or by a mixture of all that were seen
// Kept       what excludes the sectors, as points of the bodies: it mostly excludes those of the next step of a motion
// Divided    by half, across n and along it in turn; the parts of the last divided are looked at first
// Given up   where o is lower than at n, where n.c <= 0, and where 16 witnesses do not do: other covers do better then
#pragma once

#include <algorithm>
#include <array>
#include <optional>

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

  /// `known`: of an earlier contact, if any.
  SectorCover(Incumbent& incumbent, const Witnesses<S>* known)
      : incumbent_(incumbent), known_(known), radii_(incumbent.solver().inner_rolling_radii()) {
    const S both = sum<S>(radii_);
    if (both > S(0)) radii_ = radii_ * PerBody<S>(incumbent.rolling_radius() / both);
  }

  void start() {
    if (!incumbent_.is_found()) return give_up();
    const Vector3<S> n = incumbent_.best().normal;
    const std::optional<Vector3<S>> c = incumbent_.forwards();
    if (!c || !(dot(n, *c) > S(0))) return give_up();
    const DirectionSquare<S> square =
        convex_square<S>(incumbent_.solver().support_shapes(), n, incumbent_.bound(), widest_square);
    if (!(square.reach > S(0))) return give_up();
    add(incumbent_.witness(incumbent_.best()), gauge_of(n, points_of(incumbent_.best())));
    for (std::size_t j = 0; known_ != nullptr && j < known_->count; ++j) add_known(j);
    for (const Corners& corners : sectors_about(square, *c)) push({corners, 0});
  }
  [[nodiscard]] bool is_empty() const { return waiting_count_ == 0; }
  /// Whether it has given up.
  [[nodiscard]] bool has_left_out() const { return has_given_up_; }

  void look_at_next() {
    const Cell cell = waiting_[--waiting_count_];
    const S height = incumbent_.excluded_height();
    if (const auto one = witnesses_.one_that_reaches(height, cell.corners)) return keep(*one);
    if (known_ != nullptr && cell.depth < known_depth) return divide(cell);
    const auto [mixture, place] = witnesses_.solve(cell.corners, height);
    if (reaches(mixture, height, cell.corners)) return keep(mixture_of(witnesses_.shares()));
    if (witnesses_.is_full()) return give_up();
    const Vector3<PerBody<S>> points = incumbent_.farthest_points(place);
    const Vector3<S> g = difference(points);
    if (incumbent_.sees_lower(place, g)) return give_up();
    const Vector3<S> witness = incumbent_.witness(place, g);
    has_seen_more_ = true;
    add(witness, gauge_of(unit(place), points));
    if (reaches(witness, height, cell.corners)) return keep(count_ - 1);
    divide(cell);
  }

  /// Whether witnesses were missing.
  [[nodiscard]] bool has_seen_more() const { return has_seen_more_; }
  /// Those that exclude the cells, or the first of them.
  [[nodiscard]] const Witnesses<S>& witnesses() const { return kept_; }

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

  [[nodiscard]] Vector3<S> difference(const Vector3<PerBody<S>>& points) const {
    return first(points) - second(points) - incumbent_.solver().centre();
  }
  [[nodiscard]] Vector3<PerBody<S>> points_of(const typename Solver::Answer& found) const {
    const Solver& solver = incumbent_.solver();
    return per_body(solver.point1(found), solver.point2(found) - solver.centre());
  }
  /// Points farthest along the unit vector v: of the bodies without the balls that roll inside, in body axes and semi-axes.
  [[nodiscard]] Vector3<PerBody<S>> gauge_of(const Vector3<S>& v, const Vector3<PerBody<S>>& points) const {
    return incumbent_.solver().to_gauge(points - per_body(v, v * S(-1)) * radii_);
  }

  void add(const Vector3<S>& witness, const Vector3<PerBody<S>>& gauge) {
    witnesses_.add(witness);
    gauge_[count_++] = gauge;
  }
  void add_known(std::size_t j) {
    const Vector3<PerBody<S>> gauge =
        per_body(Vector3<S>::of(known_->points[0][j]), Vector3<S>::of(known_->points[1][j]));
    add(difference(incumbent_.solver().from_gauge(gauge)), gauge);
  }

  void keep(std::size_t witness) {
    if (!is_kept_[witness]) keep(gauge_[witness]);
    is_kept_[witness] = true;
  }
  void keep(const Vector3<PerBody<S>>& gauge) {
    if (kept_.count == Witnesses<S>::most) return;
    kept_.points[0][kept_.count] = first(gauge).eigen();
    kept_.points[1][kept_.count++] = second(gauge).eigen();
  }
  /// A little nearer to the centres: mixtures of mixtures must not drift out of the bodies.
  [[nodiscard]] Vector3<PerBody<S>> mixture_of(const std::array<S, MixtureBound<S>::most_witnesses>& shares) const {
    Vector3<PerBody<S>> out = for_each_body(Vector3<S>{S(0), S(0), S(0)});
    for (std::size_t j = 0; j < count_; ++j)
      if (shares[j] > S(0)) out = out + gauge_[j] * PerBody<S>(shares[j]);
    return out * PerBody<S>(S(1) - S(tolerance::mixing) * epsilon<S>());
  }

  /// Of cells that witnesses of an earlier contact may exclude one by one.
  static constexpr int known_depth = 3;

  void push(const Cell& cell) { waiting_[waiting_count_++] = cell; }
  void divide(const Cell& cell) {
    for (const int part : {0, 1}) push(cell.part(part));
  }

  void give_up() {
    waiting_count_ = 0;
    has_given_up_ = true;
  }

  Incumbent& incumbent_;
  const Witnesses<S>* known_;
  PerBody<S> radii_;           ///< of balls that roll inside the bodies
  MixtureBound<S> witnesses_;  ///< all that were seen, and those known before
  std::array<Vector3<PerBody<S>>, MixtureBound<S>::most_witnesses> gauge_;  ///< their points
  std::array<bool, MixtureBound<S>::most_witnesses> is_kept_{};
  std::size_t count_ = 0;
  Witnesses<S> kept_;
  bool has_seen_more_ = false;
  /// A cell that is divided is one more: it costs a witness, or goes to `known_depth`.
  std::array<Cell, 4 + known_depth + MixtureBound<S>::most_witnesses> waiting_;
  std::size_t waiting_count_ = 0;
  bool has_given_up_ = false;
};

}  // namespace plumb
