// One stationary direction: the proof that it exists, what it is, and a region in which it is the only one.
#pragma once

#include <optional>

#include "solver/reference/interval/direction_box.hpp"
#include "solver/reference/interval/interval_mpfi.hpp"
#include "solver/reference/search/chart_solve.hpp"
#include "solver/reference/search/stationary.hpp"

namespace plumb::reference {

/// A proved pair with its region: directions B L (x, y, 1), |x| and |y| <= half, B L the frame.
struct Isolated {
  StationaryPair pair;
  DirectionFrame frame;
  double half;
};

/// Whether all directions of a cell of `search` (in the world's axes) lie in the region.
template <class I>
[[nodiscard]] bool is_inside_region(const ChartedPair<I>& search, const Cell& cell, const Isolated& region);
/// The same for one direction, pair frame, in double.
[[nodiscard]] bool lies_in_region(const EnclosedPair<RoughInterval>& pair, const Vec3<double>& direction,
                                  const Isolated& region);

class Isolator {
 public:
  explicit Isolator(const Pair& pair);

  [[nodiscard]] const EnclosedPair<Interval18>& coarse() const { return coarse_; }

  /// Of bodies of revolution: the stationary direction that Newton's method finds near a unit direction (pair frame), by the functional of
  /// body 1's axis. Where the bodies all but share their axes a local solve of the charts follows the ring without end.
  [[nodiscard]] std::optional<ChartPair<Real50>> zero_near(const Vec3<double>& direction) const;

  /// The proof for a solution to 40 digits; empty where there is none.
  [[nodiscard]] std::optional<Isolated> isolate(const ChartPair<Real50>& at) const;

 private:
  [[nodiscard]] std::optional<Isolated> isolate_in(const DirectionFrame& frame, const IVec3<Interval80>& v) const;
  [[nodiscard]] std::optional<Isolated> isolate_convex(const Mat3<double>& frame, const IVec3<Interval80>& v) const;

  const Pair pair_;
  const PlacedPair<Real50> placed_;
  const EnclosedPair<Interval80> fine_;
  const EnclosedPair<Interval18> coarse_;
  const EnclosedPair<RoughInterval> rough_;
};

}  // namespace plumb::reference
