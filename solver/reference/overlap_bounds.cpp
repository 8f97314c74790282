#include "solver/reference/overlap_bounds.hpp"

#include <algorithm>
#include <limits>

#include "solver/reference/frame.hpp"
#include "solver/reference/interval/interval_double.hpp"
#include "solver/reference/proof/verify.hpp"
#include "solver/reference/search/cover_search.hpp"
#include "solver/standard_arithmetic.hpp"

namespace plumb::reference {
namespace {

constexpr double nothing_proved = -std::numeric_limits<double>::infinity();
constexpr double worthwhile_gap = 1e-12;  // relative to the size

/// A pair, and what may be the contact of lowest overlap.
struct Bounded {
  PlacedPair<double> rough;
  EnclosedPair<DoubleInterval> enclosed;
  Mat3<double> frame;  ///< its third axis is the contact's normal, to rounding
  FramedPair<DoubleInterval> framed;
  Witness points;

  Bounded(const Pair& pair, const Contact<double>& contact)
      : rough(place<double>(pair)), enclosed(enclose<DoubleInterval>(pair)), frame(frame_about(contact.normal)),
        framed(enclosed, frame), points(witness_of(rough, rough.to_pair_point(contact.point1, pair),
                                                   rough.to_pair_point(contact.point2, pair))) {}
};

/// Bodies apart: by two of their points, the centres where need be.
double lower_bound_apart(const Bounded& on) {
  const Vec3<double> centre = Vec3<double>::Zero();
  for (const Witness& points : {on.points, Witness{centre, centre}})
    if (const auto least = least_overlap_apart<DoubleInterval>(on.enclosed, points)) return low(*least);
  return nothing_proved;
}

/// By a cover of all directions.
double lower_bound_overlapping(const Bounded& on, double level, int cells) {
  const Cell third_axis{2, 1, 0, 0, 0};
  const KnownMinimum unproved{third_axis, false, on.points};
  const Settle ask_nobody = [&](const Vec3<double>&) -> Settled { return {false, level, {}}; };
  const CoverLimits limits{worthwhile_gap, cells};
  const Cover cover = search_cover(on.rough, on.frame, level, {unproved}, limits, ask_nobody).cover;
  const CoverProof proof = verify_cover<DoubleInterval>(on.framed, cover, level);
  return proof.well_formed && proof.excluded ? std::min(level, proof.least_open) : nothing_proved;
}

}  // namespace

OverlapBounds bound_overlap(const Pair& pair, const Contact<double>& contact, int cells) {
  const StandardArithmetic mode;
  const Bounded on(pair, contact);
  const double upper = high(overlap_at<DoubleInterval>(on.framed, {0.0, 0.0, 1.0}));
  const double lower = upper < 0 ? lower_bound_apart(on) : lower_bound_overlapping(on, upper, cells);
  const auto in_world = [&](double x) { return times_power_of_two<DoubleInterval>(x, on.enclosed.exponent); };
  return {low(in_world(lower)), high(in_world(upper))};
}

}  // namespace plumb::reference
