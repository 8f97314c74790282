#include "solver/reference/touch/touch.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace plumb::reference {
namespace {

using I = TouchScalar;
using Unknowns = Eigen::Matrix<Real80, 5, 1>;  ///< two chart coordinates a body, and the parameter
using TouchBox = Eigen::Matrix<I, 5, 1>;
using TouchMatrix = Eigen::Matrix<I, 5, 5>;

/// s1, s2 and c of the family at t, and their derivatives.
struct Growth {
  I s1 = I(1.0), s2 = I(1.0), ds1 = I(0.0), ds2 = I(0.0);
  IVec3<I> centre, dcentre = IVec3<I>::Constant(I(0.0));
};

Growth growth_at(const TouchFamily& family, const I& t) {
  Growth out;
  out.centre = family.pair.centre;
  switch (family.kind) {
    case TouchKind::along_line:
      out.centre = family.line * t;
      out.dcentre = family.line;
      break;
    case TouchKind::moved_along_line:
      out.centre += family.line * t;
      out.dcentre = family.line;
      break;
    case TouchKind::second_grown:
      out.s2 = t;
      out.ds2 = I(1.0);
      break;
    case TouchKind::both_grown:
      const I rate1 = I(1.0) / I(family.pair.body1.n1), rate2 = I(1.0) / I(family.pair.body2.n1);
      out.s1 = exp(I(t * rate1));
      out.s2 = exp(I(t * rate2));
      out.ds1 = rate1 * out.s1;
      out.ds2 = rate2 * out.s2;
      break;
  }
  return out;
}

/// s1 X1 - c - s2 X2 = 0 and two components of G1 x G2 = 0, with their Jacobian. The third component vanishes with them
/// where the component of G1 beside it does not.
struct Equations {
  TouchBox value;
  TouchMatrix jacobian;
  IVec3<I> point, gradient1, gradient2;
};

/// The body axis that the pair's axis `a` is parallel to, exactly; -1 for none. The body is its own mirror image along it.
int parallel_axis(const EnclosedBody<I>& body, int a) {
  for (int j = 0; j < 3; ++j)
    if (is_exactly(body.rotation(a, (j + 1) % 3), 0) && is_exactly(body.rotation(a, (j + 2) % 3), 0)) return j;
  return -1;
}

// Where both bodies and the family are their own mirror images along one of the pair's axes, so is the one touch: normal
// and points have no component along it, and the two unknowns that say so are fixed at zero. Their place in the equations
// (the axis's own row and the cross product's that holds only such components) is taken by "this unknown is zero". Without
// that the equations would be singular there for any exponent other than 2.
class TouchSystem {
 public:
  TouchSystem(const TouchFamily& family, const ChartPair<Real50>& at)
      : family_(family), first_(chart_box(at.at1, I(0.0))), second_(chart_box(at.at2, I(0.0))) {
    const IVec3<I> g = enclose_surface<I>(family.pair.body1, first_).gradient;
    for (int i = 1; i < 3; ++i)
      if (low(magnitude<I>(g[i])) > low(magnitude<I>(g[pivot_]))) pivot_ = i;
    for (int step = 1; step < 3; ++step) find_mirror(step);
  }

  [[nodiscard]] Unknowns start(const Real50& parameter) const {
    Unknowns y;
    for (int k = 0; k < 2; ++k) {
      y[k] = middle<Real80>(first_.w[first_.minor(k)]);
      y[2 + k] = middle<Real80>(second_.w[second_.minor(k)]);
    }
    y[4] = Real80(parameter);
    for (int k = 0; k < 5; ++k)
      if (is_fixed(k)) y[k] = 0;
    return y;
  }

  /// Whether unknown k is zero by symmetry.
  [[nodiscard]] bool is_fixed(int k) const { return row_of_[k] >= 0; }

  [[nodiscard]] Equations at(const TouchBox& y) const {
    const SurfaceEnclosure<I> one = surface(family_.pair.body1, first_, y, 0),
                              two = surface(family_.pair.body2, second_, y, 2);
    const Growth growth = growth_at(family_, y[4]);
    Equations out;
    out.point = one.point * growth.s1;
    out.gradient1 = one.gradient;
    out.gradient2 = two.gradient;
    out.value << IVec3<I>(out.point - growth.centre - two.point * growth.s2), across(one.gradient, two.gradient);
    for (int k = 0; k < 2; ++k) {
      const IVec3<I> g1 = one.dgradient.col(k), g2 = two.dgradient.col(k);
      out.jacobian.col(k) << IVec3<I>(one.dpoint.col(k) * growth.s1), across(g1, two.gradient);
      out.jacobian.col(2 + k) << IVec3<I>(-two.dpoint.col(k) * growth.s2), across(one.gradient, g2);
    }
    out.jacobian.col(4) << IVec3<I>(one.point * growth.ds1 - two.point * growth.ds2 - growth.dcentre), I(0.0), I(0.0);
    for (int k = 0; k < 5; ++k)
      if (is_fixed(k)) put_zero(out, row_of_[k], k);
    return out;
  }

  /// Whether a solution of the equations in the box is the touch: opposite normals, and what else the family needs.
  [[nodiscard]] bool is_touch(const Equations& f, const I& parameter) const {
    const bool independent = is_positive(magnitude<I>(f.gradient1[pivot_]));
    return independent && is_the_touch(f, parameter) && high(dot(f.gradient1, f.gradient2)) < 0;
  }

 private:
  [[nodiscard]] bool is_the_touch(const Equations& f, const I& parameter) const {
    if (family_.kind == TouchKind::moved_along_line) return is_positive(dot(f.gradient1, family_.line));
    return family_.kind == TouchKind::both_grown || is_positive(parameter);
  }

  static SurfaceEnclosure<I> surface(const EnclosedBody<I>& body, SurfaceBox<I> chart, const TouchBox& y, int first) {
    for (int k = 0; k < 2; ++k) chart.w[chart.minor(k)] = y[first + k];
    return enclose_surface<I>(body, chart);
  }

  /// The two components of a x b other than the pivot's.
  [[nodiscard]] IVec2<I> across(const IVec3<I>& a, const IVec3<I>& b) const {
    const int i = (pivot_ + 1) % 3, j = (pivot_ + 2) % 3;
    return {a[j] * b[pivot_] - a[pivot_] * b[j], a[pivot_] * b[i] - a[i] * b[pivot_]};
  }

  /// The pair's axis `step` after the pivot; the other one's row of the cross product is 5 - step.
  void find_mirror(int step) {
    const int a = (pivot_ + step) % 3;
    if (!is_across(a)) return;
    const int first = unknown_of(first_, parallel_axis(family_.pair.body1, a));
    const int second = unknown_of(second_, parallel_axis(family_.pair.body2, a));
    if (first < 0 || second < 0) return;
    row_of_[first] = a;
    row_of_[2 + second] = 5 - step;
  }

  /// Whether all of the family's centres have no component along the pair's axis `a`.
  [[nodiscard]] bool is_across(int a) const {
    const bool line = family_.kind == TouchKind::along_line || family_.kind == TouchKind::moved_along_line;
    const bool from_centre = family_.kind != TouchKind::along_line;
    return (!line || is_exactly(family_.line[a], 0)) && (!from_centre || is_exactly(family_.pair.centre[a], 0));
  }

  /// Which of a chart's unknowns belongs to a body axis; -1 for neither.
  static int unknown_of(const SurfaceBox<I>& chart, int axis) {
    for (int k = 0; k < 2; ++k)
      if (chart.minor(k) == axis) return k;
    return -1;
  }

  static void put_zero(Equations& f, int row, int unknown) {
    f.value[row] = I(0.0);
    for (int j = 0; j < 5; ++j) f.jacobian(row, j) = I(j == unknown ? 1.0 : 0.0);
  }

  const TouchFamily& family_;
  SurfaceBox<I> first_, second_;
  int pivot_ = 0;                                                             ///< the largest component of G1
  Eigen::Matrix<int, 5, 1> row_of_ = Eigen::Matrix<int, 5, 1>::Constant(-1);  ///< of the equation that fixes an unknown
};

TouchBox points_of(const Unknowns& y) {
  TouchBox out;
  for (int i = 0; i < 5; ++i) out[i] = enclosing<I>(y[i]);
  return out;
}

/// An approximate inverse of the Jacobian's middle, as exact numbers.
TouchMatrix preconditioner(const TouchMatrix& jacobian) {
  Eigen::Matrix<Real80, 5, 5> m;
  for (int i = 0; i < 25; ++i) m(i / 5, i % 5) = middle<Real80>(jacobian(i / 5, i % 5));
  const Eigen::Matrix<Real80, 5, 5> inverse = m.fullPivLu().inverse();
  TouchMatrix out;
  for (int i = 0; i < 25; ++i) out(i / 5, i % 5) = enclosing<I>(inverse(i / 5, i % 5));
  return out;
}

/// One Newton step; y is left at its end.
struct Step {
  TouchBox size;  ///< C f(y) before the step
  TouchMatrix preconditioner;
};

Step newton_step(const TouchSystem& system, Unknowns& y) {
  const Equations f = system.at(points_of(y));
  Step out;
  out.preconditioner = preconditioner(f.jacobian);
  out.size = out.preconditioner * f.value;
  for (int i = 0; i < 5; ++i)
    if (!system.is_fixed(i)) y[i] -= middle<Real80>(out.size[i]);
  return out;
}

/// Newton from a 50-digit solution: one step or two, and many only where the charts are nearly singular.
void polish(const TouchSystem& system, Unknowns& y) {
  const int limit = 40;
  const Real80 small("1e-60"), least("1e-40");
  bool done = false;
  for (int i = 0; i < limit && !done; ++i) {
    const Unknowns before = y;
    (void)newton_step(system, y);
    done = true;
    for (int k = 0; k < 5; ++k) done &= !(abs(Real80(y[k] - before[k])) > small * (abs(y[k]) + least));
  }
}

/// A box about y, some times as wide as the last step, and box - y, rounded outwards like the box itself.
struct Trial {
  TouchBox box, radius;
};

Trial trial_about(const TouchSystem& system, const TouchBox& y, const TouchBox& step, const I& widening) {
  const double relative_floor = 1e-74, floor = 1e-78;
  Trial out{y, TouchBox::Constant(I(0.0))};
  for (int k = 0; k < 5; ++k) {
    if (system.is_fixed(k)) continue;
    const I rounding = magnitude<I>(y[k]) * I(relative_floor) + I(floor);
    const I reach = high_end<I>(I(widening * (magnitude<I>(step[k]) + rounding)));
    out.box[k] = y[k] + hull<I>(I(-reach), reach);
    out.radius[k] = out.box[k] - y[k];
  }
  return out;
}

/// K = y - C f(y) + (1 - C J(box)) (box - y), which holds every solution in the box, and has one where K lies inside it.
TouchBox krawczyk(const TouchBox& y, const Step& step, const TouchMatrix& jacobian, const TouchBox& radius) {
  TouchMatrix rest = -(step.preconditioner * jacobian);
  for (int i = 0; i < 5; ++i) rest(i, i) += I(1.0);
  return y - step.size + rest * radius;
}

bool lies_inside(const TouchSystem& system, const TouchBox& x, const TouchBox& box) {
  bool inside = true;
  for (int k = 0; k < 5; ++k) inside &= system.is_fixed(k) || mpfi_is_strictly_inside(x[k].data(), box[k].data()) > 0;
  return inside;
}

}  // namespace

EnclosedTouch enclose_touch(const TouchFamily& family, const ChartPair<Real50>& start, const Real50& parameter) {
  const int widenings = 6;
  const TouchSystem system(family, start);
  Unknowns y = system.start(parameter);
  polish(system, y);
  const TouchBox centre = points_of(y);
  const Step step = newton_step(system, y);
  I widening(8.0);
  for (int i = 0; i < widenings; ++i, widening *= I(32.0)) {
    const Trial trial = trial_about(system, centre, step.size, widening);
    const Equations f = system.at(trial.box);
    const TouchBox image = krawczyk(centre, step, f.jacobian, trial.radius);
    if (!lies_inside(system, image, trial.box)) continue;
    if (!system.is_touch(f, trial.box[4])) return {};
    return {true, image[4], f.point, f.gradient1 / length_of(f.gradient1)};
  }
  return {};
}

EnclosedPair<I> exchanged(const EnclosedPair<I>& pair) {
  return {pair.body2, pair.body1, IVec3<I>(-pair.centre), pair.exponent};
}

Bounds ends_of(const I& x) {
  return {low_as<Real50>(x), high_as<Real50>(x)};
}

}  // namespace plumb::reference
