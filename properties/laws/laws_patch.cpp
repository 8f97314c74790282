#include "properties/laws/laws_patch.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "properties/generators/draft.hpp"
#include "solver/method/methods.hpp"
#include "solver/patch/patch.hpp"
#include "solver/reference/lens_bounds.hpp"
#include "solver/scalar.hpp"

namespace plumb {
namespace {

double width_of(const Patch& patch) {
  return std::sqrt(patch.second_moments[0]);
}

/// Of a body inside the other the area is 0: errors are measured with that of what encloses the lens.
double area_scale(const Patch& patch) {
  return std::max(patch.area, patch.volume / width_of(patch));
}

Vec3<double> area_vector(const Patch& patch) {
  return patch.normal.allFinite() ? Vec3<double>(patch.area * patch.normal) : Vec3<double>::Zero();
}

/// Second moments where `to_widths` takes a patch's widths to 1: from roots, for squares lose the thickness of a thin lens.
Mat3<double> spread_in(const Mat3<double>& to_widths, const Patch& patch) {
  const Mat3<double> roots = to_widths * patch.axes * patch.second_moments.cwiseSqrt().asDiagonal();
  return roots * roots.transpose();
}

/// What a patch may be off: what it says, and as much as was allowed.
double slack_of(const Patch& patch, double tolerance) {
  return std::max(patch.error, tolerance);
}

Finding compared(FindingKind kind, double error, double allowed, const char* what) {
  const double severity = std::isnan(error) ? HUGE_VAL : error / allowed;
  if (!(severity > 1)) return {};
  return {kind, severity, {}, fmt::format("{}: {:.3g}, allowed {:.3g}", what, error, allowed)};
}

/// Two patches, by a relative difference. What says of itself that no digit of it is right, or that there is none, is not contradicted.
Finding differing(FindingKind kind, double error, double allowed, const char* what) {
  return allowed < 1 ? compared(kind, error, allowed, what) : Finding{};
}

Finding is_a_patch(const PatchEvidence& e) {
  const Patch& p = e.patch;
  const bool are_numbers = std::isfinite(p.volume) && std::isfinite(p.area) && std::isfinite(p.error) &&
                           p.centre.allFinite() && p.area_moment.allFinite() && p.second_moments.allFinite();
  if (!are_numbers) return {FindingKind::not_finite, HUGE_VAL, {}, "a number of the patch is none"};
  const bool is_positive = p.volume > 0 && p.area >= 0 && p.error > 0 && p.second_moments[2] >= 0;
  const bool is_descending = p.second_moments[0] >= p.second_moments[1] && p.second_moments[1] >= p.second_moments[2];
  if (!is_positive || !is_descending)
    return {FindingKind::point_error, HUGE_VAL, {}, "volume, area, error or a second moment has a wrong sign or place"};
  const Vec3<double> third = p.axes.col(0).cross(p.axes.col(1));
  const bool is_to_body2 = !p.normal.allFinite() || p.axes.col(2).dot(p.normal) >= 0;
  if (third.dot(p.axes.col(2)) < 0 || !is_to_body2)
    return {FindingKind::misaligned, HUGE_VAL, {}, "axes that are left-handed, or the third to body 1"};
  const double off = (p.axes.transpose() * p.axes - Mat3<double>::Identity()).norm();
  return compared(FindingKind::misaligned, off, 1e-13, "axes that are not orthonormal");
}

Finding has_its_error(const PatchEvidence& e) {
  const double finer = 1e-2 * e.tolerance;
  const Patch fine = e.solve(e.pair, finer);
  return differing(FindingKind::overlap_error, difference(e.patch, fine),
                   slack_of(e.patch, e.tolerance) + slack_of(fine, finer), "difference from a finer patch");
}

Finding is_exchanged(const PatchEvidence& e) {
  const Patch other = e.solve(swapped(e.pair), e.tolerance);
  return differing(FindingKind::asymmetric, difference(other, e.patch, -1),
                   slack_of(e.patch, e.tolerance) + slack_of(other, e.tolerance),
                   "difference from the exchanged pair's");
}

Finding keeps_its_bits(const PatchEvidence& e) {
  Pair large = e.pair;
  scale(large, 8);
  const Patch other = e.solve(large, e.tolerance);
  const bool is_same = other.volume == 512 * e.patch.volume && other.area == 64 * e.patch.area &&
                       other.second_moments == 64 * e.patch.second_moments && other.error == e.patch.error;
  if (is_same) return {};
  return {FindingKind::nondeterministic, HUGE_VAL, {}, "a unit of a power of two changes bits of the patch"};
}

/// Turned by 120 degrees about (1, 1, 1), which permutes axes and components and rounds nothing.
Finding moves_along(const PatchEvidence& e) {
  const auto turned = [](const Vec3<double>& v) -> Vec3<double> { return {v[2], v[0], v[1]}; };
  Pair moved = e.pair;
  for (Body* body : {&moved.body1, &moved.body2}) {
    body->position = turned(body->position);
    body->quaternion = product({1, 1, 1, 1}, body->quaternion);
  }
  Patch want = e.patch;
  want.normal = turned(want.normal), want.centre = turned(want.centre), want.area_moment = turned(want.area_moment);
  for (int k = 0; k < 3; ++k) want.axes.col(k) = turned(e.patch.axes.col(k));
  const Patch got = e.solve(moved, e.tolerance);
  return differing(FindingKind::asymmetric, difference(got, want),
                   slack_of(e.patch, e.tolerance) + slack_of(got, e.tolerance), "difference from the turned pair's");
}

/// The volume's central difference as body 2 is moved forwards and backwards, and the larger error of the two volumes.
struct Slope {
  double value, error;
};

Slope slope(const PatchEvidence& e, double tolerance, const std::function<void(Body&, double)>& move, double step) {
  Pair forwards = e.pair, backwards = e.pair;
  move(forwards.body2, step);
  move(backwards.body2, -step);
  const Patch after = e.solve(forwards, tolerance), before = e.solve(backwards, tolerance);
  return {(after.volume - before.volume) / (2 * step), std::max(after.error, before.error)};
}

/// The same rotation, by a power of two: a turn of a quaternion of 1e-310 would be lost in rounding.
Quaternion of_usual_length(Quaternion q) {
  double largest = 0;
  for (const double x : q) largest = std::max(largest, std::abs(x));
  for (double& x : q) x = std::ldexp(x, -std::ilogb(largest));
  return q;
}

/// dV = -a . dx for a shift of body 2, dV = -m . dw for a turn about the centre; `share`: of the lens's thickness.
Finding gradient_by_steps(const PatchEvidence& e, double share) {
  const double fine = 1e-6, curving = 2e-3;  // what third derivatives do
  const Patch p = e.solve(e.pair, fine);
  const double width = width_of(p), area = area_scale(p), shift = share * p.volume / area, turned = shift / width;
  double off = 0, error = p.error;
  const auto differ = [&](const Slope& found, double from, double unit) {
    off = std::max(off, std::abs(found.value + from) / unit);
    error = std::max(error, found.error);
  };
  for (int k = 0; k < 3; ++k) {
    const Vec3<double> axis = Vec3<double>::Unit(k);
    const auto move = [&](Body& b, double by) { b.position += by * axis; };
    const auto turn_about_centre = [&](Body& b, double by) {
      const Vec3<double> from = b.position - p.centre, across = axis.cross(from);
      b.quaternion = product(turn(axis, by), of_usual_length(b.quaternion));
      b.position += std::sin(by) * across + (1 - std::cos(by)) * axis.cross(across);
    };
    differ(slope(e, fine, move, shift), area_vector(p)[k], 1);
    differ(slope(e, fine, turn_about_centre, turned), p.area_moment[k], width);
  }
  const double noise = 10 * error * p.volume / shift;
  return compared(FindingKind::misaligned, off, noise + curving * area,
                  "area vector and moment against the volume's differences");
}

/// A superellipsoid's (Dirichlet's integral).
double volume_of(const Superellipsoid<double>& shape) {
  const double e1 = 1 / shape.n1, e2 = 1 / shape.n2;
  return 8 * shape.semi_axes.prod() * e2 * std::beta(e2, e2 + 1) * e1 * std::beta(e1, 2 * e1 + 1);
}

/// Body 1, cut through the patch's centre, is both its parts: their volumes, and their moments about its own centre.
Finding adds_up(const PatchEvidence& e) {
  const Body& body = e.pair.body1;
  const Vec3<double> across = e.patch.axes.col(2);
  const Patch below = patch_at_wall(body, across, e.patch.centre, e.tolerance),
              above = patch_at_wall(body, -across, e.patch.centre, e.tolerance);
  const double slack = slack_of(below, e.tolerance) + slack_of(above, e.tolerance), volume = volume_of(body.shape);
  const double off_volume = (below.volume - volume + above.volume) / volume;
  const Finding of_volume = differing(FindingKind::overlap_error, std::abs(off_volume), slack, "volume of two parts");
  if (of_volume.kind != FindingKind::none) return of_volume;
  const Vec3<double> moment =
      below.volume * (below.centre - body.position) + above.volume * (above.centre - body.position);
  const double width = body.shape.semi_axes.maxCoeff() + 8 * epsilon<double>() / slack * body.position.norm();
  return differing(FindingKind::point_error, moment.norm() / (volume * width), slack, "centre of two parts");
}

/// Where it seems not to, half the step tells: what third derivatives do falls fourfold.
Finding has_the_gradient(const PatchEvidence& e) {
  const double share = 0.02;
  const Finding found = gradient_by_steps(e, share);
  return found.kind == FindingKind::none ? found : gradient_by_steps(e, share / 2);
}

Finding within(const reference::LensBounds& bounds, const PatchEvidence& e) {
  const double slack = slack_of(e.patch, e.tolerance), width = width_of(e.patch);
  const double off_volume = std::max(bounds.volume_lower - e.patch.volume, e.patch.volume - bounds.volume_upper);
  const Vec3<double> off_centre = (bounds.centre_lower - e.patch.centre).cwiseMax(e.patch.centre - bounds.centre_upper);
  const Finding volume =
      compared(FindingKind::overlap_error, off_volume, slack * e.patch.volume, "volume off its bounds");
  if (volume.kind != FindingKind::none) return volume;
  const Finding centre =
      compared(FindingKind::point_error, off_centre.maxCoeff(), slack * width, "centre off its bounds");
  if (centre.kind != FindingKind::none) return centre;
  const Vec3<double>& moments = e.patch.second_moments;
  const Vec3<double> off_moments =
      (bounds.moments_lower - moments).cwiseMax(moments - bounds.moments_upper).cwiseQuotient(moments);
  return compared(FindingKind::point_error, off_moments.maxCoeff(), 4 * slack, "second moments off their bounds");
}

Finding is_within_bounds(const PatchEvidence& e) {
  return against_bounds(e).finding;
}

/// The largest component of the area vector.
Finding has_its_area(const PatchEvidence& e) {
  const int level = 2;
  const double share =
      0.5;  // of the lens's thickness: less, and the bounds of volumes are too wide for it; more, and the volume is curved
  Eigen::Index axis = 0;
  const Vec3<double> vector = area_vector(e.patch);
  if (!(vector.cwiseAbs().maxCoeff(&axis) > 0)) return {};
  const double shift = share * e.patch.volume / area_scale(e.patch);
  const Contact<double> contact = find_method("auto")->solve(e.pair, {}, nullptr);
  const reference::AreaBounds bounds = reference::bound_area(e.pair, contact, static_cast<int>(axis), shift, level);
  const double off = std::max(bounds.lower - vector[axis], vector[axis] - bounds.upper);
  return compared(FindingKind::overlap_error, std::isnan(off) ? 0 : off,
                  slack_of(e.patch, e.tolerance) * area_scale(e.patch), "area off its bounds");
}

constexpr std::array all_patch_laws{
    PatchLaw{"patch", "numbers, positive where they must be, on orthonormal axes", is_a_patch},
    PatchLaw{"bounds", "volume and centre lie within the certified bounds", is_within_bounds, false},
    PatchLaw{"area", "the area lies within the certified bounds", has_its_area, false},
    PatchLaw{"error", "a hundred times the accuracy moves it by no more than its error", has_its_error},
    PatchLaw{"exchange", "(B, A) has the patch of (A, B), its normal and moment reversed", is_exchanged},
    PatchLaw{"motion", "a rigid motion moves it along", moves_along},
    PatchLaw{"unit", "a unit that is a power of two changes no bit", keeps_its_bits},
    PatchLaw{"parts", "a body cut in two is both its parts", adds_up, false},
    PatchLaw{"gradient", "the volume's derivatives by the pose are minus area vector and moment", has_the_gradient,
             false},
};

}  // namespace

std::span<const PatchLaw> patch_laws() {
  return all_patch_laws;
}

Finding judge_patch(const PatchEvidence& evidence) {
  for (const PatchLaw& law : patch_laws()) {
    Finding found = law.check(evidence);
    if (found.kind == FindingKind::none) continue;
    found.law = law.name;
    return found;
  }
  return {};
}

BoundsSaid against_bounds(const PatchEvidence& evidence, int level) {
  const Contact<double> contact = find_method("auto")->solve(evidence.pair, {}, nullptr);
  const reference::LensBounds bounds = reference::bound_lens(evidence.pair, contact, level, evidence.patch.axes);
  if (!std::isfinite(bounds.volume_upper)) return {};
  return {within(bounds, evidence), (bounds.volume_upper - bounds.volume_lower) / evidence.patch.volume};
}

double difference(const Patch& a, const Patch& b, int side) {
  const double width = width_of(b), area = area_scale(b), rounding = 4 * epsilon<double>() * b.centre.norm();
  const Vec3<double> widths = b.second_moments.cwiseSqrt().array() + rounding;
  const Mat3<double> to_widths = widths.cwiseInverse().asDiagonal() * b.axes.transpose();
  const std::array parts{
      std::abs(a.volume - b.volume) / b.volume, (side * area_vector(a) - area_vector(b)).norm() / area,
      (to_widths * (a.centre - b.centre)).norm(), (spread_in(to_widths, a) - spread_in(to_widths, b)).norm(),
      (side * a.area_moment - b.area_moment).norm() / (area * width)};
  double worst = 0;
  for (const double part : parts) worst = part <= worst ? worst : part;  // NaN is the worst
  return worst;
}

bool has_volumes(const Pair& pair) {
  const double longest = 1e90;
  const double size = size_of(pair);
  return size < longest && size > 1 / longest;
}

}  // namespace plumb
