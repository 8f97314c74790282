// The bodies that atoms are: shape, mass and size.
#include <algorithm>
#include <cmath>
#include <utility>

#include "solver/lammps/fix_plumb_nve.hpp"
#include "solver/scene/body/mass.hpp"
#include "solver/scene/body/world_setup.hpp"

namespace plumb::lammps {

bool PairPlumbCn::is_body(int i) const {
  const int type = atom->type[i];
  for (int other = 1; other <= atom->ntypes; ++other)
    if (setflag[std::min(type, other)][std::max(type, other)] != 0) return true;
  return false;
}

bool PairPlumbCn::is_ellipsoid(int i) const {
  return atom->dvector[n1_][i] == 2 && atom->dvector[n2_][i] == 2;
}

void PairPlumbCn::find_shapes() {
  n1_ = vector_of(*atom, "n1");
  n2_ = vector_of(*atom, "n2");
  density_ = vector_of(*atom, "density");
  require(n1_ >= 0 && n2_ >= 0 && density_ >= 0, "needs fix property/atom d_n1 d_n2 d_density ghost yes");
}

/// A body's mass follows from its shape. Others are said to be replaced, but for what LAMMPS gives an ellipsoid or an atom that is new.
void PairPlumbCn::weigh_atoms() {
  constexpr double rounding = 1e-12, of_new_atom = 1;
  long long here = 0, all = 0;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!is_body(i)) continue;
    const scene::SceneBody one = body(i);
    const double mass = one.density * scene::mass_properties(one.body.shape).volume;
    const double ellipsoid = one.density * scene::mass_properties({one.body.shape.semi_axes, 2, 2}).volume;
    const double was = std::exchange(atom->rmass[i], mass);
    const auto is_like = [was](double m) { return std::abs(was - m) <= rounding * m; };
    here += is_like(mass) || is_like(ellipsoid) || was == of_new_atom ? 0 : 1;
  }
  MPI_Allreduce(&here, &all, 1, MPI_LONG_LONG, MPI_SUM, world);
  if (all > 0 && comm->me == 0)
    error->warning(FLERR, said(fmt::format("{} masses were not d_density times the volume, and are now", all)));
}

void PairPlumbCn::measure_types() {
  std::vector<double> here(index(atom->ntypes) + 1);
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!is_body(i)) continue;
    double& radius = here[index(atom->type[i])];
    radius = std::max(radius, scene::bounding_radius(body(i).body.shape));
  }
  for (const NewBody& one : motion_->new_bodies()) {
    double& radius = here[index(one.type)];
    radius = std::max(radius, scene::bounding_radius(one.shape));
  }
  radius_.resize(here.size());
  MPI_Allreduce(here.data(), radius_.data(), static_cast<int>(here.size()), MPI_DOUBLE, MPI_MAX, world);
}

scene::SceneBody PairPlumbCn::body(int i) const {
  scene::SceneBody out;
  if (atom->ellipsoid[i] < 0) error->one(FLERR, said(fmt::format("atom {} has no shape", atom->tag[i])));
  const auto axes = shapes_.semi_axes(i);
  out.body.shape = {{axes[0], axes[1], axes[2]}, atom->dvector[n1_][i], atom->dvector[n2_][i]};
  out.density = atom->dvector[density_][i];
  out.is_fixed = is_fixed(i);
  if (!materials_.empty()) out.material = index(atom->type[i]) - 1;
  const plumb::Pair alone{out.body, out.body};
  if (const InputError wrong = find_input_error(alone); !wrong.reason.empty())
    error->one(FLERR, said(fmt::format("atom {}: {}: {}{}", atom->tag[i], wrong.field, wrong.reason,
                                       i < atom->nlocal ? "" : "; fix property/atom needs `ghost yes`")));
  if (!(std::isfinite(out.density) && out.density > 0))
    error->one(FLERR, said(fmt::format("atom {}: d_density must be a positive number", atom->tag[i])));
  return out;
}

Vec3<double> PairPlumbCn::inverse_inertia(int i) const {
  scene::Bodies alone;
  scene::add_body(alone, body(i), true);
  return alone.inverse_inertia[0];
}

}  // namespace plumb::lammps
