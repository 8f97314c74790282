// plumb_certify, in a library of its own: it needs MPFI, MPFR and GMP.
#include <cmath>
#include <cstring>
#include <limits>
#include <new>

#include "solver/c/door.hpp"
#include "solver/plumb.h"
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

}  // namespace
}  // namespace plumb

extern "C" int plumb_certify(const plumb_pair* pair, plumb_certificate* certificate) {
  const plumb::StandardArithmetic mode;
  if (pair == nullptr || certificate == nullptr || certificate->size < sizeof(std::size_t)) return PLUMB_ERROR_ARGUMENT;
  const plumb::Pair bodies = plumb::door::pair_of(*pair);
  if (!plumb::is_valid(bodies)) return PLUMB_ERROR_ARGUMENT;
  try {
    const plumb_certificate found = plumb::certificate_of(plumb::find_reference(bodies), certificate->size);
    std::memcpy(certificate, &found, std::min(certificate->size, sizeof found));
    return PLUMB_OK;
  } catch (const std::bad_alloc&) {
    return PLUMB_ERROR_MEMORY;
  } catch (...) {
    return PLUMB_ERROR_INTERNAL;
  }
}
