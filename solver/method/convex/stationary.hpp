// Newton for a common normal whose pieces are known.
//
// Unknowns   n; o; l_i, the weights of the pieces x_i(n) of body 1, and m_j, those of the pieces y_j(-n) of body 2
// Equations  sum l_i x_i - sum m_j y_j = o n     the points lie along the normal
//            x_i.n = x_0.n,  y_j.n = y_0.n       all pieces are farthest
//            sum l_i = 1,  sum m_j = 1,  n.n = 1
//
// One piece of each body: two points of smooth surfaces. Two of one body: a point of an edge or of a cone's side; three: of a face.
// A smooth core is described by its support point x(n), or by the chart of its surface (chart.hpp), which is smooth where x(n) jumps, on a
// flat, and where n turns by much between points that are next to each other, at an edge:
//            nu(w) = s n                            its two coordinates w and s more
//
// Where bodies touch with a corner on an edge or a rim, a fan of normals is one contact: o I vanishes in the equations, and turning n within the
// fan changes nothing. The shortest of all steps that solve them leaves it where it is.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "solver/method/convex/nearest.hpp"

namespace plumb::detail {

/// A common normal of the cores.
struct CommonNormal {
  Vec3<double> normal;
  double overlap;
  Vec3<double> point1, point2;
};

/// How a smooth core is described: by its support point; or by its chart, from where that has the normal, or the point.
enum class Described : std::uint8_t { by_support, from_normal, from_point };

/// A body's part in a contact: the pieces that it lies on, and how it is described.
struct ActivePieces {
  static constexpr int most = 3;
  std::array<int, most> piece{};
  std::array<double, most> weight{};
  int count = 0;
  bool by_chart = false;
  CubePoint<double> at{};  ///< by_chart
  double s = 1;

  /// False: there is no room for one more.
  bool add(int which, double by) {
    for (int k = 0; k < count; ++k)
      if (piece[static_cast<std::size_t>(k)] == which) return weight[static_cast<std::size_t>(k)] += by, true;
    if (count == most) return false;
    piece[static_cast<std::size_t>(count)] = which;
    weight[static_cast<std::size_t>(count++)] = by;
    return true;
  }
  /// Weights that are below 0 by rounding are 0: the point belongs to its body then.
  void draw_in() {
    double sum = 0;
    for (double& l : weight) sum += l = std::max(l, 0.0);
    for (double& l : weight) l /= sum;
  }
  [[nodiscard]] bool is_mixture() const {
    constexpr double rounding = 1e-12;
    return std::all_of(weight.begin(), weight.begin() + count, [](double l) { return l >= -rounding; });
  }
};

/// Of Newton's equations: the one there is, or where they are singular the shortest; or the one there is however far it leads at first, as
/// around a ring of normals that are all but as low.
enum class NewtonStep : std::uint8_t { only, shortest, far };

class StationaryNewton {
 public:
  StationaryNewton(const PlacedCores& pair, const Mixture& from, const Vec3<double>& normal)
      : pair_(pair), start_(from), start_normal_(normal) {
    for (int k = 0; k < from.count; ++k) {
      const auto at = static_cast<std::size_t>(k);
      if (!(from.weight[at] > 0)) continue;
      const int piece1 = pair.body1.is_foreign() ? 0 : from.of[at].piece1,
                piece2 = pair.body2.is_foreign() ? 0 : from.of[at].piece2;
      fits_ = fits_ && pieces_[0].add(piece1, from.weight[at]) && pieces_[1].add(piece2, from.weight[at]);
    }
    fits_ = fits_ && pieces_[0].count + pieces_[1].count <= most_pieces;
  }

  /// nullopt: it does not converge, or not to a contact. Each smooth core may be described by its chart.
  [[nodiscard]] std::optional<CommonNormal> solve(Described first, Described second, NewtonStep step) const {
    if (!fits_ || (first != Described::by_support && !pair_.body1.is_smooth()) ||
        (second != Described::by_support && !pair_.body2.is_smooth()))
      return std::nullopt;
    Iteration iteration{pair_, start_normal_, start_.w().dot(start_normal_), pieces_, step, {}, {}};
    iteration.describe(0, first, start_.point1());
    iteration.describe(1, second, start_.point2());
    return iteration.run();
  }

 private:
  static constexpr int most_pieces = 4;  // n has two degrees of freedom
  static constexpr int most_unknowns = 3 + 1 + most_pieces + 2 * 3;
  using System = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_unknowns, most_unknowns>;
  using Column = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_unknowns, 1>;

  struct Iteration {
    const PlacedCores& pair;
    Vec3<double> n;
    double overlap;
    std::array<ActivePieces, 2> pieces;
    NewtonStep way;
    System jacobian;
    Column residual;
    double bend = 0;  ///< the largest radius of curvature of the pieces

    [[nodiscard]] const PlacedCore& body(int i) const { return i == 0 ? pair.body1 : pair.body2; }
    [[nodiscard]] ActivePieces& of(int i) { return pieces[static_cast<std::size_t>(i)]; }
    [[nodiscard]] const ActivePieces& of(int i) const { return pieces[static_cast<std::size_t>(i)]; }
    [[nodiscard]] static double sign(int i) { return i == 0 ? 1 : -1; }

    void describe(int i, Described how, const Vec3<double>& x) {
      of(i).by_chart = how != Described::by_support;
      if (how == Described::from_normal) of(i).at = body(i).chart_of_normal(sign(i) * n);
      if (how == Described::from_point) of(i).at = body(i).chart_of_point(x);
    }

    [[nodiscard]] std::optional<CommonNormal> run() {
      constexpr int most_steps = 16;
      constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
      const Vec3<double> start = n;
      const double most_growth = way == NewtonStep::far ? 1e6 : 1e3;
      double last = std::numeric_limits<double>::infinity();
      for (int step = 0;; ++step) {
        const double now = evaluate();
        const bool is_last = step == most_steps;
        const bool is_solved = now <= rounding * pair.size || (now <= 64 * rounding * pair.size && now >= last / 2) ||
                               (is_last && is_as_far_as_rounding_lets(64 * rounding));
        if (is_solved) return is_contact() && is_near(start) ? std::optional(contact()) : std::nullopt;
        const bool grows = !(now < most_growth * last || (pair.all_but_touch(overlap) && now < 0.1 * pair.size));
        if (is_last || grows || !take_step()) return std::nullopt;
        last = std::min(last, now);
      }
    }

    /// Whether it is the contact that was begun from. Of bodies that all but touch the least error of a point turns the normal by any angle.
    [[nodiscard]] bool is_near(const Vec3<double>& start) const {
      constexpr double near = 0.1;
      return (n - start).norm() < near || pair.all_but_touch(overlap);
    }

    /// All but the points, and these but for what rounding of n makes of them: on a surface that is all but flat it turns a point by its radius,
    /// many times the size. A smooth core has its chart for that.
    [[nodiscard]] bool is_as_far_as_rounding_lets(double rounding) const {
      constexpr double most = 0x1p20;
      for (int i = 0; i < 2; ++i)
        if (body(i).is_smooth() && !of(i).by_chart) return false;
      return residual.tail(residual.size() - 3).cwiseAbs().maxCoeff() <= rounding * pair.size &&
             residual.head<3>().cwiseAbs().maxCoeff() <= rounding * std::clamp(bend, pair.size, most * pair.size);
    }

    /// The residual's largest component, a length.
    double evaluate() {
      const int m = of(0).count + of(1).count,
                unknowns = 4 + m + 3 * (of(0).by_chart ? 1 : 0) + 3 * (of(1).by_chart ? 1 : 0);
      jacobian = System::Zero(unknowns, unknowns);
      residual = Column::Zero(unknowns);
      jacobian.topLeftCorner<3, 3>() = -overlap * Mat3<double>::Identity();
      jacobian.block<3, 1>(0, 3) = -n;
      residual.head<3>() = -overlap * n;
      jacobian.block<1, 3>(3, 0) = 2 * n.transpose();
      residual[3] = n.squaredNorm() - 1;
      bend = 0;
      int weights = 4, charts = 4 + m;
      for (int i = 0; i < 2; ++i) {
        if (of(i).by_chart)
          add_chart(i, weights, charts), charts += 3;
        else
          add_pieces(i, weights);
        weights += of(i).count;
      }
      return residual.cwiseAbs().maxCoeff();
    }

    /// `at`: the place of the body's weights among the unknowns, and of its equations about pieces.
    void add_pieces(int i, int at) {
      const Vec3<double> u = sign(i) * n;
      Vec3<double> first = Vec3<double>::Zero();
      residual[at] = -1;
      for (int k = 0; k < of(i).count; ++k) {
        const double weight = of(i).weight[static_cast<std::size_t>(k)];
        const PieceSupport x = body(i).support(of(i).piece[static_cast<std::size_t>(k)], u);
        if (k == 0) first = x.point;
        residual.head<3>() += sign(i) * weight * x.point;
        jacobian.topLeftCorner<3, 3>() += weight * x.hessian;  // of body 2: both signs turn
        bend = std::max(bend, x.hessian.cwiseAbs().maxCoeff());
        jacobian.block<3, 1>(0, at + k) = sign(i) * x.point;
        residual[at] += weight;
        jacobian(at, at + k) = 1;
        if (k == 0) continue;
        residual[at + k] = (x.point - first).dot(u);
        jacobian.block<1, 3>(at + k, 0) = sign(i) * (x.point - first).transpose();
      }
    }

    /// One piece, of weight 1.
    void add_chart(int i, int at, int unknown) {
      const SurfacePoint<double> of_chart = body(i).on_chart(of(i).at);
      residual.head<3>() += sign(i) * of_chart.point;
      jacobian.block<3, 2>(0, unknown) = sign(i) * of_chart.dpoint;
      jacobian(at, at) = 1;
      residual.segment<3>(unknown) = of_chart.normal - of(i).s * sign(i) * n;
      jacobian.block<3, 2>(unknown, unknown) = of_chart.dnormal;
      jacobian.block<3, 3>(unknown, 0) = -of(i).s * sign(i) * Mat3<double>::Identity();
      jacobian.block<3, 1>(unknown, unknown + 2) = -sign(i) * n;
    }

    /// The shortest step: J' (J J' + e I)^-1 r, which is that but for what e makes it shorter, where e is far below the squares of the
    /// singular values that are not 0.
    [[nodiscard]] Column solved() const {
      constexpr double damping = 1e-13;
      if (way != NewtonStep::shortest) return jacobian.partialPivLu().solve(residual);
      System square = jacobian.lazyProduct(jacobian.transpose());
      square.diagonal().array() += damping;
      const Column shares = square.llt().solve(residual);
      return jacobian.transpose().lazyProduct(shares);
    }

    [[nodiscard]] bool take_step() {
      if (!jacobian.allFinite() || !residual.allFinite()) return false;
      const Column step = solved();
      if (!step.allFinite()) return false;
      n = (n - step.head<3>()).normalized();
      overlap -= step[3];
      int weights = 4, charts = 4 + of(0).count + of(1).count;
      for (int i = 0; i < 2; ++i) {
        for (int k = 0; k < of(i).count; ++k) of(i).weight[static_cast<std::size_t>(k)] -= step[weights + k];
        weights += of(i).count;
        if (!of(i).by_chart) continue;
        of(i).at = of(i).at.moved(-step[charts], -step[charts + 1]);
        of(i).s -= step[charts + 2];
        charts += 3;
      }
      return true;
    }

    /// Its points lie on the pieces, no other point of the bodies is farther, and o does not fall on any side.
    [[nodiscard]] bool is_contact() const {
      constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();
      return of(0).is_mixture() && of(1).is_mixture() && pair.overlap(n) <= overlap + rounding * pair.size &&
             is_lowest_nearby();
    }

    /// On the directions along which all pieces stay farthest, the second derivative of o is not below 0, but for what rounding makes of an
    /// overlap that is 0.
    [[nodiscard]] bool is_lowest_nearby() const {
      const double surely = overlap > 0 ? std::max(overlap - pair.rounding(), 0.0) : overlap;
      Mat3<double> second = -surely * Mat3<double>::Identity();
      Vec3<double> kink = Vec3<double>::Zero();
      for (int i = 0; i < 2; ++i) {
        Vec3<double> first = Vec3<double>::Zero();
        for (int k = 0; k < of(i).count; ++k) {
          const PieceSupport x = body(i).support(of(i).piece[static_cast<std::size_t>(k)], sign(i) * n);
          second += of(i).weight[static_cast<std::size_t>(k)] * x.hessian;
          if (k == 0)
            first = x.point;
          else
            kink = x.point - first;
        }
      }
      const int kinks = of(0).count + of(1).count - 2;
      if (kinks == 2 || !second.allFinite()) return true;  // infinite: on a flat
      const Vec3<double> s = kinks == 1 ? n.cross(kink).normalized() : n.unitOrthogonal(), t = n.cross(s);
      const double ss = s.dot(second * s), tt = t.dot(second * t), st = s.dot(second * t);
      return ss >= 0 && (kinks == 1 || (tt >= 0 && ss * tt >= st * st));
    }

    [[nodiscard]] CommonNormal contact() {
      for (ActivePieces& p : pieces) p.draw_in();
      return {n, overlap, point(0), point(1)};
    }
    [[nodiscard]] Vec3<double> point(int i) const {
      if (of(i).by_chart) return body(i).on_chart(of(i).at).point;
      Vec3<double> out = Vec3<double>::Zero();
      for (int k = 0; k < of(i).count; ++k)
        out += of(i).weight[static_cast<std::size_t>(k)] *
               body(i).support(of(i).piece[static_cast<std::size_t>(k)], sign(i) * n).point;
      return out;
    }
  };

  const PlacedCores& pair_;
  const Mixture& start_;
  Vec3<double> start_normal_;
  std::array<ActivePieces, 2> pieces_;
  bool fits_ = true;
};

}  // namespace plumb::detail
