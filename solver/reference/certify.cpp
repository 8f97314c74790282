#include "solver/reference/certify.hpp"

#include <algorithm>
#include <functional>
#include <numbers>
#include <optional>
#include <vector>

#include "solver/reference/condition/condition.hpp"
#include "solver/reference/interval/digits.hpp"
#include "solver/reference/real.hpp"
#include "solver/reference/search/cover_search.hpp"
#include "solver/reference/search/minimum.hpp"
#include "solver/reference/search/revolution.hpp"
#include "solver/reference/search/stationary.hpp"

namespace plumb::reference {
namespace {

/// Cells that a search may look at: where the cheaper efforts need many, the digits of the next need few.
template <class I>
constexpr int most_cells = std::is_same_v<I, Interval80> ? 60'000 : 4'000;

/// Beyond these a ring is a continuum, or too near to one.
constexpr int most_cells_of_stationary = 20'000;

/// Of a direction in the frame of a meridian.
template <class S>
S place_of(const Vec3<S>& v) {
  using std::sqrt;
  const S across = sqrt(S(v[0] * v[0] + v[1] * v[1]));
  if (v[2] >= across) return across / v[2];
  return v[2] <= -across ? S(4) + across / v[2] : S(2) - v[2] / across;
}

template <class I, class S>
class Certifier {
 public:
  Certifier(const Pair& pair, const Reference* cheaper)
      : pair_(pair), cheaper_(has_closed_cover(cheaper) ? cheaper : nullptr),
        on_(pair, cheaper_ ? &cheaper_->cover.frame : nullptr), minimum_at_(on_), best_(on_.first) {}

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

  [[nodiscard]] bool is_separated() const { return high(value_) < 0; }
  /// A separating common normal is the only one.
  [[nodiscard]] bool is_done() const { return is_separated() && best_.solved; }

  /// Whether a direction becomes the best: o is lower there.
  bool look_at(const StationaryPoint<S>& found) {
    const I value = overlap_at<I>(on_.framed, chart_point<I, S>(on_.frame, found.normal).v);
    if (!is_lower<I>(high_end<I>(value), high_end<I>(value_))) return false;
    value_ = value;
    best_ = found;
    return true;
  }

  /// Looks at a stationary point, and keeps it where it is new and a minimum, or the lowest.
  std::optional<KnownMinimum> know(const StationaryPoint<S>& found) {
    const bool is_lowest = look_at(found);
    if (!found.solved || is_known(found)) return {};
    Min minimum = minimum_at_.locate(found);
    if (!is_lowest && !minimum.proof.convex) return {};
    minima_.push_back(std::move(minimum));
    return known(minima_.back());
  }

  [[nodiscard]] KnownMinimum known(const Min& minimum) const {
    return {minimum.region, minimum.is_tight(), witness(minimum.at)};
  }

  [[nodiscard]] bool is_known(const StationaryPoint<S>& found) const {
    const double same = 1e-9;
    return std::any_of(minima_.begin(), minima_.end(), [&](const Min& other) {
      return static_cast<double>((other.at.normal - found.normal).norm()) < same;
    });
  }

  [[nodiscard]] Witness witness(const StationaryPoint<S>& at) const {
    return witness_of(on_.rough, at.point1.template cast<double>(), at.point2.template cast<double>());
  }

  /// Bodies of revolution about one line whose lowest directions are not on it: whether the bounds are settled by that.
  bool bound_by_revolution() {
    if (is_sphere(pair_.body1.shape) && is_sphere(pair_.body2.shape)) return bound_spheres();
    const auto axis = common_axis(on_.rough);
    if (!axis) return false;
    using C = std::conditional_t<Setting<I, S>::in_doubles, DoubleInterval, Interval18>;
    const Mat3<double> frame = frame_about(*axis);
    const FramedPair<C> framed(enclose<C>(pair_), frame);
    const double slack = high(asymmetry<C>(pair_, framed));
    MeridianSearchResult found;
    do found = search_meridian<C>(on_.rough, framed, frame, OneStepOutward::up(high(value_) + slack), bounds_gap / 4);
    while (found.lower && look_at(point_from<S>(on_.rough, on_.fine, *found.lower)) && !is_separated());
    out_.cells = found.cells;
    if (is_separated()) return is_done();
    if (!found.complete || found.lower || found.lowest.empty()) return false;
    if (found.lowest.front().first == 0 || found.lowest.back().last == 4) return false;
    for (const Arc& arc : found.lowest) add_valley(found.meridian, frame, arc);
    const MeridianProof<I> proof = verify_meridian<I>(pair_, {on_.enclosed, frame}, found.meridian);
    if (!proof.well_formed) return false;
    bound(lower_of(value_, proof.least));
    for (const Arc& arc : found.lowest) out_.rings.push_back(ring(*axis, arc));
    out_.meridian = std::move(found.meridian);
    out_.cover.frame = frame;
    out_.reason = "bodies of revolution about one line: a ring of common normals";
    if (slack == 0) out_.unique = Claim::disproved;
    return true;
  }

  /// Where the best direction, or its mirror image, is the lowest place of the arc.
  void add_valley(Meridian& meridian, const Mat3<double>& frame, const Arc& arc) const {
    const S place = place_of<S>(in_frame<S>(frame, best_.normal));
    for (const S& lowest : {place, S(S(4) - place)}) {
      const auto high_part = static_cast<double>(lowest);
      if (!(arc.first < high_part && high_part < arc.last)) continue;
      meridian.valleys.push_back({arc.first, arc.last, high_part, static_cast<double>(S(lowest - S(high_part)))});
      return;
    }
  }

  /// Widened for the axis, which is rounded.
  [[nodiscard]] static Ring ring(const Vec3<double>& axis, const Arc& arc) {
    const double rounding = 1e-15;
    return {axis, low(angle_at(arc.first)) - rounding, high(angle_at(arc.last)) + rounding};
  }

  /// o(n) = r1 + r2 - n.c: lowest along the line of centres, the same everywhere where they coincide.
  bool bound_spheres() {
    if (!minima_.empty() && minima_.front().exists) return false;
    bound(lowest_overlap_of_spheres<I>(on_.enclosed));
    out_.unique = pair_.body1.position == pair_.body2.position ? Claim::disproved : Claim::proved;
    if (out_.unique == Claim::proved) return true;
    out_.rings.push_back({Vec3<double>::UnitZ(), 0, std::numbers::pi});
    out_.reason = "concentric spheres: every direction is a common normal";
    return true;
  }

  /// Whether all directions are excluded but those of one region, where the one minimum bounds o well enough.
  [[nodiscard]] static bool has_closed_cover(const Reference* found) {
    if (found == nullptr || found->cover.regions.size() != 1) return false;
    return std::all_of(found->cover.tree.begin(), found->cover.tree.end(),
                       [](Leaf leaf) { return leaf != Leaf::open && leaf != Leaf::bounded; });
  }

  /// The cheaper effort's cover holds here too: what it excludes is above a level that is no lower than o here, and the one minimum
  /// of its region is the one that is known now. Whether that is so.
  bool take_over() {
    if (cheaper_ == nullptr || minima_.size() != 1) return false;
    const Min& only = minima_.front();
    const bool is_as_low = to_world(value_, value_).upper <= cheaper_->overlap.upper;
    if (!is_as_low || !only.exists || !only.is_tight() || !only.lies_in(cheaper_->cover.regions.front())) return false;
    bound(lower_of(value_, only.least()));
    out_.cover = cheaper_->cover;
    out_.cells = cheaper_->cells;
    out_.unique = Claim::proved;
    return true;
  }

  void search() {
    if (take_over()) return;
    std::vector<KnownMinimum> start;
    for (const Min& m : minima_) start.push_back(known(m));
    const Settle settle = [&](const Vec3<double>& direction) -> Settled {
      auto minimum = know(point_from<S>(on_.rough, on_.fine, direction));
      return {is_done(), high(value_), std::move(minimum)};
    };
    CoverResult found = search_cover(on_.rough, on_.frame, high(value_), start, {bounds_gap, most_cells<I>}, settle);
    out_.cells = found.cells;
    if (is_separated()) return;
    conclude(found, verified(found.cover));
  }

  /// In doubles, and in Interval18 where that takes more digits: for the witnesses alone, or for all.
  [[nodiscard]] CoverProof verified(const Cover& cover) const {
    const double level = high(value_);
    CoverProof proof = verify_cover<DoubleInterval>(on_.rough_framed, cover, level);
    if (on_.in_doubles || is_sound(proof)) return proof;
    const auto bodies = enclose<Interval18>(pair_);
    proof = verify_cover<DoubleInterval, Interval18>(on_.rough_framed, bodies, cover, level);
    if (is_sound(proof)) return proof;
    return verify_cover<Interval18>({bodies, on_.frame}, cover, level);
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
    if (!out_.open.empty() && settle_by_stationary_directions(least)) return;
    if (found.exhausted)
      out_.reason = "cell budget: directions are left open";
    else if (!out_.open.empty())
      out_.reason = "directions are left open that tie within the gap";
    else if (minima_.size() == 1)
      find_among(proof.reach.front(), least);
    const auto is_settled = [](const Min& m) { return m.exists || !m.proof.convex; };
    if (out_.open.empty() && std::all_of(minima_.begin(), minima_.end(), is_settled)) out_.unique = Claim::proved;
  }

  /// Bodies of revolution whose axes all but coincide leave a ring of open cells. Its stationary directions are found one by one; whether
  /// they are all there are: then the lowest overlap is that of one of them, or of a tight minimum. `by_cover`: a lower bound.
  bool settle_by_stationary_directions(const I& by_cover) {
    if (on_.in_doubles || !on_.enclosed.body1.axis || !on_.enclosed.body2.axis) return false;
    const StationarySet all = find_stationary(pair_, undecided_cells(out_.cover), {most_cells_of_stationary});
    out_.cells += all.cells;
    if (!all.complete) return false;
    I least = value_;
    for (const StationaryPair& each : all.pairs) {
      least = lower_of(least, to_pair(each.overlap_lower));
      if (each.kind == StationaryKind::minimum) look_at(each);
    }
    out_.open.clear();
    tell(all);
    for (const Min& m : minima_)
      if (m.is_tight()) least = lower_of(least, m.least());
    bound(is_lower<I>(least, by_cover) ? by_cover : least);
    return true;
  }

  void look_at(const StationaryPair& pair) {
    const Vec3<S> n = pair.normal.template cast<S>();
    know(point_from<S>(on_.rough, on_.fine, n.template cast<double>()));
    if (!is_below<I>(to_pair(pair.overlap_upper), value_)) return;
    const ChartPair<S> at = charts_of_direction<S>(on_.fine, n);  // no local solve leads there
    look_at(point_at<S>(chart_residual<S>(on_.fine, {}, at), at, std::numeric_limits<S>::infinity()));
  }

  /// Keeps the minima that exist, and says whether each that may be as low as the lowest is among them. Beside a saddle and a maximum there
  /// are lower directions.
  void tell(const StationarySet& all) {
    const Real50 highest = to_world(value_, value_).upper;
    std::vector<const Min*> told;
    for (const StationaryPair& each : all.pairs) {
      if (each.kind != StationaryKind::minimum) continue;
      const Min* minimum = locate_by(each);
      if (minimum != nullptr && std::find(told.begin(), told.end(), minimum) == told.end())
        told.push_back(minimum);
      else if (!(each.overlap_lower > highest))
        out_.open.push_back(each.normal.template cast<double>());
    }
    std::erase_if(minima_, [](const Min& m) { return !m.exists; });
    if (out_.open.empty())
      out_.unique = Claim::proved;
    else
      out_.reason = "a common normal that may be as low is proved and not located";
  }

  /// The minimum that a proved stationary direction is, located by it where it is not; null where none is known to be.
  const Min* locate_by(const StationaryPair& pair) {
    const double same = 1e-9, rounding = 1e-45;  // the latter of a chart point in fifty digits
    ChartPoint<I> at = chart_point<I, Real50>(on_.frame, pair.normal);
    const I reach(8 * pair.normal_radius + rounding);
    for (const int step : {1, 2}) at.v[(at.face.axis + step) % 3] += hull<I>(I(-reach), reach);
    for (Min& m : minima_) {
      const bool is_in_region = is_in_cell<I>(m.region, at.face, at.v);
      if (m.exists && is_in_region) return &m;
      const bool is_near = static_cast<double>((m.at.normal.template cast<Real50>() - pair.normal).norm()) < same;
      const bool is_on_face = at.face.axis == m.region.axis && at.face.sign == m.region.sign;
      if (m.exists || !is_near || !is_on_face || !(is_in_region || m.region.half == 0)) continue;
      m.exists = m.proof.located = m.proof.convex = true;
      m.proof.value = hull<I>(to_pair(pair.overlap_lower), to_pair(pair.overlap_upper));
      m.proof.deficit = I(0.0);
      m.box = at.v;
      return &m;
    }
    return nullptr;
  }

  /// Cells that hold the leaves which nothing excludes, but for those that a region's minimum bounds well.
  [[nodiscard]] static DirectionCells undecided_cells(const Cover& cover) {
    const double smallest = 1.0 / 32;  // another search divides them where it must
    DirectionCells out{cover.frame, {}};
    std::size_t next = 0;
    const std::function<bool(const Cell&)> is_undecided = [&](const Cell& cell) {
      const Leaf leaf = cover.tree[next++];
      bool undecided = leaf == Leaf::open || leaf == Leaf::bounded;
      if (leaf == Leaf::split)
        for (int i = 0; i < 4; ++i) undecided |= is_undecided(cell.quarter(i));
      if (!undecided || cell.half < smallest) return undecided;
      out.cells.push_back(cell);
      return false;
    };
    for (int face = 0; face < 6; ++face) (void)is_undecided(face_of_cube(face));
    return out;
  }

  [[nodiscard]] I to_pair(const Real50& world) const {
    return times_power_of_two<I>(enclosing<I>(world), -on_.enclosed.exponent);
  }

  [[nodiscard]] static I lower_of(const I& a, const I& b) { return low_end<I>(is_lower<I>(a, b) ? a : b); }

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
    I least = least_by_points();
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

  /// Points that are not proved to lie in their bodies are drawn in, to the centres where need be.
  I least_by_points() {
    const auto [point1, point2] = witness(best_);
    const Witness centres{Vec3<double>::Zero(), Vec3<double>::Zero()};
    const double little = 1 - 0x1p-40, much = 1 - 0x1p-20;
    for (const Witness& points : {Witness{point1, point2}, Witness{little * point1, little * point2},
                                  Witness{much * point1, much * point2}, centres}) {
      out_.nearest = points;
      if (const auto least = least_overlap_apart<I>(on_.enclosed, points)) return *least;
    }
    return I(-std::numeric_limits<double>::infinity());
  }

  [[nodiscard]] Bounds to_world(const I& least, const I& highest) const {
    return {low_as<Real50>(times_power_of_two<I>(least, on_.enclosed.exponent)),
            high_as<Real50>(times_power_of_two<I>(highest, on_.enclosed.exponent))};
  }

  void bound(const I& least) {
    out_.overlap = to_world(least, value_);
    const bool is_close = high(I(high_end<I>(value_) - low_end<I>(least))) <= bounds_gap * on_.rough.size();
    if (is_close && isfinite(out_.overlap.lower) && isfinite(out_.overlap.upper)) out_.global = Claim::proved;
  }

  /// The lowest minimum is the answer; others whose bounds meet its own tie with it.
  void report() {
    out_.direction = best_.normal.template cast<Real50>();
    if (out_.overlap.lower > 0) out_.verdict = Verdict::overlapping;
    if (out_.overlap.upper < 0) out_.verdict = Verdict::separated;
    const auto lower = [](const Min& a, const Min& b) { return a.at.overlap < b.at.overlap; };
    std::stable_sort(minima_.begin(), minima_.end(), lower);
    const auto is_unlocated = [](const Min& m) { return !m.exists; };
    bool may_be_elsewhere = false;
    for (const Min& m : minima_)
      if (is_unlocated(m) && m.proof.convex && !is_below<I>(value_, m.least())) {
        may_be_elsewhere = true;
        out_.open.push_back(m.normal.template cast<double>());
      }
    minima_.erase(std::remove_if(minima_.begin(), minima_.end(), is_unlocated), minima_.end());
    const bool is_best_proved = !minima_.empty() && !is_below<I>(value_, may_be_elsewhere ? minima_.front().proof.value
                                                                                          : minima_.front().least());
    if (is_best_proved)
      out_.common_normal = solution(minima_.front());
    else if (!is_separated())
      out_.common_normal = solution(best_);
    if (!out_.rings.empty()) out_.common_normal.condition = {out_.common_normal.condition.overlap};
    report_others(is_best_proved ? 1 : 0);
    if (out_.tied.empty()) return;
    out_.unique = Claim::open;
    out_.reason = is_best_proved ? "other common normals tie with it" : "it is not located, and others tie with it";
    if (!out_.open.empty()) out_.reason += "; more may";
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
    else if (out_.verdict == Verdict::undecided)
      out_.reason = "zero lies within the bounds";
  }

  void report_others(std::size_t first) {
    const Real50 close = Real50(size_of(pair_)) * Real50(1e-7);
    for (std::size_t k = first; k < minima_.size(); ++k) {
      Solution other = solution(minima_[k]);
      if (other.bounds.lower > out_.overlap.upper + close) continue;
      const bool is_tied = other.bounds.lower <= out_.overlap.upper;
      (is_tied ? out_.tied : out_.close).push_back(std::move(other));
    }
  }

  [[nodiscard]] Solution solution(const StationaryPoint<S>& found) const {
    Solution out;
    out.solved = found.solved;
    if (!found.solved) out.reason = "no local solve converged";
    out.overlap = Real50(on_.fine.to_world_length(found.overlap));
    out.normal = found.normal.template cast<Real50>();
    out.point1 = on_.fine.to_world_point(found.point1, pair_).template cast<Real50>();
    out.point2 = on_.fine.to_world_point(found.point2, pair_).template cast<Real50>();
    out.residual = Real50(found.residual);
    if (found.solved) out.condition = condition_of<S>(on_.fine, {}, found.at);
    return out;
  }

  /// Normal and points over the box of directions that holds the true one.
  [[nodiscard]] Solution solution(const Min& minimum) const {
    Solution out = solution(minimum.at);
    const DirectionEnclosure<I> at = enclose_direction<I>(on_.framed, minimum.box);
    out.proved = true;
    out.normal = minimum.normal.template cast<Real50>();
    out.bounds = to_world(minimum.least(), minimum.proof.value);
    out.normal_radius = angle_of_chord(farthest(at.normal, out.normal));
    out.points_radius = reach_of_points(out, at.point1, at.point2);
    if constexpr (std::is_same_v<S, Real50>) sharpen(out, minimum);
    return out;
  }

  /// How far the boxes (pair frame) reach from the solution's points (world frame).
  [[nodiscard]] double reach_of_points(const Solution& from, const IVec3<I>& point1, const IVec3<I>& point2) const {
    return std::max(farthest(on_.enclosed.to_world_point(point1, pair_), from.point1),
                    farthest(on_.enclosed.to_world_point(point2, pair_), from.point2));
  }

  /// On flat faces a direction says little about the points, and the charts all.
  void sharpen(Solution& out, const Min& minimum) const {
    const double sharp = 1e-30;  // relative to the size; what a regular direction gives
    if (out.points_radius < sharp * size_of(pair_) && out.normal_radius < sharp) return;
    const auto box = minimum_at_.proved_on_charts(minimum);
    if (!box) return;
    const auto &body1 = box->jet.body1, &body2 = box->jet.body2;
    out.normal_radius = std::min(out.normal_radius, angle_of_chord(farthest(body1.normal, out.normal)));
    const IVec3<I> point2 = body2.point + on_.enclosed.centre;
    out.points_radius = std::min(out.points_radius, reach_of_points(out, body1.point, point2));
  }

  const Pair& pair_;
  const Reference* const cheaper_;  ///< whose cover is closed; null where there is none
  const Setting<I, S> on_;
  const MinimumLocator<I, S> minimum_at_;
  StationaryPoint<S> best_;                               ///< the lowest direction known
  I value_ = I(std::numeric_limits<double>::infinity());  ///< o there
  std::vector<Min> minima_;
  Reference out_;
};

}  // namespace

template <class I, class S>
Reference certify(const Pair& pair, const Reference* cheaper) {
  return Certifier<I, S>(pair, cheaper).run();
}

template Reference certify<DoubleInterval, double>(const Pair&, const Reference*);
template Reference certify<Interval18, long double>(const Pair&, const Reference*);
template Reference certify<Interval80, Real50>(const Pair&, const Reference*);

}  // namespace plumb::reference
