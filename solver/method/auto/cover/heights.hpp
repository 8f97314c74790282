// A cover of two ellipsoids' support heights, for the lowest o.
//
// On directions n whose h1 = |A1 n| is in [a, a'] the root's chord over the squares is not above it,
//     h1 >= (|A1 n|^2 + a a') / (a + a')
// and the same of h2 in [b, b']. With M = A1'A1 / (a + a') + A2'A2 / (b + b') all such n have
//     o(n) >= a a' / (a + a') + b b' / (b + b') + n.M n - n.c
// The minimum over ALL unit n is known (sphere_minimum.hpp). Outside of [a, a'] the chord is above the root. So the bound is
// below the lowest o by the chords' loss alone, the square of a cell's width. That holds as well where the lowest common
// normals are a circle, or nearly one, or mirror images of each other: those have the same two heights.
//
// Cells      rectangles of heights, the one of the lowest bound first
// Excluded   where the bound is not below the incumbent's
// Divided    else, at the height of the bound's direction. o is evaluated there, and a local solve starts where it is lower
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "solver/method/auto/budgets.hpp"
#include "solver/method/auto/cover/cell_heap.hpp"
#include "solver/method/auto/cover/incumbent.hpp"
#include "solver/method/auto/cover/sphere_minimum.hpp"
#include "solver/method/auto/ellipsoid/ellipsoids.hpp"

namespace plumb {

template <class S, class Solver>
class HeightCover {
 public:
  using Incumbent = plumb::Incumbent<S, Solver>;

  HeightCover(Incumbent& incumbent, const EllipsoidPair<S>& pair) : incumbent_(incumbent), pair_(pair) {}

  void start() { push(whole()); }
  [[nodiscard]] bool is_empty() const { return cells_.is_above(incumbent_.excluded_overlap()); }
  [[nodiscard]] static bool has_left_out() { return false; }

  void look_at_next() { look_at(cells_.pop().ends); }

 private:
  // Each that is looked at becomes two, by one more height.
  static constexpr std::size_t most_cells = budget::last_search + 2, most_heights = budget::last_search + 4;
  static constexpr double least_share = 0.25;  // of a cell's width on either side of a cut

  /// Of one body's heights.
  struct Range {
    S low, high;

    /// Of the root's chord over the squares.
    [[nodiscard]] S slope() const { return S(1) / (low + high); }
    /// How far the chord is below the root; less than 0 outside.
    [[nodiscard]] S loss(const S& height) const { return (height - low) * (high - height) * slope(); }
    [[nodiscard]] S cut(const S& height) const {
      const S least = (high - low) * S(least_share);
      return std::clamp(height, S(low + least), S(high - least));
    }
  };

  struct Rectangle {
    Range of1, of2;
  };

  /// Where heights_ has the ends of a rectangle.
  using Place = std::uint16_t;
  struct Ends {
    Place low1, high1, low2, high2;
  };

  /// Small, for there may be many and they are on the stack: the rest is computed again where a cell is looked at.
  struct Cell {
    S bound;
    Ends ends;
  };

  /// A direction along which a bound would be reached.
  struct Seen {
    Vector3<S> n;
    Touch<S> there;
    S height1, height2;
  };

  [[nodiscard]] Ends whole() {
    using std::max;
    using std::min;
    const Vector3<PerBody<S>>& a = pair_.semi_axes;
    const PerBody<S> least = min(a.x, min(a.y, a.z)), longest = max(a.x, max(a.y, a.z));
    return {add(first<S>(least)), add(first<S>(longest)), add(second<S>(least)), add(second<S>(longest))};
  }

  [[nodiscard]] Place add(const S& height) {
    heights_[height_count_] = height;
    return static_cast<Place>(height_count_++);
  }

  [[nodiscard]] Rectangle rectangle(const Ends& ends) const {
    return {{heights_[ends.low1], heights_[ends.high1]}, {heights_[ends.low2], heights_[ends.high2]}};
  }

  [[nodiscard]] Seen see(const Rectangle& cell) const {
    Seen out;
    const SphereMinimum<S> least(sum(pair_.square * per_body<S>(cell.of1.slope(), cell.of2.slope())), pair_.c * S(0.5));
    out.n = least.direction();
    out.there = touch(pair_, out.n);  // the square of a needle's map has lost the digits of its short axes
    out.height1 = first<S>(out.there.h);
    out.height2 = second<S>(out.there.h);
    return out;
  }

  void push(const Ends& ends) {
    const Rectangle cell = rectangle(ends);
    const Seen seen = see(cell);
    const S bound =
        sum<S>(seen.there.h) - dot(seen.n, pair_.c) - cell.of1.loss(seen.height1) - cell.of2.loss(seen.height2);
    if (bound >= incumbent_.excluded_overlap()) return;
    cells_.push({bound, ends});
  }

  void look_at(const Ends& ends) {
    const Rectangle cell = rectangle(ends);
    const auto [n, there, height1, height2] = see(cell);
    incumbent_.count();
    if (incumbent_.sees_lower(n, sum(there.p) - pair_.c)) incumbent_.solve_from(n, Attempts::several);
    Ends low = ends, high = ends;
    if (cell.of1.loss(height1) > cell.of2.loss(height2))
      low.high1 = high.low1 = add(cell.of1.cut(height1));
    else
      low.high2 = high.low2 = add(cell.of2.cut(height2));
    push(low);
    push(high);
  }

  Incumbent& incumbent_;
  const EllipsoidPair<S>& pair_;
  CellHeap<Cell, most_cells> cells_;
  std::array<S, most_heights> heights_;
  std::size_t height_count_ = 0;
};

}  // namespace plumb
