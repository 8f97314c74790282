// fix ID all plumb/wall px py pz nx ny nz [velocity vx vy vz] [amplitude ax ay az] [frequency f]: a scene's wall, the half space that the
// normal points away from. Its contacts are pair_style plumb/cn's.
#pragma once

#include "solver/lammps/lammps_headers.hpp"
#include "solver/scene/scene.hpp"

namespace plumb::lammps {

class FixPlumbWall : public LAMMPS_NS::Fix {
 public:
  FixPlumbWall(LAMMPS_NS::LAMMPS* lammps, int count, char** words);
  int setmask() override { return 0; }

  [[nodiscard]] const scene::Wall& wall() const { return wall_; }
  /// Its number in the scene's walls is the caller's to set.
  [[nodiscard]] const scene::WallMotion& motion() const { return motion_; }

 private:
  scene::Wall wall_;
  scene::WallMotion motion_;
};

}  // namespace plumb::lammps
