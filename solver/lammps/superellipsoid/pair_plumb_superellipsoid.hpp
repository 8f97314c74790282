// pair_style plumb/superellipsoid: contacts and forces of plumb/cn, in the words of LAMMPS's own pair_style granular/superellipsoid.
#pragma once

#include <optional>
#include <vector>

#include "solver/lammps/pair_plumb_cn.hpp"
#include "solver/lammps/superellipsoid/coefficients.hpp"

namespace plumb::lammps {

/// As LAMMPS does when `set density` is done: the masses of atoms whose density was set, of their shapes of now.
void weigh_by_density(LAMMPS_NS::Atom& atom);

class PairPlumbSuperellipsoid : public PairPlumbCn {
 public:
  using PairPlumbCn::PairPlumbCn;

  /// [cutoff] [no_bounding_box] [curvature_gaussian] [geometric], which are about LAMMPS's way to a contact and change nothing here.
  void settings(int count, char** words) override;
  void coeff(int count, char** words) override;
  void init_style() override;
  [[nodiscard]] const char* name() const override { return "plumb/superellipsoid"; }
  [[nodiscard]] bool puts_motion_last() const override { return true; }

 private:
  using Coefficients = scene::SuperellipsoidCoefficients;

  /// Types are counted from 1.
  [[nodiscard]] std::size_t row_of_types() const { return static_cast<std::size_t>(atom->ntypes) + 1; }
  [[nodiscard]] std::optional<Coefficients>& given(int type1, int type2);
  /// Nothing of a type that is another style's.
  [[nodiscard]] std::optional<Coefficients> between(int type1, int type2);
  /// Exponents that were not set are 2. A density that was not set, or the shape since, is the mass's.
  void complete_shapes() const;
  void give_effects();

  std::vector<std::optional<Coefficients>> given_;
};

}  // namespace plumb::lammps
