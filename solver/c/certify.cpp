// plumb_certify and plumb_certify_convex, in a library of their own: it needs MPFI, MPFR and GMP.
#include <cmath>
#include <cstring>
#include <limits>
#include <new>

#include "solver/c/convex_door.hpp"
#include "solver/c/door.hpp"
#include "solver/c/texts.hpp"
#include "solver/plumb.h"
#include "solver/reference/convex_bounds.hpp"
#include "solver/reference/reference.hpp"
#include "solver/standard_arithmetic.hpp"

namespace plumb {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

static_assert(static_cast<int>(Claim::open) == PLUMB_OPEN);
static_assert(static_cast<int>(Claim::proved) == PLUMB_PROVED);
static_assert(static_cast<int>(Claim::disproved) == PLUMB_DISPROVED);

double rounded_down(const Real50& x) {
  const auto near = static_cast<double>(x);
  return Real50(near) > x ? std::nextafter(near, -infinite) : near;
}

double rounded_up(const Real50& x) {
  return -rounded_down(Real50(-x));
}

/// A ball about the vector in doubles that holds the one about the vector: wider by how far the two are from each other.
double write_ball(const Vec3<Real50>& centre, double radius, double (&out)[3]) {
  Real50 moved = 0;
  for (int i = 0; i < 3; ++i) {
    out[i] = static_cast<double>(centre[i]);
    moved += abs(Real50(centre[i] - out[i]));
  }
  return std::nextafter(rounded_up(Real50(radius + moved)), infinite);
}

void write_not_found(plumb_certificate& out) {
  Vec3<double>::Map(out.normal) = not_valid<double>();
  Vec3<double>::Map(out.points[0]) = not_valid<double>();
  Vec3<double>::Map(out.points[1]) = not_valid<double>();
  out.normal_radius = out.points_radius = infinite;
}

void write_common_normal(const Solution& found, plumb_certificate& out) {
  out.normal_radius = write_ball(found.normal, found.normal_radius, out.normal);
  const double radius1 = write_ball(found.point1, found.points_radius, out.points[0]);
  const double radius2 = write_ball(found.point2, found.points_radius, out.points[1]);
  out.points_radius = std::max(radius1, radius2);
}

plumb_certificate certificate_of(const Reference& found, std::size_t size) {
  plumb_certificate out{};
  out.size = size;
  out.verdict = static_cast<int>(found.verdict);
  out.global = static_cast<int>(found.global);
  out.unique = static_cast<int>(found.unique);
  out.overlap_lower = rounded_down(found.overlap.lower);
  out.overlap_upper = rounded_up(found.overlap.upper);
  write_not_found(out);
  if (found.common_normal.proved) write_common_normal(found.common_normal, out);
  out.condition_overlap = found.common_normal.condition.overlap;
  out.condition_normal = found.common_normal.condition.normal;
  out.condition_points = found.common_normal.condition.points;
  return out;
}

Verdict verdict_of_bounds(const reference::ConvexBounds& bounds) {
  if (bounds.lower > 0) return Verdict::overlapping;
  return bounds.upper < 0 ? Verdict::separated : Verdict::undecided;
}

plumb_certificate certificate_of(const ConvexPair& pair, const Vec3<double>& normal, std::size_t size) {
  constexpr int cells = 4000;  // a few milliseconds
  const reference::ConvexBounds found = reference::bound_overlap(pair, normal, cells);
  plumb_certificate out{};
  out.size = size;
  out.verdict = static_cast<int>(verdict_of_bounds(found));
  out.global = static_cast<int>(std::isfinite(found.lower) ? Claim::proved : Claim::open);
  out.unique = static_cast<int>(Claim::open);
  out.overlap_lower = found.lower;
  out.overlap_upper = found.upper;
  write_not_found(out);
  out.condition_overlap = out.condition_normal = out.condition_points = std::numeric_limits<double>::quiet_NaN();
  out.open = c_text(reference::what_is_open(pair, found));
  return out;
}

/// Writes it, as much as the caller has room for, or says why not.
template <class Certify>
int write_certificate(const Certify& certify, plumb_certificate& to) {
  try {
    const plumb_certificate found = certify();
    std::memcpy(&to, &found, std::min(to.size, sizeof found));
    return PLUMB_OK;
  } catch (const std::bad_alloc&) {
    return PLUMB_ERROR_MEMORY;
  } catch (...) {
    return PLUMB_ERROR_INTERNAL;
  }
}

}  // namespace
}  // namespace plumb

using namespace plumb;

extern "C" {

int plumb_certify(const plumb_pair* pair, plumb_certificate* certificate) {
  const StandardArithmetic mode;
  if (pair == nullptr || certificate == nullptr || certificate->size < sizeof(std::size_t)) return PLUMB_ERROR_ARGUMENT;
  const Pair bodies = door::pair_of(*pair);
  if (!is_valid(bodies)) return PLUMB_ERROR_ARGUMENT;
  return write_certificate([&] { return certificate_of(find_reference(bodies), certificate->size); }, *certificate);
}

int plumb_certify_convex(const plumb_convex_pair* pair, const double* normal, plumb_certificate* certificate) {
  const StandardArithmetic mode;
  if (pair == nullptr || certificate == nullptr || certificate->size < sizeof(std::size_t)) return PLUMB_ERROR_ARGUMENT;
  if (!door::error_in_shapes(*pair).reason.empty()) return PLUMB_ERROR_ARGUMENT;
  const ConvexPair bodies = door::pair_of(*pair);
  if (!find_input_error(bodies).reason.empty()) return PLUMB_ERROR_ARGUMENT;
  const Vec3<double> guess = normal == nullptr ? not_valid<double>() : Vec3<double>(Vec3<double>::Map(normal));
  return write_certificate([&] { return certificate_of(bodies, guess, certificate->size); }, *certificate);
}

}  // extern "C"
