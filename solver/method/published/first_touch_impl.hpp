// Bodies of the templates of first_touch.hpp; included only where they are instantiated.
#pragma once

#include "solver/method/published/first_touch.hpp"
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

#define PLUMB_INSTANTIATE_FIRST_TOUCH(S) \
  template Contact<S> undone_motion<S>(const Pair&, const Want&, const Contact<S>*);

}  // namespace plumb
