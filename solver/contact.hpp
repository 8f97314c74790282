// The vocabulary of plumb: what goes into a solver and what comes out.
//
// Frames   world frame throughout; a body's quaternion takes body axes to world axes.
// Signs    overlap > 0: the bodies penetrate by that length; overlap < 0: they are -overlap apart.
//          normal points from body 1 to body 2.
// Units    lengths in the caller's own unit (any, positions and semi-axes alike), angles in radians.
// Validity a field that was not asked for, or that a method could not find, is NaN - never a zero.
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <optional>
#include <string_view>

namespace plumb {

/// A column of three.
template <class S>
using Vec3 = Eigen::Matrix<S, 3, 1>;
/// A 3x3 matrix.
template <class S>
using Mat3 = Eigen::Matrix<S, 3, 3>;

/// Three NaN: a field that was not asked for, or not found.
template <class S>
[[nodiscard]] Vec3<S> not_valid() {
  return Vec3<S>::Constant(std::numeric_limits<S>::quiet_NaN());
}

/// Superellipsoid (|x/a|^n2 + |y/b|^n2)^(n1/n2) + |z/c|^n1 = 1 in body axes; n1, n2 > 1 keep it convex with one normal
/// at each point. n1 pairs the xy-radius with z, n2 pairs x with y (the order of LIGGGHTS); 2, 2 is an ellipsoid.
template <class S = double>
struct Superellipsoid {
  Vec3<S> semi_axes = Vec3<S>::Ones();
  S n1{2};
  S n2{2};
};

/// A shape and where it is.
struct Body {
  Superellipsoid<double> shape;
  Vec3<double> position = Vec3<double>::Zero();
  /// (w, x, y, z), any non-zero length: the rotation is that of the quaternion divided by its norm.
  std::array<double, 4> quaternion{1, 0, 0, 0};
};

/// The exact input of every solver and of the reference: these doubles, and nothing derived from them.
struct Pair {
  Body body1;
  Body body2;
  /// Body 2's velocity relative to body 1's, any unit and length; zero: not known. Only its direction counts, and only for
  /// Problem::first_touch.
  Vec3<double> motion = Vec3<double>::Zero();
};

/// What the caller pays for. The methods of the literature fill overlap, normal and points in any case, for they come out of
/// one solve, and know no derivatives.
struct Want {
  bool overlap = true;
  bool normal = true;
  bool points = true;
  bool curvature = false;
  bool derivatives = false;
  bool patch = false;
  /// Relative error at which a patch may stop; see Patch::error.
  double patch_tolerance = 1e-3;
  int iteration_limit = 100;  ///< of each local solve: the last resorts of `auto` are several; see Status::stalled
  /// Residual, relative to the pair's size, at which a method may stop; 0 asks for all that rounding allows.
  double tolerance = 0;

  /// Nothing but the verdict, which may end at the first proof of it.
  [[nodiscard]] bool is_yes_or_no() const {
    return !(overlap || normal || points || curvature || derivatives || patch);
  }
};

/// Each value says which inequality ended the solve; only `converged` vouches for the residual (in a yes
/// or no, for the verdict alone), and not even that vouches for the answer: see reference/.
enum class Status {
  converged,        ///< residual <= max(Want::tolerance, the method's rounding floor)
  iteration_limit,  ///< Want::iteration_limit steps were taken and the residual is still larger
  stalled,          ///< no step along the search direction lowers the residual any more, or 100 did by less than 10 %
  singular,         ///< the Jacobian has lost rank, so that there is no search direction
  not_finite,       ///< a NaN or an infinity came up at a point that the method had to use
  invalid_input     ///< a number is not finite, an axis not positive, an exponent not above 1, or a quaternion zero
};

/// `undecided`: the overlap is zero to within the rounding floor of the answer, or there is no answer.
enum class Verdict { undecided, overlapping, separated };

/// Principal curvature of one surface at its contact point.
template <class S>
struct PrincipalCurvature {
  S radius1 = std::numeric_limits<S>::quiet_NaN();  ///< length; infinite on a flat, 0 on an edge
  S radius2 = std::numeric_limits<S>::quiet_NaN();
  Vec3<S> direction1 = not_valid<S>();  ///< unit, tangent to the surface, world frame
  Vec3<S> direction2 = not_valid<S>();
};

/// How overlap and normal follow a body that is shifted by dx and turned by the rotation vector dw (rad), both in world axes,
/// the turn about the body's own position.
template <class S>
struct PoseDerivative {
  Vec3<S> overlap_by_shift;  ///< d overlap = . dx
  Vec3<S> overlap_by_turn;   ///< d overlap = . dw, length
  Mat3<S> normal_by_shift;   ///< d normal = . dx, 1/length; NaN, as the next, where there is none: on a ring of normals
  Mat3<S> normal_by_turn;    ///< d normal = . dw
};

/// The part that two overlapping bodies have in common, and what it exerts under a pressure: no number of it depends on the contact's
/// point or normal, and all but the axes follow the poses without a jump. World frame. Bodies apart have volume and area 0, and the rest NaN.
struct Patch {
  double volume = std::numeric_limits<double>::quiet_NaN();  ///< V, length^3
  double area = std::numeric_limits<double>::quiet_NaN();  ///< |a|, a the area vector of body 1's surface inside body 2
  /// a/|a|: from body 1 to body 2. dV = -a . dx where body 2 is shifted by dx; NaN where a = 0, a body inside the other.
  Vec3<double> normal = not_valid<double>();
  Vec3<double> centre = not_valid<double>();  ///< of the volume, so also of the depth along any direction
  /// int (x - centre) x dA over body 1's surface inside body 2, length^3: where body 2 is turned by dw about the centre, dV = -. dw
  Vec3<double> area_moment = not_valid<double>();
  Vec3<double> second_moments =
      not_valid<double>();  ///< principal, int (x - centre)^2 dV / V, length^2, the largest first
  /// Columns: their axes, right-handed, the third from body 1 to body 2. Any in their plane where two moments are equal, and they turn at once
  /// near there: points_of (patch.hpp) does not.
  Mat3<double> axes = Mat3<double>::Constant(std::numeric_limits<double>::quiet_NaN());
  /// Estimate of the largest relative error: of V, of |a|, of the centre and the moments by the lens's own widths. Above
  /// Want::patch_tolerance where that was not reached; infinite where there is no answer: none was found, or its error is larger than itself.
  double error = std::numeric_limits<double>::infinity();
};

/// Pairs of points, one inside each body, that show how deep the bodies reach into one another along many directions. They move with the bodies:
/// what proved that one contact is the lowest is where the proof for the next one begins.
template <class S>
struct Witnesses {
  static constexpr std::size_t most = 6;
  std::size_t count = 0;
  std::array<std::array<Vec3<S>, most>, 2> points;  ///< of body 1 and of body 2: body axes, in its semi-axes
  std::array<Superellipsoid<double>, 2> shapes;     ///< whose: of others they may be no points
};

/// By how much the last step of a chart (body axes) differs from the one before: a correction, for which floats will do. NaN where one is.
template <class S>
[[nodiscard]] Vec3<float> chart_bend(const Vec3<S>& chart, const Vec3<S>& last, const Vec3<S>& before_last) {
  return Vec3<S>(chart - last - (last - before_last)).template cast<float>();
}

/// The answer to a pair. Only with Status::converged are its numbers an answer; world frame, the caller's unit.
template <class S = double>
struct Contact {
  std::string_view method;          ///< the method that answered; empty for invalid_input
  Status status = Status::stalled;  ///< pessimistic until a method says otherwise
  Verdict verdict = Verdict::undecided;
  S overlap = std::numeric_limits<S>::quiet_NaN();  ///< length, signed as above
  Vec3<S> normal = not_valid<S>();                  ///< unit, from body 1 to body 2
  Vec3<S> point1 = not_valid<S>();                  ///< on body 1's surface, world frame
  Vec3<S> point2 = not_valid<S>();                  ///< on body 2's surface, world frame
  Vec3<S> contact_point = not_valid<S>();           ///< where a force would act
  /// The points' chart directions in body axes (shape/chart.hpp), of `auto` only: what its warm start takes, for they stay
  /// good whatever way the bodies move together. Of other shapes than superellipsoids the outward normals in body axes.
  Vec3<S> chart1 = not_valid<S>(), chart2 = not_valid<S>();
  /// Those of the contact that this one was warm started from, and their bends: what moves steadily is ahead of where it was.
  Vec3<S> last_chart1 = not_valid<S>(), last_chart2 = not_valid<S>();
  Vec3<float> bend1 = not_valid<float>(), bend2 = not_valid<float>();
  /// Of `auto`, where a short search showed that nothing is lower, now or at an earlier step: it takes the next one less.
  std::optional<Witnesses<S>> witnesses;
  std::array<PrincipalCurvature<S>, 2> curvature;
  std::optional<std::array<PoseDerivative<S>, 2>> derivatives;  ///< by the pose of body 1 and of body 2
  std::optional<Patch> patch;  ///< of `auto`, where it was asked for and the contact converged
  int iterations = 0;          ///< steps of the outer loop, of the local solve that answered (all its attempts)
  int evaluations = 0;         ///< of the residual, over all there was: line searches, other attempts, the guard
};

/// Tells a contact with charts which one it was warm started from.
template <class S>
void keep_steps(Contact<S>& contact, const Contact<S>& last) {
  contact.last_chart1 = last.chart1;
  contact.last_chart2 = last.chart2;
  contact.bend1 = chart_bend(contact.chart1, last.chart1, last.last_chart1);
  contact.bend2 = chart_bend(contact.chart2, last.chart2, last.last_chart2);
}

/// The question that a method answers; each is judged against its own.
enum class Problem {
  common_normal,   ///< normals opposite, the line through the points along them, lowest overlap
  deepest_points,  ///< geometric potential: the point of each surface where the other's potential is lowest
  midway,          ///< geometric potential: the point where both potentials are equal and their gradients opposite
  first_touch      ///< the single point at which the bodies touch where their relative motion is undone
};

/// All there are.
inline constexpr std::array problems{Problem::common_normal, Problem::deepest_points, Problem::midway,
                                     Problem::first_touch};

/// The contract's word: "converged", "iteration_limit", ..
[[nodiscard]] std::string_view name(Status status);
/// "undecided", "overlapping", "separated".
[[nodiscard]] std::string_view name(Verdict verdict);
/// "common_normal", "deepest_points", ..
[[nodiscard]] std::string_view name(Problem problem);

/// Empty when the pair is legal input; otherwise the first offending field ("bodies[1].shape.exponents[0]") and why.
struct InputError {
  std::string_view field;
  std::string_view reason;
  int body = 0;  ///< -1: of the pair
};
/// The first thing wrong with a pair; both texts are empty where it is legal.
[[nodiscard]] InputError find_input_error(const Pair& pair);
/// The same without words, in a few nanoseconds.
[[nodiscard]] bool is_valid(const Pair& pair);
/// The same for who has set the standard mode (standard_arithmetic.hpp): in others a subnormal axis may count as zero.
[[nodiscard]] bool is_valid_in_callers_mode(const Pair& pair);

/// The pair with its bodies exchanged.
[[nodiscard]] inline Pair swapped(const Pair& pair) {
  return {pair.body2, pair.body1, -pair.motion};
}

/// The larger body's size (its longest semi-axis): the length to which every error is relative.
[[nodiscard]] inline double size_of(const Pair& pair) {
  return std::max(pair.body1.shape.semi_axes.maxCoeff(), pair.body2.shape.semi_axes.maxCoeff());
}

}  // namespace plumb
