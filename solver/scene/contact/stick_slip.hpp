// A spring and a dashpot that hold up to a limit and slip beyond: what friction, rolling and twisting resistance share.
#pragma once

#include <cmath>

#include "solver/contact.hpp"

namespace plumb::scene {

struct StickSlip {
  double stiffness;  ///< force / stretch
  double viscous;    ///< force / rate
  double limit;      ///< force

  /// The force against the stretch, which goes on by rate * time. Spring and dashpot together hold up to the limit. Beyond it they
  /// slip: the spring is as long as leaves them at the limit (Luding 2008, Granular Matter 10, 235, section 2.4), so that the force
  /// has no jump where slipping begins, ends or turns back. The dashpot alone is cut to the limit before: otherwise the spring
  /// would be stretched against it, and hold energy that nobody put in.
  [[nodiscard]] Vec3<double> pull(Eigen::Ref<Vec3<double>> stretch, const Vec3<double>& rate, double time) const {
    if (limit == 0) {  // by itself, as squares of what is small enough are 0 too, and do not exceed it
      stretch.setZero();
      return Vec3<double>::Zero();
    }
    stretch += rate * time;
    const double most = viscous * rate.norm();
    const Vec3<double> dashpot = (most > limit ? limit / most : 1) * viscous * rate;
    const Vec3<double> held = -stiffness * stretch - dashpot;
    const double size = held.squaredNorm();
    if (size <= limit * limit) return held;
    const Vec3<double> force = held * (limit / std::sqrt(size));
    stretch = -(force + dashpot) / stiffness;
    return force;
  }
};

}  // namespace plumb::scene
