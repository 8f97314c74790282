// The lowest common normal of overlapping cores of revolution about one axis: o depends on the angle from the axis alone, and a whole circle
// of directions may be as low. So half a meridian is searched, as direction_search.hpp searches the sphere.
#pragma once

#include "solver/method/convex/descent.hpp"

namespace plumb::detail {

class MeridianSearch {
 public:
  /// Of the axis's direction, unit; nullopt: there is no common axis, to rounding.
  [[nodiscard]] static std::optional<Vec3<double>> axis_of(const PlacedCores& pair) {
    const bool is_first = has_axis(pair.body1), is_second = has_axis(pair.body2);
    if (!(is_first || is_point(pair.body1)) || !(is_second || is_point(pair.body2))) return std::nullopt;
    const Vec3<double> axis = (is_first ? pair.body1 : pair.body2).rotation.col(2), other = pair.body2.rotation.col(2);
    const bool is_parallel = !is_first || !is_second || axis.cross(other).norm() <= rounding;
    const bool is_on_axis = axis.cross(pair.body2.centre).norm() <= rounding * pair.size;
    return (is_first || is_second) && is_parallel && is_on_axis ? std::optional(axis) : std::nullopt;
  }

  MeridianSearch(const PlacedCores& pair, const Vec3<double>& axis, const CommonNormal& first)
      : pair_(pair), descent_(pair), axis_(axis), across_(axis.unitOrthogonal()), best_(first) {}

  /// Whether all directions are excluded but those as low as the best, to rounding.
  [[nodiscard]] bool run() {
    bool is_complete = true;
    for (int k = 0; k < parts; ++k) is_complete = exclude(width() * k, width(), 0) && is_complete;
    return is_complete;
  }
  [[nodiscard]] const CommonNormal& best() const { return best_; }
  [[nodiscard]] int cells() const { return cells_; }

 private:
  static constexpr int parts = 4, deepest = 30, most_cells = 2000;
  /// Of the size. What an axis that is common but for rounding does to o, and what is left for the search.
  static constexpr double rounding = 16 * std::numeric_limits<double>::epsilon(),
                          tolerance = 128 * std::numeric_limits<double>::epsilon();

  [[nodiscard]] static double width() { return static_cast<double>(EIGEN_PI) / parts; }
  [[nodiscard]] static bool is_point(const PlacedCore& body) {
    const auto* segment = std::get_if<SegmentCore>(&body.core);
    return segment != nullptr && segment->half_length == 0;
  }
  /// Of revolution about its z axis, and no point.
  [[nodiscard]] static bool has_axis(const PlacedCore& body) {
    return !is_point(body) && std::visit([](const auto& core) { return core.is_of_revolution(); }, body.core);
  }

  [[nodiscard]] Vec3<double> at(double angle) const { return std::cos(angle) * axis_ + std::sin(angle) * across_; }
  [[nodiscard]] double level() const { return best_.overlap - tolerance * pair_.size; }

  /// Whether no direction from `from` on is lower, over `width`.
  [[nodiscard]] bool exclude(double from, double width, int depth) {
    if (++cells_ > most_cells) return false;
    const Vec3<double> first = at(from), middle = at(from + width / 2), last = at(from + width);
    const Vec3<double> at_first = pair_.support(first).w(), at_last = pair_.support(last).w(),
                       seen = pair_.support(middle).w();
    if (seen.dot(middle) < level()) take(descent_.from(middle));
    const auto are_above = [&](const Vec3<double>& w, const Vec3<double>& n) { return w.dot(n) >= level(); };
    for (const Vec3<double>& w : {seen, Vec3<double>(best_.overlap * best_normal())})
      if (are_above(w, first) && are_above(w, last)) return true;
    // Up to where the two are as high one excludes, and beyond it the other.
    const Vec3<double> crossing = crossing_of(at_first - at_last, middle);
    if (are_above(at_first, first) && are_above(at_last, last) && are_above(at_first, crossing) &&
        are_above(at_last, crossing))
      return true;
    if (depth == deepest) return false;
    return exclude(from, width / 2, depth + 1) && exclude(from + width / 2, width / 2, depth + 1);
  }
  /// Of the meridian, across w, on the side of n.
  [[nodiscard]] Vec3<double> crossing_of(const Vec3<double>& w, const Vec3<double>& n) const {
    const Vec3<double> out = w.dot(across_) * axis_ - w.dot(axis_) * across_;
    return out.isZero(0) ? n : (out.dot(n) < 0 ? -out : out).stableNormalized().eval();
  }
  /// The best, turned about the axis into the meridian.
  [[nodiscard]] Vec3<double> best_normal() const {
    const double along = best_.normal.dot(axis_), beside = (best_.normal - along * axis_).norm();
    return along * axis_ + beside * across_;
  }
  void take(const CommonNormal& found) {
    if (found.overlap < best_.overlap) best_ = found;
  }

  const PlacedCores& pair_;
  Descent descent_;
  Vec3<double> axis_, across_;
  CommonNormal best_;
  int cells_ = 0;
};

}  // namespace plumb::detail
