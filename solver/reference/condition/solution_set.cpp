#include "solver/reference/condition/solution_set.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <vector>

#include "solver/pose.hpp"
#include "solver/reference/frame.hpp"
#include "solver/reference/interval/enclosure.hpp"
#include "solver/reference/interval/input_change.hpp"
#include "solver/shape/superellipsoid.hpp"
#include "solver/standard_arithmetic.hpp"

namespace plumb::reference {
namespace {

using Coarse = Interval18;

constexpr double half_turn = std::numbers::pi;

IVec3<Coarse> scaled(const EnclosedBody<Coarse>& body, const IVec3<Coarse>& direction) {
  IVec3<Coarse> q = body.rotation.transpose() * direction;
  for (int i = 0; i < 3; ++i) q[i] = q[i] * body.semi_axes[i];
  return q;
}

/// |n| o(n).
Coarse overlap(const EnclosedPair<Coarse>& pair, const IVec3<Coarse>& n) {
  return support_value<Coarse>(pair.body1, scaled(pair.body1, n)) +
         support_value<Coarse>(pair.body2, scaled(pair.body2, n)) - dot(n, pair.centre);
}

struct ContactBox {
  IVec3<Coarse> point1, point2;  ///< world
};

/// A ball about the middle of what was added so far.
class Hull {
 public:
  void add(const IVec3<Coarse>& x) {
    for (int i = 0; i < 3; ++i) {
      low_[i] = std::min(low_[i], low(x[i]));
      high_[i] = std::max(high_[i], high(x[i]));
    }
  }
  [[nodiscard]] Vec3<double> middle() const { return low_ + (high_ - low_) / 2; }
  [[nodiscard]] static double distance(const Vec3<double>& from, const IVec3<Coarse>& x) {
    return high(length_of<Coarse>(x - enclosed<Coarse>(from)));
  }

 private:
  Vec3<double> low_ = Vec3<double>::Constant(std::numeric_limits<double>::infinity()), high_ = -low_;
};

/// The search over cells of directions F v.
class Sublevel {
 public:
  Sublevel(const Pair& pair, const Vec3<Real50>& normal, double k)
      : pair_(pair), placed_(place<double>(pair)), enclosed_(enclose<Coarse>(pair)), change_(enclosed_, k),
        changed1_(widened(enclosed_.body1, change_)), changed2_(widened(enclosed_.body2, change_)) {
    set_frame(frame_about(normal.cast<double>()));
    delta_ = change_.delta(enclosed_);
    const IVec3<Coarse> n = enclosed<Coarse>(normal);
    level_ = high_end<Coarse>(Coarse(overlap(enclosed_, n) / length_of(n) + Coarse(2.0) * delta_));
    rough_level_ = high(level_);
  }

  SolutionSet run(int budget) {
    std::vector<Cell> open;
    for (int face = 0; face < 6; ++face) open.push_back(face_of_cube(face));
    SolutionSet out;
    out.delta = high(times_power_of_two<Coarse>(delta_, enclosed_.exponent));
    out.level = high(times_power_of_two<Coarse>(level_, enclosed_.exponent));
    double last_radius = half_turn;
    int stretches = 0;
    for (bool is_thin = false;;) {
      const double radius = rough_radius(open);
      const std::size_t before = open.size();
      out.complete = open.front().half < smallest_cell || is_resolved(open) || (is_thin && radius > 0.9 * last_radius);
      last_radius = radius;
      if (out.complete || out.cells + 4 * static_cast<int>(before) > budget) break;
      out.cells += 4 * static_cast<int>(before);
      open = refined(open);
      // The number of cells grows as a curve's does.
      is_thin = open.size() > few && 2 * open.size() < 5 * before;
      if (is_thin && stretches < most_stretches) stretches = stretch(open) ? stretches + 1 : most_stretches;
      is_thin = is_thin && open.size() > most_on_a_curve;
    }
    enclose_set(open, out);
    return out;
  }

 private:
  static constexpr std::size_t few = 64, most_on_a_curve = 512;
  static constexpr double smallest_cell = 0x1p-62;
  static constexpr int most_stretches = 8;
  static constexpr std::size_t most_recent = 16;

  void set_frame(const Mat3<double>& frame) {
    frame_ = frame;
    for (int i = 0; i < 9; ++i) enclosed_frame_(i / 3, i % 3) = Coarse(frame_(i / 3, i % 3));
    to_body1_ = placed_.body1.rotation.transpose() * frame_;
    to_body2_ = placed_.body2.rotation.transpose() * frame_;
  }

  /// A direction's coordinates across the frame's third axis: the gnomonic map.
  [[nodiscard]] static Eigen::Vector2d across(const Mat3<double>& frame, const Vec3<double>& d) {
    const double along = frame.col(2).dot(d);
    return {frame.col(0).dot(d) / along, frame.col(1).dot(d) / along};
  }

  /// Puts a long and narrow set of cells into one cell of a frame whose axes are as long and as narrow, so that it is as wide
  /// as long there. Does nothing, and says so, where that is not proved to hold them all.
  [[nodiscard]] bool stretch(std::vector<Cell>& open) {
    const Vec3<double> axis = middle(open);
    const Mat3<double> straight = frame_about(axis);
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (const Cell& cell : open) {
      const Eigen::Vector2d x = across(straight, frame_ * cell.at(0, 0));
      spread += x * x.transpose();
    }
    const double slope = 0.5 * std::atan2(2 * spread(0, 1), spread(0, 0) - spread(1, 1));
    Mat3<double> next = straight;
    next.col(0) = std::cos(slope) * straight.col(0) + std::sin(slope) * straight.col(1);
    next.col(1) = std::cos(slope) * straight.col(1) - std::sin(slope) * straight.col(0);
    Eigen::Vector2d reach = Eigen::Vector2d::Constant(4 * machine_epsilon);
    for (const Cell& cell : open)
      for (const double du : {-1.0, 1.0})
        for (const double dv : {-1.0, 1.0})
          reach = reach.cwiseMax(across(next, frame_ * cell.at(du, dv)).cwiseAbs() * 1.01);
    if (!(reach.maxCoeff() < 1)) return false;
    next.col(0) *= reach[0];
    next.col(1) *= reach[1];
    if (!holds_all(next, open)) return false;
    set_frame(next);
    open = {{2, 1.0, 0, 0, 1}};
    return true;
  }

  /// Whether the first cell of the frame's third face holds the cells: with d = x f0 + y f1 + z f2, z > 0 and |x|, |y| <= z.
  [[nodiscard]] bool holds_all(const Mat3<double>& frame, const std::vector<Cell>& open) const {
    std::array<IVec3<Coarse>, 3> f;
    for (int k = 0; k < 3; ++k) f[static_cast<std::size_t>(k)] = enclosed<Coarse>(frame.col(k));
    const IVec3<Coarse> by_x = cross_product<Coarse>(f[1], f[2]), by_y = cross_product<Coarse>(f[2], f[0]),
                        by_z = cross_product<Coarse>(f[0], f[1]);
    if (!is_positive(dot(by_z, f[2]))) return false;
    for (const Cell& cell : open)
      for (const double du : {-1.0, 1.0})
        for (const double dv : {-1.0, 1.0}) {
          const IVec3<Coarse> d = direction(cell, du, dv);
          const Coarse z = dot(by_z, d);
          if (!is_positive(z) || !is_positive(Coarse(z - magnitude<Coarse>(dot(by_x, d)))) ||
              !is_positive(Coarse(z - magnitude<Coarse>(dot(by_y, d)))))
            return false;
        }
    return true;
  }

  /// p1 - p2 of the support points at one direction: |d| o(d) >= (p1 - p2).d for every d.
  struct Bound {
    Vec3<double> rough;
    IVec3<Coarse> exact;
  };

  [[nodiscard]] std::vector<Cell> refined(const std::vector<Cell>& open) {
    std::vector<Cell> out;
    for (const Cell& cell : open)
      for (int i = 0; i < 4; ++i)
        if (const Cell quarter = cell.quarter(i); !is_excluded(quarter)) out.push_back(quarter);
    return out;
  }

  /// By a bound of a neighbour, which saves most of the intervals' powers, or by its own.
  [[nodiscard]] bool is_excluded(const Cell& cell) {
    for (const Bound& bound : recent_)
      if (seems_above(cell, bound.rough) && is_above(cell, bound.exact)) return true;
    const Vec3<double> own = rough_gradient(cell.at(0, 0));
    if (!seems_above(cell, own)) return false;
    const Bound bound{own, gradient(direction(cell, 0, 0))};
    if (recent_.size() < most_recent)
      recent_.push_back(bound);
    else
      recent_[next_recent_++ % most_recent] = bound;
    return is_above(cell, bound.exact);
  }

  [[nodiscard]] Vec3<double> rough_gradient(const Vec3<double>& v) const {
    return placed_.body1.rotation * support_point<double>(placed_.body1.shape, to_body1_ * v).gradient +
           placed_.body2.rotation * support_point<double>(placed_.body2.shape, to_body2_ * v).gradient -
           placed_.body2.centre;
  }

  [[nodiscard]] IVec3<Coarse> gradient(const IVec3<Coarse>& d) const {
    return enclosed_.body1.rotation * support<Coarse>(enclosed_.body1, scaled(enclosed_.body1, d)).point +
           enclosed_.body2.rotation * support<Coarse>(enclosed_.body2, scaled(enclosed_.body2, d)).point -
           enclosed_.centre;
  }

  /// is_above in double, to save most of the intervals' time.
  [[nodiscard]] bool seems_above(const Cell& cell, const Vec3<double>& g) const {
    for (const double du : {-1.0, 1.0})
      for (const double dv : {-1.0, 1.0}) {
        const Vec3<double> d = frame_ * cell.at(du, dv);
        if (!(g.dot(d) - rough_level_ * d.norm() > -8 * machine_epsilon)) return false;
      }
    return true;
  }

  [[nodiscard]] IVec3<Coarse> direction(const Cell& cell, double du, double dv) const {
    return enclosed_frame_ * enclosed<Coarse>(cell.at(du, dv));
  }

  [[nodiscard]] IVec3<Coarse> direction_box(const Cell& cell) const {
    return enclosed_frame_ * box_of<Coarse>(cell, cell.half);
  }

  /// Whether g.d > level |d| on the cell. For level >= 0 the difference is concave and its least value at a corner; otherwise
  /// |d| is bounded by itself.
  [[nodiscard]] bool is_above(const Cell& cell, const IVec3<Coarse>& g) const {
    const bool concave = low(level_) >= 0;
    const Coarse least = concave ? Coarse(0.0) : low_end<Coarse>(length_of(direction_box(cell)));
    for (const double du : {-1.0, 1.0})
      for (const double dv : {-1.0, 1.0}) {
        const IVec3<Coarse> d = direction(cell, du, dv);
        if (!is_positive(Coarse(dot(g, d) - level_ * (concave ? length_of(d) : least)))) return false;
      }
    return true;
  }

  /// Whether most cells' centres are in the set themselves, so that it cannot be much smaller than its cells.
  [[nodiscard]] bool is_resolved(const std::vector<Cell>& open) const {
    if (open.size() < few) return false;
    std::size_t in = 0;
    for (const Cell& cell : open) {
      const Vec3<double> v = cell.at(0, 0);
      const Vec3<double> d = frame_ * v;
      if (rough_gradient(v).dot(d) <= rough_level_ * d.norm()) ++in;
    }
    return 2 * in >= open.size();
  }

  /// Unit middle of the cells' directions; the first cell's where they balance.
  [[nodiscard]] Vec3<double> middle(const std::vector<Cell>& open) const {
    Eigen::AlignedBox<double, 3> box;
    for (const Cell& cell : open) box.extend((frame_ * cell.at(0, 0)).normalized());
    const Vec3<double> out = box.center();
    return out.norm() > 0.1 ? out.normalized() : frame_.col(2).normalized().eval();
  }

  [[nodiscard]] double rough_radius(const std::vector<Cell>& open) const {
    const Vec3<double> axis = middle(open);
    double chord = 0;
    for (const Cell& cell : open)
      for (const double du : {-1.0, 1.0})
        for (const double dv : {-1.0, 1.0})
          chord = std::max(chord, ((frame_ * cell.at(du, dv)).normalized() - axis).norm());
    return chord;
  }

  /// Half-angle about `axis` of a cone that holds the cells. A cap of less than a right angle is convex: it holds a cell
  /// when it holds its corners.
  [[nodiscard]] double enclosing_angle(const std::vector<Cell>& open, const Vec3<double>& axis) const {
    const IVec3<Coarse> a = enclosed<Coarse>(axis);
    const IVec3<Coarse> unit = a / length_of(a);
    double chord = 0;
    for (const Cell& cell : open)
      for (const double du : {-1.0, 1.0})
        for (const double dv : {-1.0, 1.0}) {
          const IVec3<Coarse> d = direction(cell, du, dv);
          chord = std::max(chord, high(length_of(IVec3<Coarse>(d / length_of(d) - unit))));
        }
    const double right_angle = std::numbers::sqrt2 * (1 - 4 * machine_epsilon);
    if (!(chord < right_angle)) return half_turn;
    const Coarse sine = Coarse(chord) / Coarse(2.0);
    return high(Coarse(Coarse(2.0) * angle_of<Coarse>(sine, root<Coarse>(Coarse(1.0) - square<Coarse>(sine)))));
  }

  /// Both points in the world for every changed input whose lowest direction is in the cell.
  [[nodiscard]] ContactBox points(const Cell& cell) const {
    const IVec3<Coarse> d = direction_box(cell);
    const IVec3<Coarse> x1 = changed1_.rotation * support<Coarse>(changed1_, scaled(changed1_, d)).point,
                        x2 = changed2_.rotation * support<Coarse>(changed2_, scaled(changed2_, d)).point;
    const Coarse moved = change_.both_ways() * change_.size;
    ContactBox out;
    for (int i = 0; i < 3; ++i) {
      out.point1[i] =
          Coarse(pair_.body1.position[i]) + times_power_of_two<Coarse>(Coarse(x1[i] + moved), enclosed_.exponent);
      out.point2[i] =
          Coarse(pair_.body2.position[i]) - times_power_of_two<Coarse>(Coarse(x2[i] + moved), enclosed_.exponent);
    }
    return out;
  }

  void enclose_set(const std::vector<Cell>& open, SolutionSet& out) const {
    out.normal = middle(open);
    out.normal_radius = enclosing_angle(open, out.normal);
    Hull hull1, hull2;
    std::vector<ContactBox> boxes;
    for (const Cell& cell : open) {
      boxes.push_back(points(cell));
      hull1.add(boxes.back().point1);
      hull2.add(boxes.back().point2);
    }
    out.point1 = hull1.middle();
    out.point2 = hull2.middle();
    out.points_radius = 0;
    for (const ContactBox& box : boxes)
      out.points_radius =
          std::max({out.points_radius, Hull::distance(out.point1, box.point1), Hull::distance(out.point2, box.point2)});
  }

  const Pair& pair_;
  const PlacedPair<double> placed_;
  const EnclosedPair<Coarse> enclosed_;
  const InputChange change_;
  const EnclosedBody<Coarse> changed1_, changed2_;
  Mat3<double> frame_;
  IMat3<Coarse> enclosed_frame_;
  Coarse delta_, level_;
  double rough_level_;
  Mat3<double> to_body1_, to_body2_;
  std::vector<Bound> recent_;
  std::size_t next_recent_ = 0;
};

}  // namespace

SolutionSet enclose_solutions(const Pair& pair, const Vec3<Real50>& normal, double k, const SolutionSetLimits& limits) {
  const StandardArithmetic mode;
  const EnclosedPair<Coarse> enclosed = enclose<Coarse>(pair);
  const InputChange change(enclosed, k);
  if (!change.keeps_exponents(enclosed.body1) || !change.keeps_exponents(enclosed.body2)) return {};
  return Sublevel(pair, normal, k).run(limits.cells);
}

bool holds_normal(const SolutionSet& set, const Vec3<double>& normal) {
  const StandardArithmetic mode;
  const Vec3<double> n = normal.normalized();
  return 2 * std::atan2((n - set.normal).norm(), (n + set.normal).norm()) <= set.normal_radius + 4 * machine_epsilon;
}

// |o(n) - o(m)| <= |n - m| |p1 - p2|, and no two points of the bodies are further apart than both radii and the centres.
bool may_be_lowest(const Pair& pair, const SolutionSet& set, const Vec3<double>& normal) {
  const StandardArithmetic mode;
  const EnclosedPair<Coarse> exact = enclose<Coarse>(pair);
  const IVec3<Coarse> n = enclosed<Coarse>(normal);
  const Coarse steepest = circumradius(exact.body1) + circumradius(exact.body2) + length_of(exact.centre);
  const Coarse level =
      times_power_of_two<Coarse>(Coarse(set.level), -exact.exponent) + Coarse(4 * machine_epsilon) * steepest;
  return !is_positive(Coarse(overlap(exact, n) / length_of(n) - level));
}

bool holds_points(const SolutionSet& set, const Vec3<double>& point1, const Vec3<double>& point2, double rounding) {
  const StandardArithmetic mode;
  const double allowed = set.points_radius + rounding;
  return (point1 - set.point1).norm() <= allowed && (point2 - set.point2).norm() <= allowed;
}

}  // namespace plumb::reference
