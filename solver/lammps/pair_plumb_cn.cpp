#include "solver/lammps/pair_plumb_cn.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "solver/lammps/fix_plumb_nve.hpp"
#include "solver/lammps/fix_plumb_wall.hpp"
#include "solver/lammps/refusals.hpp"
#include "solver/scene/body/mass.hpp"
#include "solver/scene/body/rotation.hpp"
#include "solver/scene/body/world_setup.hpp"

namespace plumb::lammps {
namespace {

using LAMMPS_NS::tagint;

/// Of Update::whichflag.
constexpr int minimizing = 2;

/// The command that is being done: nothing else tells a rerun from a run before its first force.
struct CommandOf : LAMMPS_NS::Input {
  static std::string_view name(const LAMMPS_NS::Input& input) {
    const char* command = input.*(&CommandOf::command);
    return command != nullptr ? command : "";
  }
};

Vec3<double> vector_at(const double* x) {
  return {x[0], x[1], x[2]};
}

}  // namespace

PairPlumbCn::PairPlumbCn(LAMMPS_NS::LAMMPS* lammps) : Pair(lammps) {
  single_enable = 0;
  restartinfo = 0;
  respa_enable = 0;
  no_virial_fdotr_compute = 1;
}

PairPlumbCn::~PairPlumbCn() {
  if (allocated == 0) return;
  memory->destroy(setflag);
  memory->destroy(cutsq);
}

std::string PairPlumbCn::said(const std::string& reason) const {
  return fmt::format("pair_style {}: {}", name(), reason);
}

void PairPlumbCn::require(bool holds, const char* reason) const {
  if (!holds) error->all(FLERR, said(reason));
}

void PairPlumbCn::init_style() {
  shapes_ = EllipsoidBonus(*atom);
  require(shapes_.is_there(), "needs atom_style ellipsoid");
  require(atom->tag_enable != 0, "needs atom IDs");
  require(force->newton_pair == 0, "needs `newton off`: each process sums the forces of its own atoms");
  require(comm->ghost_velocity != 0, "needs `comm_modify vel yes`");
  require(force->ftm2v == 1, "needs units in which force = mass acceleration: lj, si, cgs, micro or nano");
  require(update->whichflag != minimizing, "cannot minimize");
  require(CommandOf::name(*input) != "rerun", "cannot rerun: a dump does not bring back orientations");
  require(std::strcmp(update->integrate_style, "verlet") == 0, "needs run_style verlet");
  require(compute_flag != 0, "cannot be left out: no `pair_modify compute no`");
  const auto motions = fixes_of<FixPlumbNve>(*modify);
  require(motions.size() == 1, "needs one fix plumb/nve");
  motion_ = motions.front();
  find_shapes();
  find_frozen();
  make_part();
  refuse_what_goes_wrong({*lmp, name(), *motion_, frozen_, has_closing(), [&](int i) { return is_body(i); },
                          [&](int i) { return is_ellipsoid(i); }});
  weigh_atoms();
  measure_types();
  neighbor->request(this, instance_me);
}

void PairPlumbCn::make_part() {
  scene::PartSettings settings{arguments_.effects, {}, update->dt, arguments_.accuracy, counted_materials(),
                               material_pairs_};
  scene::MovingWalls moving;
  std::vector<std::string> walls;
  for (const FixPlumbWall* fix : fixes_of<FixPlumbWall>(*modify)) {
    walls.emplace_back(fix->id);
    moving.motions.push_back(fix->motion());
    moving.motions.back().wall = static_cast<int>(settings.walls.size());
    settings.walls.push_back(fix->wall());
    if (materials_.empty()) settings.walls.back().material = 0;
  }
  if (!moving.motions.empty()) settings.effects.moving_walls = moving;
  try {
    part_ = std::make_unique<scene::Part>(settings);
  } catch (const scene::SceneError& refusal) {
    error->all(FLERR, said(fmt::format("{}: {}", refusal.field, refusal.what())));
  }
  motion_->keep_only(part_->history_names(), walls, row_width());
  is_stale_ = true;
}

double PairPlumbCn::init_one(int type1, int type2) {
  return radius_[index(type1)] + radius_[index(type2)] + part_->range();
}

bool PairPlumbCn::is_fixed(int i) const {
  return (atom->mask[i] & motion_->groupbit) == 0 || (atom->mask[i] & frozen_) != 0;
}

void PairPlumbCn::find_frozen() {
  frozen_ = frozen_before_ = 0;
  bool is_before = true;
  for (int k = 0; k < modify->nfix; ++k) {
    const LAMMPS_NS::Fix& fix = *modify->fix[k];
    is_before = is_before && &fix != motion_;
    if (std::string_view(fix.style) != "freeze") continue;
    if (is_before) frozen_before_ |= fix.groupbit;
    if (is_before || puts_motion_last()) frozen_ |= fix.groupbit;
  }
}

bool PairPlumbCn::is_owned(std::uint32_t body) const {
  return body < atom_of_body_.size() && atom_of_body_[body] < atom->nlocal;
}

/// Whether bonds of the kind that special_bonds numbers so leave a pair out.
bool PairPlumbCn::is_bonded_apart(int kind) const {
  const double factor = force->special_lj[kind];
  if (factor != 0 && factor != 1) error->one(FLERR, said("a contact is there or not: special_bonds must be 0 or 1"));
  return factor == 0;
}

std::vector<PairPlumbCn::AtomPair> PairPlumbCn::listed_pairs() const {
  std::vector<AtomPair> out;
  for (int k = 0; k < list->inum; ++k) {
    const int i = list->ilist[k];
    for (int n = 0; n < list->numneigh[i]; ++n) {
      const int entry = list->firstneigh[i][n], j = entry & NEIGHMASK;
      if (is_bonded_apart(sbmask(entry)) || (is_fixed(i) && is_fixed(j))) continue;
      out.emplace_back(i, j);
    }
  }
  return out;
}

void PairPlumbCn::number_bodies(const std::vector<AtomPair>& listed) {
  body_of_atom_.assign(index(atom->nlocal + atom->nghost), -1);
  atom_of_body_.clear();
  const auto take = [&](int i) {
    if (std::exchange(body_of_atom_[index(i)], 0) < 0) atom_of_body_.push_back(i);
  };
  for (int i = 0; i < atom->nlocal; ++i)
    if (is_body(i)) take(i);
  for (const auto& [i, j] : listed) take(j);
  std::ranges::sort(atom_of_body_, {}, [&](int i) { return std::pair(atom->tag[i], i); });
  for (std::size_t k = 0; k < atom_of_body_.size(); ++k) body_of_atom_[index(atom_of_body_[k])] = static_cast<int>(k);
}

std::vector<std::array<std::uint32_t, 2>> PairPlumbCn::contact_pairs(const std::vector<AtomPair>& listed) const {
  std::vector<std::array<std::uint32_t, 2>> out;
  for (const auto& [i, j] : listed) {
    const auto a = static_cast<std::uint32_t>(body_of(i)), b = static_cast<std::uint32_t>(body_of(j));
    out.push_back({std::min(a, b), std::max(a, b)});
  }
  const auto walls = fixes_of<FixPlumbWall>(*modify);
  for (int i = 0; i < atom->nlocal; ++i)
    for (std::size_t wall = 0; wall < walls.size() && is_body(i) && !is_fixed(i); ++wall)
      out.insert(out.end(), scene::places_of(walls[wall]->wall().shape),
                 {static_cast<std::uint32_t>(body_of(i)), static_cast<std::uint32_t>(atom_of_body_.size() + wall)});
  std::ranges::sort(out);
  return out;
}

/// A contact is known by its atoms' IDs, so that no atom may have two images of another for neighbours.
void PairPlumbCn::refuse_two_images() const {
  std::vector<std::pair<std::uint32_t, double>> seen;
  for (const auto& [a, b] : part_->world().contacts.pairs) {
    if (part_->world().bodies.is_wall(b)) continue;
    if (is_owned(a)) seen.emplace_back(a, key_of(b));
    if (is_owned(b)) seen.emplace_back(b, key_of(a));
  }
  std::ranges::sort(seen);
  if (std::ranges::adjacent_find(seen) != seen.end())
    error->one(FLERR, said("an atom and two images of another are neighbours: the box is too small"));
}

/// What ghosts of `fix property/atom` without `ghost yes` have is left over from other atoms. On all processes.
void PairPlumbCn::refuse_left_over_shapes() const {
  std::vector<std::vector<double>> rows(index(atom->nlocal + atom->nghost));
  const auto row_of = [&](int i) {
    return std::vector{1.0, atom->dvector[n1_][i], atom->dvector[n2_][i], atom->dvector[density_][i]};
  };
  for (int i = 0; i < atom->nlocal; ++i) rows[index(i)] = row_of(i);
  constexpr std::size_t width = 4;
  motion_->share(rows, width);
  for (const int i : atom_of_body_)
    if (rows[index(i)] != row_of(i))
      error->one(FLERR, said(fmt::format("atom {} has not its shape as a ghost: fix property/atom needs "
                                         "`ghost yes`",
                                         atom->tag[i])));
}

void PairPlumbCn::renew() {
  const auto listed = listed_pairs();
  number_bodies(listed);
  std::vector<scene::SceneBody> bodies;
  for (const int i : atom_of_body_) {
    bodies.push_back(body(i));
    if (scene::bounding_radius(bodies.back().body.shape) > radius_[index(atom->type[i])])
      error->one(FLERR, said(fmt::format("atom {} is larger than those of its type were at the start of the run",
                                         atom->tag[i])));
  }
  if (update->setupflag != 0) refuse_left_over_shapes();
  part_->renew(bodies, contact_pairs(listed));
  refuse_two_images();
  motion_->forget_new_atoms(row_width());
  recall();
  is_stale_ = false;
}

/// Of a fixed body that a fix of LAMMPS turns: what it is told is kept as the angular momentum of an ellipsoid, I = m/5 (b^2 + c^2).
Vec3<double> PairPlumbCn::told_angular_velocity(int i) const {
  const auto axes = shapes_.semi_axes(i);
  const Vec3<double> squares = vector_at(axes.data()).cwiseAbs2();
  const Vec3<double> inertia = atom->rmass[i] / 5 * (Vec3<double>::Constant(squares.sum()) - squares);
  const auto [w, x, y, z] = shapes_.quaternion(i);
  return scene::angular_velocity({w, x, y, z}, vector_at(atom->angmom[i]), inertia.cwiseInverse());
}

void PairPlumbCn::place_bodies() {
  for (std::size_t k = 0; k < atom_of_body_.size(); ++k) {
    const int i = atom_of_body_[k];
    part_->place(k, vector_at(atom->x[i]), vector_at(atom->v[i]), shapes_.quaternion(i), vector_at(atom->angmom[i]));
    if (is_fixed(i)) part_->world().state.angular_velocity->vector(k) = told_angular_velocity(i);
  }
}

void PairPlumbCn::compute(int eflag, int vflag) {
  ev_init(eflag, vflag);
  if (is_stale_) renew();
  // As a run begins LAMMPS asks for it whether or not anything reads it.
  if (vflag_either != 0 && update->setupflag == 0 && part_->world().bodies.walls > 0 &&
      !std::exchange(has_warned_, true) && comm->me == 0)
    error->warning(FLERR, said("pressures are without the forces of walls"));
  part_->keep_contact_forces(vflag_either != 0);
  place_bodies();
  const double step = update->setupflag != 0 ? 0 : update->dt;
  part_->press(motion_->time(), step);
  add_forces();
  if (eflag_atom != 0) share_energy();
  if (eflag_global == 0) return;
  const auto& pairs = part_->world().contacts.pairs;
  eng_vdwl += part_->energy([&](std::size_t contact) { return is_owned(pairs[contact][0]); });
}

/// Half of a contact's for each of its atoms; a wall has none, and its contact's is all the atom's.
void PairPlumbCn::share_energy() {
  const auto& pairs = part_->world().contacts.pairs;
  const std::vector<double> energies = part_->energies();
  for (std::size_t c = 0; c < pairs.size(); ++c) {
    const double share = pairs[c][1] < atom_of_body_.size() ? 0.5 : 1;
    for (const std::uint32_t body : pairs[c])
      if (is_owned(body)) eatom[atom_of_body_[body]] += share * energies[c];
  }
}

void PairPlumbCn::add_forces() const {
  const scene::State& state = part_->world().state;
  for (std::size_t k = 0; k < atom_of_body_.size(); ++k) {
    if (!is_owned(static_cast<std::uint32_t>(k))) continue;
    Eigen::Map<Vec3<double>>(atom->f[atom_of_body_[k]]) += state.force->vector(k);
    Eigen::Map<Vec3<double>>(atom->torque[atom_of_body_[k]]) += state.torque->vector(k);
  }
}

void PairPlumbCn::close() {
  const scene::State& state = part_->world().state;
  for (std::size_t k = 0; k < atom_of_body_.size(); ++k) {
    state.force->vector(k) = vector_at(atom->f[atom_of_body_[k]]);
    state.torque->vector(k) = vector_at(atom->torque[atom_of_body_[k]]);
  }
  part_->close();
  for (std::size_t k = 0; k < atom_of_body_.size(); ++k) {
    if (!is_owned(static_cast<std::uint32_t>(k)) || (atom->mask[atom_of_body_[k]] & frozen_before_) != 0) continue;
    Eigen::Map<Vec3<double>>(atom->f[atom_of_body_[k]]) = state.force->vector(k);
    Eigen::Map<Vec3<double>>(atom->torque[atom_of_body_[k]]) = state.torque->vector(k);
  }
}

/// Centre to centre, as LAMMPS has it of any pair. A wall has no centre: what it does is not in the virial.
void PairPlumbCn::tally_virial() {
  if (vflag_either == 0) return;
  const scene::Contacts& contacts = part_->world().contacts;
  for (const std::uint32_t c : contacts.touching) {
    const auto [a, b] = contacts.pairs[c];
    if (b >= atom_of_body_.size()) continue;
    const int i = atom_of_body_[a], j = atom_of_body_[b];
    const Vec3<double> force = -contacts.force->vector(c), apart = vector_at(atom->x[i]) - vector_at(atom->x[j]);
    ev_tally_xyz(i, j, atom->nlocal, 0, 0, 0, force.x(), force.y(), force.z(), apart.x(), apart.y(), apart.z());
  }
  if (force->pair != this) add_virial_to(*force->pair);
}

/// pair_style hybrid has summed its styles up before dashpots were there, and so without this.
void PairPlumbCn::add_virial_to(Pair& all) const {
  constexpr int components = 6;
  for (int k = 0; k < components && vflag_global != 0; ++k) all.virial[k] += virial[k];
  for (int i = 0; i < atom->nlocal && vflag_atom != 0; ++i)
    for (int k = 0; k < components; ++k) all.vatom[i][k] += vatom[i][k];
}

long long PairPlumbCn::failed_contacts() const {
  const long long here = part_->totals().failed;
  long long all = 0;
  MPI_Allreduce(&here, &all, 1, MPI_LONG_LONG, MPI_SUM, world);
  return all;
}

}  // namespace plumb::lammps
