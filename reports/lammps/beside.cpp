#include "reports/lammps/beside.hpp"

#include <fmt/format.h>

namespace plumb::scene {
namespace {

constexpr double diameter = 0.02;

/// {0}: atom style, {1}: distance, {2}: what a body is, {3}: pair style, {4}: motion.
constexpr const char* script = R"(units si
atom_style {0}
newton off
comm_modify vel yes
boundary p p p
lattice sc {1}
region box block 0 22 0 22 0 22
create_box 1 box
fix shapes all property/atom d_n1 d_n2 d_density ghost yes
create_atoms 1 box
{2}
variable vx atom 0.05*(random(0,1,77)-0.5)
variable vy atom 0.05*(random(0,1,78)-0.5)
variable vz atom 0.05*(random(0,1,79)-0.5)
velocity all set v_vx v_vy v_vz sum no
pair_style {3}
pair_coeff * *
fix motion all {4}
timestep 1e-5
neighbor 0.001 bin
neigh_modify every 1 delay 0 check yes
thermo 1000
dump last all custom 1000 dump.lammpstrj id
run 300
)";

constexpr const char* own_ball = R"(set group all diameter {0}
set group all density 2500)";

constexpr const char* body = R"(set group all shape {0} {0} {0}
set group all quat/random 1971
set group all d_n1 {1}
set group all d_n2 {1}
set group all d_density 2500)";

}  // namespace

std::string beside_script(const BesideBox& box) {
  const bool is_own = box.exponent == 0;
  return fmt::format(fmt::runtime(script), is_own ? "sphere" : "ellipsoid", box.spacing * diameter,
                     is_own ? fmt::format(fmt::runtime(own_ball), diameter)
                            : fmt::format(fmt::runtime(body), diameter, box.exponent),
                     box.style, is_own ? "nve/sphere" : "plumb/nve");
}

}  // namespace plumb::scene
