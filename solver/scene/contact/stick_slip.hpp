// A spring and a dashpot that hold up to a limit and slip beyond: what friction, rolling and twisting resistance share.
#pragma once

#include <cmath>

#include "solver/contact.hpp"

namespace plumb::scene {

struct StickSlip {
  double stiffness;  ///< force / stretch
  double viscous;    ///< force / rate
  double limit;      ///< force

  /// The force against the stretch, which goes on by rate * time. Once it slips the spring alone holds the limit, and is no longer
  /// than that; before, spring and dashpot together do not exceed it.
  [[nodiscard]] Vec3<double> pull(Eigen::Ref<Vec3<double>> stretch, const Vec3<double>& rate, double time) const {
    if (limit == 0) {  // by itself, as squares of what is small enough are 0 too, and do not exceed it
      stretch.setZero();
      return Vec3<double>::Zero();
    }
    stretch += rate * time;
    const double elastic = stiffness * stiffness * stretch.squaredNorm(), most = limit * limit;
    if (elastic > most) {
      stretch *= limit / std::sqrt(elastic);
      return -stiffness * stretch;
    }
    const Vec3<double> force = -stiffness * stretch - viscous * rate;
    const double size = force.squaredNorm();
    return size > most ? Vec3<double>(force * (limit / std::sqrt(size))) : force;
  }
};

}  // namespace plumb::scene
