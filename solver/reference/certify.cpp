#include "solver/reference/certify.hpp"

#include <algorithm>
#include <functional>
#include <numbers>
#include <optional>
#include <vector>

#include "solver/reference/search/known_minima.hpp"
#include "solver/reference/search/revolution.hpp"
#include "solver/reference/search/solution_writer.hpp"

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
        on_(pair, cheaper_ ? &cheaper_->cover.frame : nullptr), known_(on_), write_(pair, on_) {}

  Reference run() {
    known_.know(known_.best);
    if (!known_.is_done() && !bound_by_revolution()) search();
    if (known_.is_separated()) separate();
    report();
    explain();
    return std::move(out_);
  }

 private:
  using Min = Minimum<I, S>;

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
    do {
      const double level = OneStepOutward::up(high(known_.value) + slack);
      found = search_meridian<C>(on_.rough, framed, frame, level, bounds_gap / 4);
    } while (found.lower && known_.look_at(point_from<S>(on_.rough, on_.fine, *found.lower)) && !known_.is_separated());
    out_.cells = found.cells;
    if (known_.is_separated()) return known_.is_done();
    if (!found.complete || found.lower || found.lowest.empty()) return false;
    if (found.lowest.front().first == 0 || found.lowest.back().last == 4) return false;
    for (const Arc& arc : found.lowest) add_valley(found.meridian, frame, arc);
    const MeridianProof<I> proof = verify_meridian<I>(pair_, {on_.enclosed, frame}, found.meridian);
    if (!proof.well_formed) return false;
    bound(lower_of(known_.value, proof.least));
    for (const Arc& arc : found.lowest) out_.rings.push_back(ring(*axis, arc));
    out_.meridian = std::move(found.meridian);
    out_.cover.frame = frame;
    out_.reason = "bodies of revolution about one line: a ring of common normals";
    if (slack == 0) out_.unique = Claim::disproved;
    return true;
  }

  /// Where the best direction, or its mirror image, is the lowest place of the arc.
  void add_valley(Meridian& meridian, const Mat3<double>& frame, const Arc& arc) const {
    const S place = place_of<S>(in_frame<S>(frame, known_.best.normal));
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
    if (!known_.minima.empty() && known_.minima.front().exists) return false;
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
    if (cheaper_ == nullptr || known_.minima.size() != 1) return false;
    const Min& only = known_.minima.front();
    const bool is_as_low = write_.to_world(known_.value, known_.value).upper <= cheaper_->overlap.upper;
    if (!is_as_low || !only.exists || !only.is_tight() || !only.lies_in(cheaper_->cover.regions.front())) return false;
    bound(lower_of(known_.value, only.least()));
    out_.cover = cheaper_->cover;
    out_.cells = cheaper_->cells;
    out_.unique = Claim::proved;
    return true;
  }

  void search() {
    if (take_over()) return;
    std::vector<KnownMinimum> start;
    for (const Min& m : known_.minima) start.push_back(known_.for_search(m));
    const Settle settle = [&](const Vec3<double>& direction) -> Settled {
      auto minimum = known_.know(point_from<S>(on_.rough, on_.fine, direction));
      return {known_.is_done(), high(known_.value), std::move(minimum)};
    };
    CoverResult found =
        search_cover(on_.rough, on_.frame, high(known_.value), start, {bounds_gap, most_cells<I>}, settle);
    out_.cells = found.cells;
    if (known_.is_separated()) return;
    conclude(found, verified(found.cover));
  }

  /// In doubles, and in Interval18 where that takes more digits: for the witnesses alone, or for all.
  [[nodiscard]] CoverProof verified(const Cover& cover) const {
    const double level = high(known_.value);
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
    I least = lower_of(known_.value, I(proof.least_open));
    for (const Min& m : known_.minima)
      if (m.is_tight()) least = lower_of(least, m.least());
    bound(least);
    out_.open = std::move(found.open);
    out_.cover = std::move(found.cover);
    if (!out_.open.empty() && settle_by_stationary_directions(least)) return;
    if (found.exhausted)
      out_.reason = "cell budget: directions are left open";
    else if (!out_.open.empty())
      out_.reason = "directions are left open that tie within the gap";
    else if (known_.minima.size() == 1)
      find_among(proof.reach.front(), least);
    const auto is_settled = [](const Min& m) { return m.exists || !m.proof.convex; };
    if (out_.open.empty() && std::all_of(known_.minima.begin(), known_.minima.end(), is_settled))
      out_.unique = Claim::proved;
  }

  /// Bodies of revolution whose axes all but coincide leave a ring of open cells. Its stationary directions are found one by one; whether
  /// they are all there are: then the lowest overlap is that of one of them, or of a tight minimum. `by_cover`: a lower bound.
  bool settle_by_stationary_directions(const I& by_cover) {
    if (on_.in_doubles || !on_.enclosed.body1.axis || !on_.enclosed.body2.axis) return false;
    const StationarySet all = find_stationary(pair_, undecided_cells(out_.cover), {most_cells_of_stationary});
    out_.cells += all.cells;
    if (!all.complete) return false;
    I least = known_.value;
    for (const StationaryPair& each : all.pairs) {
      least = lower_of(least, known_.to_pair(each.overlap_lower));
      if (each.kind == StationaryKind::minimum) known_.look_at(each);
    }
    out_.open.clear();
    tell(all);
    for (const Min& m : known_.minima)
      if (m.is_tight()) least = lower_of(least, m.least());
    bound(is_lower<I>(least, by_cover) ? by_cover : least);
    return true;
  }

  /// Keeps the minima that exist, and says whether each that may be as low as the lowest is among them. Beside a saddle and a maximum there
  /// are lower directions.
  void tell(const StationarySet& all) {
    const Real50 highest = write_.to_world(known_.value, known_.value).upper;
    std::vector<const Min*> told;
    for (const StationaryPair& each : all.pairs) {
      if (each.kind != StationaryKind::minimum) continue;
      const Min* minimum = known_.locate_by(each);
      if (minimum != nullptr && std::find(told.begin(), told.end(), minimum) == told.end())
        told.push_back(minimum);
      else if (!(each.overlap_lower > highest))
        out_.open.push_back(each.normal.template cast<double>());
    }
    std::erase_if(known_.minima, [](const Min& m) { return !m.exists; });
    if (out_.open.empty())
      out_.unique = Claim::proved;
    else
      out_.reason = "a common normal that may be as low is proved and not located";
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

  [[nodiscard]] static I lower_of(const I& a, const I& b) { return low_end<I>(is_lower<I>(a, b) ? a : b); }

  /// The one region holds every direction that is not excluded, and so the lowest: it lies among the bounded leaves.
  void find_among(const Reach& part, const I& least) {
    Min& only = known_.minima.front();
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
    const auto own = std::find_if(known_.minima.begin(), known_.minima.end(),
                                  [&](const Min& m) { return m.exists && high(I(m.proof.value)) < 0; });
    known_.minima = own == known_.minima.end() ? std::vector<Min>{} : std::vector<Min>{Min(*own)};
    I least = least_by_points();
    if (!known_.minima.empty() && high(least) < low(known_.minima.front().least()))
      least = known_.minima.front().least();
    bound(least);
    if (known_.minima.empty()) out_.reason = "the points are not located";
    if (out_.global == Claim::proved) out_.unique = Claim::proved;
    out_.common_normal = write_.solution(known_.best);
    if (!known_.minima.empty()) return;
    // -o(n) is the shadow of the shortest line on n: the cosine between the two is at least -o(n) / distance.
    const I cosine = low_end<I>(I(-high_end<I>(known_.value))) / high_end<I>(I(-least));
    out_.common_normal.proved = true;
    out_.common_normal.bounds = out_.overlap;
    out_.common_normal.normal_radius = angle_of_chord(high(root<I>(magnitude<I>(I(I(2.0) - I(2.0) * cosine)))));
  }

  /// Points that are not proved to lie in their bodies are drawn in, to the centres where need be.
  I least_by_points() {
    const auto [point1, point2] = known_.witness(known_.best);
    const Witness centres{Vec3<double>::Zero(), Vec3<double>::Zero()};
    const double little = 1 - 0x1p-40, much = 1 - 0x1p-20;
    for (const Witness& points : {Witness{point1, point2}, Witness{little * point1, little * point2},
                                  Witness{much * point1, much * point2}, centres}) {
      out_.nearest = points;
      if (const auto least = least_overlap_apart<I>(on_.enclosed, points)) return *least;
    }
    return I(-std::numeric_limits<double>::infinity());
  }

  void bound(const I& least) {
    out_.overlap = write_.to_world(least, known_.value);
    const bool is_close = high(I(high_end<I>(known_.value) - low_end<I>(least))) <= bounds_gap * on_.rough.size();
    if (is_close && isfinite(out_.overlap.lower) && isfinite(out_.overlap.upper)) out_.global = Claim::proved;
  }

  /// The lowest minimum is the answer; others whose bounds meet its own tie with it.
  void report() {
    out_.direction = known_.best.normal.template cast<Real50>();
    if (out_.overlap.lower > 0) out_.verdict = Verdict::overlapping;
    if (out_.overlap.upper < 0) out_.verdict = Verdict::separated;
    const auto lower = [](const Min& a, const Min& b) { return a.at.overlap < b.at.overlap; };
    std::stable_sort(known_.minima.begin(), known_.minima.end(), lower);
    const auto is_unlocated = [](const Min& m) { return !m.exists; };
    bool may_be_elsewhere = false;
    for (const Min& m : known_.minima)
      if (is_unlocated(m) && m.proof.convex && !is_below<I>(known_.value, m.least())) {
        may_be_elsewhere = true;
        out_.open.push_back(m.normal.template cast<double>());
      }
    known_.minima.erase(std::remove_if(known_.minima.begin(), known_.minima.end(), is_unlocated), known_.minima.end());
    const bool is_best_proved =
        !known_.minima.empty() && !is_below<I>(known_.value, may_be_elsewhere ? known_.minima.front().proof.value
                                                                              : known_.minima.front().least());
    if (is_best_proved)
      out_.common_normal = write_.solution(known_.minima.front());
    else if (!known_.is_separated())
      out_.common_normal = write_.solution(known_.best);
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
    for (std::size_t k = first; k < known_.minima.size(); ++k) {
      Solution other = write_.solution(known_.minima[k]);
      if (other.bounds.lower > out_.overlap.upper + close) continue;
      const bool is_tied = other.bounds.lower <= out_.overlap.upper;
      (is_tied ? out_.tied : out_.close).push_back(std::move(other));
    }
  }

  const Pair& pair_;
  const Reference* const cheaper_;  ///< whose cover is closed; null where there is none
  const Setting<I, S> on_;
  KnownMinima<I, S> known_;
  const SolutionWriter<I, S> write_;
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
