#include "reports/certified/six_equations.hpp"

#include "solver/least_squares.hpp"
#include "solver/pose.hpp"
#include "solver/shape/superellipsoid.hpp"
#include "solver/shape/tangent.hpp"

namespace plumb::reports {
namespace {

using R = Real50;
using Vec6 = Eigen::Matrix<R, 6, 1>;
using Mat6 = Eigen::Matrix<R, 6, 6>;

constexpr int most_evaluations = 300;
constexpr int most_halvings = 12;
constexpr int most_dampings = 24;

/// A body's gauge at r from its centre, with the derivatives of the unit normal by r; pair frame.
struct Surface {
  R gauge;
  Vec3<R> gradient, normal;
  Mat3<R> dnormal;
};

Surface surface_at(const PlacedBody<R>& body, const Vec3<R>& r) {
  const NormHessian<R> g = gauge_hessian<R>(body.shape, body.to_body_direction(r));
  Surface out;
  out.gauge = g.value;
  out.gradient = body.to_pair_direction(g.gradient);
  const R length = out.gradient.norm();
  out.normal = out.gradient / length;
  const Mat3<R> hessian = body.rotation * g.hessian * body.rotation.transpose();
  out.dnormal = (hessian - out.normal * (out.normal.transpose() * hessian)) / length;
  return out;
}

struct System {
  Vec6 value;
  Mat6 jacobian;
  Surface s1, s2;
  Vec3<R> d;

  [[nodiscard]] bool finite() const { return value.allFinite() && jacobian.allFinite(); }
};

// E moves with n1 by parallel transport, E'dn1 = -dE'n1: the terms with n1.n2 and n1.d. Another basis turns the two
// equations among themselves and leaves |F| as it is.
System system_at(const PlacedPair<R>& pair, const Vec6& x) {
  const Vec3<R> r1 = x.head<3>(), r2 = x.tail<3>();
  System f{{}, Mat6::Zero(), surface_at(pair.body1, r1), surface_at(pair.body2, r2), pair.body2.centre + (r2 - r1)};
  const R size = pair.size();
  const Eigen::Matrix<R, 2, 3> across = tangent_basis<R>(f.s1.normal).transpose();
  f.value << f.s1.gauge - R(1), f.s2.gauge - R(1), across * f.s2.normal, across * f.d / size;
  f.jacobian.block<1, 3>(0, 0) = f.s1.gradient.transpose();
  f.jacobian.block<1, 3>(1, 3) = f.s2.gradient.transpose();
  const Eigen::Matrix<R, 2, 3> turn = across * f.s1.dnormal;
  f.jacobian.block<2, 3>(2, 0) = -f.s1.normal.dot(f.s2.normal) * turn;
  f.jacobian.block<2, 3>(2, 3) = across * f.s2.dnormal;
  f.jacobian.block<2, 3>(4, 0) = (-across - f.s1.normal.dot(f.d) * turn) / size;
  f.jacobian.block<2, 3>(4, 3) = across / size;
  return f;
}

R largest_exponent(const PlacedPair<R>& pair) {
  R out(2);
  for (const R& n : {pair.body1.shape.n1, pair.body1.shape.n2, pair.body2.shape.n1, pair.body2.shape.n2})
    if (n > out) out = n;
  return out;
}

/// Rounding of F: powers multiply it, and d carries that of the centres' distance.
R noise_of(const PlacedPair<R>& pair) {
  return R(8) * epsilon<R>() * (R(1) + largest_exponent(pair)) * (R(1) + pair.body2.centre.norm());
}

class Solve {
 public:
  Solve(const PlacedPair<R>& pair, const Vec6& start) : pair_(pair), x_(start), here_(system_at(pair, start)) {}

  void run() {
    const R noise = noise_of(pair_);
    while (here_.finite() && residual() > noise && !is_spent()) {
      ++steps_;
      if (!newton() && !levenberg_marquardt()) return;
    }
  }

  [[nodiscard]] R residual() const { return here_.value.norm(); }
  [[nodiscard]] const System& here() const { return here_; }
  [[nodiscard]] const Vec6& x() const { return x_; }
  [[nodiscard]] int steps() const { return steps_; }
  [[nodiscard]] bool is_spent() const { return evaluations_ > most_evaluations; }

 private:
  bool accept(const Vec6& step, const R& share) {
    ++evaluations_;
    const Vec6 next = x_ + step;
    const System there = system_at(pair_, next);
    if (!there.finite() || !(there.value.norm() < share * residual())) return false;
    x_ = next;
    here_ = there;
    return true;
  }

  bool newton() {
    const Vec6 step = least_squares<R>(here_.jacobian, -here_.value).x;
    if (!step.allFinite()) return false;
    R t(1);
    for (int i = 0; i < most_halvings; ++i, t /= R(2))
      if (accept(t * step, R(1) - t / R(1000))) return true;
    return false;
  }

  bool levenberg_marquardt() {
    R damping("1e-20");
    for (int i = 0; i < most_dampings; ++i, damping *= R(10)) {
      Eigen::Matrix<R, 12, 6> stacked;
      stacked << here_.jacobian, damping * Mat6::Identity();
      Eigen::Matrix<R, 12, 1> right = Eigen::Matrix<R, 12, 1>::Zero();
      right.head<6>() = -here_.value;
      const Vec6 step = least_squares<R>(stacked, right).x;
      if (accept(step, R("0.9999"))) return true;
    }
    return false;
  }

  const PlacedPair<R>& pair_;
  Vec6 x_;
  System here_;
  int steps_ = 0, evaluations_ = 0;
};

std::string_view failure(const Solve& solve) {
  const System& f = solve.here();
  if (!f.finite()) return "the Hessian is infinite at a zero coordinate";
  if (!(solve.residual() < R("1e-40"))) return solve.is_spent() ? "evaluation limit" : "no descent";
  return f.s1.normal.dot(f.s2.normal) < R(0) ? "" : "the normals are equal, not opposite";
}

/// |J^-1| (|F| + rounding): how far the solution may be from the points (size in [1, 2)).
R points_error(const Solve& solve, const R& noise) {
  const Mat6 inverse = least_squares<R>(solve.here().jacobian, Mat6::Identity()).x;
  return inverse.norm() * (solve.residual() + noise);
}

Vec6 from_centres(const Pair& pair, const PlacedPair<R>& placed, const Vec3<R>& point1, const Vec3<R>& point2) {
  Vec6 out;
  out << placed.to_pair_point(point1, pair), placed.to_pair_point(point2, pair) - placed.body2.centre;
  return out;
}

SixEquations answer(const Pair& pair, const PlacedPair<R>& placed, const Solve& solve) {
  SixEquations out;
  const System& f = solve.here();
  out.steps = solve.steps();
  out.reason = failure(solve);
  out.solved = out.reason.empty();
  if (!f.finite()) return out;
  out.residual = solve.residual();
  out.normal = f.s1.normal;
  out.overlap = placed.to_world_length(-f.d.dot(f.s1.normal));
  out.point1 = placed.to_world_point(solve.x().head<3>(), pair);
  out.point2 = placed.to_world_point(Vec3<R>(placed.body2.centre + solve.x().tail<3>()), pair);
  const R noise = noise_of(placed), error = points_error(solve, noise);
  out.normal_error = static_cast<double>(f.s1.dnormal.norm() * error + noise);
  out.points_error = static_cast<double>(placed.to_world_length(error));
  return out;
}

}  // namespace

SixEquations solve_six_equations(const Pair& pair, const Vec3<Real50>& point1, const Vec3<Real50>& point2) {
  const PlacedPair<R> placed = place<R>(pair);
  Solve solve(placed, from_centres(pair, placed, point1, point2));
  solve.run();
  return answer(pair, placed, solve);
}

Stretch stretch_to(const Pair& pair, const SixEquations& from, const Vec3<Real50>& point1, const Vec3<Real50>& point2) {
  const PlacedPair<R> placed = place<R>(pair);
  const Vec6 start = from_centres(pair, placed, from.point1, from.point2);
  const Vec6 end = from_centres(pair, placed, point1, point2);
  const R allowed = R(4) * (noise_of(placed) + from.residual);
  const int parts = 4;
  Stretch out{true, 0};
  for (int k = 1; k <= parts; ++k) {
    const System there = system_at(placed, start + (end - start) * (R(k) / R(parts)));
    out.holds = out.holds && there.value.norm() <= allowed;
    out.turn = static_cast<double>((there.s1.normal - from.normal).norm());
  }
  return out;
}

Real50 overlap_along(const Pair& pair, const Vec3<Real50>& n) {
  const PlacedPair<R> placed = place<R>(pair);
  const Vec3<R> unit = n / n.norm();
  const R h1 = support<R>(placed.body1.shape, placed.body1.to_body_direction(unit));
  const R h2 = support<R>(placed.body2.shape, placed.body2.to_body_direction(-unit));
  return placed.to_world_length(h1 + h2 - unit.dot(placed.body2.centre));
}

}  // namespace plumb::reports
