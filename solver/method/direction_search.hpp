// The last resort of `auto`: a search over all directions for a common normal lower than the one at hand.
//
// f(v) = max over both bodies of v.(p1 - p2) is o(v/|v|) |v|: convex, of degree 1, and g(v) = p1 - p2 is its gradient.
// s(v) = f(v) - o |v| with o > 0 the level at hand; what is sought is a direction with s < 0.
//
// Cells     a quadtree on the faces of a cube of directions, depth first
// Excluded  f(v) >= g.v for any g = p1 - p2, wherever it was found, and g.v - o |v| is concave: where it is not negative
//           at a cell's four corners s is not negative on the cell
// Explained s looks convex on the hull of the cell and of a common normal already known (its gradients at the corners, at
//           the middle and there are monotone in pairs); then s is no lower on the cell than at that common normal
// Else      the cell is divided; now and then a local solve starts from its middle, and what it finds becomes known
//
// What it does not promise. `Explained` looks at six points, and plain doubles are no intervals: a proof is reference/'s
// business. The number of evaluations is limited: `complete` says whether every cell was settled.
#pragma once

#include <array>

#include "solver/method/vector3.hpp"
#include "solver/scalar.hpp"

namespace plumb {

/// `Form` offers   Vector3<S> farthest(v): g(v) for any v but zero
///                 Answer solve(v): a local solve; Answer has status, overlap, normal, iterations, evaluations
///                 int least_level(): of a cell that six points can explain; higher where o has narrow folds
template <class S, class Form, class Answer>
class DirectionSearch {
 public:
  DirectionSearch(const Form& form, const S& size, const Answer& first) : form_(form), size_(size), best_(first) {
    if (first.status == Status::converged) remember(first);
  }

  /// The lowest common normal found, with the iterations of its own solve and the evaluations of the whole search.
  [[nodiscard]] Answer lowest() {
    for (int face = 0; face < faces; ++face) push({face, 0, S(0), S(0), S(1), Vector3<S>{S(0), S(0), S(0)}});
    while (depth_ > 0 && level() > S(0) && best_.evaluations < most_evaluations)
      look_at(stack_[static_cast<std::size_t>(--depth_)]);
    return best_;
  }

  /// Whether every cell is settled. Bodies apart need none: a common normal with o <= 0 is the lowest.
  [[nodiscard]] bool complete() const { return depth_ == 0 || !(level() > S(0)); }

 private:
  static constexpr int faces = 6;
  static constexpr int deepest = 24;    // 2^-24 of a face: what is left is at the rounding of o
  static constexpr int solve_each = 3;  // levels between two local solves
  static constexpr int most_known = 16;
  static constexpr double explained_reach = 4;  // half edges of a cell: six points do not see further
  static constexpr int most_evaluations = 800;  // below the 1000 that the laws call slow
  static constexpr double noise = 64;           // epsilon times this and the size: rounding of a gradient

  struct Cell {
    int face, level;
    S u, v, half;
    Vector3<S> witness;  ///< g of the cell above; zero for a face
  };

  struct Sample {
    Vector3<S> v;      ///< on the face's plane
    Vector3<S> slope;  ///< of s
  };

  struct Known {
    Vector3<S> normal;
    S overlap;
  };

  [[nodiscard]] S level() const {
    return best_.status == Status::converged ? best_.overlap : std::numeric_limits<S>::infinity();
  }

  [[nodiscard]] static Vector3<S> on_face(const Cell& cell, const S& u, const S& v) {
    const S w = cell.face % 2 == 0 ? S(1) : S(-1);
    switch (cell.face / 2) {
      case 0: return {w, u, v};
      case 1: return {v, w, u};
      default: return {u, v, w};
    }
  }

  [[nodiscard]] static std::array<Vector3<S>, 4> corners(const Cell& c) {
    return {on_face(c, c.u - c.half, c.v - c.half), on_face(c, c.u + c.half, c.v - c.half),
            on_face(c, c.u - c.half, c.v + c.half), on_face(c, c.u + c.half, c.v + c.half)};
  }

  void push(const Cell& cell) { stack_[static_cast<std::size_t>(depth_++)] = cell; }

  [[nodiscard]] bool is_excluded(const Cell& cell, const Vector3<S>& g) const {
    for (const Vector3<S>& v : corners(cell))
      if (!(dot(g, v) >= level() * length(v))) return false;
    return true;
  }

  void look_at(const Cell& cell) {
    if (is_excluded(cell, cell.witness)) return;
    const Vector3<S> middle = on_face(cell, cell.u, cell.v);
    const Vector3<S> g = farthest(middle);
    if (is_excluded(cell, g)) return;
    const bool is_lower = dot(g, middle) < level() * length(middle);
    if (is_lower || cell.level % solve_each == solve_each - 1) solve_from(middle);
    if (cell.level >= form_.least_level() && is_explained(cell, {middle, slope(middle, g)})) return;
    if (cell.level < deepest) divide(cell, g);
  }

  void divide(const Cell& c, const Vector3<S>& g) {
    const S half = c.half / 2;
    for (const S& u : {c.u - half, c.u + half})
      for (const S& v : {c.v - half, c.v + half}) push({c.face, c.level + 1, u, v, half, g});
  }

  [[nodiscard]] Vector3<S> farthest(const Vector3<S>& v) {
    ++best_.evaluations;
    return form_.farthest(v);
  }

  [[nodiscard]] Vector3<S> slope(const Vector3<S>& v, const Vector3<S>& g) const {
    return g - v * (level() / length(v));
  }

  [[nodiscard]] bool is_explained(const Cell& cell, const Sample& middle) {
    std::array<Sample, 6> samples;
    samples[0] = middle;
    std::size_t n = 1;
    for (const Vector3<S>& v : corners(cell)) samples[n++] = {v, slope(v, farthest(v))};
    if (!are_monotone(samples, n)) return false;
    const Vector3<S> outwards = on_face(cell, S(0), S(0));
    for (int k = 0; k < known_count_; ++k) {
      const Known& known = known_[static_cast<std::size_t>(k)];
      const S height = dot(known.normal, outwards);
      if (!(height > S(0.25))) continue;  // beyond a neighbouring face
      samples[n] = {known.normal * (S(1) / height), known.normal * (known.overlap - level())};
      if (largest(samples[n].v - middle.v) > S(explained_reach) * cell.half) continue;
      if (are_monotone(samples, n + 1)) return true;
    }
    return false;
  }

  /// Pairwise, to rounding.
  [[nodiscard]] bool are_monotone(const std::array<Sample, 6>& samples, std::size_t n) const {
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const Vector3<S> along = samples[i].v - samples[j].v;
        const S rise = dot(samples[i].slope - samples[j].slope, along);
        if (!(rise >= -S(noise) * epsilon<S>() * size_ * length(along))) return false;
      }
    return true;
  }

  void solve_from(const Vector3<S>& v) {
    Answer found = form_.solve(v);
    const int evaluations = best_.evaluations + found.evaluations;
    if (found.status == Status::converged) {
      remember(found);
      if (best_.status != Status::converged || found.overlap < best_.overlap) best_ = found;
    }
    best_.evaluations = evaluations;
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
  std::array<Known, most_known> known_;
  int known_count_ = 0;
  std::array<Cell, faces + 3 * deepest + 4> stack_;
  int depth_ = 0;
};

}  // namespace plumb
