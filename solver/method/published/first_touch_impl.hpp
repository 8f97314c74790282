// First touch: the relative motion is undone until the bodies touch at a single point (Cleary, Stokes & Hurley 1997).
//
// Body 2 goes back against the pair's motion, or along the line of centres where no motion is given, by t along the unit line l:
//   g1(x1) = 1, g2(x2) = 1, n1 + n2 = 0, x1 - x2 - t l = 0            8 equations of rank 7 in x1, x2, t
// x2 is the touching point of body 2 where body 2 is, so that after the move by t l both are one. The normal is that of the touch, the
// contact point the middle of x1 and x2. The overlap is n1.(x1 - x2) = t n1.l, the distance of the two planes across the normal:
// with it all methods measure the same, t itself depends on how slantingly the bodies met. Bodies apart are moved together, t < 0.
//
// What it does not promise: a common normal. x1 - x2 lies along the motion and not along the normal; the normal's deviation vanishes
// with t, linearly, the overlap's with its square (o is stationary at the common normal). A line that misses the other body has no touch,
// nor have bodies that are apart and fly apart: these end without an answer. Coinciding centres without a motion are parted along z. It
// has one start and no guard.
#pragma once

#include "solver/method/methods.hpp"
#include "solver/method/published/opposite_normals.hpp"

namespace plumb {
namespace detail {

/// Both points on their surfaces, normals opposite, x1 - x2 = t l, in r1, r2, t.
template <class S>
struct UndoneMotionSystem {
  const PlacedPair<S>& pair;
  Vec3<S> line;

  [[nodiscard]] Linearisation<S, 8, 7> operator()(const Eigen::Matrix<S, 7, 1>& x) const {
    const PairTerms<S> t(pair, x.template head<3>(), x.template segment<3>(3));
    const S& way = x[6];
    const S size = pair.size();
    Linearisation<S, 8, 7> f;
    set_opposite_normals<S>(f, t);
    f.value.template tail<3>() = (t.d + way * line) / size;
    f.jacobian.template block<3, 3>(5, 0) = -Mat3<S>::Identity() / size;
    f.jacobian.template block<3, 3>(5, 3) = Mat3<S>::Identity() / size;
    f.jacobian.template block<3, 1>(5, 6) = line / size;
    f.noise.setConstant(epsilon<S>() * power_noise<S>(pair));
    f.noise.template tail<3>().array() += epsilon<S>() * (pair.body2.centre.stableNorm() / size);
    return f;
  }
};

/// Unit; in which body 2 goes back.
template <class S>
[[nodiscard]] Vec3<S> way_back(const Pair& pair, const PlacedPair<S>& placed) {
  if (pair.motion.isZero(0)) return centre_line<S>(placed);
  return (-pair.motion / pair.motion.cwiseAbs().maxCoeff()).cast<S>().normalized();
}

template <class S>
[[nodiscard]] NewtonResult<S, 7> solve_undone_motion(const PlacedPair<S>& placed, const Offsets<S>& start,
                                                     const Vec3<S>& line, const Want& want) {
  const UndoneMotionSystem<S> system{placed, line};
  Eigen::Matrix<S, 7, 1> x;
  x << start.r1, start.r2, line.dot(start.r1 - start.r2 - placed.body2.centre);
  NewtonResult<S, 7> out = Newton<S, 8, 7, UndoneMotionSystem<S>>(system, want).solve(x);
  // The line meets the other body twice: at the other place the bodies touch on the far side.
  const Vec3<S> normal = surface_terms_about_centre<S>(placed.body1, out.x.template head<3>()).normal;
  if (out.status == Status::converged && !(normal.dot(line) > S(0))) out.status = Status::stalled;
  return out;
}

/// Whether bodies that a move by t > 0 along the line parts do overlap, and were not apart before they flew through each other: a move
/// the other way parts them as well.
template <class S>
[[nodiscard]] bool overlaps_on_the_way(const PlacedPair<S>& placed, const Vec3<S>& line, const Want& want,
                                       NewtonResult<S, 7>& counted) {
  const Vec3<S> back = -line;
  const NewtonResult<S, 7> other = solve_undone_motion<S>(placed, start_along<S>(placed, back), back, want);
  counted.iterations += other.iterations;
  counted.evaluations += other.evaluations;
  return other.status == Status::converged && other.x[6] > -S(undecided_floor) * epsilon<S>() * placed.size();
}

}  // namespace detail

template <class S>
Contact<S> undone_motion(const Pair& pair, const Want& want, const Contact<S>* last) {
  const PlacedPair<S> placed = place<S>(pair);
  const Vec3<S> line = detail::way_back<S>(pair, placed);
  auto result = detail::solve_undone_motion<S>(placed, start_points<S>(placed, pair, last, line), line, want);
  // Along the line of centres body 2 comes from body 1's centre.
  const bool is_known = !pair.motion.isZero(0);
  if (result.status == Status::converged && is_known && result.x[6] > S(0) &&
      !detail::overlaps_on_the_way<S>(placed, line, want, result))
    result.status = Status::stalled;
  return detail::to_contact<S, 7>("first_touch", result, want, placed, pair);
}

}  // namespace plumb
