#include "solver/reference/search/revolution.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "solver/reference/interval/interval_double.hpp"
#include "solver/reference/search/cover_search.hpp"

namespace plumb::reference {
namespace {

constexpr double rounding_of_case = 1e-14;  // relative to the size, far below the gap of the bounds
constexpr int most_meridian_cells = 20'000;
constexpr double shortest_arc = 1.0 / (1LL << 44);  // beyond it the witnesses' rounding is all that is left

Vec3<double> line_of_centres(const Vec3<double>& centre) {
  return centre.isZero(0) ? Vec3<double>::UnitZ() : centre.stableNormalized();
}

template <class I>
class MeridianSearch {
 public:
  MeridianSearch(const PlacedPair<double>& pair, const FramedPair<I>& framed, const Mat3<double>& frame, double level,
                 double gap)
      : pair_(pair), framed_(framed), frame_(frame), level_(level), gap_(gap) {}

  MeridianSearchResult run() {
    std::vector<Arc> todo{{3, 4}, {2, 3}, {1, 2}, {0, 1}};  // the next one last, so that arcs are kept in their order
    out_.meridian.places.push_back(0);
    while (!todo.empty() && out_.cells < most_meridian_cells) {
      const Arc arc = todo.back();
      todo.pop_back();
      const double middle = (arc.first + arc.last) / 2;
      if (is_settled(arc, middle)) continue;
      todo.push_back({middle, arc.last});
      todo.push_back({arc.first, middle});
    }
    out_.complete = todo.empty();
    for (std::size_t i = 0; i < bounds_.size(); ++i)
      if (bounds_[i] <= level_) add({out_.meridian.places[i], out_.meridian.places[i + 1]});
    return std::move(out_);
  }

 private:
  /// Whether o is above the level on the arc, or near enough to it at its lowest.
  bool is_settled(const Arc& arc, double middle) {
    ++out_.cells;
    const Vec3<double> chart = chart_at<double>(middle), direction = (frame_ * chart).normalized();
    learn(direction, high(overlap_at<I>(framed_, enclosed<I>(chart))));
    const Witness witness = witness_along(pair_, direction);
    const double bound = bound_on(arc, witness);
    const bool is_above = bound > level_, is_short = !(arc.last - arc.first > shortest_arc);
    if (!is_above && !(bound > level_ - gap_) && !is_short) return false;
    bounds_.push_back(bound);
    out_.meridian.places.push_back(arc.last);
    out_.meridian.witnesses.push_back(witness);
    return true;
  }

  void learn(const Vec3<double>& direction, double overlap) {
    if (overlap >= level_ - gap_ / 2) return;
    level_ = overlap;
    out_.lower = direction;
  }

  /// By two points near the support points of the middle, not an enclosure of those: on a flat they move with the last digit
  /// of the direction.
  [[nodiscard]] double bound_on(const Arc& arc, const Witness& witness) const {
    const auto apart = points_apart<I>(framed_.pair, witness);
    return apart ? least_on<I>(framed_, arc, *apart) : -std::numeric_limits<double>::infinity();
  }

  void add(const Arc& arc) {
    if (!out_.lowest.empty() && out_.lowest.back().last == arc.first)
      out_.lowest.back().last = arc.last;
    else
      out_.lowest.push_back(arc);
  }

  const PlacedPair<double>& pair_;
  const FramedPair<I>& framed_;
  const Mat3<double>& frame_;
  double level_;
  const double gap_;
  std::vector<double> bounds_;  ///< of the arcs
  MeridianSearchResult out_;
};

}  // namespace

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

template <class I>
MeridianSearchResult search_meridian(const PlacedPair<double>& pair, const FramedPair<I>& framed,
                                     const Mat3<double>& frame, double level, double gap) {
  return MeridianSearch<I>(pair, framed, frame, level, gap).run();
}

Interval18 angle_at(double place) {
  const IVec3<Interval18> v = chart_at<Interval18>(place);
  return angle_of<Interval18>(v[0], v[2]);
}

template MeridianSearchResult search_meridian(const PlacedPair<double>&, const FramedPair<DoubleInterval>&,
                                              const Mat3<double>&, double, double);
template MeridianSearchResult search_meridian(const PlacedPair<double>&, const FramedPair<Interval18>&,
                                              const Mat3<double>&, double, double);

}  // namespace plumb::reference
