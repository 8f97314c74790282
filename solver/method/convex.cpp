#include "solver/method/convex.hpp"

#include <optional>

#include "solver/method/automatic.hpp"
#include "solver/method/common.hpp"
#include "solver/method/convex/direction_search.hpp"
#include "solver/method/convex/flat_faces.hpp"
#include "solver/method/convex/meridian_search.hpp"
#include "solver/method/convex/polytope_contact.hpp"
#include "solver/method/convex/shared_face.hpp"
#include "solver/method/derivatives.hpp"
#include "solver/standard_arithmetic.hpp"

namespace plumb {
namespace detail {
namespace {

/// The frame of a pair: origin at body 1, lengths over 2^exponent.
struct ConvexFrame {
  int exponent;
  Vec3<double> origin;

  explicit ConvexFrame(const ConvexPair& pair) : exponent(exponent_of(pair)), origin(pair.body1.position) {}

  /// Of the larger body's size; of bodies so far apart that squares of the distance would overflow, of a share of that.
  [[nodiscard]] static int exponent_of(const ConvexPair& pair) {
    constexpr double share = 0x1p-100;
    const Vec3<double> apart = pair.body2.position * share - pair.body1.position * share;
    return exponent_above(std::max(size_of(pair), apart.cwiseAbs().maxCoeff())) - 1;
  }
  [[nodiscard]] Vec3<double> to_world(const Vec3<double>& x) const { return PowerOfTwo<double>(exponent)(x) + origin; }
  [[nodiscard]] double to_world(double length) const { return PowerOfTwo<double>(exponent)(length); }
  /// Large units are divided out before the subtraction, small ones after it, as in PairFrame.
  [[nodiscard]] Vec3<double> to_centre(const ConvexPair& pair) const {
    const int before = std::max(exponent, 0);
    const PowerOfTwo<double> large(-before), small(before - exponent);
    return small(Vec3<double>(large(pair.body2.position) - large(pair.body1.position)));
  }
};

using Watches = std::array<ForeignWatch, 2>;

[[nodiscard]] PlacedCores placed(const ConvexPair& pair, const ConvexFrame& frame, Watches& watches) {
  const CoreOf core_of(frame.exponent, watches[0]), core_of_second(frame.exponent, watches[1]);
  const RoundedCore first = std::visit(core_of, pair.body1.shape),
                    second = std::visit(core_of_second, pair.body2.shape);
  const Vec3<double> centre = frame.to_centre(pair);
  const double size = PowerOfTwo<double>(-frame.exponent)(size_of(pair));
  return {{first.core, rotation<double>(pair.body1.quaternion), Vec3<double>::Zero()},
          {second.core, rotation<double>(pair.body2.quaternion), centre},
          first.radius + core_of.unit(pair.body1.swept_radius),
          second.radius + core_of.unit(pair.body2.swept_radius),
          std::max(size, centre.cwiseAbs().maxCoeff())};
}

/// What a descent from the best's own normal leads to, where that is exact: it came from another, and its points are of pieces seen from there.
[[nodiscard]] CommonNormal seen_again(const PlacedCores& pair, const BestNormal& found, const CommonNormal& best) {
  const Descent descent(pair, true);
  const CommonNormal again = descent.from(best.normal);
  return found.is_low(again) && descent.is_exact(again) ? again : best;
}

template <class Search>
[[nodiscard]] Lowest lowest_by(Search search, const PlacedCores& pair, const Descent& descent) {
  const bool is_complete = search.run();
  const BestNormal& found = search.best();
  CommonNormal best = settled_on_a_face(pair, descent, found.normal(), found.lowest() + pair.rounding());
  if (!descent.is_exact(best)) best = seen_again(pair, found, best);
  // Of cores apart there is one common normal alone, and nothing else has to be excluded.
  const bool is_lowest = best.overlap < 0 || (is_complete && found.is_low(best));
  return {best, is_lowest && descent.is_exact(best), search.cells()};
}

/// With the cells of the search before.
[[nodiscard]] Lowest after(const Lowest& before, Lowest next) {
  next.cells += before.cells;
  return next;
}

[[nodiscard]] Lowest lowest_by_search(const PlacedCores& pair, const Vec3<double>& line) {
  using Turned = MeridianSearch::Turned;
  const Descent descent(pair);
  Lowest found{descent.from(line), false, 0};
  const auto search_about = [&](const std::optional<MeridianSearch::Axis>& axis) {
    if (axis && !found.is_proved)
      found = after(found, lowest_by(MeridianSearch(pair, *axis, found.contact), pair, descent));
  };
  const auto search_all = [&](int cells) {
    if (!found.is_proved) found = after(found, lowest_by(DirectionSearch(pair, found.contact, cells), pair, descent));
  };
  constexpr int few = 12'000, many = 120'000;  // of 240 000 pairs that lie anyhow none took more than the few
  constexpr double all_but_one = 0x1p-8, roughly_one = 0x1p-5;
  const auto common = MeridianSearch::common_axis(pair, all_but_one);
  search_about(common);
  search_all(few);
  for (const Turned turned : {Turned::first, Turned::second}) search_about(MeridianSearch::axis_of(pair, turned));
  if (!common) search_about(MeridianSearch::common_axis(pair, roughly_one));
  search_all(many);
  return found;
}

/// Of cores apart there is one common normal; of faces that are parallel the middle of what they share is taken.
[[nodiscard]] Lowest nearest_points(const PlacedCores& pair, const Nearest& nearest, const Vec3<double>& line) {
  const Descent descent(pair);
  CommonNormal found = descent.sharpened(nearest);
  // Of what is apart by little more than rounding more is seen from farther away, and otherwise from elsewhere.
  for (const Vec3<double>& n : {found.normal, line})
    if (!descent.is_exact(found)) {
      const CommonNormal next = descent.from(n);
      found = settled_on_a_face(pair, descent, next, next.overlap + pair.rounding());
    }
  if (pair.are_polytopes())
    if (const auto shared = SharedFace(pair, found.normal).contact(); shared && descent.is_exact(*shared))
      return {*shared, true, 0};
  return {found, descent.is_exact(found), 0};
}

/// `line`: where to begin.
[[nodiscard]] Lowest lowest_of_cores(const PlacedCores& pair, const Vec3<double>& line) {
  if (pair.are_polytopes() && pair.overlap(line) > 0)  // sooner than the nearest points are found
    if (const auto overlapping = lowest_of_polytopes(pair, line)) return *overlapping;
  const Nearest nearest = NearestPoint(pair, Vec3<double>::Zero(), line).find();
  if (!nearest.is_inside) {
    const Lowest apart = nearest_points(pair, nearest, line);
    const double overlap = apart.contact.overlap;
    if (overlap < 0 && apart.is_proved) return apart;
    if (overlap < 0 && !pair.all_but_touch(overlap))
      return nearest_features(pair, apart.contact.normal).value_or(apart);
  }
  const Lowest found = lowest_by_search(pair, line);
  return found.is_proved ? found : nearest_features(pair, found.contact.normal).value_or(found);
}

/// From the normal of the contact before, or along the line of centres: polytopes are solved no sooner from a normal, and what is wrong
/// with a foreign shape is to be seen again.
[[nodiscard]] Vec3<double> where_to_begin(const PlacedCores& pair, const Contact<double>* last) {
  if (last != nullptr && !pair.are_polytopes() && !pair.body1.is_foreign() && !pair.body2.is_foreign()) {
    const Vec3<double> n = pair.body1.rotation * last->chart1 - pair.body2.rotation * last->chart2;
    if (n.squaredNorm() > 1 && n.squaredNorm() < 5) return n.normalized();
  }
  const Vec3<double>& c = pair.body2.centre;
  return c.isZero(0) ? Vec3<double>::UnitZ().eval() : c.stableNormalized().eval();
}

[[nodiscard]] Lowest lowest_of(const ConvexPair& bodies, const PlacedCores& pair, const Vec3<double>& line) {
  const auto on_plane = [&](bool is_first, const PlacedCore& plane) {
    return Lowest{contact_on_plane(pair, is_first, plane.centre, plane.rotation.col(2)), true, 0};
  };
  if (std::holds_alternative<HalfSpace>(bodies.body1.shape)) return on_plane(true, pair.body1);
  if (std::holds_alternative<HalfSpace>(bodies.body2.shape)) return on_plane(false, pair.body2);
  return lowest_of_cores(pair, line);
}

/// A contact of the bodies, in the world.
struct WorldContact {
  double overlap;
  Vec3<double> normal, point1, point2;
};

void write(const WorldContact& found, Verdict verdict, const Want& want, Contact<double>& out) {
  out.verdict = verdict;
  if (want.overlap) out.overlap = found.overlap;
  if (want.normal) out.normal = found.normal;
  if (!want.points) return;
  out.point1 = found.point1;
  out.point2 = found.point2;
  out.contact_point = found.point1 / 2 + found.point2 / 2;
}

/// Both bodies without their radii, where they are superellipsoids.
[[nodiscard]] std::optional<Pair> superellipsoids_of(const ConvexPair& pair) {
  const auto *first = std::get_if<Superellipsoid<double>>(&pair.body1.shape),
             *second = std::get_if<Superellipsoid<double>>(&pair.body2.shape);
  if (first == nullptr || second == nullptr) return std::nullopt;
  Pair out;
  out.body1 = {*first, pair.body1.position, pair.body1.quaternion};
  out.body2 = {*second, pair.body2.position, pair.body2.quaternion};
  return out;
}

/// Swept by a sphere, which turns no normal.
[[nodiscard]] PrincipalCurvature<double> rounded(PrincipalCurvature<double> of, double radius) {
  of.radius1 += radius;
  of.radius2 += radius;
  return of;
}

/// Two superellipsoids swept by spheres: `auto` knows the cores' contact, and the bodies' has the same normal.
[[nodiscard]] Contact<double> solve_swept(const ConvexPair& bodies, const Pair& cores, const Want& want,
                                          const Contact<double>* last) {
  const double r1 = bodies.body1.swept_radius, r2 = bodies.body2.swept_radius;
  if (r1 + r2 == 0) return automatic<double>(cores, want, last);
  Want all = want;
  all.overlap = all.normal = all.points = true;
  const Contact<double> core = automatic<double>(cores, all, last);
  Contact<double> out = core;
  out.overlap = std::numeric_limits<double>::quiet_NaN();
  out.normal = out.point1 = out.point2 = out.contact_point = not_valid<double>();
  const double overlap = core.overlap + r1 + r2;
  write({overlap, core.normal, core.point1 + r1 * core.normal, core.point2 - r2 * core.normal},
        verdict_of<double>(overlap, size_of(bodies)), want, out);
  if (want.curvature) out.curvature = {rounded(core.curvature[0], r1), rounded(core.curvature[1], r2)};
  finish<double>(out, want);
  return out;
}

/// What is handed out where there is no answer.
[[nodiscard]] Contact<double> without_answer(Status status, const Contact<double>& from) {
  Contact<double> out;
  out.method = from.method;
  out.status = status;
  out.iterations = from.iterations;
  out.evaluations = from.evaluations;
  return out;
}

[[nodiscard]] bool has_foreign(const ConvexPair& bodies) {
  return std::holds_alternative<ForeignShape>(bodies.body1.shape) ||
         std::holds_alternative<ForeignShape>(bodies.body2.shape);
}

[[nodiscard]] bool are_equal(const CommonNormal& a, const CommonNormal& b) {
  return a.overlap == b.overlap && a.normal == b.normal && a.point1 == b.point1 && a.point2 == b.point2;
}

/// Once more, every point being held to the plane of the answer's own.
void run_again(const ConvexPair& bodies, const PlacedCores& pair, const Vec3<double>& line, const Lowest& found,
               Watches& watches) {
  const Vec3<double>& n = found.contact.normal;
  for (const auto& [body, shape, watch, sign] : {std::tuple(&pair.body1, &bodies.body1.shape, watches.data(), 1.0),
                                                 {&pair.body2, &bodies.body2.shape, &watches[1], -1.0}}) {
    const auto* foreign = std::get_if<ForeignShape>(shape);
    if (foreign == nullptr) continue;
    const Vec3<double> u = (sign * (body->rotation.transpose() * n)).normalized();
    Vec3<double> x = not_valid<double>();
    foreign->support(foreign->data, u.data(), x.data());
    watch->see(*foreign, u, x);
    watch->hold_to(u, x);
  }
  if (are_equal(lowest_of(bodies, pair, line).contact, found.contact)) return;
  if (pair.body1.is_foreign()) watches[0].blame(ForeignFault::not_the_same);
  if (pair.body2.is_foreign()) watches[1].blame(ForeignFault::not_the_same);
}

/// The lowest common normal, and what is wrong with foreign shapes.
[[nodiscard]] Lowest watched_lowest_of(const ConvexPair& bodies, const PlacedCores& pair, const Vec3<double>& line,
                                       Watches& watches) {
  const Lowest found = lowest_of(bodies, pair, line);
  if (watches[0].has_forgotten() || watches[1].has_forgotten()) run_again(bodies, pair, line, found, watches);
  return found;
}

[[nodiscard]] Status status_of(const Lowest& found, const Watches& watches) {
  for (const ForeignWatch& watch : watches)
    if (watch.fault() != ForeignFault::none)
      return watch.fault() == ForeignFault::not_finite ? Status::not_finite : Status::invalid_input;
  return found.is_proved ? Status::converged : Status::stalled;
}

/// Where a normal turns so many times as fast as a body, rounding says how: of edges that are parallel but for rounding.
[[nodiscard]] bool is_rounding(const PoseDerivative<double>& by) {
  constexpr double fastest = 0x1p40;
  return !(by.normal_by_turn.cwiseAbs().maxCoeff() < fastest);
}

/// Derivatives by the poses are the cores': a radius moves the overlap and turns nothing.
[[nodiscard]] std::array<PoseDerivative<double>, 2> derivatives_of(const PlacedContact<double>& cores, double unit) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  auto out = pose_derivatives<double>(cores);
  if (is_rounding(out[0]) || is_rounding(out[1]))
    for (PoseDerivative<double>& by : out) by.normal_by_shift.fill(none), by.normal_by_turn.fill(none);
  return in_units(out, unit);
}

/// Curvature and derivatives.
void set_second_order(const ConvexPair& bodies, const PlacedCores& pair, const CommonNormal& at, const Want& want,
                      const ConvexFrame& frame, Contact<double>& out) {
  const auto curvature = [&](const ConvexBody& body, const PlacedCore& core, const Vec3<double>& outward,
                             const Vec3<double>& x) {
    return std::holds_alternative<HalfSpace>(body.shape) ? Touch{outward, x, 0}.flat()
                                                         : core.curvature(outward, x, Descent::exact(pair));
  };
  const PlacedContact<double> cores{at.overlap,
                                    at.normal,
                                    {at.point1 - pair.body1.centre, at.point2 - pair.body2.centre},
                                    {curvature(bodies.body1, pair.body1, at.normal, at.point1),
                                     curvature(bodies.body2, pair.body2, -at.normal, at.point2)}};
  const std::array radii{pair.radius1, pair.radius2};
  for (std::size_t i = 0; want.curvature && i < 2; ++i) {
    out.curvature[i] = rounded(cores.curvature[i], radii[i]);
    for (double* radius : {&out.curvature[i].radius1, &out.curvature[i].radius2}) *radius = frame.to_world(*radius);
  }
  if (want.derivatives) out.derivatives = derivatives_of(cores, frame.to_world(1.0));
}

/// Of a legal pair, whatever its status.
[[nodiscard]] Contact<double> solve_by_cores(const ConvexPair& bodies, const Want& want, const Contact<double>* last,
                                             Watches& watches) {
  constexpr double undecided = 64;  // epsilon of the size: what a common normal is exact to
  const ConvexFrame frame(bodies);
  const PlacedCores pair = placed(bodies, frame, watches);
  const Lowest found = watched_lowest_of(bodies, pair, where_to_begin(pair, last), watches);
  const CommonNormal& at = found.contact;
  Contact<double> out;
  out.method = "auto";
  out.status = status_of(found, watches);
  out.evaluations = found.cells;
  const double overlap = at.overlap + pair.radius1 + pair.radius2;
  write({frame.to_world(overlap), at.normal, frame.to_world(Vec3<double>(at.point1 + pair.radius1 * at.normal)),
         frame.to_world(Vec3<double>(at.point2 - pair.radius2 * at.normal))},
        verdict_of<double>(overlap, pair.size, undecided), want, out);
  out.chart1 = pair.body1.rotation.transpose() * at.normal;
  out.chart2 = -(pair.body2.rotation.transpose() * at.normal);
  if (out.status == Status::converged && (want.curvature || want.derivatives))
    set_second_order(bodies, pair, at, want, frame, out);
  finish<double>(out, {.overlap = want.overlap, .normal = want.normal, .points = want.points});
  return out;
}

[[nodiscard]] std::string_view in_words(ForeignFault fault) {
  switch (fault) {
    case ForeignFault::none: return "";
    case ForeignFault::not_finite: return "writes what is no finite number";
    case ForeignFault::beyond_bound: return "writes a point beyond bounding_radius";
    case ForeignFault::below_inscribed: return "writes a point that is less far along n than inscribed_radius";
    case ForeignFault::not_convex: return "writes points of no convex body: one lies beyond the plane of another";
    default: return "does not write the same for the same n";
  }
}

}  // namespace
}  // namespace detail

Contact<double> solve_convex(const ConvexPair& pair, const Want& want, const Contact<double>* last) {
  const StandardArithmetic mode;
  if (!find_input_error(pair).reason.empty()) return detail::without_answer(Status::invalid_input, {});
  Want known = want;
  known.patch = false;
  detail::Watches watches;
  const auto cores = detail::superellipsoids_of(pair);
  const Contact<double> out =
      cores ? detail::solve_swept(pair, *cores, known, last) : detail::solve_by_cores(pair, known, last, watches);
  return out.status == Status::converged ? out : detail::without_answer(out.status, out);
}

InputError find_foreign_error(const ConvexPair& pair) {
  const StandardArithmetic mode;
  if (!detail::has_foreign(pair) || !find_input_error(pair).reason.empty()) return {};
  detail::Watches watches;
  (void)detail::solve_by_cores(pair, {}, nullptr, watches);
  for (int body = 0; body < 2; ++body)
    if (const auto fault = watches[static_cast<std::size_t>(body)].fault(); fault != detail::ForeignFault::none)
      return {"shape.foreign.support", detail::in_words(fault), body};
  return {};
}

}  // namespace plumb
