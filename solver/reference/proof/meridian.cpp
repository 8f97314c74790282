#include "solver/reference/proof/meridian.hpp"

#include <algorithm>
#include <cmath>

#include "solver/reference/interval/interval_double.hpp"
#include "solver/reference/interval/interval_mpfi.hpp"
#include "solver/reference/meter.hpp"

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

/// Lower bound of a body's support Hessian along one chart coordinate.
template <class I>
I support_curvature(const EnclosedBody<I>& body, const IVec3<I>& q, const IVec3<I>& column) {
  ChartMap<I> map;
  map << column, IVec3<I>::Constant(I(0.0));
  I best(0.0);
  for (const HessianTerms<I>& terms : {hessian_terms<I>(body, q, map), hessian_floor<I>(body, q, map)}) {
    I sum(0.0);
    for (const RankOne<I>& term : terms)
      if (is_positive(term.weight)) sum += term.weight * square<I>(term.vector[0]);
    if (low(sum) > low(best)) best = low_end<I>(sum);
  }
  return best;
}

/// Lower bound of the second derivative of s - c |F v| along one chart coordinate, c >= 0 exact: see LengthHessian.
template <class I>
I curvature_along(const FramedPair<I>& framed, const IVec3<I>& box, int along, const I& c) {
  const I length = length_of<I>(box), least = framed.shortest * low_end<I>(length),
          greatest = framed.longest * high_end<I>(length);
  const I inwards = dot<I>(framed.gram.col(along), box);
  return low_end<I>(support_curvature<I>(framed.pair.body1, framed.to_q1 * box, framed.to_q1.col(along)) +
                    support_curvature<I>(framed.pair.body2, framed.to_q2 * box, framed.to_q2.col(along)) +
                    c * square<I>(inwards) / (greatest * square<I>(greatest)) - c * square<I>(framed.longest) / least);
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

// On the arc s - o0 |F v| (o0 = o at the place) is zero at the place, convex with second derivative mu at least, and so above
// -slope^2 / (2 mu).
template <class I>
std::optional<I> least_in(const FramedPair<I>& framed, const Valley& valley) {
  const auto& [first, last, high_part, low_part] = valley;
  for (const double corner : {1.0, 3.0})
    if (first < corner && corner < last) return {};
  const I place = I(high_part) + I(low_part);
  if (!(low(I(place - I(first))) >= 0 && low(I(I(last) - place)) >= 0)) return {};
  const double side = first < 1 ? 0 : (first < 3 ? 2 : 4);  // a place between the same corners
  const int along = side == 2 ? 2 : 0;
  const OverlapAt<I> at = support_at<I>(framed, chart_at<I>(place, side));
  if (!(low(at.value) >= 0)) return {};
  const IVec3<I> one = chart_at<I>(I(first), side), other = chart_at<I>(I(last), side);
  const IVec3<I> box{hull<I>(one[0], other[0]), hull<I>(one[1], other[1]), hull<I>(one[2], other[2])};
  const I curvature = curvature_along<I>(framed, box, along, high_end<I>(at.value));
  if (!is_positive(curvature)) return {};
  const I slope = at.slope(framed.frame.col(along));
  return low_end<I>(I(at.value - square<I>(slope) / (I(2.0) * curvature * framed.shortest)));
}

namespace {

/// The highest bound of the valleys that hold an arc, for arcs in their order: of those that have begun one that ends too early
/// is dropped, for later arcs end later still. n log n, however many lie over one another.
template <class I>
class ValleysAlong {
 public:
  ValleysAlong(const FramedPair<I>& framed, const std::vector<Valley>& valleys) {
    for (const Valley& valley : valleys)
      if (const auto least = least_in<I>(framed, valley); least && std::isfinite(low(*least)))
        bounded_.push_back({valley.first, valley.last, *least});
    std::sort(bounded_.begin(), bounded_.end(), [](const Bounded& a, const Bounded& b) { return a.first < b.first; });
  }

  /// nullptr where none holds it.
  [[nodiscard]] const I* over(const Arc& arc) {
    const auto is_worse = [this](std::size_t a, std::size_t b) {
      count_work(nanoseconds_of_a_comparison);
      return is_lower<I>(bounded_[a].least, bounded_[b].least);
    };
    for (; next_ < bounded_.size() && bounded_[next_].first <= arc.first; ++next_) {
      begun_.push_back(next_);
      std::push_heap(begun_.begin(), begun_.end(), is_worse);
    }
    while (!begun_.empty() && bounded_[begun_.front()].last < arc.last) {
      std::pop_heap(begun_.begin(), begun_.end(), is_worse);
      begun_.pop_back();
    }
    return begun_.empty() ? nullptr : &bounded_[begun_.front()].least;
  }

 private:
  struct Bounded {
    double first, last;
    I least;
  };

  std::vector<Bounded> bounded_;  ///< by their beginnings
  std::size_t next_ = 0;
  std::vector<std::size_t> begun_;  ///< a heap, the highest bound in front
};

}  // namespace

template <class I>
MeridianProof<I> verify_meridian(const Pair& pair, const FramedPair<I>& framed, const Meridian& meridian) {
  const auto& [places, witnesses, valleys] = meridian;
  MeridianProof<I> out;
  if (places.size() != witnesses.size() + 1 || !is_half_circle(places)) return out;
  const I infinite(std::numeric_limits<double>::infinity());
  ValleysAlong<I> along(framed, valleys);
  I least = infinite;
  for (std::size_t i = 0; i < witnesses.size(); ++i) {
    const auto apart = points_apart<I>(framed.pair, witnesses[i]);
    if (!apart) return out;
    const Arc arc{places[i], places[i + 1]};
    I bound(least_on<I>(framed, arc, *apart));
    if (const I* valley = along.over(arc); valley != nullptr && is_lower<I>(bound, *valley)) bound = *valley;
    if (is_lower<I>(bound, least)) least = bound;
  }
  out.well_formed = true;
  if (std::isfinite(low(least))) out.least = low_end<I>(I(least - asymmetry<I>(pair, framed)));
  return out;
}

#define PLUMB_INSTANTIATE_MERIDIAN(I)                                          \
  template I lowest_overlap_of_spheres(const EnclosedPair<I>&);                \
  template I asymmetry(const Pair&, const FramedPair<I>&);                     \
  template double least_on(const FramedPair<I>&, const Arc&, const IVec3<I>&); \
  template std::optional<I> least_in(const FramedPair<I>&, const Valley&);     \
  template MeridianProof<I> verify_meridian(const Pair&, const FramedPair<I>&, const Meridian&);

PLUMB_INSTANTIATE_MERIDIAN(DoubleInterval)
PLUMB_INSTANTIATE_MERIDIAN(Interval18)
PLUMB_INSTANTIATE_MERIDIAN(Interval80)

}  // namespace plumb::reference
