// Whether some mixture of witnesses shows that no direction of a cell is lower: a matrix game.
//
// Bodies and their Minkowski sum are convex: a mixture of witnesses (incumbent.hpp) is a witness. The best one is the highest
// at the corner where it is the lowest. That is a game of witnesses against corners. Its other half is the place in the cell
// where the best of the witnesses is the lowest: a new witness tells most there. Between two flats one witness lies on either
// side of a groove of o. Neither excludes a cell on the groove; a mixture of the two does.
//
// The corners' linear program (max sum p, sum over corners of p h <= 1 for each witness, h > 0 the heights) has a start, p = 0,
// and 4 unknowns: the simplex method on a condensed tableau, a row a witness. The caller tests whether the mixture excludes
// the cell: rounding costs mixtures, not truth.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "solver/method/auto/tolerances.hpp"
#include "solver/method/vector3.hpp"
#include "solver/scalar.hpp"

namespace plumb {

/// Whether a witness is as high as that at every corner, unit.
template <class S, std::size_t corner_count>
[[nodiscard]] inline bool reaches(const Vector3<S>& witness, const S& height,
                                  const std::array<Vector3<S>, corner_count>& corners) {
  return std::all_of(corners.begin(), corners.end(), [&](const Vector3<S>& v) { return dot(witness, v) >= height; });
}

template <class S>
class MixtureBound {
 public:
  static constexpr std::size_t corner_count = 4, most_witnesses = 16;
  using Corners = std::array<Vector3<S>, corner_count>;  ///< unit

  void add(const Vector3<S>& witness) { witnesses_[count_++] = witness; }
  [[nodiscard]] bool is_full() const { return count_ == most_witnesses; }

  struct Best {
    Vector3<S> mixture;  ///< of witnesses
    Vector3<S> place;    ///< of corners, of any length: where no witness reaches the height, or the lowest
  };

  /// Ends where it is clear that no mixture is as high as `height` at every corner.
  [[nodiscard]] Best solve(const Corners& corners, const S& height) {
    set_up(corners);
    const S wanted = (height - lowest_) * scale_ + S(1);
    for (int pivots = 0; pivots < most_pivots && total_ * wanted <= S(1); ++pivots) {
      const std::size_t column = entering(), row = leaving(column);
      if (!(objective_[column] > tolerance::least_gain.of<S>()) || row == count_) break;
      pivot(row, column);
    }
    return best(corners);
  }

  /// One of them that is as high as that at every corner, by its number.
  [[nodiscard]] std::optional<std::size_t> one_that_reaches(const S& height, const Corners& corners) const {
    for (std::size_t j = 0; j < count_; ++j)
      if (plumb::reaches(witnesses_[j], height, corners)) return j;
    return std::nullopt;
  }

  /// How much of each witness is in the mixture that `solve` found last.
  [[nodiscard]] std::array<S, most_witnesses> shares() const {
    std::array<S, most_witnesses> out{};
    S all(0);
    for (std::size_t k = 0; k < corner_count; ++k)
      if (of_column_[k] >= corner_count && objective_[k] < S(0))
        all += out[of_column_[k] - corner_count] = -objective_[k];
    if (!(all > S(0))) out[0] = all = S(1);
    for (S& share : out) share = share / all;
    return out;
  }

  /// Whether one of them shows that o along v is as high as that.
  [[nodiscard]] bool reaches(const S& height, const Vector3<S>& v) const {
    const S least = height * length(v);
    return std::any_of(witnesses_.begin(), witnesses_.begin() + static_cast<std::ptrdiff_t>(count_),
                       [&](const Vector3<S>& witness) { return dot(witness, v) >= least; });
  }

 private:
  static constexpr int most_pivots = 24;
  using Row = std::array<S, corner_count>;

  /// Heights between 1 and 2.
  void set_up(const Corners& corners) {
    S highest = lowest_ = dot(witnesses_[0], corners[0]);
    for (std::size_t j = 0; j < count_; ++j)
      for (std::size_t k = 0; k < corner_count; ++k) {
        const S height = rows_[j][k] = dot(witnesses_[j], corners[k]);
        lowest_ = std::min(lowest_, height);
        highest = std::max(highest, height);
      }
    scale_ = highest > lowest_ ? S(1) / (highest - lowest_) : S(1);
    for (std::size_t j = 0; j < count_; ++j) {
      for (S& height : rows_[j]) height = (height - lowest_) * scale_ + S(1);
      right_[j] = S(1);
      of_row_[j] = corner_count + j;
    }
    for (std::size_t k = 0; k < corner_count; ++k) of_column_[k] = k;
    objective_.fill(S(1));
    total_ = S(0);
  }

  [[nodiscard]] std::size_t entering() const {
    return static_cast<std::size_t>(std::max_element(objective_.begin(), objective_.end()) - objective_.begin());
  }

  /// None, `count_`, only by rounding: the heights are positive, so that every unknown has a limit.
  [[nodiscard]] std::size_t leaving(std::size_t column) const {
    std::size_t best = count_;
    for (std::size_t j = 0; j < count_; ++j) {
      const S& entry = rows_[j][column];
      if (!(entry > tolerance::least_gain.of<S>())) continue;
      if (best == count_ || right_[j] * rows_[best][column] < right_[best] * entry) best = j;
    }
    return best;
  }

  void pivot(std::size_t row, std::size_t column) {
    const S inverse = S(1) / rows_[row][column];
    Row pivot_row = rows_[row];
    pivot_row[column] = S(1);
    for (S& value : pivot_row) value *= inverse;
    const S right = right_[row] * inverse;
    for (std::size_t j = 0; j < count_; ++j) right_[j] -= eliminate(rows_[j], pivot_row, column) * right;
    total_ += eliminate(objective_, pivot_row, column) * right;
    rows_[row] = pivot_row;
    right_[row] = right;
    std::swap(of_row_[row], of_column_[column]);
  }

  /// What the pivot row was taken off by.
  [[nodiscard]] static S eliminate(Row& row, const Row& pivot_row, std::size_t column) {
    const S factor = std::exchange(row[column], S(0));
    for (std::size_t k = 0; k < corner_count; ++k) row[k] -= factor * pivot_row[k];
    return factor;
  }

  [[nodiscard]] Best best(const Corners& corners) const {
    const Vector3<S> none{S(0), S(0), S(0)};
    Best out{none, none};
    S shares(0);
    for (std::size_t k = 0; k < corner_count; ++k)
      if (of_column_[k] >= corner_count && objective_[k] < S(0)) {
        out.mixture = out.mixture - witnesses_[of_column_[k] - corner_count] * objective_[k];
        shares -= objective_[k];
      }
    out.mixture = shares > S(0) ? out.mixture * (S(1) / shares) : witnesses_[0];
    for (std::size_t j = 0; j < count_; ++j)
      if (of_row_[j] < corner_count) out.place = out.place + corners[of_row_[j]] * right_[j];
    return out;
  }

  std::array<Vector3<S>, most_witnesses> witnesses_;
  std::size_t count_ = 0;
  std::array<Row, most_witnesses> rows_;  ///< the tableau
  std::array<S, most_witnesses> right_;
  Row objective_;
  S total_;
  std::array<std::size_t, most_witnesses> of_row_;  ///< corner k is k, witness j is 4 + j
  std::array<std::size_t, corner_count> of_column_;
  S lowest_, scale_;  ///< of the heights
};

}  // namespace plumb
