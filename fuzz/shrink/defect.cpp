#include "fuzz/shrink/defect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumb {
namespace {

/// Between the sizes of one defect: a mistake in a formula goes with the angles and lengths that shrinking rounds, and 131
/// degrees must not become 0.003.
constexpr double kFactor = 2;

/// What rounding leaves of ordinary pairs (condition numbers below 1e4), in degrees and of the size: below them a size is noise.
constexpr double kLeastDegrees = 1e-9, kLeastLength = 1e-12;

bool is_an_angle(FindingKind kind) {
  return kind == FindingKind::misaligned || kind == FindingKind::wrong_branch;
}

double size_in(const Pair& pair, const Judgement& judgement) {
  switch (judgement.finding.kind) {
    case FindingKind::misaligned:
    case FindingKind::wrong_branch: return judgement.angle_error_deg;
    case FindingKind::overlap_error: return judgement.overlap_error;
    case FindingKind::false_contact:
    case FindingKind::missed_contact: return std::abs(judgement.overlap) / size_of(pair);
    case FindingKind::off_surface:
    case FindingKind::point_error: return judgement.point_error;
    default: return std::numeric_limits<double>::quiet_NaN();
  }
}

double least(FindingKind kind) {
  return is_an_angle(kind) ? kLeastDegrees : kLeastLength;
}

}  // namespace

Defect defect_of(const Pair& pair, const JudgedAnswer& found) {
  return {found.judgement.finding.kind, size_in(pair, found.judgement)};
}

bool is_same(const Defect& from, const Defect& now) {
  if (now.kind != from.kind) return false;
  if (std::isnan(from.size)) return true;
  if (std::isnan(now.size)) return false;
  const double before = std::max(from.size, least(from.kind)), after = std::max(now.size, least(now.kind));
  return after >= before / kFactor && after <= before * kFactor;
}

std::string size_text(const Defect& defect) {
  if (!(defect.size > least(defect.kind))) return "";
  return is_an_angle(defect.kind) ? fmt::format("{:.3g} degrees", defect.size)
                                  : fmt::format("{:.3g} of the size", defect.size);
}

}  // namespace plumb
