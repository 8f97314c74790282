#include "reports/study/limits.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "corpus/command/in_parallel.hpp"
#include "reports/bench/quantile.hpp"

namespace plumb::reports {
namespace {

struct Difference {
  double angle, point, overlap;
};

/// In 50 digits, so that differences of 1e-12 have digits.
Difference difference(const Truth& common_normal, const Truth& other) {
  const Vec3<Real50> chord = other.normal - common_normal.normal;
  const Vec3<Real50> apart = other.point1 + other.point2 - common_normal.point1 - common_normal.point2;
  return {2 * std::asin(static_cast<double>(chord.norm()) / 2) * (180 / std::numbers::pi),
          static_cast<double>(apart.norm()) / 2 / common_normal.size,
          static_cast<double>(abs(Real50(other.overlap / common_normal.overlap - 1)))};
}

/// By system; empty where an answer is not proved.
using Differences = std::array<std::optional<Difference>, limit_systems.size()>;

Differences differences_of(const Pair& pair) {
  Differences out;
  const Truth common_normal = truth_of(pair, Problem::common_normal);
  for (std::size_t k = 0; k < limit_systems.size() && common_normal.known; ++k)
    if (const Truth other = truth_of(pair, limit_systems[k]); other.known) out[k] = difference(common_normal, other);
  return out;
}

std::string_view method_of(Problem problem) {
  const auto all = methods();
  return std::find_if(all.begin(), all.end(), [&](const Method& m) { return m.problem == problem; })->name;
}

Limit limit_of(std::size_t k, const std::vector<Differences>& all) {
  std::vector<double> angles, points, overlaps;
  for (const Differences& one : all) {
    const std::optional<Difference>& found = one[k];
    if (!found) continue;
    angles.push_back(found->angle);
    points.push_back(found->point);
    overlaps.push_back(found->overlap);
  }
  Limit out{};
  out.system = method_of(limit_systems[k]);
  out.pairs = static_cast<int>(all.size());
  out.certified = static_cast<int>(angles.size());
  out.angle = quantile(angles, 0.5);
  out.angle_max = quantile(angles, 1);
  out.point = quantile(points, 0.5);
  out.overlap = quantile(overlaps, 0.5);
  return out;
}

struct Shape {
  std::string words;
  Bed bed;
};

std::vector<Shape> shapes_to_the_limit() {
  std::vector<Shape> out;
  for (const double aspect : {1.5, 2.0, 3.0}) out.push_back({fmt::format("aspect {:g}", aspect), {.aspect = aspect}});
  for (const double n : {3.0, 4.0})
    out.push_back({fmt::format("aspect 1.5, exponents {0:g}, {0:g}", n), {.aspect = 1.5, .n1 = n, .n2 = n}});
  return out;
}

}  // namespace

Order order_of(const Limit& larger, const Limit& smaller) {
  const auto slope = [&](double Limit::* of) {
    return std::log(larger.*of / (smaller.*of)) / std::log(larger.x / smaller.x);
  };
  return {smaller.shape,        smaller.system,         slope(&Limit::angle),
          slope(&Limit::point), slope(&Limit::overlap), smaller.angle};
}

std::vector<Limit> limits_of(std::string_view sweep, const std::string& shape, const Bed& bed, double x, double ratio,
                             int pairs, std::uint64_t seed, unsigned threads) {
  std::vector<Differences> all(static_cast<std::size_t>(pairs));
  in_parallel(all.size(), threads, [&](std::size_t i) {
    Stream random("study_limit", seed, i);
    all[i] = differences_of(pair_of(any_orientation(bed, random), ratio));
  });
  std::vector<Limit> out;
  for (std::size_t k = 0; k < limit_systems.size(); ++k) {
    out.push_back(limit_of(k, all));
    out.back().sweep = sweep;
    out.back().shape = shape;
    out.back().x = x;
  }
  return out;
}

Limits find_limits(int pairs, std::uint64_t seed, unsigned threads) {
  Limits out;
  const double ratio = 1e-2;
  const auto add = [&](std::string_view sweep, const std::string& shape, const Bed& bed, double x, double at) {
    if (interrupted()) return;
    for (Limit& one : limits_of(sweep, shape, bed, x, at, pairs, seed, threads)) out.limits.push_back(std::move(one));
  };
  for (const auto& [words, bed] : shapes_to_the_limit()) {
    for (const double x : limit_ratios) add("ratio", words, bed, x, x);
    const std::size_t n = out.limits.size(), systems = limit_systems.size();
    for (std::size_t k = 0; k < systems && !interrupted(); ++k)
      out.orders.push_back(order_of(out.limits[n - 2 * systems + k], out.limits[n - systems + k]));
  }
  for (const double x : {1.25, 1.5, 2.0, 3.0, 5.0})
    add("aspect", "spheroids, overlap ratio 0.01", {.aspect = x}, x, ratio);
  for (const double x : {2.0, 2.5, 3.0, 4.0, 6.0, 8.0})
    add("exponent", "aspect 1.5, overlap ratio 0.01", {.aspect = 1.5, .n1 = x, .n2 = x}, x, ratio);
  return out;
}

}  // namespace plumb::reports
