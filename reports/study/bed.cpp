#include "reports/study/bed.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "properties/generators/described.hpp"
#include "solver/method/methods.hpp"

namespace plumb::reports {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// Of a direction uniform over the sphere: degrees from the pole.
double any_zenith(Stream& random) {
  return std::acos(random.uniform(-1, 1)) / degree;
}

}  // namespace

Pair pair_of(const Bed& bed, double ratio) {
  Described out;
  for (Body* body : {&out.pair.body1, &out.pair.body2}) body->shape = {Vec3<double>(1, 1, bed.aspect), bed.n1, bed.n2};
  out.euler_deg = {Vec3<double>::Zero(), bed.euler};
  out.place = Vec3<double>(bed.theta_L, bed.phi_L, ratio);
  const std::optional<Pair> found = plumb::pair_of(out);
  if (!found) throw InputFailure("study", 0, "placement", "no first touch found along this line");
  return *found;
}

const std::vector<std::string_view>& studied() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> out;
    for (const bool published : {true, false})
      for (const Method& method : methods())
        if (method.is_published() == published) out.push_back(method.name);
    return out;
  }();
  return names;
}

Bed any_orientation(const Bed& shape, Stream& random) {
  Bed out = shape;
  out.theta_L = any_zenith(random);
  out.phi_L = random.uniform(0, 360);
  const double phi = random.uniform(0, 360), theta = any_zenith(random);
  out.euler << phi, theta, random.uniform(0, 360);
  return out;
}

CertifiedNormal certified_normal(const Pair& pair) {
  const double sharp = 1e-16;  // rad: below what a double shows
  Reference found = find_reference(pair, Effort::proof);
  if (!(found.common_normal.normal_radius <= sharp)) found = find_reference(pair, Effort::digits);
  const bool proved = found.common_normal.normal_radius <= sharp && found.common_normal.solved &&
                      found.common_normal.proved && found.global == Claim::proved && found.unique == Claim::proved;
  return {proved, found.common_normal.normal.cast<double>()};
}

Studied study(std::string_view method, const Pair& pair, const CertifiedNormal& truth) {
  Studied out{find_method(method)->solve(pair, {}, nullptr), {}, std::numeric_limits<double>::quiet_NaN()};
  out.diagnosis = diagnose(pair, out.contact.point1, out.contact.point2, 1);
  if (truth.proved && out.contact.normal.allFinite()) out.off = angle_deg(out.contact.normal, truth.normal);
  return out;
}

Json rounded(double x, int digits) {
  if (!std::isfinite(x)) return nullptr;
  return std::stod(fmt::format("{:.{}e}", x, digits - 1));
}

}  // namespace plumb::reports
