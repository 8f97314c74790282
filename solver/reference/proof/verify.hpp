// The verifier of a cover: no search, only checks, in interval arithmetic. This file and enclosure.hpp are all that has
// to be believed, with the intervals (of a stored proof: MPFI).
#pragma once

#include <optional>

#include "solver/reference/cover.hpp"
#include "solver/reference/interval/enclosure.hpp"

namespace plumb::reference {

/// A region where o has one stationary direction at most, and how near the given solution is to it.
template <class I>
struct RegionProof {
  bool convex = false;   ///< o has at most one stationary direction in the region, and it is the lowest there
  bool located = false;  ///< there is one, within `radius` of the given solution
  I value = I(0.0);      ///< o at the given solution
  I gradient = I(0.0);   ///< of s - value |F v| by the chart's coordinates there: 0 at a solution; an upper bound
  I curvature = I(0.0);  ///< lower bound of the least eigenvalue of the Hessian of s - o |F v| on the region
  I radius = I(0.0);     ///< chart distance
  I deficit = I(0.0);    ///< o >= value - deficit on the region
};

/// The pair with a cover's frame, and what every check needs of the two.
template <class I>
struct FramedPair {
  EnclosedPair<I> pair;
  IMat3<I> frame, gram;         ///< F, F'F
  I longest, shortest;          ///< shortest |v| <= |F v| <= longest |v|
  IMat3<I> to_q1, to_q2;        ///< diag(semi-axes) R' F: from a chart point to a body's q
  IMat3<I> to_body1, to_body2;  ///< R' F

  FramedPair(const EnclosedPair<I>& enclosed, const Mat3<double>& f);
};

/// A box in the chart coordinates of a region's face.
struct Reach {
  double low_u = std::numeric_limits<double>::infinity(), high_u = -low_u, low_v = low_u, high_v = -low_u;
};

/// What the cover proves.
struct CoverProof {
  bool well_formed = false;  ///< the leaves cover every face, every witness lies in its body
  bool excluded = false;     ///< every leaf marked `excluded` or `convex` is rightly so marked
  double least_open = std::numeric_limits<double>::infinity();  ///< lower bound of o over the open leaves
  std::vector<Reach> reach;  ///< of each region, the part that leaves marked `bounded` take up
  int witnesses = 0;
};

/// Checks the cover against `level` >= 0: every excluded leaf has o > level. W: the intervals of the one test that takes
/// powers, whether the witnesses lie in the bodies.
template <class I, class W>
[[nodiscard]] CoverProof verify_cover(const FramedPair<I>& pair, const EnclosedPair<W>& bodies, const Cover& cover,
                                      double level);
template <class I>
[[nodiscard]] CoverProof verify_cover(const FramedPair<I>& pair, const Cover& cover, double level) {
  return verify_cover<I, I>(pair, pair.pair, cover, level);
}

/// o at a chart point.
template <class I>
[[nodiscard]] I overlap_at(const FramedPair<I>& pair, const IVec3<I>& chart);

/// Lower bound of the least eigenvalue of the Hessian of s - o |F v| on the region; not above zero where none is found.
template <class I>
[[nodiscard]] I curvature_on(const FramedPair<I>& pair, const Cell& region);

/// By all the forms that curvature_on tries, and so not below what it gives on any region that holds this one.
template <class I>
[[nodiscard]] I highest_curvature_on(const FramedPair<I>& pair, const Cell& region);

/// o at a chart point, and what its slopes there take.
template <class I>
struct OverlapAt {
  I value;
  IVec3<I> direction;  ///< F v
  I length;            ///< |F v|
  IVec3<I> reach;      ///< p1 - p2 of the support points: the derivative of s by the direction

  /// Of s - value |F v|, along a column of the frame.
  [[nodiscard]] I slope(const IVec3<I>& column) const {
    return dot<I>(reach, column) - value * dot<I>(direction, column) / length;
  }
};
template <class I>
[[nodiscard]] OverlapAt<I> support_at(const FramedPair<I>& pair, const IVec3<I>& chart);

/// o at a chart point of a face, and the length of the gradient of s - value |F v| there, an upper bound.
template <class I>
struct Slope {
  I value, gradient;
};
template <class I>
[[nodiscard]] Slope<I> slope_at(const FramedPair<I>& pair, int axis, const IVec3<I>& chart);

/// What follows for the region from a lower bound of its curvature and the slope at a chart point of its face.
template <class I>
[[nodiscard]] RegionProof<I> proof_on(const Cell& region, const I& curvature, const IVec3<I>& chart,
                                      const Slope<I>& slope, const I& shortest);

/// o and the proof of convexity on `region` for the solution at `chart` (a chart point of the region's face).
template <class I>
[[nodiscard]] RegionProof<I> verify_region(const FramedPair<I>& pair, const Cell& region, const IVec3<I>& chart);

/// p1 - p2 (pair frame): o(n) >= n.(p1 - p2) for every n. Nothing when a witness is not proved to lie in its body.
template <class I>
[[nodiscard]] std::optional<IVec3<I>> points_apart(const EnclosedPair<I>& pair, const Witness& witness);

/// Bodies apart: o is minus the distance, which no two points of the bodies undercut. Nothing when a witness is not proved to
/// lie in its body.
template <class I>
[[nodiscard]] std::optional<I> least_overlap_apart(const EnclosedPair<I>& pair, const Witness& witness);

/// Unit normal and support points (pair frame) of every direction F v, v in a box of chart points.
template <class I>
struct DirectionEnclosure {
  IVec3<I> normal, point1, point2;
};
template <class I>
[[nodiscard]] DirectionEnclosure<I> enclose_direction(const FramedPair<I>& pair, const IVec3<I>& box);

}  // namespace plumb::reference
