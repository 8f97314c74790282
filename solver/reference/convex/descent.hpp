// Low directions of a pair of cores, and the mixtures of points that bound the overlap near them, in double. Nothing here has to be
// right for a bound to be right.
#pragma once

#include "solver/reference/convex/mixture.hpp"
#include "solver/reference/convex/placed_cores.hpp"

namespace plumb::reference::cores {

/// A unit direction and the overlap of the cores there.
struct LowDirection {
  Vec3<double> n;
  double overlap;
};

/// Points of A with weights that are not negative.
struct Mixture {
  std::vector<Atom> atoms;
  std::vector<double> weights;
  double value;  ///< min over a cell's corners c of its w.c
};

/// When the search in a cell may stop: once the mixture is known to have the value asked for, or that there is none of it.
struct Enough {
  double value;  ///< that is asked for
  double level;  ///< the lowest overlap known; the defect below it is found to a tenth
};

/// The mixture of greatest value in a cell of unit corners. `start`: atoms that may be of use. `lowest` learns of lower directions.
[[nodiscard]] Mixture mixture_in(const PlacedCores& pair, const CornersOfCell& corners, std::vector<Atom> start,
                                 const Enough& enough, LowDirection& lowest);

/// The point of A nearest to the origin; the origin itself where the cores overlap.
[[nodiscard]] Mixture nearest_point(const PlacedCores& pair);
[[nodiscard]] Mixture nearest_point_from(const PlacedCores& pair, Mixture start);
/// The point nearest to the line through the origin along a unit n, of those of A that are farthest along n, to rounding: a face of a
/// plate is told from its other face.
[[nodiscard]] Mixture nearest_on_face(const PlacedCores& pair, const Vec3<double>& n);
[[nodiscard]] Vec3<double> mixed(const Mixture& mixture);

/// Downhill from a direction to the lowest one near it, with the mixture that shows how low the overlap may be there.
struct Descent {
  LowDirection lowest;
  Mixture mixture;
};
[[nodiscard]] Descent descend(const PlacedCores& pair, const Vec3<double>& from);

[[nodiscard]] LowDirection along(const PlacedCores& pair, const Vec3<double>& v);

}  // namespace plumb::reference::cores
