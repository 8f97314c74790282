// The lowest common normal of overlapping cores of revolution whose axes are common, or nearly so: o depends on the angle from the axis
// alone, or nearly so, and a whole circle of directions may be as low. So half a meridian is searched, as direction_search.hpp searches the
// sphere. Where one core alone is of revolution a part of a circle may be as low: where the other has its end on the axis.
//
// Both: a is body 1's axis, b body 2's, turned to a's side; body 2's centre is z a + s, s across. n = n_a a + n_e e, e any unit vector
// across. A point of body 1 is x_a a + x_e e, for every e, and one of body 2 is z a + s + Q (y_a a + y_e e), Q the least rotation from a
// to b. With m = b - cos a, sin = |m|, k the unit vector across a and m, the height n.(x1 - x2) is
//     n_a (x_a - z) + n_e x_e - cos (n_a y_a + n_e y_e) - [c.e + B (k.e)^2],   c = n_e s + (y_a n_e - y_e n_a) m,   B = (1 - cos) n_e y_e
// For all e at once the bracket is at most |c| + max(B, 0), and |c| alone where c is along m and 2 B <= |c|: there |c| cos + B sin^2 is
// greatest at the angle 0. A spheroid is a smaller body swept by the largest ball that rolls within it, of which o knows the radius alone: its
// points, taken for every e, tell the less the farther they are from the axis, and what is left of a spheroid that is all but round is small.
// One alone, about a through the origin, the point x2 of the other being the same for every e:
//     n_a (x_a - x2.a) + n_e x_e - c.e,   c = n_e (x2 - (x2.a) a)
// Being the greatest of functions that are linear in n, it is convex: a height that two directions have, all between them have. Where the
// lowest e differs from point to point no two points show for all e what a mixture of them shows for each: then arcs of e are searched,
// and over an arc the bracket's two terms are each at most their greatest in it.
#pragma once

#include <cstdint>

#include "solver/method/convex/best_normal.hpp"
#include "solver/shape/curvature.hpp"

namespace plumb::detail {

class MeridianSearch {
 public:
  enum class Turned : std::uint8_t { both, first, second };
  struct Axis {
    Vec3<double> direction;
    Turned of;
  };
  /// The first core's axis; nullopt: there is none that is common to both, but for an angle, or a share of the size, of `nearly`.
  [[nodiscard]] static std::optional<Axis> common_axis(const PlacedCores& pair, double nearly) {
    const bool is_first = has_axis(pair.body1), is_second = has_axis(pair.body2);
    if (!(is_first || is_point(pair.body1)) || !(is_second || is_point(pair.body2))) return std::nullopt;
    const Vec3<double> axis = (is_first ? pair.body1 : pair.body2).rotation.col(2), other = pair.body2.rotation.col(2);
    const bool is_parallel = !is_first || !is_second || axis.cross(other).norm() <= nearly;
    const bool is_on_axis = axis.cross(pair.body2.centre).norm() <= nearly * pair.size;
    if (!(is_first || is_second) || !is_parallel || !is_on_axis) return std::nullopt;
    return Axis{axis, Turned::both};
  }
  /// A core's own axis.
  [[nodiscard]] static std::optional<Axis> axis_of(const PlacedCores& pair, Turned which) {
    const PlacedCore& body = which == Turned::first ? pair.body1 : pair.body2;
    return has_axis(body) ? std::optional(Axis{body.rotation.col(2), which}) : std::nullopt;
  }

  MeridianSearch(const PlacedCores& pair, const Axis& about, const CommonNormal& first)
      : pair_(pair), descent_(pair), turned_(about.of), axis_(about.direction), other_(about.direction),
        best_(pair, descent_, first) {
    const Vec3<double>& axis = axis_;
    if (turned_ == Turned::both && has_axis(pair.body2)) other_ = pair.body2.rotation.col(2);
    if (other_.dot(axis) < 0) other_ = -other_;
    centre_ = pair.body2.centre.dot(axis);
    shift_ = pair.body2.centre - centre_ * axis;
    tilt_ = other_ - other_.dot(axis) * axis;
    less_ = (other_ - axis).squaredNorm() / 2;
    const Vec3<double>& aside = tilt_.norm() > rounding ? tilt_ : shift_;
    across_ = aside.norm() > rounding * pair.size ? made_across(made_across(aside)) : axis.unitOrthogonal().eval();
    beside_ = axis.cross(across_);
    if (turned_ == Turned::both) rolling_ = {rolling(pair.body1), rolling(pair.body2)};
  }

  /// Whether all directions are excluded but those as low as the lowest that was seen, to rounding.
  [[nodiscard]] bool run() {
    const double before = best_.lowest();
    if (search()) return true;
    // What was looked at before the lowest was known is looked at again.
    return best_.lowest() < before - tolerance * pair_.size && search();
  }
  [[nodiscard]] const BestNormal& best() const { return best_; }
  [[nodiscard]] int cells() const { return cells_; }

 private:
  static constexpr double pi = static_cast<double>(EIGEN_PI);
  static constexpr int parts = 4, deepest = 60, kept = 8;
  static constexpr int most_cells = 20'000, most_about_one = 4'000;  // what is shown about one body's axis took 500
  /// Of the size. What an axis that is common but for rounding does to o, and what is left for the search.
  static constexpr double rounding = 16 * std::numeric_limits<double>::epsilon(),
                          tolerance = 128 * std::numeric_limits<double>::epsilon();

  /// n_a and n_e >= 0, of length 1 or less.
  using Angle = Vec2<double>;
  /// A point of each core, for every e: the height is n.plane - [(n_a along + n_e across).e + n_e bulge (k.e)^2].
  struct Witness {
    Vec2<double> plane;
    Vec3<double> along, across;
    double bulge;
  };

  /// Unit e, by their angle from `across_`: all of them, or an arc.
  struct Arc {
    double middle = 0, half = pi;

    [[nodiscard]] bool is_circle() const { return half == pi; }
    [[nodiscard]] Arc centre() const { return {middle, 0}; }
    /// -1 or 1.
    [[nodiscard]] Arc part(int side) const { return {middle + side * half / 2, half / 2}; }
    /// The greatest cosine of the angle between a direction and one of the arc.
    [[nodiscard]] double nearest_cosine(double angle) const {
      return std::cos(std::max(std::abs(std::remainder(middle - angle, 2 * pi)) - half, 0.0));
    }
  };
  /// The directions at the angles `from` to `from + width` from the axis, of an arc.
  struct Cell {
    double from, width;
    Arc arc;
    int depth;

    [[nodiscard]] std::array<Cell, 2> parts_of_arc() const {
      return {Cell{from, width, arc.part(-1), depth + 1}, {from, width, arc.part(1), depth + 1}};
    }
    [[nodiscard]] std::array<Cell, 2> parts_of_angle() const {
      return {Cell{from, width / 2, arc, depth + 1}, {from + width / 2, width / 2, arc, depth + 1}};
    }
  };

  [[nodiscard]] bool search() {
    // So much that the bodies without them still overlap: what follows from a chord's ends holds along its arc of heights above 0.
    const double most = std::max(best_.lowest(), 0.0), both = rolling_[0] + rolling_[1],
                 share = both > most ? most / both : 1;
    taken_ = {share * rolling_[0], share * rolling_[1]};
    bool is_complete = true;
    last_cell_ = cells_ + (turned_ == Turned::both ? most_cells : most_about_one);
    for (int k = 0; k < parts; ++k) is_complete = exclude({width() * k, width(), {}, 0}) && is_complete;
    return is_complete && !has_taken_too_much();
  }

  [[nodiscard]] static double width() { return pi / parts; }
  /// Unit; across the axis but for the rounding of v over its length.
  [[nodiscard]] Vec3<double> made_across(const Vec3<double>& v) const {
    return (v - v.dot(axis_) * axis_).normalized();
  }
  [[nodiscard]] static bool is_point(const PlacedCore& body) {
    const auto* segment = std::get_if<SegmentCore>(&body.core);
    return segment != nullptr && segment->half_length == 0;
  }
  /// Of revolution about its z axis, and no point.
  [[nodiscard]] static bool has_axis(const PlacedCore& body) {
    return !is_point(body) && std::visit([](const auto& core) { return core.is_of_revolution(); }, body.core);
  }

  /// The radius of the largest ball that rolls within a spheroid; 0 of all else.
  [[nodiscard]] static double rolling(const PlacedCore& body) {
    const auto* smooth = std::get_if<SmoothCore>(&body.core);
    if (smooth == nullptr || smooth->n1 != 2 || !smooth->is_of_revolution() ||
        smooth->semi_axes[4] != smooth->semi_axes[5])
      return 0;
    const double across = smooth->semi_axes[0], along = smooth->semi_axes[4], shorter = std::min(across, along);
    return (1 - rounding) * shorter * (shorter / std::max(across, along));
  }

  [[nodiscard]] static Angle at(double angle) { return {std::cos(angle), std::sin(angle)}; }
  /// What is left of the bodies does not overlap: what chords show does not hold along their arcs then.
  [[nodiscard]] bool has_taken_too_much() const {
    return taken_[0] + taken_[1] > 0 && level() < -2 * tolerance * pair_.size;
  }
  /// Of what is left of the bodies.
  [[nodiscard]] double level() const { return best_.lowest() - taken_[0] - taken_[1] - tolerance * pair_.size; }

  /// Of the farthest points along a unit n.
  [[nodiscard]] Witness seen_along(const Vec3<double>& n, const Vec3<double>& point1, const Vec3<double>& point2,
                                   const Vec3<double>& e) const {
    return seen(point1 - taken_[0] * n, point2 + taken_[1] * n, e);
  }
  /// Of what is smaller by a ball the points are the normal's own: along another normal the ball's centre is another.
  [[nodiscard]] Witness seen_at_best() const {
    const CommonNormal& best = best_.normal();
    const Vec3<double>& n = best.normal;
    return seen_along(n, taken_[0] > 0 ? pair_.body1.support(n).point : best.point1,
                      taken_[1] > 0 ? pair_.body2.support(-n).point : best.point2, across(n));
  }
  /// Of points of the bodies. Those of both are seen in the plane of an axis and e, where the second lies in it but for little.
  [[nodiscard]] Witness seen(const Vec3<double>& point1, const Vec3<double>& point2, const Vec3<double>& e) const {
    const Vec3<double>&c = pair_.body2.centre, y = point2 - c;
    if (turned_ == Turned::second) return about_one(c - point2, c - point1, e);
    const Vec3<double> turned = e - other_.dot(e) / (2 - less_) * (axis_ + other_);  // Q e
    const double y_a = y.dot(other_), y_e = y.dot(turned), nearly = 0.99;
    const bool is_in_plane = std::abs(y_e) >= nearly * (y - y_a * other_).norm();
    if (turned_ == Turned::first || !is_in_plane) return about_one(point1, point2, e);
    const double cosine = 1 - less_;
    return {{point1.dot(axis_) - centre_ - cosine * y_a, point1.dot(e) - cosine * y_e},
            -y_e * tilt_,
            shift_ + y_a * tilt_,
            less_ * y_e};
  }
  /// `ring`: what is seen of a point belongs to its body as well; `fixed`: the other body's, from the same origin.
  [[nodiscard]] Witness about_one(const Vec3<double>& ring, const Vec3<double>& fixed, const Vec3<double>& e) const {
    const double height = fixed.dot(axis_);
    return {{ring.dot(axis_) - height, ring.dot(e)}, Vec3<double>::Zero(), fixed - height * axis_, 0};
  }
  /// e of a direction; any, where it is the axis but for rounding. What is left of a direction beside the axis is mostly rounding, some of it along
  /// the axis.
  [[nodiscard]] Vec3<double> across(const Vec3<double>& n) const {
    const Vec3<double> e = n - n.dot(axis_) * axis_;
    return e.norm() > rounding ? made_across(e.normalized()) : across_;
  }

  /// c, and B.
  struct Aside {
    Vec3<double> vector;
    double bulge;

    [[nodiscard]] Aside operator-() const { return {-vector, -bulge}; }
  };
  [[nodiscard]] static Aside aside(const Witness& w, const Angle& n) {
    return {n[0] * w.along + n[1] * w.across, n[1] * w.bulge};
  }
  /// The greatest bracket of an arc, or more.
  [[nodiscard]] double greatest(const Aside& of, const Arc& arc) const {
    const double length = of.vector.norm();
    if (arc.is_circle()) {
      const bool is_along_tilt = std::abs(of.vector.dot(beside_)) <= rounding * length;
      return is_along_tilt && 2 * of.bulge <= length ? length : length + std::max(of.bulge, 0.0);
    }
    const double angle = std::atan2(of.vector.dot(beside_), of.vector.dot(across_));
    const double sine = std::max(arc.nearest_cosine(pi / 2), arc.nearest_cosine(-pi / 2)),
                 cosine = std::max(arc.nearest_cosine(0), arc.nearest_cosine(pi));
    return length * arc.nearest_cosine(angle) + of.bulge * (of.bulge > 0 ? sine * sine : 1 - cosine * cosine);
  }

  /// The lowest n.(x1 - x2) of an arc's directions at an angle, or less.
  [[nodiscard]] double height(const Witness& w, const Angle& n, const Arc& arc) const {
    return n.dot(w.plane) - greatest(aside(w, n), arc);
  }
  /// By how much those differ, or more.
  [[nodiscard]] double range(const Witness& w, const Angle& n, const Arc& arc) const {
    const Aside of = aside(w, n);
    return greatest(of, arc) + greatest(-of, arc);
  }

  /// The support points of the arc's middle; of a circle, of what is lowest in the plane of both axes and across it. A lower direction than
  /// the best is followed.
  [[nodiscard]] Witness look(const Angle& n, const Arc& arc) {
    double lowest = std::numeric_limits<double>::infinity();
    Witness out;
    const auto see = [&](const Vec3<double>& e) {
      const Vec3<double> direction = n[0] * axis_ + n[1] * e;
      const Difference at = pair_.support(direction);
      const double overlap = at.w().dot(direction);
      if (overlap < best_.lowest() - pair_.rounding()) best_.take(descent_.from(direction));
      if (overlap < lowest) lowest = overlap, out = seen_along(direction, at.point1, at.point2, e);
    };
    see(std::cos(arc.middle) * across_ + std::sin(arc.middle) * beside_);
    if (arc.is_circle())
      for (const Vec3<double>& e : {Vec3<double>(-across_), beside_, Vec3<double>(-beside_)}) see(e);
    seen_[static_cast<std::size_t>(looks_++ % kept)] = out;
    return out;
  }

  /// Whether no direction of the cell is lower.
  [[nodiscard]] bool exclude(const Cell& cell) {
    if (++cells_ > last_cell_ || has_taken_too_much()) return false;
    const Arc& arc = cell.arc;
    // What cannot be divided may be lower by half as much again.
    const double slack = cell.depth == deepest ? tolerance * pair_.size / 2 : 0;
    const auto are_above = [&](const Witness& w, const Angle& n1, const Angle& n2) {
      return height(w, n1, arc) >= level() - slack && height(w, n2, arc) >= level() - slack;
    };
    const Angle first = at(cell.from), middle = at(cell.from + cell.width / 2), last = at(cell.from + cell.width);
    const Witness at_middle = look(middle, arc);
    const Witness of_best = seen_at_best();
    if (are_above(at_middle, first, last) || are_above(of_best, first, last)) return true;
    // Up to where the two are as high one excludes, and beyond it the other.
    const Witness at_first = look(first, arc), at_last = look(last, arc);
    for (int k = 0; k < std::min(looks_, kept); ++k)
      if (are_above(mixture(at_middle, seen_[static_cast<std::size_t>(k)], first, last, arc), first, last)) return true;
    const Angle between = crossing(at_first, at_last, first, last, arc);
    if (are_above(at_first, first, between) && are_above(at_last, between, last)) return true;
    if (cell.depth == deepest) return false;
    const auto of_centre = [&](const Angle& n) { return height(at_middle, n, arc.centre()); };
    const double by_angle = of_centre(middle) - std::min(of_centre(first), of_centre(last));
    const auto halves = range(at_middle, middle, arc) > by_angle ? cell.parts_of_arc() : cell.parts_of_angle();
    return exclude(halves[0]) && exclude(halves[1]);
  }

  /// Of two, of which each falls off to another side: as high at both angles, but for what the bracket adds.
  [[nodiscard]] Witness mixture(const Witness& w1, const Witness& w2, const Angle& n1, const Angle& n2,
                                const Arc& arc) const {
    const double falls = height(w1, n1, arc) - height(w1, n2, arc), rises = height(w2, n2, arc) - height(w2, n1, arc);
    const double share = falls * rises > 0 ? rises / (falls + rises) : 0.5, rest = 1 - share;
    return {share * w1.plane + rest * w2.plane, share * w1.along + rest * w2.along,
            share * w1.across + rest * w2.across, share * w1.bulge + rest * w2.bulge};
  }

  /// Where both heights are the same, by the secant.
  [[nodiscard]] Angle crossing(const Witness& w1, const Witness& w2, const Angle& n1, const Angle& n2,
                               const Arc& arc) const {
    constexpr int steps = 6;
    const auto excess = [&](double t) {
      const Angle n = n1 + t * (n2 - n1);
      return height(w1, n, arc) - height(w2, n, arc);
    };
    double t0 = 0, t1 = 1, e0 = excess(t0), e1 = excess(t1);
    for (int step = 0; step < steps && e0 != e1; ++step) {
      const double t = std::clamp(t1 - e1 * (t1 - t0) / (e1 - e0), 0.0, 1.0);
      t0 = t1, e0 = e1, t1 = t, e1 = excess(t);
    }
    return n1 + t1 * (n2 - n1);
  }

  const PlacedCores& pair_;
  Descent descent_;
  Turned turned_;
  Vec3<double> axis_, other_, shift_, tilt_;   ///< a, b, s, m
  Vec3<double> across_, beside_;               ///< unit e: along m, or along s where there is no m, and across that
  double centre_, less_;                       ///< z, 1 - cos
  std::array<double, 2> rolling_{}, taken_{};  ///< radii: of balls within, and what the search takes off
  BestNormal best_;
  int cells_ = 0, last_cell_ = 0;
  std::array<Witness, kept> seen_;  ///< the last; number k has the place k modulo their number
  int looks_ = 0;
};

}  // namespace plumb::detail
