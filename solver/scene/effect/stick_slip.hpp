// A spring and a dashpot that hold up to a limit and slip beyond: what friction, rolling and twisting resistance share.
#pragma once

#include <cmath>

#include "solver/contact.hpp"

namespace plumb::scene {

struct StickSlip {
  double stiffness;  ///< force / stretch
  double viscous;    ///< force / rate
  double limit;      ///< force

  /// The force against the stretch, which goes on by rate * time; once it slips, the spring is as long as the limit holds.
  [[nodiscard]] Vec3<double> pull(Eigen::Ref<Vec3<double>> stretch, const Vec3<double>& rate, double time) const {
    stretch += rate * time;
    Vec3<double> force = -stiffness * stretch - viscous * rate;
    const double size = force.norm();
    if (size <= limit) return force;
    force *= limit / size;
    if (stiffness > 0) stretch = -(force + viscous * rate) / stiffness;
    return force;
  }
};

}  // namespace plumb::scene
