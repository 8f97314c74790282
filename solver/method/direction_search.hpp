// The last resort of `auto`: a search over all directions for a common normal lower than the one at hand.
//
// f(v) = max over both bodies of v.(p1 - p2) is o(v/|v|) |v|: convex, of degree 1, and g(v) = p1 - p2 is its gradient.
// s(v) = f(v) - o |v| with o > 0 the level at hand; what is sought is a direction with s < 0.
//
// Half      the bodies are their own mirror images through their centres, so that o(-n) = o(n) + 2 n.c: the lowest common normal
//           has n.c >= 0, and only such directions are looked at (c from body 1's centre to body 2's)
// Cells     a quadtree on the faces of a cube of directions, level by level; the cube is turned so that the common normal at hand
//           is the middle of a cell of the level that first explains
// Excluded  where a witness (lowest.hpp) says so at a cell's four corners
// Explained s looks convex on the hull of the cell and of a common normal n already known: of its values at the corners, at
//           the middle and there none lies below a tangent plane at another. The plane at n is (o(n) - o) n.v, not negative
//           where n.v is not, and s lies above it
// Else      the cell is divided. A local solve starts from its middle where o is lower there, and every third level anyway:
//           what it finds becomes known
//
// What it does not promise. `Explained` looks at six points, and plain doubles are no intervals: a proof is reference/'s
// business. The number of evaluations is limited: an answer is not called converged where cells are left, or above any o
// that was seen on the way.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "solver/method/lowest.hpp"
#include "solver/shape/tangent.hpp"

namespace plumb {

template <class S, class Form, class Answer>
class DirectionSearch {
 public:
  DirectionSearch(const Form& form, const S& size, const Answer& first) : form_(form), found_(form, size, first) {
    if (found_.is_found()) centre_on(first.normal);
    const Vector3<S> forwards = form.centre() * (S(1) / largest(form.centre()));
    forwards_ = largest(forwards) <= S(2) ? forwards : axes_[0];  // else the centres coincide; 1 but for rounding
  }

  /// The lowest common normal found, with the iterations of its own solve and the evaluations of the whole search.
  [[nodiscard]] Answer lowest() {
    if (const Answer first = found_.best(); found_.is_found()) take(first);
    for (int face = 0; face < faces; ++face) push({0, 0, static_cast<std::int8_t>(face), 0, -1});
    while (!is_complete() && found_.may_go_on())
      look_at(queue_[static_cast<std::size_t>(looked_at_++ % longest_queue)]);
    return found_.answer(is_complete() && !is_too_deep_);
  }

 private:
  using Found = Lowest<S, Form, Answer>;

  static constexpr int faces = 6;
  static constexpr int deepest = 22;    // 2^-22 of a face
  static constexpr int solve_each = 3;  // levels between two local solves
  static constexpr int most_known = 16;
  static constexpr int last_witnesses = 8;  // more save no more time than they take
  static constexpr int most_fruitless = 4;  // solves in a row that find what is known
  static constexpr double explained_reach = 4,
                          longest_reach = 0.4;  // half edges of a cell, of the cube: see no further
  static constexpr int last_insisting = 700;    // a descent below
  static constexpr int most_seen = Found::most_evaluations + 8,
                       longest_queue = 4096;  // four parts of each that was seen

  /// Small, for there may be thousands. u and v have no more than `deepest` binary digits.
  struct Cell {
    float u, v;  ///< the middle
    std::int8_t face, level;
    std::int16_t witness;  ///< of the cell above; -1 for a face

    [[nodiscard]] S half() const { return S(1) / static_cast<S>(1 << level); }
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

  [[nodiscard]] bool is_complete() const { return looked_at_ == pushed_ || found_.is_settled(); }

  /// Turns the cube.
  void centre_on(const Vector3<S>& n) {
    const S half = S(1) / static_cast<S>(1 << form_.least_level());
    const Vec3<S> middle = Vec3<S>(S(1), S(3) * half, S(3) * half).normalized();
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
    const S u(c.u), v(c.v), h = c.half();
    return {on_face(c, u - h, v - h), on_face(c, u + h, v - h), on_face(c, u - h, v + h), on_face(c, u + h, v + h)};
  }

  void push(const Cell& cell) { queue_[static_cast<std::size_t>(pushed_++ % longest_queue)] = cell; }

  [[nodiscard]] bool is_mirrored(const Corners& corners) const {
    return std::all_of(corners.begin(), corners.end(), [&](const Vector3<S>& v) { return dot(v, forwards_) <= S(0); });
  }

  [[nodiscard]] bool is_excluded(const Corners& corners, const Vector3<S>& witness) const {
    return std::all_of(corners.begin(), corners.end(),
                       [&](const Vector3<S>& v) { return found_.excludes(witness, v); });
  }

  /// By what was seen of the cell above, or by one of the last.
  [[nodiscard]] bool is_excluded(const Corners& corners, int above) const {
    if (above >= 0 && is_excluded(corners, seen_[static_cast<std::size_t>(above)])) return true;
    for (int k = seen_count_; k-- > std::max(0, seen_count_ - last_witnesses);)
      if (is_excluded(corners, seen_[static_cast<std::size_t>(k)])) return true;
    return false;
  }

  void look_at(const Cell cell) {  // a copy: its place in the queue may be taken
    const Corners around = corners(cell);
    if (is_mirrored(around) || is_excluded(around, cell.witness)) return;
    const Vector3<S> middle = on_face(cell, S(cell.u), S(cell.v)), g = farthest(middle);
    const int witness = seen_count_ - 1;
    if (is_excluded(around, seen_[static_cast<std::size_t>(witness)])) return;
    const bool is_lower = found_.sees_lower(middle, g);
    if (is_lower) solve_from(middle, found_.best().evaluations < last_insisting);
    if (may_be_explained(cell, around, middle) && is_explained(cell, around, {middle, slope(middle, g)})) return;
    const bool is_due = !is_lower && cell.level > 0 && cell.level % solve_each == 0;
    if (is_due && fruitless_ < most_fruitless && !is_known_near(cell, middle)) explore_from(middle);
    if (cell.level < deepest) return divide(cell, witness);
    solve_from(middle, true);
    is_too_deep_ = is_too_deep_ || !is_explained(cell, around, {middle, slope(middle, g)});
  }

  /// Whether it is small enough for six points.
  [[nodiscard]] bool may_be_explained(const Cell& cell, const Corners& around, const Vector3<S>& middle) const {
    constexpr double margin = 1.5;  // half diagonals: a fold not far past the cell counts as well
    return cell.level >= form_.least_level() &&
           cell.level >= form_.least_level(middle, length(around[0] - middle) * S(margin));
  }

  void divide(const Cell& c, int witness) {
    const auto level = static_cast<std::int8_t>(c.level + 1);
    const float half = static_cast<float>(c.half()) / 2;
    for (const float u : {c.u - half, c.u + half})
      for (const float v : {c.v - half, c.v + half}) push({u, v, c.face, level, static_cast<std::int16_t>(witness)});
  }

  [[nodiscard]] Vector3<S> farthest(const Vector3<S>& v) {
    const Vector3<S> g = found_.farthest(v);
    seen_[static_cast<std::size_t>(seen_count_++)] = found_.witness(v, g);
    return g;
  }

  [[nodiscard]] Vector3<S> slope(const Vector3<S>& v, const Vector3<S>& g) const {
    return g - v * (found_.level() / length(v));
  }

  [[nodiscard]] bool is_explained(const Cell& cell, const Corners& around, const Sample& middle) {
    Samples samples;
    samples[0] = middle;
    std::size_t n = 1;
    for (const Vector3<S>& v : around) {
      const Vector3<S> g = farthest(v);
      if (found_.sees_lower(v, g)) return false;
      samples[n++] = {v, slope(v, g)};
    }
    if (!looks_convex(samples, n)) return false;
    const Vector3<S> outwards = on_face(cell, S(0), S(0));
    for (int k = 0; k < known_count_; ++k) {
      const Known& known = known_[static_cast<std::size_t>(k)];
      const S height = dot(known.normal, outwards);
      const bool is_beside = height > S(0.25);  // and not beyond a neighbouring face
      if (!is_beside || !is_on_this_side(around, known.normal)) continue;
      samples[n] = {known.normal * (S(1) / height), known.normal * (known.overlap - found_.level())};
      const S reach = std::min(S(longest_reach), S(explained_reach) * cell.half());
      if (largest(samples[n].v - middle.v) > reach) continue;
      if (looks_convex(samples, n + 1)) return true;
    }
    return false;
  }

  [[nodiscard]] static bool is_on_this_side(const Corners& around, const Vector3<S>& n) {
    return std::all_of(around.begin(), around.end(), [&](const Vector3<S>& v) { return dot(n, v) >= S(0); });
  }

  /// s(v) = slope.v, and above all tangent planes, to rounding. A corner or middle that is the known normal says nothing.
  [[nodiscard]] bool looks_convex(const Samples& samples, std::size_t n) const {
    const S same = by_precision<S>(1e-12, 1e-6);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        const S distance = length(samples[i].v - samples[j].v);
        const S above = dot(samples[i].slope - samples[j].slope, samples[i].v);
        if (distance > same && !(above >= -found_.rounding())) return false;
      }
    return true;
  }

  void solve_from(const Vector3<S>& v, bool insists) {
    const Answer found = found_.solve(v, insists);
    if (found.status == Status::converged) take(found);
  }

  void take(const Answer& found) {
    remember(found);
    found_.take(found);
    const bool is_backwards = dot(found.normal, form_.centre()) < -found_.rounding();  // then -n is as much lower
    if (is_backwards && found.overlap <= found_.level()) solve_from(found.normal * S(-1), true);
  }

  /// A local solve would find that one again.
  [[nodiscard]] bool is_known_near(const Cell& cell, const Vector3<S>& v) const {
    const Vector3<S> n = v * (S(1) / length(v));
    return std::any_of(known_.begin(), known_.begin() + known_count_, [&](const Known& known) {
      return largest(known.normal - n) < S(explained_reach) * cell.half();
    });
  }

  void explore_from(const Vector3<S>& v) {
    const int known = known_count_;
    solve_from(v, false);
    fruitless_ = known_count_ > known ? 0 : fruitless_ + 1;
  }

  void remember(const Answer& found) {
    const S same = by_precision<S>(1e-6, 1e-3);
    for (int k = 0; k < known_count_; ++k)
      if (largest(known_[static_cast<std::size_t>(k)].normal - found.normal) < same) return;
    if (known_count_ < most_known) known_[static_cast<std::size_t>(known_count_++)] = {found.normal, found.overlap};
  }

  const Form& form_;
  Found found_;
  Vector3<S> forwards_;
  std::array<Vector3<S>, 3> axes_{{{S(1), S(0), S(0)}, {S(0), S(1), S(0)}, {S(0), S(0), S(1)}}};
  std::array<Known, most_known> known_;
  int known_count_ = 0, fruitless_ = 0, seen_count_ = 0;
  std::array<Vector3<S>, most_seen> seen_;  ///< every witness
  std::array<Cell, longest_queue> queue_;
  int looked_at_ = 0, pushed_ = 0;
  bool is_too_deep_ = false;
};

}  // namespace plumb
