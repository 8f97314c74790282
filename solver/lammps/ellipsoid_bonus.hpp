// Shapes and orientations of atom_style ellipsoid, and the vectors of fix property/atom beside them. The package has no header of that style, but its library exports the functions by
// which it packs them for other processes: these are declared here, and nothing of the class's layout is known or used.
#pragma once

#include <array>

#include "solver/contact.hpp"
#include "solver/lammps/lammps_headers.hpp"

namespace LAMMPS_NS {

class AtomVecEllipsoid {
 public:
  int pack_comm_bonus(int count, int* list, double* out);    ///< quaternion (w, x, y, z) of each
  void unpack_comm_bonus(int count, int first, double* in);  ///< the same, of consecutive atoms
  int pack_border_bonus(int count, int* list, double* out);  ///< a flag, semi-axes, quaternion
  void set_shape(int atom, double a, double b, double c);    ///< semi-axes; turned by nothing where it had none
};

}  // namespace LAMMPS_NS

namespace plumb::lammps {

class EllipsoidBonus {
 public:
  EllipsoidBonus() = default;
  explicit EllipsoidBonus(LAMMPS_NS::Atom& atom)
      : atoms_(reinterpret_cast<LAMMPS_NS::AtomVecEllipsoid*>(atom.style_match("ellipsoid"))) {}

  /// Whether the atoms are of that style.
  [[nodiscard]] bool is_there() const { return atoms_ != nullptr; }

  [[nodiscard]] std::array<double, 3> semi_axes(int atom) const {
    std::array<double, 8> packed{};
    atoms_->pack_border_bonus(1, &atom, packed.data());
    return {packed[1], packed[2], packed[3]};
  }
  [[nodiscard]] std::array<double, 4> quaternion(int atom) const {
    std::array<double, 4> packed{};
    atoms_->pack_comm_bonus(1, &atom, packed.data());
    return packed;
  }
  void set_semi_axes(int atom, const Vec3<double>& axes) const { atoms_->set_shape(atom, axes[0], axes[1], axes[2]); }
  void set_quaternion(int atom, std::array<double, 4> quaternion) const {
    atoms_->unpack_comm_bonus(1, atom, quaternion.data());
  }

 private:
  LAMMPS_NS::AtomVecEllipsoid* atoms_ = nullptr;
};

/// An atom's custom vector of that name, or -1.
[[nodiscard]] inline int vector_of(LAMMPS_NS::Atom& atom, const char* name) {
  int is_double = 0, columns = 0;
  const int found = atom.find_custom(name, is_double, columns);
  return is_double == 1 && columns == 0 ? found : -1;
}

}  // namespace plumb::lammps
