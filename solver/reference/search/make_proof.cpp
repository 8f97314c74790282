#include "solver/reference/search/make_proof.hpp"

#include <cmath>

#include "solver/pose.hpp"
#include "solver/reference/frame.hpp"
#include "solver/reference/proof/meridian.hpp"
#include "solver/standard_arithmetic.hpp"

namespace plumb::reference {
namespace {

SplitVector split(const Vec3<Real50>& v) {
  SplitVector out;
  out.high = v.cast<double>();
  out.low = (v - out.high.cast<Real50>()).cast<double>();
  return out;
}

/// The chart point of a region's face; nothing where the direction lies outside the region.
std::optional<SplitVector> chart_point_in(const Cell& region, const Vec3<Real50>& v) {
  const Real50 along = v[region.axis] * region.sign;
  if (!(along > 0)) return {};
  SplitVector out = split(Vec3<Real50>(v / along));
  out.high[region.axis] = region.sign;
  out.low[region.axis] = 0;
  const bool inside = ((out.high - region.at(0, 0)).cwiseAbs().array() <= region.half).all();
  return inside ? std::optional(out) : std::nullopt;
}

/// The directions that the reference tells, in the frame, the lowest first.
std::vector<Vec3<Real50>> directions_of(const Reference& reference, const Mat3<double>& frame) {
  std::vector<Vec3<Real50>> out{in_frame(frame, reference.direction), in_frame(frame, reference.common_normal.normal)};
  for (const auto* others : {&reference.tied, &reference.close})
    for (const Solution& other : *others) out.push_back(in_frame(frame, other.normal));
  return out;
}

/// Of the directions that the region holds and its middle, the one that bounds o on it best.
SplitVector solution_in(const Cell& region, const FramedPair<Interval80>& framed,
                        const std::vector<Vec3<Real50>>& directions) {
  SplitVector best{region.at(0, 0), Vec3<double>::Zero()};
  const auto bound_by = [&](const SplitVector& point) {
    const auto proof = verify_region<Interval80>(framed, region, point.enclosed());
    const Interval80 bound = proof.value - proof.deficit;
    return proof.convex ? low_as<Real50>(bound) : Bounds().lower;
  };
  Real50 highest = bound_by(best);
  for (const Vec3<Real50>& direction : directions) {
    const auto point = chart_point_in(region, direction);
    if (!point) continue;
    const Real50 bound = bound_by(*point);
    if (!(bound > highest)) continue;
    highest = bound;
    best = *point;
  }
  return best;
}

Proof proof_by_cover(const Pair& pair, const Reference& reference) {
  Proof out;
  out.cover = reference.cover;
  const FramedPair<Interval80> framed(enclose<Interval80>(pair), out.cover.frame);
  const std::vector<Vec3<Real50>> directions = directions_of(reference, out.cover.frame);
  for (const Cell& region : out.cover.regions) out.solutions.push_back(solution_in(region, framed, directions));
  const Real50 level = ldexp(reference.overlap.upper, -place<double>(pair).exponent);
  out.level = mpfr_get_d(level.backend().data(), MPFR_RNDU);
  out.direction = split(directions.front());
  return out;
}

/// Adds the widest region about the direction in which the verifier locates the common normal, if there is one.
void add_region(const Pair& pair, Proof& proof) {
  const int widest = -3, narrowest = -49;  // half-widths, powers of two
  const FramedPair<Interval80> framed(enclose<Interval80>(pair), proof.cover.frame);
  const Vec3<Real50> v = proof.direction.high.cast<Real50>() + proof.direction.low.cast<Real50>();
  for (int power = widest; power >= narrowest; --power) {
    const Cell region{2, 1, static_cast<double>(v[0] / v[2]), static_cast<double>(v[1] / v[2]), std::ldexp(1.0, power)};
    const auto chart = chart_point_in(region, v);
    if (!chart) return;
    if (!verify_region<Interval80>(framed, region, chart->enclosed()).located) continue;
    proof.cover.regions.push_back(region);
    proof.solutions.push_back(*chart);
    return;
  }
}

Proof proof_of_distance(const Pair& pair, const Reference& reference) {
  Proof out;
  out.cover.frame = frame_about(reference.direction.cast<double>());
  out.direction = split(in_frame(out.cover.frame, reference.direction));
  out.kind = ProofKind::apart;
  out.apart = reference.nearest.value_or(Witness{Vec3<double>::Zero(), Vec3<double>::Zero()});
  add_region(pair, out);
  return out;
}

Proof proof_by_meridian(const Reference& reference) {
  Proof out;
  out.kind = ProofKind::meridian;
  out.cover.frame = reference.cover.frame;
  out.meridian = reference.meridian;
  out.direction = split(in_frame(out.cover.frame, reference.direction));
  return out;
}

Proof proof_of_spheres(const Reference& reference) {
  Proof out;
  out.kind = ProofKind::spheres;
  out.direction = split(reference.direction);
  return out;
}

}  // namespace

std::optional<Proof> make_proof(const Pair& pair, const Reference& reference) {
  const StandardArithmetic mode;
  if (reference.overlap.upper < 0) return proof_of_distance(pair, reference);
  if (!reference.cover.tree.empty()) return proof_by_cover(pair, reference);
  if (!reference.meridian.witnesses.empty()) return proof_by_meridian(reference);
  if (is_sphere(pair.body1.shape) && is_sphere(pair.body2.shape)) return proof_of_spheres(reference);
  return {};
}

}  // namespace plumb::reference
