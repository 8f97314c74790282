#include "solver/reference/revolution.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "solver/reference/cover_search.hpp"
#include "solver/reference/interval_double.hpp"

namespace plumb::reference {
namespace {

constexpr double rounding_of_case = 1e-14;  // relative to the size, far below the gap of the bounds
constexpr int most_meridian_cells = 20'000;

/// The body axis of revolution: z of a superellipsoid, the unequal one of a spheroid.
std::optional<int> axis_of_revolution(const Superellipsoid<double>& shape) {
  if (shape.n2 != 2) return {};
  const Vec3<double>& a = shape.semi_axes;
  if (a[0] == a[1]) return 2;
  if (shape.n1 != 2) return {};
  if (a[1] == a[2]) return 0;
  return a[0] == a[2] ? std::optional(1) : std::nullopt;
}

Vec3<double> line_of_centres(const Vec3<double>& centre) {
  return centre.isZero(0) ? Vec3<double>::UnitZ() : centre.stableNormalized();
}

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

/// The chart point at a place of the meridian; exact for the places that halving gives.
Vec3<double> chart_at(double place) {
  if (place <= 1) return {place, 0, 1};
  if (place <= 3) return {1, 0, 2 - place};
  return {4 - place, 0, -1};
}

constexpr double shortest_arc = 1.0 / (1LL << 44);  // the places of shorter ones are not exact

template <class I>
class MeridianSearch {
 public:
  MeridianSearch(const PlacedPair<double>& pair, const FramedPair<I>& framed, const Mat3<double>& frame, double level,
                 double gap)
      : pair_(pair), framed_(framed), frame_(frame), level_(level), gap_(gap) {}

  MeridianBound run() {
    std::vector<Arc> todo{{3, 4}, {2, 3}, {1, 2}, {0, 1}};  // the next one last, so that arcs are kept in their order
    while (!todo.empty() && out_.cells < most_meridian_cells) {
      const Arc arc = todo.back();
      todo.pop_back();
      const double middle = (arc.first + arc.last) / 2;
      if (is_settled(arc, middle)) continue;
      todo.push_back({middle, arc.last});
      todo.push_back({arc.first, middle});
    }
    out_.complete = todo.empty();
    out_.least = level_;
    for (const Bounded& kept : kept_)
      if (kept.bound <= level_) add(kept);
    return std::move(out_);
  }

 private:
  struct Bounded {
    Arc arc;
    double bound;
  };

  /// Whether o is above the level on the arc, or near enough to it at its lowest.
  bool is_settled(const Arc& arc, double middle) {
    ++out_.cells;
    const Vec3<double> chart = chart_at(middle), direction = (frame_ * chart).normalized();
    learn(direction, high(overlap_at<I>(framed_, enclosed<I>(chart))));
    const double bound = bound_on(arc, witness_along(pair_, direction));
    if (bound > level_) return true;
    if (!(bound > level_ - gap_) && arc.last - arc.first > shortest_arc) return false;
    kept_.push_back({arc, bound});
    return true;
  }

  void learn(const Vec3<double>& direction, double overlap) {
    if (overlap >= level_ - gap_ / 2) return;
    level_ = overlap;
    out_.lower = direction;
  }

  /// Two points near the support points of the middle, not an enclosure of those: on a flat they move with the last digit of the
  /// direction.
  [[nodiscard]] double bound_on(const Arc& arc, const Witness& witness) const {
    const auto apart = points_apart<I>(framed_.pair, witness);
    if (!apart) return -std::numeric_limits<double>::infinity();
    return std::min(bound_at(*apart, arc.first), bound_at(*apart, arc.last));
  }

  /// The tangent line is below |F v| o on the whole arc, and over |F v| least at one of the ends.
  [[nodiscard]] double bound_at(const IVec3<I>& apart, double place) const {
    const IVec3<I> direction = framed_.frame * enclosed<I>(chart_at(place));
    const I above = dot<I>(direction, apart);
    return low(above) >= 0 ? low(I(above / length_of<I>(direction))) : -std::numeric_limits<double>::infinity();
  }

  void add(const Bounded& kept) {
    out_.least = std::min(out_.least, kept.bound);
    if (!out_.arcs.empty() && out_.arcs.back().last == kept.arc.first)
      out_.arcs.back().last = kept.arc.last;
    else
      out_.arcs.push_back(kept.arc);
  }

  const PlacedPair<double>& pair_;
  const FramedPair<I>& framed_;
  const Mat3<double>& frame_;
  double level_;
  const double gap_;
  std::vector<Bounded> kept_;
  MeridianBound out_;
};

}  // namespace

bool is_sphere(const Superellipsoid<double>& shape) {
  const Vec3<double>& a = shape.semi_axes;
  return shape.n1 == 2 && shape.n2 == 2 && a[0] == a[1] && a[1] == a[2];
}

std::optional<Vec3<double>> common_axis(const PlacedPair<double>& pair) {
  std::optional<Vec3<double>> axis;
  for (const PlacedBody<double>* body : {&pair.body1, &pair.body2}) {
    if (is_sphere(body->shape)) continue;
    const auto own = axis_of_revolution(body->shape);
    if (!own) return {};
    const Vec3<double> line = body->rotation.col(*own);
    if (axis && line.cross(*axis).norm() > rounding_of_case) return {};
    axis = line;
  }
  const Vec3<double>& centre = pair.body2.centre;
  if (!axis) return line_of_centres(centre);
  if (centre.cross(*axis).norm() > rounding_of_case * pair.size()) return {};
  return axis;
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
MeridianBound bound_meridian(const PlacedPair<double>& pair, const FramedPair<I>& framed, const Mat3<double>& frame,
                             double level, double gap) {
  return MeridianSearch<I>(pair, framed, frame, level, gap).run();
}

double angle_at(double place) {
  const Vec3<double> v = chart_at(place);
  return std::atan2(v[0], v[2]);
}

#define PLUMB_INSTANTIATE_REVOLUTION(I)                                                                               \
  template I asymmetry(const Pair&, const FramedPair<I>&);                                                            \
  template MeridianBound bound_meridian(const PlacedPair<double>&, const FramedPair<I>&, const Mat3<double>&, double, \
                                        double);

PLUMB_INSTANTIATE_REVOLUTION(DoubleInterval)
PLUMB_INSTANTIATE_REVOLUTION(Interval18)

}  // namespace plumb::reference
