// The dashpots of effect `damping`: what damps along the normal, and what friction has a share of.
#pragma once

#include "solver/scene/effect/normal/damping.hpp"
#include "solver/scene/material/by_pair.hpp"

namespace plumb::scene {

/// The shortest time in which the dashpots of a scene do something.
[[nodiscard]] double dashpot_time(const Damping& damping, const Scene& scene);

class Dashpots {
 public:
  explicit Dashpots(const World& world);

  /// Force / normal velocity of a contact that presses, once the elastic force is there.
  [[nodiscard]] double at(std::size_t contact) const;

 private:
  /// Of a pair of materials; nothing where it has no elastic force.
  struct Law {
    double of_stiffness = 0;  ///< 2 beta'
    double mass_velocity = 0, viscoelastic = 0;
  };

  static Law law_of(const Effects& effects);

  const World* world_;
  ByPair<Law> laws_;
};

}  // namespace plumb::scene
