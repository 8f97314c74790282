// The tolerances of `auto`, each once with its reason. One that names no case was chosen by measurement, and no case has moved
// it since. Lengths are relative to the pair's size, angles are in rad.
//
// What goes with the precision has two numbers, the second for float.
#pragma once

#include "solver/scalar.hpp"

namespace plumb::tolerance {

struct ByPrecision {
  double of_double, of_float;

  template <class S>
  [[nodiscard, gnu::always_inline]] S of() const {
    return by_precision<S>(of_double, of_float);
  }
};

// Multiples of epsilon.
inline constexpr double touching = 8;        ///< concentric spheres: o is the inner rolling radius itself, to rounding
inline constexpr double surely_apart = 16;   ///< o is below zero whatever its rounding
inline constexpr double undecided = 8;       ///< of the overlap: what rounding may do to it leaves the verdict open
inline constexpr double search_noise = 16;   ///< of o; at 64 a tie of 1.6e-14 was taken for the lowest
inline constexpr double behind_centre = 32;  ///< of d.c, by n.c: how far the corners of a sector lie behind its plane
inline constexpr double squared_tilt = 16;   ///< of axes called parallel, its square: what search_noise takes up
inline constexpr double small_tilt = 0.05;  ///< of axes that are nearly parallel, its sine; beyond it squares do better
inline constexpr double mixing = 4;         ///< of a mixture of four points, in semi-axes
inline constexpr double rotation_noise = 32;  ///< of the derivative of o along a rotation
inline constexpr double common_axis = 8;      ///< of the axes and centres of bodies on one line
inline constexpr double same_length = 4;      ///< a step or two of a double: semi-axes of a body of revolution
inline constexpr double own_noise = 16;       ///< of a gauge, times its powers: a point that both bodies hold
inline constexpr double residual = 4;         ///< of a common normal of superellipsoids
/// Where such a residual counts as rounding once it falls no longer. The laws allow 16 of the points as they are handed out,
/// which rounds once more.
inline constexpr double resting_residual = 12;
/// A residual at rest falls by less than a fifth a step. On a needle's flat tip it falls to a third a step, and by half at
/// last: corpus/cases/regressions/needles-in-line-16-eps.json.
inline constexpr double resting_factor = 1.25;
inline constexpr double last_step = 0.05;  ///< by how much the last step's square may turn a normal

// Shares.
inline constexpr double armijo = 1e-4;           ///< of the descent that is predicted (Nocedal & Wright)
inline constexpr double shorter_step = 0.4;      ///< a step that a line search does not take is cut to this
inline constexpr double basin_slope = 0.2;       ///< of the lowest curvature: Newton's iteration stays in this basin
inline constexpr double least_curvature = 1e-3;  ///< of the size: flatter directions get a step of that curvature
inline constexpr double off_saddle = 0.3;        ///< step of a descent off a saddle
inline constexpr double widest_descent = 0.5;    ///< first and largest radius of trust
inline constexpr double beside_saddle = 0.4, across_saddle = 0.07;  ///< starts beside a saddle, on no plane of symmetry
inline constexpr double promising_residual = 0.05;                  ///< small, and by
inline constexpr double promising_factor = 0.8;                     ///< falling: more steps are worth it
inline constexpr double steady_step = 0.1;  ///< of a chart's unit vector: a longer one was a jump
inline constexpr double steady_bend =
    0.25;                            ///< of that step: by how much it may differ from the one before and go on so
inline constexpr double blocky = 3;  ///< an exponent above it: the direction does not say where on a face a point is

// A step from surface point to surface point (surface_step.hpp).
inline constexpr double pole = 1e-3;          ///< of the outer arc's c: nearer to the pole the inner arc is Cartesian
inline constexpr double past_the_pole = 0.1;  ///< of the radius in g: one that falls below is taken as past the pole
inline constexpr double near_inner_point = 0.04;  ///< square of the inner arc's turn: second order holds up to it
inline constexpr double most_shrunk = -0.7, most_grown = 3;  ///< by which the normal's length is corrected
inline constexpr double least_ratio = 0.02;       ///< of the smaller coordinate: a step past infinity ends there
inline constexpr double longest_component = 1e3;  ///< of a step that a singular system has blown up

// Newton's iteration on directions (ellipsoid_newton.hpp).
inline constexpr double noise_multiple = 2;    ///< of epsilon: rounding of p1 + p2 - c
inline constexpr double circle_multiple = 12;  ///< of epsilon: an axis common to 8 epsilon leaves a slope of that size
inline constexpr double settled_multiple = 8;  ///< of the floor: what the settling steps must reach
inline constexpr double longest_turn = 0.8;    ///< 0.7 .. 1 do as well; at 1.5 needles take 19 steps instead of 12
inline constexpr double shorter = 0.3;         ///< a step that does not lower o is cut to this
inline constexpr double tie = 0.01;  ///< of o: the eigenvalue along a circle of minima or between ties, made positive
inline constexpr double tie_on_circle = 1e-9;     ///< the same where the rotation is held anyway
inline constexpr double least_correction = 0.01;  ///< of the length before: less, or more than the next, says nothing
inline constexpr double most_correction = 100;
inline constexpr double short_direction = 1e-3, long_direction = 1e3;  ///< largest components: beyond them n is scaled
inline constexpr double determinant_noise = 16;       ///< of epsilon: below it a determinant of needles has no sign
inline constexpr ByPrecision short_turn{1e-4, 1e-2};  ///< from here on o is too flat to tell what is lower
inline constexpr ByPrecision last_turn{1e-9, 1e-4};   ///< its square, the error of the linear step, is below rounding
inline constexpr double last_turn_of_root = 0.06;     ///< the same of finer scalars, of the root of epsilon
inline constexpr ByPrecision near{1e-8, 1e-4};  ///< error, relative to the size, from which its floor is asked for

/// Above the rounding of what proves that a common normal is the lowest, for bodies that are no needles.
inline constexpr ByPrecision proof_margin{1e-9, 1e-4};
/// An overlap above the start's by more: Newton's iteration has run uphill. A slope below it is none.
inline constexpr ByPrecision uphill{1e-9, 1e-4};
/// Normals that are one and the same to a search.
inline constexpr ByPrecision same_normal{1e-6, 1e-3};
/// Offset and tilt of two axes up to which Newton's iteration takes the rounding of o's second derivative around the axis for
/// that derivative.
inline constexpr ByPrecision nearly_coaxial{1e-7, 1e-3};
/// Gain and pivot of the simplex method, whose tableau holds numbers about 1.
inline constexpr ByPrecision least_gain{1e-12, 1e-5};
/// Sizes apart from which the line of centres is the normal to rounding.
inline constexpr ByPrecision far_apart{1e17, 1e8};
/// Sizes apart up to which centres coincide, for a start.
inline constexpr ByPrecision coinciding{1e-14, 1e-6};
/// A residual from which the last step of surface points may be tried.
inline constexpr ByPrecision last_step_residual{1e-7, 3e-4};
/// The radius of trust that a descent keeps.
inline constexpr ByPrecision least_radius{1e-6, 1e-3};
/// A minimum of o to rounding: relative to the curvature, and of the size.
inline constexpr ByPrecision curvature_noise{1e-6, 1e-3};
inline constexpr ByPrecision minimum_noise{1e-12, 1e-5};
/// One over the radius of curvature that a flat counts as.
inline constexpr ByPrecision flat_curvature{1e-8, 1e-5};
/// An exponent this near to 2 takes the limit of its t*.
inline constexpr ByPrecision near_two{1e-6, 1e-3};

// Numbers whose powers, squares or reciprocals stay finite.
/// For a coordinate of zero.
inline constexpr ByPrecision smallest_ratio{1e-140, 1e-15};
/// For a power of it, and for that power's logarithm.
inline constexpr ByPrecision least_power{1e-300, 1e-35};
inline constexpr ByPrecision least_logarithm{-690, -80};
/// For a pivot of zero: the step is cut in any case.
inline constexpr ByPrecision smallest_pivot{1e-300, 1e-36};
/// A direction's largest component that has a reciprocal.
inline constexpr ByPrecision smallest_direction{1e-300, 1e-36};
/// For an infinite curvature.
inline constexpr ByPrecision largest_curvature{1e60, 1e12};
/// For an infinite t*: the arc is followed in c alone.
inline constexpr ByPrecision endless_switch{1e300, 1e38};
/// Square of a step that is no infinity and no NaN.
inline constexpr ByPrecision largest_square{1e200, 1e30};

}  // namespace plumb::tolerance
