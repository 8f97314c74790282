#include "solver/reference/meridian.hpp"

#include <algorithm>

#include "solver/reference/interval_double.hpp"

namespace plumb::reference {
namespace {

/// |a - b| or |a + b|, the lesser: of two lines.
template <class I>
I distance_of_lines(const IVec3<I>& a, const IVec3<I>& b) {
  const I minus = length_of<I>(a - b), plus = length_of<I>(a + b);
  return high(minus) < high(plus) ? minus : plus;
}

/// How much a body's support function may change in a turn about `axis` (unit): see asymmetry.
template <class I>
I body_asymmetry(const EnclosedBody<I>& body, const Superellipsoid<double>& shape, const IVec3<I>& axis) {
  if (is_sphere(shape)) return I(0.0);
  const auto own = axis_of_revolution(shape);
  if (!own) return I(std::numeric_limits<double>::infinity());
  const I reach = root<I>(I(square<I>(body.semi_axes[*own]) + square<I>(body.semi_axes[(*own + 1) % 3])));
  return I(2.0) * reach * distance_of_lines<I>(body.rotation.col(*own), axis);
}

/// |F v| is convex and the tangent plane's v.w linear: where w.v >= 0 their quotient is least at an end.
template <class I>
double least_at(const FramedPair<I>& framed, double place, const IVec3<I>& apart) {
  const IVec3<I> direction = framed.frame * chart_at<I>(place);
  const I above = dot<I>(direction, apart);
  return low(above) >= 0 ? low(I(above / length_of<I>(direction))) : -std::numeric_limits<double>::infinity();
}

/// From 0 to 4 with the corners among the places, so that every arc is a straight line of chart points.
bool is_half_circle(const std::vector<double>& places) {
  const auto holds = [&](double corner) { return std::find(places.begin(), places.end(), corner) != places.end(); };
  const auto is_not_after = [](double a, double b) { return !(a < b); };
  return holds(1) && holds(3) && places.front() == 0 && places.back() == 4 &&
         std::adjacent_find(places.begin(), places.end(), is_not_after) == places.end();
}

}  // namespace

bool is_sphere(const Superellipsoid<double>& shape) {
  const Vec3<double>& a = shape.semi_axes;
  return shape.n1 == 2 && shape.n2 == 2 && a[0] == a[1] && a[1] == a[2];
}

std::optional<int> axis_of_revolution(const Superellipsoid<double>& shape) {
  if (shape.n2 != 2) return {};
  const Vec3<double>& a = shape.semi_axes;
  if (a[0] == a[1]) return 2;
  if (shape.n1 != 2) return {};
  if (a[1] == a[2]) return 0;
  return a[0] == a[2] ? std::optional(1) : std::nullopt;
}

template <class I>
I lowest_overlap_of_spheres(const EnclosedPair<I>& pair) {
  return pair.body1.semi_axes[0] + pair.body2.semi_axes[0] - length_of<I>(pair.centre);
}

// A turn Q about the axis f takes any direction n to the meridian. A body of revolution about e is at most |e - f| R from one
// about f, R its circumradius, and so is its support function: |h(Qn) - h(n)| <= 2 |e - f| R. And |n.c - Qn.c| is at most
// twice the distance of c from the axis.
template <class I>
I asymmetry(const Pair& pair, const FramedPair<I>& framed) {
  const IVec3<I> third = framed.frame.col(2), axis = third / length_of<I>(third), &c = framed.pair.centre;
  const I along = dot<I>(c, axis);
  const IVec3<I> across = c - axis * along;
  return body_asymmetry<I>(framed.pair.body1, pair.body1.shape, axis) +
         body_asymmetry<I>(framed.pair.body2, pair.body2.shape, axis) + I(2.0) * length_of<I>(across);
}

template <class I>
double least_on(const FramedPair<I>& framed, const Arc& arc, const IVec3<I>& apart) {
  return std::min(least_at<I>(framed, arc.first, apart), least_at<I>(framed, arc.last, apart));
}

template <class I>
MeridianProof verify_meridian(const Pair& pair, const FramedPair<I>& framed, const Meridian& meridian) {
  const auto& [places, witnesses] = meridian;
  MeridianProof out;
  if (places.size() != witnesses.size() + 1 || !is_half_circle(places)) return out;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < witnesses.size(); ++i) {
    const auto apart = points_apart<I>(framed.pair, witnesses[i]);
    if (!apart) return out;
    least = std::min(least, least_on<I>(framed, {places[i], places[i + 1]}, *apart));
  }
  out.well_formed = true;
  out.least = low(I(I(least) - high_end<I>(asymmetry<I>(pair, framed))));
  return out;
}

#define PLUMB_INSTANTIATE_MERIDIAN(I)                                          \
  template I lowest_overlap_of_spheres(const EnclosedPair<I>&);                \
  template I asymmetry(const Pair&, const FramedPair<I>&);                     \
  template double least_on(const FramedPair<I>&, const Arc&, const IVec3<I>&); \
  template MeridianProof verify_meridian(const Pair&, const FramedPair<I>&, const Meridian&);

PLUMB_INSTANTIATE_MERIDIAN(DoubleInterval)
PLUMB_INSTANTIATE_MERIDIAN(Interval18)
PLUMB_INSTANTIATE_MERIDIAN(Interval80)

}  // namespace plumb::reference
