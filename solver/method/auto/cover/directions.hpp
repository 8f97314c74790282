// A cover of all directions: a quadtree on the faces of a cube, depth by depth (direction_cells.hpp).
//
// f(v) = max over both bodies of v.(p1 - p2) is o(v/|v|) |v|: convex, of degree 1, and g(v) = p1 - p2 is its gradient.
// s(v) = f(v) - o* |v| with o* > 0 the incumbent's bound. A lower common normal is a direction with s < 0.
//
// Half        the bodies are their own mirror images through their centres, so that o(-n) = o(n) + 2 n.c. The lowest common
//             normal has n.c >= 0, c from body 1's centre to body 2's: only such directions are looked at
// Excluded    by a witness (incumbent.hpp) at a cell's four corners, or by a mixture of several (mixture_bound.hpp)
// Rotation    a cell where o changes as directions turn about an axis of revolution has no common normal
//             (rotation_derivative.hpp)
// Convex      in a square about a known common normal n on which s is convex (curvature_bound.hpp). s lies above its tangent
//             plane at n there, (o(n) - o*) n.v
// Divided     o is evaluated at the cell's middle, or where the witnesses are the lowest. In narrow grooves of o those two
//             are far apart. A local solve starts there where o is lower, and at every third depth in any case
//
// Cells are looked at first in, first out. The best first, other pairs stall: the local solves start elsewhere.
#pragma once

#include <algorithm>
#include <array>

#include "solver/method/auto/cover/direction_cells.hpp"
#include "solver/method/auto/cover/incumbent.hpp"
#include "solver/method/auto/cover/mixture_bound.hpp"
#include "solver/method/auto/cover/rotation_derivative.hpp"

namespace plumb {

/// `budget`: of evaluations, the incumbent's or more.
template <class S, class Solver, int budget>
class DirectionCover {
 public:
  using Incumbent = plumb::Incumbent<S, Solver>;

  DirectionCover(Incumbent& incumbent, const std::optional<RotationDerivative<S>>& rotation)
      : incumbent_(incumbent), rotation_(rotation),
        forwards_(incumbent.forwards().value_or(Vector3<S>{S(1), S(0), S(0)})) {}

  void start() {
    if (const Answer first = incumbent_.best(); incumbent_.is_found()) take(first);
  }
  [[nodiscard]] bool is_empty() const { return next_face_ == Cell::faces && waiting_.is_empty(); }
  [[nodiscard]] bool has_left_out() const { return has_left_out_; }

  void look_at_next() {
    if (next_face_ < Cell::faces) return look_at({0, 0, next_face_++, 0}, nullptr);
    const Cell cell = waiting_.next();
    look_at(cell, &waiting_.witness());
  }

 private:
  using Answer = typename Incumbent::Answer;
  using Mixtures = MixtureBound<S>;
  using Corners = typename Mixtures::Corners;
  using Cell = DirectionCell<S>;
  static_assert(std::is_same_v<Corners, std::array<Vector3<S>, Cell::parts>>);

  static constexpr int deepest = std::min(Cell::deepest, std::numeric_limits<S>::digits - 2);  // 2^-26 of a face
  static constexpr int first_mixture = 3;            // depth: of wider cells no mixture says more than one witness
  static constexpr int first_groove = 8;             // depth: narrower cells are cut more than once
  static constexpr int few_cuts = 3, most_cuts = 8;  // evaluations in a cell, in one that can't be divided
  static constexpr int last_witnesses = 6;           // more save evaluations, and no time
  static constexpr std::size_t kept_witnesses = 8;   // a power of two
  static constexpr int solve_each = 3;               // depths between two local solves
  static constexpr int most_known = 16;
  static constexpr int most_fruitless = 4;    // solves in a row that find what is known
  static constexpr int patience = 2;          // depths from a solve in vain to the next
  static constexpr double known_reach = 4;    // half edges of a cell
  static constexpr int first_insisting = 4;   // depth: of wider cells a start may be far from the minimum
  static constexpr int last_insisting = 700;  // evaluations: a descent below the first search's budget
  static_assert(2 + last_witnesses + most_cuts <= static_cast<int>(Mixtures::most_witnesses));

  /// About a common normal, where it explains every direction. The bound only falls: s is the more convex for it. Of reach -1 until it is
  /// measured.
  using Known = DirectionSquare<S>;

  /// `above`: a witness of the cell above, none for a face.
  void look_at(const Cell& cell, const Vector3<S>* above) {
    const Corners corners = cell.corners();
    if (is_mirrored(corners) || is_excluded(corners, above) || is_in_convex_square(corners)) return;
    if (rotation_ && rotation_->has_one_sign(corners)) return;
    if (becomes_excluded(cell, corners, above) || is_in_convex_square(corners)) return;
    const Vector3<S> middle = cell.middle();
    const bool is_due = cell.depth > 0 && cell.depth % solve_each == 0 && fruitless_ < most_fruitless;
    if (is_due && !is_known_near(cell, middle)) explore_from(middle);
    if (cell.depth < deepest) return waiting_.push(cell, last_seen(0));
    solve_from(middle, Attempts::several);
    has_left_out_ = has_left_out_ || !is_in_convex_square(corners);
  }

  [[nodiscard]] bool is_mirrored(const Corners& corners) const {
    return std::all_of(corners.begin(), corners.end(), [&](const Vector3<S>& v) { return dot(v, forwards_) <= S(0); });
  }

  [[nodiscard]] bool is_excluded(const Corners& corners, const Vector3<S>& witness) const {
    return reaches(witness, incumbent_.excluded_height(), corners);
  }

  /// By what was seen of the cell above, or by one of the last.
  [[nodiscard]] bool is_excluded(const Corners& corners, const Vector3<S>* above) const {
    if (above != nullptr && is_excluded(corners, *above)) return true;
    for (int back = 0; back < std::min(seen_count_, last_witnesses); ++back)
      if (is_excluded(corners, last_seen(back))) return true;
    return false;
  }

  /// So many witnesses before the last one, last_witnesses at most.
  [[nodiscard]] const Vector3<S>& last_seen(int back) const { return seen_[place_of(seen_count_ - 1 - back)]; }
  [[nodiscard]] static std::size_t place_of(int seen) { return static_cast<std::size_t>(seen) % kept_witnesses; }

  /// Sees more of the cell; whether nothing in it is lower. Ends as well where o is lower than that of any common normal
  /// known, and where what the witnesses do not exclude is between the corners alone, which dividing brings closer.
  [[nodiscard]] bool becomes_excluded(const Cell& cell, const Corners& corners, const Vector3<S>* above) {
    if (cell.depth < first_mixture) return !see(cell.middle(), cell.depth) && is_excluded(corners, last_seen(0));
    Mixtures mixtures = witnesses_with(*above);
    const int cuts = cell.depth < first_groove ? 1 : cell.depth < deepest ? few_cuts : most_cuts;
    for (int cut = 0; cut <= cuts; ++cut) {
      const auto [mixture, place] = mixtures.solve(corners, incumbent_.excluded_height());
      if (is_excluded(corners, mixture)) return true;
      const bool is_enough = cut == cuts || !incumbent_.may_go_on();
      if (is_enough || (cut > 0 && mixtures.reaches(incumbent_.excluded_height(), place))) return false;
      if (see(place, cell.depth)) return false;
      if (is_excluded(corners, last_seen(0))) return true;
      mixtures.add(last_seen(0));
    }
    return false;
  }

  [[nodiscard]] Mixtures witnesses_with(const Vector3<S>& above) const {
    Mixtures out;
    out.add(above);
    if (incumbent_.is_found()) out.add(incumbent_.witness(incumbent_.best()));
    for (int back = 0; back < std::min(seen_count_, last_witnesses); ++back) out.add(last_seen(back));
    return out;
  }

  /// Evaluates o along v; whether it is lower than that of any common normal known. Solves from there then, unless that was in
  /// vain a short while ago.
  bool see(const Vector3<S>& v, int depth) {
    const Vector3<S> g = incumbent_.farthest(v);
    seen_[place_of(seen_count_++)] = incumbent_.witness(v, g);
    if (!incumbent_.sees_lower(v, g)) return false;
    if (depth < next_solve_) return true;
    const bool is_worth_more = depth >= first_insisting && incumbent_.best().evaluations < last_insisting;
    next_solve_ = solve_from(v, is_worth_more ? Attempts::several : Attempts::one) ? 0 : depth + patience;
    return true;
  }

  [[nodiscard]] bool is_in_convex_square(const Corners& corners) {
    for (int k = 0; k < known_count_; ++k) {
      Known& known = known_[static_cast<std::size_t>(k)];
      if (known.reach < S(0))
        known = convex_square<S>(incumbent_.solver().support_shapes(), known.n, incumbent_.bound());
      if (std::all_of(corners.begin(), corners.end(), [&](const Vector3<S>& v) { return known.holds(v); })) return true;
    }
    return false;
  }

  /// Whether the common normal found is the lowest so far.
  bool solve_from(const Vector3<S>& v, Attempts attempts) {
    const Answer found = incumbent_.solve(v, attempts);
    return found.status == Status::converged && take(found);
  }

  bool take(const Answer& found) {
    remember(found);
    const bool is_lower = incumbent_.take(found);
    const bool is_backwards = dot(found.normal, incumbent_.solver().centre()) < -incumbent_.rounding() &&
                              incumbent_.may_go_on();  // then -n is as much lower
    if (is_backwards && found.overlap <= incumbent_.best().overlap) solve_from(found.normal * S(-1), Attempts::several);
    return is_lower;
  }

  /// A local solve would find that one again.
  [[nodiscard]] bool is_known_near(const Cell& cell, const Vector3<S>& v) const {
    const Vector3<S> n = v * (S(1) / length(v));
    return std::any_of(known_.begin(), known_.begin() + known_count_,
                       [&](const Known& known) { return largest(known.n - n) < S(known_reach) * cell.half(); });
  }

  void explore_from(const Vector3<S>& v) {
    const int known = known_count_;
    solve_from(v, Attempts::one);
    fruitless_ = known_count_ > known ? 0 : fruitless_ + 1;
  }

  void remember(const Answer& found) {
    for (int k = 0; k < known_count_; ++k)
      if (largest(known_[static_cast<std::size_t>(k)].n - found.normal) < tolerance::same_normal.of<S>()) return;
    if (known_count_ < most_known) known_[static_cast<std::size_t>(known_count_++)] = {found.normal, {}, S(-1)};
  }

  Incumbent& incumbent_;
  std::optional<RotationDerivative<S>> rotation_;
  Vector3<S> forwards_;
  std::array<Known, most_known> known_;
  int known_count_ = 0, fruitless_ = 0, seen_count_ = 0;
  std::array<Vector3<S>, kept_witnesses> seen_;  ///< the last; number k has the place k modulo their number
  DirectionQueue<S, budget> waiting_;            ///< a cell that is divided costs an evaluation or more
  int next_face_ = 0;
  int next_solve_ = 0;  ///< the depth of the next local solve where o is lower
  bool has_left_out_ = false;
};

}  // namespace plumb
