// A foreign shape in a solve: its support points, and what shows that its functions are not those of a convex body.
//
// Points x_i, farthest along unit n_i, are those of a convex body exactly where x_j.n_i <= x_i.n_i for all i and j: their hull is one. All of
// a solve's points are believed to belong to the body; what they show is right of each body that has them. The answer is wrong of none
// where no point lies beyond the plane of the answer's own, so that all points are held to it: the last ones to each other as they come,
// and, where there were more, every point of a second run to the first run's answer.
#pragma once

#include <algorithm>
#include <bit>

#include "solver/method/convex/piece_support.hpp"
#include "solver/method/convex/touch.hpp"
#include "solver/power_of_two.hpp"
#include "solver/shape/shapes.hpp"

namespace plumb::detail {

enum class ForeignFault { none, not_finite, beyond_bound, below_inscribed, not_convex, not_the_same };

/// Of one body, all along a solve; body axes, the caller's unit.
class ForeignWatch {
 public:
  /// Every later point is held to this plane as well.
  void hold_to(const Vec3<double>& n, const Vec3<double>& x) { held_ = {n, x}, is_held_ = true; }
  void see(const ForeignShape& shape, const Vec3<double>& n, const Vec3<double>& x) {
    if (fault_ == ForeignFault::none) fault_ = fault_of(shape, n, x);
    last_[static_cast<std::size_t>(count_++ % kept)] = {n, x};
  }
  void blame(ForeignFault fault) {
    if (fault_ == ForeignFault::none) fault_ = fault;
  }
  [[nodiscard]] ForeignFault fault() const { return fault_; }
  /// Whether there were more points than are held to each other.
  [[nodiscard]] bool has_forgotten() const { return count_ > kept; }

 private:
  static constexpr int kept = 48;
  static constexpr double rounding = 1024 * std::numeric_limits<double>::epsilon();

  struct Seen {
    Vec3<double> n, x;
  };

  [[nodiscard]] ForeignFault fault_of(const ForeignShape& shape, const Vec3<double>& n, const Vec3<double>& x) const {
    const double slack = rounding * shape.bounding_radius;
    if (!x.allFinite()) return ForeignFault::not_finite;
    if (!(x.stableNorm() <= shape.bounding_radius + slack)) return ForeignFault::beyond_bound;
    if (!(x.dot(n) >= shape.inscribed_radius - slack)) return ForeignFault::below_inscribed;
    const auto are_one_bodys = [&](const Seen& other) {
      return other.x.dot(n) <= x.dot(n) + slack && x.dot(other.n) <= other.x.dot(other.n) + slack;
    };
    const int count = std::min(count_, kept);
    const bool are_all = std::all_of(last_.begin(), last_.begin() + count, are_one_bodys);
    return are_all && (!is_held_ || are_one_bodys(held_)) ? ForeignFault::none : ForeignFault::not_convex;
  }

  std::array<Seen, kept> last_;
  Seen held_;
  int count_ = 0;
  bool is_held_ = false;
  ForeignFault fault_ = ForeignFault::none;
};

/// Where its Hessian is not known, the derivative is that of differences. Jumps of x are not told, as the pieces of other cores are.
struct ForeignCore {
  static constexpr bool is_polytope = false;
  const ForeignShape* shape;
  PowerOfTwo<double> unit;
  ForeignWatch* watch;

  [[nodiscard]] bool is_of_revolution() const { return false; }
  /// The piece tells points from each other, where x may jump: what is the same piece is the same point.
  [[nodiscard]] CorePoint support(const Vec3<double>& u) const {
    const Vec3<double> x = farthest(u);
    return {x, shape->hessian == nullptr ? number_of(x) : 0};
  }
  [[nodiscard]] PieceSupport support(int /*piece*/, const Vec3<double>& u) const {
    const Vec3<double> n = unit_of(u);
    return {farthest(n), shape->hessian == nullptr ? by_differences(n) : by_function(n)};
  }
  /// Not known.
  [[nodiscard]] static bool holds(const Vec3<double>& /*x*/, double /*beyond*/) { return false; }
  /// NaN without a Hessian, or where x is not the shape's own point.
  [[nodiscard]] PrincipalCurvature<double> curvature(const Touch& touch) const {
    if (shape->hessian == nullptr) return {};
    const PieceSupport at = support(0, touch.u);
    const double near = std::sqrt(touch.rounding);  // a flat's own point is known no better
    const Tangent<double> basis = tangent_basis<double>(touch.u);
    const Mat2<double> m = basis.transpose() * at.hessian * basis;
    if (!m.allFinite() || !((at.point - touch.x).norm() <= near)) return {};
    const Vec2<double> v = smaller_eigenvector<double>(m(0, 0), m(0, 1), m(1, 1)), w(-v[1], v[0]);
    return {std::max(v.dot(m * v), 0.0), std::max(w.dot(m * w), 0.0), basis * v, basis * w};
  }

 private:
  [[nodiscard]] static Vec3<double> unit_of(const Vec3<double>& u) {
    const double length = u.norm();
    return length > 0 ? Vec3<double>(u / length) : Vec3<double>(0, 0, 1);
  }
  /// In the pair's unit; the origin in place of what is no point.
  [[nodiscard]] Vec3<double> farthest(const Vec3<double>& u) const {
    const Vec3<double> n = unit_of(u);
    Vec3<double> x = not_valid<double>();
    shape->support(shape->data, n.data(), x.data());
    watch->see(*shape, n, x);
    return x.allFinite() ? unit(x) : Vec3<double>(0, 0, 0);
  }
  [[nodiscard]] Mat3<double> by_function(const Vec3<double>& n) const {
    Mat3<double> out = Mat3<double>::Constant(std::numeric_limits<double>::quiet_NaN());
    shape->hessian(shape->data, n.data(), out.data());
    for (double& entry : out.reshaped()) entry = unit(entry);
    return (out + out.transpose()) / 2;
  }
  [[nodiscard]] Mat3<double> by_differences(const Vec3<double>& n) const {
    constexpr double aside = 0x1p-17;  // its square and the points' rounding over it are alike
    Mat3<double> out = Mat3<double>::Zero();
    const Vec3<double> s = n.unitOrthogonal();
    for (const Vec3<double>& t : {s, Vec3<double>(n.cross(s))})
      out += (farthest(n + aside * t) - farthest(n - aside * t)) / (2 * aside) * t.transpose();
    return (out + out.transpose()) / 2;
  }
  [[nodiscard]] static int number_of(const Vec3<double>& x) {
    std::uint64_t out = 0;
    for (const double component : x)
      out = (out ^ std::bit_cast<std::uint64_t>(component)) * 0x9E3779B97F4A7C15U, out ^= out >> 29;
    return static_cast<int>(out >> 33);
  }
};

}  // namespace plumb::detail
