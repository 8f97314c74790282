// A periodic box full of superquadrics at random, as LAMMPS reads it, and a script that is ready to run it.
#pragma once

#include <fmt/format.h>

#include <string>

#include "properties/generators/draft.hpp"
#include "solver/contact.hpp"

namespace plumb::scene {

struct Crate {
  int side = 4;          ///< bodies along each edge
  double spacing = 0.9;  ///< of a lattice; the longest diameter of a body is 1
  int types = 1;
  bool is_triclinic = true;
  double diameter = 0;    ///< where it is not 0: as `atom_style hybrid ellipsoid sphere` has it
  double shear_rate = 0;  ///< velocities have this gradient of x along y
  /// All bodies moved so far, in edges of the box, and with them where the shear flow is at rest.
  Vec3<double> moved = Vec3<double>::Zero();
};

namespace detail {

/// Into the box, and how many boxes further up along y it was.
inline int wrap(Vec3<double>& x, double edge) {
  const double rows = std::floor(x.y() / edge);
  for (double& part : x) part -= edge * std::floor(part / edge);
  return static_cast<int>(rows);
}

}  // namespace detail

[[nodiscard]] inline std::string data_text(const Crate& crate) {
  const double edge = crate.side * crate.spacing;
  const int bodies = crate.side * crate.side * crate.side;
  Stream stream("crate", 1, 0);
  std::string atoms, velocities, ellipsoids, shapes;
  for (int k = 0; k < bodies; ++k) {
    const Eigen::Vector3i place(k % crate.side, k / crate.side % crate.side, k / (crate.side * crate.side));
    Vec3<double> x = crate.spacing * (place.cast<double>() + Vec3<double>::Constant(0.5)), v;
    for (double& part : x) part += stream.uniform(-0.05, 0.05);
    for (double& part : v) part = stream.uniform(-0.3, 0.3);
    x += edge * crate.moved;
    v.x() += crate.shear_rate * (x.y() - edge * detail::wrap(x, edge));
    const Quaternion q = random_rotation(stream);
    const int id = k + 1;
    const std::string at = fmt::format(" {} {} {}", x[0], x[1], x[2]);
    atoms += fmt::format("{} {}", id, 1 + k % crate.types) +
             (crate.diameter > 0 ? fmt::format("{} 1 1 {}\n", at, crate.diameter) : " 1 1" + at + "\n");
    velocities += fmt::format("{} {} {} {} 0 0 0.01{}\n", id, v[0], v[1], v[2], crate.diameter > 0 ? " 0 0 0" : "");
    ellipsoids += fmt::format("{} 1 0.8 0.7 {} {} {} {}\n", id, q[0], q[1], q[2], q[3]);
    shapes += fmt::format("{} {} {} 1\n", id, k % 2 == 0 ? 4 : 2.5, k % 3 == 0 ? 6 : 3);
  }
  std::string box;
  for (const char axis : {'x', 'y', 'z'}) box += fmt::format("0 {} {}lo {}hi\n", edge, axis, axis);
  if (crate.is_triclinic) box += "0 0 0 xy xz yz\n";
  return fmt::format(
      "# bodies at random\n\n{0} atoms\n{0} ellipsoids\n{1} atom types\n\n{2}\nAtoms\n\n{3}\nVelocities\n\n{4}\n"
      "Ellipsoids\n\n{5}\nShapes\n\n{6}",
      bodies, crate.types, box, atoms, velocities, ellipsoids, shapes);
}

inline const std::string shapes_fix = "fix shapes all property/atom d_n1 d_n2 d_density ghost yes\n";

struct CrateScript {
  std::string before_motion{};  ///< lines after the pair style and before fix plumb/nve
  std::string group = "all";    ///< that moves
  std::string new_bodies{};     ///< words of fix plumb/nve
  std::string thermo = "pe ke pxx pyy pzz pxy pxz pyz";
  std::string style = "units lj\natom_style ellipsoid\n";
  std::string read = shapes_fix + "read_data data.txt fix shapes NULL Shapes\n";
  std::string pair =
      "pair_style plumb/cn accuracy 1e-4 linear.stiffness 1e3 damping.restitution 0.7 friction.coefficient 0.4\n"
      "pair_coeff * *\n";
};

/// What is to be run comes after it.
[[nodiscard]] inline std::string script_text(const CrateScript& parts = {}) {
  return parts.style + "newton off\ncomm_modify vel yes\n" + parts.read + parts.pair +
         "timestep 1e-3\nneighbor 0.1 bin\nneigh_modify every 1 delay 0 check yes\ngroup low id <= 16\n"
         "group high subtract all low\n" +
         parts.before_motion + "fix motion " + parts.group + " plumb/nve " + parts.new_bodies +
         "\nthermo_style custom step atoms " + parts.thermo +
         "\nthermo_modify norm no format float %.17g\nthermo 50\n"
         "dump all all custom 50 dump.txt id x y z vx vy vz fx fy fz\ndump_modify all sort id format float %.17g\n";
}

}  // namespace plumb::scene
