#include "solver/reference/certify.hpp"

#include <algorithm>
#include <numbers>
#include <optional>

#include "solver/reference/chart_interval.hpp"
#include "solver/reference/condition.hpp"
#include "solver/reference/cover_search.hpp"
#include "solver/reference/frame.hpp"
#include "solver/reference/interval_double.hpp"
#include "solver/reference/real.hpp"
#include "solver/reference/revolution.hpp"
#include "solver/reference/stationary_point.hpp"
#include "solver/reference/verify.hpp"

namespace plumb::reference {
namespace {

constexpr double widest_region = 1.0 / 8, narrowest_region = 1e-15;
constexpr double gap = 1e-12;  // of the bounds, relative to the size

/// Cells that a search may look at: where the cheaper efforts need many, the digits of the next need few.
template <class I>
constexpr int most_cells = std::is_same_v<I, Interval80> ? 60'000 : 4'000;

/// The chart point v with F v parallel to n, to the digits of n, and its face; the half-width is not set.
template <class I>
struct ChartPoint {
  Cell face;
  IVec3<I> v;
};

template <class I, class S>
ChartPoint<I> chart_point(const Mat3<double>& frame, const Vec3<S>& n) {
  Vec3<S> v = in_frame<S>(frame, n);
  int axis = 0;
  v.template cast<double>().cwiseAbs().maxCoeff(&axis);
  const double sign = v[axis] < S(0) ? -1 : 1;
  using std::abs;
  v /= abs(v[axis]);
  ChartPoint<I> out{{axis, sign, static_cast<double>(v[(axis + 1) % 3]), static_cast<double>(v[(axis + 2) % 3]), 0},
                    {}};
  for (int i = 0; i < 3; ++i) out.v[i] = i == axis ? I(sign) : enclosing<I>(v[i]);
  return out;
}

/// Two intervals' enclosure of the same pair in the same frame. The cheap one proves what needs few digits and no power; of
/// the rest it says where a proof will succeed.
template <class I>
struct Frames {
  Mat3<double> frame;
  FramedPair<DoubleInterval> rough;
  FramedPair<I> fine;
};

/// A solution, and the region in which it is the only one.
template <class I, class S>
struct Minimum {
  Cell region;  ///< of half-width 0 where none is proved
  RegionProof<I> proof;
  IVec3<I> box;  ///< directions (chart) among which the true one is, if `exists`
  StationaryPoint<S> at;
  bool exists;

  [[nodiscard]] bool is_tight() const { return proof.located && high(proof.deficit) < gap / 2; }
  [[nodiscard]] I least() const { return low_end<I>(I(proof.value - proof.deficit)); }

  void widen(const I& reach) {
    for (const int step : {1, 2}) box[(region.axis + step) % 3] += hull<I>(I(-reach), reach);
  }
};

/// A region about a chart point with its proof.
template <class I>
struct ProvedRegion {
  Cell region;
  RegionProof<I> proof;
};

/// The widest of the tried regions on which the solution is located, or else the widest on which o is convex. C: the
/// intervals of the curvature, which needs fewer digits than the slope.
template <class C, class I>
ProvedRegion<I> region_about(const FramedPair<C>& coarse, const FramedPair<I>& pair, const ChartPoint<I>& at,
                             const Slope<I>& slope, double widest) {
  ProvedRegion<I> best{at.face, {}};
  Cell region = at.face;
  region.half = widest;
  while (region.half > narrowest_region && !best.proof.located) {
    const I curvature(low(curvature_on<C>(coarse, region)));
    const RegionProof<I> proof = proof_on<I>(region, curvature, at.v, slope, pair.shortest);
    if (proof.located || (proof.convex && !best.proof.convex)) best = {region, proof};
    region.half /= 2;
  }
  return best;
}

/// A solution located in a region is so in a small part about it too, where the curvature bounds its place better.
template <class C, class I>
ProvedRegion<I> sharpened(const ProvedRegion<I>& found, const FramedPair<C>& coarse, const FramedPair<I>& pair,
                          const ChartPoint<I>& at, const Slope<I>& slope) {
  if (!found.proof.located) return found;
  Cell part = found.region;
  part.half = std::clamp(4 * high(found.proof.radius), narrowest_region, found.region.half);
  const I curvature(low(curvature_on<C>(coarse, part)));
  const RegionProof<I> proof = proof_on<I>(part, curvature, at.v, slope, pair.shortest);
  return {found.region, proof.located ? proof : found.proof};
}

template <class I, class S>
class Certifier {
 public:
  explicit Certifier(const Pair& pair)
      : pair_(pair), rough_(place<double>(pair)), fine_(place<S>(pair)), enclosed_(enclose<I>(pair)),
        best_(point_from<S>(rough_, fine_, start_direction<double>(rough_, rough_.body2.centre))),
        frame_(frames_about(best_.normal.template cast<double>())) {}

  Reference run() {
    know(best_);
    if (!is_done() && !bound_by_revolution()) search();
    if (is_separated()) separate();
    report();
    explain();
    return std::move(out_);
  }

 private:
  using Min = Minimum<I, S>;

  [[nodiscard]] Frames<I> frames_about(const Vec3<double>& n) const {
    const Mat3<double> f = frame_about(n);
    return {f, {enclose<DoubleInterval>(pair_), f}, {enclosed_, f}};
  }

  static constexpr bool in_doubles = std::is_same_v<I, DoubleInterval>;

  /// A proof may trust the machine's + - * / and square root, not its pow: ellipsoids need none.
  [[nodiscard]] bool needs_no_power() const { return enclosed_.body1.is_ellipsoid() && enclosed_.body2.is_ellipsoid(); }

  [[nodiscard]] bool is_separated() const { return high(value_) < 0; }
  /// A separating common normal is the only one.
  [[nodiscard]] bool is_done() const { return is_separated() && best_.solved; }

  /// Whether a direction becomes the best: o is lower there.
  bool look_at(const StationaryPoint<S>& found) {
    const I value = overlap_at<I>(frame_.fine, chart_point<I, S>(frame_.frame, found.normal).v);
    if (!(high(value) < high(value_))) return false;
    value_ = value;
    best_ = found;
    return true;
  }

  /// Looks at a stationary point, and keeps it where it is new and a minimum, or the lowest.
  std::optional<KnownMinimum> know(const StationaryPoint<S>& found) {
    const bool is_lowest = look_at(found);
    if (!found.solved || is_known(found)) return {};
    const Min minimum = minimum_at(found);
    if (!is_lowest && !minimum.proof.convex) return {};
    minima_.push_back(minimum);
    return known(minimum);
  }

  [[nodiscard]] KnownMinimum known(const Min& minimum) const {
    return {minimum.region, minimum.is_tight(), witness(minimum.at)};
  }

  [[nodiscard]] ProvedRegion<I> proved_region(const ChartPoint<I>& at) const {
    const Slope<I> slope = slope_at<I>(frame_.fine, at.face.axis, at.v);
    const auto rough = region_about<DoubleInterval, I>(frame_.rough, frame_.fine, at, slope, widest_region);
    const bool is_located = rough.proof.located;
    if (in_doubles || (needs_no_power() && is_located)) return sharpened(rough, frame_.rough, frame_.fine, at, slope);
    const double widest = is_located ? rough.region.half : widest_region;
    const auto fine = region_about<I, I>(frame_.fine, frame_.fine, at, slope, widest);
    return sharpened(fine, frame_.fine, frame_.fine, at, slope);
  }

  [[nodiscard]] Min minimum_at(const StationaryPoint<S>& found) const {
    const Min own = minimum_about(found);
    if (own.is_tight() || !own.proof.convex) return own;
    Min out = own;
    if (const auto aligned = aligned_with_body1(found)) {
      Min there = minimum_about(*aligned);
      if (there.exists) out = std::move(there);
    }
    if constexpr (std::is_same_v<S, Real50>) locate_on_charts(out);
    return out;
  }

  /// Krawczyk's test on the charts: a common normal exists, its points and its overlap. Nothing where the region might not
  /// hold it: chart points v, v0 of one face are |v x v0| / (|v| |v0|) >= |v - v0| / 4 apart in the sine of their angle, and
  /// the region's middle is the solution.
  [[nodiscard]] std::optional<ProvedBox> proved_on_charts(const Min& minimum) const {
    ProvedBox box = prove_solution(enclosed_, square_form(fine_, minimum.at.at), minimum.at.at);
    if (!box.proof.exists) return {};
    const double off = farthest(box.jet.body1.normal, minimum.at.normal);
    return off < minimum.region.half / 16 ? std::optional(std::move(box)) : std::nullopt;
  }

  /// Where the direction form is singular or nearly so, its gradient says little of where in the region the minimum is.
  void locate_on_charts(Min& minimum) const {
    if (minimum.is_tight() || !minimum.proof.convex) return;
    const auto box = proved_on_charts(minimum);
    if (!box) return;
    const IVec3<I> apart = box->jet.body1.point - box->jet.body2.point - enclosed_.centre;
    const I overlap = dot<I>(box->jet.body1.normal, apart);
    const double reach = 8 * farthest(box->jet.body1.normal, minimum.at.normal);
    minimum.exists = minimum.proof.located = true;
    minimum.proof.deficit = high_end<I>(I(minimum.proof.value - low_end<I>(overlap)));
    minimum.box = chart_point<I, S>(frame_.frame, minimum.at.normal).v;
    minimum.widen(I(reach));
  }

  /// On a flat face the points follow digits of the direction that no computation has: 1e-49 off the face's normal they are a
  /// 500th of the body apart (exponent 19). Nearly along a face's normal, it is that; nothing elsewhere.
  [[nodiscard]] std::optional<StationaryPoint<S>> aligned_with_body1(const StationaryPoint<S>& found) const {
    using std::abs;
    using std::pow;
    const S rounding = pow(epsilon<S>(), S(0.9));
    Vec3<S> own = fine_.body1.to_body_direction(found.normal);
    bool is_near = false;
    for (S& component : own) {
      if (component == S(0) || !(abs(component) < rounding)) continue;
      component = S(0);
      is_near = true;
    }
    if (!is_near) return {};
    StationaryPoint<S> out = found;
    out.normal = fine_.body1.to_pair_direction(own).normalized();
    return out;
  }

  [[nodiscard]] Min minimum_about(const StationaryPoint<S>& found) const {
    const ChartPoint<I> at = chart_point<I, S>(frame_.frame, found.normal);
    const ProvedRegion<I> proved = proved_region(at);
    Min out{proved.region, proved.proof, at.v, found, proved.proof.located};
    if (out.exists) out.widen(out.proof.radius);
    return out;
  }

  [[nodiscard]] bool is_known(const StationaryPoint<S>& found) const {
    const double same = 1e-9;
    return std::any_of(minima_.begin(), minima_.end(), [&](const Min& other) {
      return static_cast<double>((other.at.normal - found.normal).norm()) < same;
    });
  }

  [[nodiscard]] Witness witness(const StationaryPoint<S>& at) const {
    return witness_of(rough_, at.point1.template cast<double>(), at.point2.template cast<double>());
  }

  /// Bodies of revolution about one line whose lowest directions are not on it: whether the bounds are settled by that.
  bool bound_by_revolution() {
    if (is_sphere(pair_.body1.shape) && is_sphere(pair_.body2.shape)) return bound_spheres();
    const auto axis = common_axis(rough_);
    if (!axis) return false;
    using C = std::conditional_t<in_doubles, DoubleInterval, Interval18>;
    const Mat3<double> frame = frame_about(*axis);
    const FramedPair<C> framed(enclose<C>(pair_), frame);
    const double slack = high(asymmetry<C>(pair_, framed));
    MeridianBound found;
    do found = bound_meridian<C>(rough_, framed, frame, OneStepOutward::up(high(value_) + slack), gap / 4);
    while (found.lower && look_at(point_from<S>(rough_, fine_, *found.lower)) && !is_separated());
    out_.cells = found.cells;
    if (is_separated()) return is_done();
    if (!found.complete || found.lower || found.arcs.empty()) return false;
    if (found.arcs.front().first == 0 || found.arcs.back().last == 4) return false;
    bound(lower_of(value_, I(found.least)) - I(slack));
    const double rounding = 1e-15;
    for (const Arc& arc : found.arcs)
      out_.rings.push_back({*axis, angle_at(arc.first) - rounding, angle_at(arc.last) + rounding});
    out_.reason = "bodies of revolution about one line: a ring of common normals";
    if (slack == 0) out_.unique = Claim::disproved;
    return true;
  }

  /// o(n) = r1 + r2 - n.c: lowest along the line of centres, the same everywhere where they coincide.
  bool bound_spheres() {
    if (!minima_.empty() && minima_.front().exists) return false;
    bound(enclosed_.body1.semi_axes[0] + enclosed_.body2.semi_axes[0] - length_of<I>(enclosed_.centre));
    out_.unique = pair_.body1.position == pair_.body2.position ? Claim::disproved : Claim::proved;
    if (out_.unique == Claim::proved) return true;
    out_.rings.push_back({Vec3<double>::UnitZ(), 0, std::numbers::pi});
    out_.reason = "concentric spheres: every direction is a common normal";
    return true;
  }

  void search() {
    std::vector<KnownMinimum> start;
    for (const Min& m : minima_) start.push_back(known(m));
    const Settle settle = [&](const Vec3<double>& direction) -> Settled {
      auto minimum = know(point_from<S>(rough_, fine_, direction));
      return {is_done(), high(value_), std::move(minimum)};
    };
    CoverResult found = search_cover(rough_, frame_.frame, high(value_), start, {gap, most_cells<I>}, settle);
    out_.cells = found.cells;
    if (is_separated()) return;
    conclude(found, verified(found.cover));
  }

  /// In doubles except for powers, and in Interval18 where that takes more digits.
  [[nodiscard]] CoverProof verified(const Cover& cover) const {
    const double level = high(value_);
    if (in_doubles || needs_no_power()) {
      CoverProof proof = verify_cover<DoubleInterval>(frame_.rough, cover, level);
      if (in_doubles || is_sound(proof)) return proof;
    }
    const auto bodies = enclose<Interval18>(pair_);
    CoverProof proof = verify_cover<DoubleInterval, Interval18>(frame_.rough, bodies, cover, level);
    if (is_sound(proof)) return proof;
    return verify_cover<Interval18>({bodies, frame_.frame}, cover, level);
  }

  [[nodiscard]] static bool is_sound(const CoverProof& proof) { return proof.well_formed && proof.excluded; }

  void conclude(CoverResult& found, const CoverProof& proof) {
    if (!is_sound(proof)) {
      out_.reason = "the cover found by the search does not stand up to its verifier";
      return;
    }
    I least = lower_of(value_, I(proof.least_open));
    for (const Min& m : minima_)
      if (m.is_tight()) least = lower_of(least, m.least());
    bound(least);
    out_.open = std::move(found.open);
    out_.cover = std::move(found.cover);
    if (found.exhausted)
      out_.reason = "cell budget: directions are left open";
    else if (!out_.open.empty())
      out_.reason = "directions are left open that tie within the gap";
    else if (minima_.size() == 1)
      find_among(proof.reach.front(), least);
    const auto is_settled = [](const Min& m) { return m.exists || !m.proof.convex; };
    if (out_.open.empty() && std::all_of(minima_.begin(), minima_.end(), is_settled)) out_.unique = Claim::proved;
  }

  [[nodiscard]] static I lower_of(const I& a, const I& b) { return low_end<I>(high(a) < high(b) ? a : b); }

  /// The one region holds every direction that is not excluded, and so the lowest: it lies among the bounded leaves.
  void find_among(const Reach& part, const I& least) {
    Min& only = minima_.front();
    if (only.exists || !only.proof.convex) return;
    only.exists = true;
    only.proof.deficit = only.proof.value - least;
    only.box[(only.region.axis + 1) % 3] = hull<I>(part.low_u, part.high_u);
    only.box[(only.region.axis + 2) % 3] = hull<I>(part.low_v, part.high_v);
  }

  // A direction with o < 0 separates the bodies: strictly convex, they have one pair of nearest points, and a stationary
  // direction with o < 0 is theirs. Any two points of the bodies bound the distance from above.
  void separate() {
    out_ = {};
    const auto own = std::find_if(minima_.begin(), minima_.end(),
                                  [&](const Min& m) { return m.exists && high(I(m.proof.value)) < 0; });
    minima_ = own == minima_.end() ? std::vector<Min>{} : std::vector<Min>{Min(*own)};
    out_.nearest = witness(best_);
    I least = I(least_overlap_apart<I>(enclosed_, *out_.nearest));
    if (!minima_.empty() && high(least) < low(minima_.front().least())) least = minima_.front().least();
    bound(least);
    if (minima_.empty()) out_.reason = "the points are not located";
    if (out_.global == Claim::proved) out_.unique = Claim::proved;
    out_.common_normal = solution(best_);
    if (!minima_.empty()) return;
    // -o(n) is the shadow of the shortest line on n: the cosine between the two is at least -o(n) / distance.
    const I cosine = low_end<I>(I(-high_end<I>(value_))) / high_end<I>(I(-least));
    out_.common_normal.proved = true;
    out_.common_normal.bounds = out_.overlap;
    out_.common_normal.normal_radius = angle_of_chord(high(root<I>(magnitude<I>(I(I(2.0) - I(2.0) * cosine)))));
  }

  [[nodiscard]] Bounds to_world(const I& least, const I& highest) const {
    return {low_as<Real50>(times_power_of_two<I>(least, enclosed_.exponent)),
            high_as<Real50>(times_power_of_two<I>(highest, enclosed_.exponent))};
  }

  void bound(const I& least) {
    out_.overlap = to_world(least, value_);
    const double scale = rough_.size() + std::abs(high(value_));
    if (high(I(high_end<I>(value_) - low_end<I>(least))) <= gap * scale) out_.global = Claim::proved;
  }

  /// The lowest minimum is the answer; others whose bounds meet its own tie with it.
  void report() {
    out_.direction = best_.normal.template cast<Real50>();
    if (out_.overlap.lower > 0) out_.verdict = Verdict::overlapping;
    if (out_.overlap.upper < 0) out_.verdict = Verdict::separated;
    const auto lower = [](const Min& a, const Min& b) { return a.at.overlap < b.at.overlap; };
    std::stable_sort(minima_.begin(), minima_.end(), lower);
    minima_.erase(std::remove_if(minima_.begin(), minima_.end(), [](const Min& m) { return !m.exists; }),
                  minima_.end());
    const bool is_best_proved = !minima_.empty() && !(high(value_) < low(minima_.front().proof.value));
    if (is_best_proved)
      out_.common_normal = solution(minima_.front());
    else if (!is_separated())
      out_.common_normal = solution(best_);
    report_others(is_best_proved ? 1 : 0);
    if (out_.tied.empty()) return;
    out_.unique = Claim::open;
    out_.reason = is_best_proved ? "other common normals tie with it" : "it is not located, and others tie with it";
  }

  /// Nothing is left open without a reason.
  void explain() {
    if (!out_.reason.empty()) return;
    if (out_.global != Claim::proved)
      out_.reason = "the bounds are further apart than their gap";
    else if (out_.unique == Claim::open)
      out_.reason = "a region has one minimum at most, which is not located";
    else if (!out_.common_normal.proved)
      out_.reason = "the common normal is not located";
  }

  void report_others(std::size_t first) {
    const Real50 close = Real50(size_of(pair_)) * Real50(1e-7);
    for (std::size_t k = first; k < minima_.size(); ++k) {
      Solution other = solution(minima_[k]);
      if (other.bounds.lower > out_.overlap.upper + close) break;
      const bool is_tied = other.bounds.lower <= out_.overlap.upper;
      (is_tied ? out_.tied : out_.close).push_back(std::move(other));
    }
  }

  [[nodiscard]] Solution solution(const StationaryPoint<S>& found) const {
    Solution out;
    out.solved = found.solved;
    if (!found.solved) out.reason = "no local solve converged";
    out.overlap = Real50(fine_.to_world_length(found.overlap));
    out.normal = found.normal.template cast<Real50>();
    out.point1 = fine_.to_world_point(found.point1, pair_).template cast<Real50>();
    out.point2 = fine_.to_world_point(found.point2, pair_).template cast<Real50>();
    out.residual = Real50(found.residual);
    if (found.solved) out.condition = condition_of<S>(fine_, {}, found.at);
    return out;
  }

  /// Normal and points over the box of directions that holds the true one.
  [[nodiscard]] Solution solution(const Min& minimum) const {
    Solution out = solution(minimum.at);
    const DirectionEnclosure<I> at = enclose_direction<I>(frame_.fine, minimum.box);
    out.proved = true;
    out.bounds = to_world(minimum.least(), minimum.proof.value);
    out.normal_radius = angle_of_chord(farthest(at.normal, out.normal));
    out.points_radius = reach_of_points(out, at.point1, at.point2);
    if constexpr (std::is_same_v<S, Real50>) sharpen(out, minimum);
    return out;
  }

  /// How far the boxes (pair frame) reach from the solution's points (world frame).
  [[nodiscard]] double reach_of_points(const Solution& from, const IVec3<I>& point1, const IVec3<I>& point2) const {
    return std::max(farthest(enclosed_.to_world_point(point1, pair_), from.point1),
                    farthest(enclosed_.to_world_point(point2, pair_), from.point2));
  }

  /// On flat faces a direction says little about the points, and the charts all.
  void sharpen(Solution& out, const Min& minimum) const {
    const double sharp = 1e-30;  // relative to the size; what a regular direction gives
    if (out.points_radius < sharp * size_of(pair_) && out.normal_radius < sharp) return;
    const auto box = proved_on_charts(minimum);
    if (!box) return;
    const auto &body1 = box->jet.body1, &body2 = box->jet.body2;
    out.normal_radius = std::min(out.normal_radius, angle_of_chord(farthest(body1.normal, out.normal)));
    const IVec3<I> point2 = body2.point + enclosed_.centre;
    out.points_radius = std::min(out.points_radius, reach_of_points(out, body1.point, point2));
  }

  const Pair& pair_;
  const PlacedPair<double> rough_;
  const PlacedPair<S> fine_;
  const EnclosedPair<I> enclosed_;
  StationaryPoint<S> best_;                               ///< the lowest direction known
  const Frames<I> frame_;                                 ///< about the first
  I value_ = I(std::numeric_limits<double>::infinity());  ///< o there
  std::vector<Min> minima_;
  Reference out_;
};

}  // namespace

template <class I, class S>
Reference certify(const Pair& pair) {
  return Certifier<I, S>(pair).run();
}

template Reference certify<DoubleInterval, double>(const Pair&);
template Reference certify<Interval18, long double>(const Pair&);
template Reference certify<Interval80, Real50>(const Pair&);

}  // namespace plumb::reference
