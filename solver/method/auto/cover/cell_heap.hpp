// The cells of a cover whose lowest comes first, on the stack. Cell has a `bound`: no direction in it has a lower overlap.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace plumb {

template <class Cell, std::size_t most>
class CellHeap {
 public:
  /// Whether no cell has a bound below `level`.
  template <class S>
  [[nodiscard]] bool is_above(const S& level) const {
    return count_ == 0 || cells_[0].bound >= level;
  }
  void push(const Cell& cell) {
    cells_[count_++] = cell;
    std::push_heap(cells_.begin(), end(), is_higher);
  }
  /// That of the lowest bound.
  [[nodiscard]] Cell pop() {
    std::pop_heap(cells_.begin(), end(), is_higher);
    return cells_[--count_];
  }

 private:
  [[nodiscard]] static bool is_higher(const Cell& a, const Cell& b) { return a.bound > b.bound; }
  [[nodiscard]] auto end() { return cells_.begin() + static_cast<std::ptrdiff_t>(count_); }

  std::array<Cell, most> cells_;
  std::size_t count_ = 0;
};

}  // namespace plumb
