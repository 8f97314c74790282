// A scene's wall; its contacts are pair_style plumb/cn's.
//
//   fix ID all plumb/wall px py pz nx ny nz MOTION                        the half space that the normal points away from
//   fix ID all plumb/wall cylinder PLACE radius half_length SIDE END END MOTION
//   fix ID all plumb/wall cone PLACE r0 r1 height SIDE END END MOTION
//   fix ID all plumb/wall box PLACE hx hy hz SIDE MOTION
//   fix ID all plumb/wall mesh PLACE smooth_deg N x y z .. MOTION         9 N numbers
//
// PLACE   x y z, and the quaternion w x y z
// SIDE    inside or outside; END, the lower and the upper: open, bare or closed
// MOTION  [velocity v v v] [amplitude a a a] [frequency f] [angular_velocity w w w] [pivot p p p], and [type N]: its material is that of
//         the atoms of type N, 1 if it is not given
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
