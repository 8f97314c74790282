// Cells of directions: a quadtree on the faces of a cube, and those of them that wait to be looked at.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "solver/method/vector3.hpp"

namespace plumb {

template <class S>
struct DirectionCell {
  std::int32_t u, v;  ///< the middle, in half edges of the cell
  int face, depth;

  static constexpr int faces = 6, parts = 4;
  static constexpr int deepest = 26;

  [[nodiscard]] S half() const { return S(1) / static_cast<S>(1 << depth); }

  /// So many half edges off the middle.
  [[nodiscard]] Vector3<S> at(int off_u, int off_v) const {
    const S w = face % 2 == 0 ? S(1) : S(-1), x = S(u + off_u) * half(), y = S(v + off_v) * half();
    if (face < 2) return {w, x, y};
    return face < 4 ? Vector3<S>{y, w, x} : Vector3<S>{x, y, w};
  }
  [[nodiscard]] Vector3<S> middle() const { return at(0, 0); }

  [[nodiscard]] std::array<Vector3<S>, parts> corners() const {
    return {unit(at(-1, -1)), unit(at(1, -1)), unit(at(-1, 1)), unit(at(1, 1))};
  }

  [[nodiscard]] DirectionCell part(int index) const {
    return {2 * u + (index < 2 ? -1 : 1), 2 * v + (index % 2 == 0 ? -1 : 1), face, depth + 1};
  }
};

/// The parts of divided cells, first in, first out, each with a witness of the cell above. All of it is on the stack: it holds what was
/// divided, not the parts, and no longer than a part of it waits.
/// `most_divided`: how many are ever pushed. They come from the faces and the parts that are out, 6 + 4 k when k are out, so that of n
/// that were pushed no more than (3 n + 6) / 4 wait.
template <class S, int most_divided>
class DirectionQueue {
 public:
  using Cell = DirectionCell<S>;

  void push(const Cell& divided, const Vector3<S>& witness) {
    waiting_[static_cast<std::size_t>(place(first_ + count_++))] = {divided.u * depths + divided.depth,
                                                                    divided.v * all_faces + divided.face, witness};
  }

  [[nodiscard]] bool is_empty() const { return count_ == 0 && next_part_ == Cell::parts; }

  [[nodiscard]] Cell next() {
    if (next_part_ == Cell::parts) take_first();
    return above_.part(next_part_++);
  }

  /// Of the cell above the one that next() gave.
  [[nodiscard]] const Vector3<S>& witness() const { return witness_; }

 private:
  static constexpr int capacity = (3 * most_divided + Cell::faces) / 4;
  static constexpr int depth_bits = 5, face_bits = 3;  // of a number that u or v shares
  static constexpr int depths = 1 << depth_bits, all_faces = 1 << face_bits;
  static_assert(Cell::deepest < depths && Cell::faces <= all_faces && Cell::deepest + depth_bits <= 31);

  struct Divided {
    std::int32_t u_and_depth, v_and_face;
    Vector3<S> witness;
  };

  [[nodiscard]] static int place(int index) { return index < capacity ? index : index - capacity; }

  void take_first() {
    const Divided& first = waiting_[static_cast<std::size_t>(first_)];
    above_ = {first.u_and_depth >> depth_bits, first.v_and_face >> face_bits, first.v_and_face & (all_faces - 1),
              first.u_and_depth & (depths - 1)};
    witness_ = first.witness;
    first_ = place(first_ + 1);
    --count_;
    next_part_ = 0;
  }

  std::array<Divided, static_cast<std::size_t>(capacity)> waiting_;
  int first_ = 0, count_ = 0, next_part_ = Cell::parts;
  Cell above_;
  Vector3<S> witness_;
};

}  // namespace plumb
