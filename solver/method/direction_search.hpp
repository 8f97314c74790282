// The last resort of `auto`: a search over all directions for a common normal lower than the one at hand.
//
// f(v) = max over both bodies of v.(p1 - p2) is o(v/|v|) |v|: convex, of degree 1, and g(v) = p1 - p2 is its gradient.
// s(v) = f(v) - o |v| with o > 0 the level at hand; what is sought is a direction with s < 0.
//
// Half      the bodies are their own mirror images through their centres, so that o(-n) = o(n) + 2 n.c: the lowest common normal
//           has n.c >= 0, and only such directions are looked at (c from body 1's centre to body 2's)
// Cells     a quadtree on the faces of a cube of directions, depth first; the cube is turned so that the common normal at hand
//           is the middle of a cell of the second level, which explains its surroundings
// Excluded  f(v) >= g.v for any g = p1 - p2, wherever it was found, and g.v - o |v| is concave: where it is not negative
//           at a cell's four corners s is not negative on the cell
// Explained s looks convex on the hull of the cell and of a common normal n already known (its gradients at the corners, at
//           the middle and there are monotone in pairs). Its tangent plane at n is (o(n) - o) n.v, not negative where n.v is
//           not, and s lies above it
// Else      the cell is divided. A local solve starts from its middle where o is lower there, and every third level anyway:
//           what it finds becomes known
//
// What it does not promise. `Explained` looks at six points, and plain doubles are no intervals: a proof is reference/'s
// business. The number of evaluations is limited: an answer is not called converged where cells are left, or above any o
// that was seen on the way.
#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "solver/method/vector3.hpp"
#include "solver/scalar.hpp"
#include "solver/shape/tangent.hpp"

namespace plumb {

/// `Form` offers   Vector3<S> farthest(v): g(v) for any v but zero
///                 Answer solve(v, insists): a local solve, by all means where it insists; Answer has status, overlap,
///                 normal, iterations, evaluations
///                 Vector3<S> centre(): c
///                 int least_level(): of a cell that six points can explain; higher where o has narrow folds
template <class S, class Form, class Answer>
class DirectionSearch {
 public:
  DirectionSearch(const Form& form, const S& size, const Answer& first) : form_(form), size_(size), best_(first) {
    if (first.status == Status::converged) centre_on(first.normal);
    forwards_ = largest(form.centre()) > S(0) ? form.centre() : axes_[0];
  }

  /// The lowest common normal found, with the iterations of its own solve and the evaluations of the whole search.
  [[nodiscard]] Answer lowest() {
    if (best_.status == Status::converged) take(best_);
    for (int face = 0; face < faces; ++face) push({face, 0, S(0), S(0), S(1)});
    while (depth_ > 0 && level() > S(0) && best_.evaluations < most_evaluations)
      look_at(stack_[static_cast<std::size_t>(--depth_)]);
    if (!complete() || lowest_seen_ < level() - rounding()) best_.status = Status::stalled;
    return best_;
  }

 private:
  static constexpr int faces = 6;
  static constexpr int deepest = 24;    // 2^-24 of a face: what is left is at the rounding of o
  static constexpr int solve_each = 3;  // levels between two local solves
  static constexpr int most_known = 16;
  static constexpr int most_witnesses = 8;  // more save no more time than they take
  static constexpr int most_fruitless = 4;  // solves in a row that find what is known
  static constexpr double explained_reach = 4,
                          longest_reach = 0.4;  // half edges of a cell, of the cube: see no further
  static constexpr int most_evaluations = 980;  // a Newton below the 1000 that the laws call slow
  static constexpr double noise = 64;           // epsilon times this and the size: rounding of a gradient

  struct Cell {
    int face, level;
    S u, v, half;
  };

  struct Sample {
    Vector3<S> v;      ///< on the face's plane
    Vector3<S> slope;  ///< of s
  };

  using Samples = std::array<Sample, 6>;
  using Corners = std::array<Vector3<S>, 4>;

  struct Known {
    Vector3<S> normal;
    S overlap;
  };

  [[nodiscard]] S level() const {
    return best_.status == Status::converged ? best_.overlap : std::numeric_limits<S>::infinity();
  }

  /// Whether every cell is settled. Bodies apart need none: a common normal with o <= 0 is the lowest.
  [[nodiscard]] bool complete() const { return depth_ == 0 || !(level() > S(0)); }

  /// Of o.
  [[nodiscard]] S rounding() const { return S(noise) * epsilon<S>() * size_; }

  /// Turns the cube.
  void centre_on(const Vector3<S>& n) {
    const S q(0.25), length_of_middle = S(1.0606601717798212);  // a cell of level 2 has its middle at (1, 1/4, 1/4)
    const Vec3<S> middle = Vec3<S>(S(1), q, q) / length_of_middle;
    const Tangent<S> from = tangent_basis<S>(middle), to = tangent_basis<S>(n.eigen());
    const Mat3<S> turn = to * from.transpose() + n.eigen() * middle.transpose();
    for (int k = 0; k < 3; ++k) axes_[static_cast<std::size_t>(k)] = Vector3<S>::of(turn.col(k));
  }

  [[nodiscard]] Vector3<S> on_face(const Cell& cell, const S& u, const S& v) const {
    const auto k = static_cast<std::size_t>(cell.face / 2);
    const S w = cell.face % 2 == 0 ? S(1) : S(-1);
    return axes_[k] * w + axes_[(k + 1) % 3] * u + axes_[(k + 2) % 3] * v;
  }

  [[nodiscard]] Corners corners(const Cell& c) const {
    return {on_face(c, c.u - c.half, c.v - c.half), on_face(c, c.u + c.half, c.v - c.half),
            on_face(c, c.u - c.half, c.v + c.half), on_face(c, c.u + c.half, c.v + c.half)};
  }

  void push(const Cell& cell) { stack_[static_cast<std::size_t>(depth_++)] = cell; }

  [[nodiscard]] bool is_mirrored(const Corners& corners) const {
    return std::all_of(corners.begin(), corners.end(), [&](const Vector3<S>& v) { return dot(v, forwards_) <= S(0); });
  }

  [[nodiscard]] bool is_excluded(const Corners& corners, const Vector3<S>& g) const {
    for (const Vector3<S>& v : corners)
      if (!(dot(g, v) >= level() * length(v))) return false;
    return true;
  }

  /// By one of the last g, latest first: mostly that of the cell above or beside.
  [[nodiscard]] bool is_excluded(const Corners& corners) const {
    for (int k = seen_; k-- > std::max(0, seen_ - most_witnesses);)
      if (is_excluded(corners, witnesses_[static_cast<std::size_t>(k % most_witnesses)])) return true;
    return false;
  }

  void look_at(const Cell cell) {  // a copy: its place in the stack is taken by its parts
    const Corners around = corners(cell);
    if (is_mirrored(around)) return;
    if (is_excluded(around)) return;
    const Vector3<S> middle = on_face(cell, cell.u, cell.v);
    const Vector3<S> g = farthest(middle);
    if (is_excluded(around, g)) return;
    const S here = dot(g, middle) / length(middle);
    lowest_seen_ = std::min(lowest_seen_, here);
    const bool is_lower = here < level() - rounding();
    if (is_lower) solve_from(middle, true);
    if (cell.level >= form_.least_level() && is_explained(cell, around, {middle, slope(middle, g)})) return;
    const bool is_due = !is_lower && cell.level > 0 && cell.level % solve_each == 0;
    if (is_due && fruitless_ < most_fruitless && !is_known_near(cell, middle)) explore_from(middle);
    if (cell.level < deepest) divide(cell);
  }

  void divide(const Cell& c) {
    const S half = c.half / 2;
    for (const S& u : {c.u - half, c.u + half})
      for (const S& v : {c.v - half, c.v + half}) push({c.face, c.level + 1, u, v, half});
  }

  [[nodiscard]] Vector3<S> farthest(const Vector3<S>& v) {
    ++best_.evaluations;
    return witnesses_[static_cast<std::size_t>(seen_++ % most_witnesses)] = form_.farthest(v);
  }

  [[nodiscard]] Vector3<S> slope(const Vector3<S>& v, const Vector3<S>& g) const {
    return g - v * (level() / length(v));
  }

  [[nodiscard]] bool is_explained(const Cell& cell, const Corners& around, const Sample& middle) {
    Samples samples;
    samples[0] = middle;
    std::size_t n = 1;
    for (const Vector3<S>& v : around) samples[n++] = {v, slope(v, farthest(v))};
    if (!are_monotone(samples, n)) return false;
    const Vector3<S> outwards = on_face(cell, S(0), S(0));
    for (int k = 0; k < known_count_; ++k) {
      const Known& known = known_[static_cast<std::size_t>(k)];
      const S height = dot(known.normal, outwards);
      const bool is_beside = height > S(0.25);  // and not beyond a neighbouring face
      if (!is_beside || !is_on_this_side(around, known.normal)) continue;
      samples[n] = {known.normal * (S(1) / height), known.normal * (known.overlap - level())};
      const S reach = std::min(S(longest_reach), S(explained_reach) * cell.half);
      if (largest(samples[n].v - middle.v) > reach) continue;
      if (are_monotone(samples, n + 1)) return true;
    }
    return false;
  }

  [[nodiscard]] static bool is_on_this_side(const Corners& around, const Vector3<S>& n) {
    return std::all_of(around.begin(), around.end(), [&](const Vector3<S>& v) { return dot(n, v) >= S(0); });
  }

  /// Pairwise, to rounding; a corner or middle that is the known normal itself says nothing.
  [[nodiscard]] bool are_monotone(const Samples& samples, std::size_t n) const {
    constexpr double same = 1e-12;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const Vector3<S> along = samples[i].v - samples[j].v;
        const S distance = length(along), rise = dot(samples[i].slope - samples[j].slope, along);
        if (distance > S(same) && !(rise >= -rounding() * distance)) return false;
      }
    return true;
  }

  void solve_from(const Vector3<S>& v, bool is_lower) {
    const Answer found = form_.solve(v, is_lower);
    best_.evaluations += found.evaluations;
    if (found.status == Status::converged) take(found);
  }

  void take(const Answer found) {  // a copy: it may be best_
    remember(found);
    if (best_.status != Status::converged || found.overlap < best_.overlap) {
      const int evaluations = best_.evaluations;
      best_ = found;
      best_.evaluations = evaluations;
    }
    const bool is_backwards = dot(found.normal, form_.centre()) < -rounding();  // then -n is as much lower
    if (is_backwards && found.overlap <= best_.overlap) solve_from(found.normal * S(-1), true);
  }

  /// A local solve would find that one again.
  [[nodiscard]] bool is_known_near(const Cell& cell, const Vector3<S>& v) const {
    const Vector3<S> n = v * (S(1) / length(v));
    return std::any_of(known_.begin(), known_.begin() + known_count_,
                       [&](const Known& known) { return largest(known.normal - n) < S(explained_reach) * cell.half; });
  }

  void explore_from(const Vector3<S>& v) {
    const int known = known_count_;
    solve_from(v, false);
    fruitless_ = known_count_ > known ? 0 : fruitless_ + 1;
  }

  void remember(const Answer& found) {
    const S same(1e-6);
    for (int k = 0; k < known_count_; ++k)
      if (largest(known_[static_cast<std::size_t>(k)].normal - found.normal) < same) return;
    if (known_count_ < most_known) known_[static_cast<std::size_t>(known_count_++)] = {found.normal, found.overlap};
  }

  const Form& form_;
  S size_;
  Answer best_;
  S lowest_seen_ = std::numeric_limits<S>::infinity();
  Vector3<S> forwards_;
  std::array<Vector3<S>, 3> axes_{{{S(1), S(0), S(0)}, {S(0), S(1), S(0)}, {S(0), S(0), S(1)}}};
  std::array<Known, most_known> known_;
  int known_count_ = 0, fruitless_ = 0, seen_ = 0;
  std::array<Vector3<S>, most_witnesses> witnesses_;
  std::array<Cell, faces + 3 * deepest + 4> stack_;
  int depth_ = 0;
};

}  // namespace plumb
