#include "solver/lammps/fix_plumb_nve.hpp"

#include <algorithm>
#include <cstring>

#include "solver/scene/body/rotation.hpp"

namespace plumb::lammps {
namespace {

using VectorOfAtom = Eigen::Map<Vec3<double>>;

/// Force and torque.
constexpr int sent_of_ghosts = 6;

}  // namespace

FixPlumbNve::FixPlumbNve(LAMMPS_NS::LAMMPS* lammps, int count, char** words) : Fix(lammps, count, words) {
  if (count != 3) error->all(FLERR, std::string("fix plumb/nve: takes no arguments"));
  time_integrate = 1;
  create_attribute = 1;
  restart_global = restart_peratom = 1;
  maxexchange_dynamic = 1;
  comm_forward = sent_of_ghosts;
  scalar_flag = extscalar = global_freq = 1;
  FixPlumbNve::grow_arrays(atom->nmax);
  for (const int event : {LAMMPS_NS::Atom::GROW, LAMMPS_NS::Atom::RESTART}) atom->add_callback(event);
}

FixPlumbNve::~FixPlumbNve() {
  for (const int event : {LAMMPS_NS::Atom::GROW, LAMMPS_NS::Atom::RESTART}) atom->delete_callback(id, event);
}

int FixPlumbNve::setmask() {
  using namespace LAMMPS_NS::FixConst;
  return INITIAL_INTEGRATE | PRE_EXCHANGE | POST_FORCE | FINAL_INTEGRATE;
}

void FixPlumbNve::init() {
  pair_ = dynamic_cast<PairPlumbCn*>(force->pair_match("plumb/cn", 1));
  if (pair_ == nullptr) error->all(FLERR, std::string("fix plumb/nve: needs pair_style plumb/cn"));
  bool is_behind = false;
  for (int k = 0; k < modify->nfix; ++k) {
    if (is_behind && (modify->fmask[k] & LAMMPS_NS::FixConst::POST_FORCE) != 0)
      error->all(FLERR, fmt::format("fix plumb/nve: must stand after fix {}: dashpots go by all other forces",
                                    modify->fix[k]->id));
    is_behind = is_behind || modify->fix[k] == this;
  }
}

bool FixPlumbNve::moves(int i) const {
  return (atom->mask[i] & groupbit) != 0;
}

void FixPlumbNve::kick() {
  const double half = update->dt / 2;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!moves(i)) continue;
    const double inverse_mass = pair_->bodies().inverse_mass[pair_->body_of(i)];
    VectorOfAtom(atom->v[i]) += half * inverse_mass * VectorOfAtom(atom->f[i]);
    VectorOfAtom(atom->angmom[i]) += half * VectorOfAtom(atom->torque[i]);
  }
}

void FixPlumbNve::initial_integrate(int /*vflag*/) {
  kick();
  const EllipsoidBonus shapes(*atom);
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!moves(i)) continue;
    VectorOfAtom(atom->x[i]) += update->dt * VectorOfAtom(atom->v[i]);
    const auto [w, x, y, z] = shapes.quaternion(i);
    const Vec3<double>& inverse_inertia = pair_->bodies().inverse_inertia[pair_->body_of(i)];
    const Eigen::Quaterniond q =
        scene::rotated({w, x, y, z}, VectorOfAtom(atom->angmom[i]), inverse_inertia, update->dt);
    shapes.set_quaternion(i, {q.w(), q.x(), q.y(), q.z()});
  }
}

void FixPlumbNve::final_integrate() {
  kick();
}

void FixPlumbNve::post_force(int /*vflag*/) {
  closed_at_ = update->ntimestep;
  if (pair_->has_closing()) {
    comm->forward_comm_fix(this);
    pair_->close();
  }
  pair_->tally_virial();
}

/// A run that goes on computes the forces of its last step again: what contacts remember stays as it was.
void FixPlumbNve::setup(int vflag) {
  const bool goes_on = closed_at_ == update->ntimestep;
  post_force(vflag);
  if (goes_on) pair_->recall();
}

void FixPlumbNve::pre_exchange() {
  pair_->remember();
  maxexchange = most_packed();
}

void FixPlumbNve::post_run() {
  pre_exchange();
  const long long failed = pair_->failed_contacts();
  if (failed > 0 && comm->me == 0)
    error->warning(FLERR, fmt::format("plumb/cn: {} solves of contacts did not converge, cold or warm", failed));
}

double FixPlumbNve::compute_scalar() {
  if (pair_ == nullptr) error->all(FLERR, fmt::format("fix plumb/nve: f_{} is there once a run was prepared", id));
  const EllipsoidBonus shapes(*atom);
  double here = 0, all = 0;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!moves(i)) continue;
    const auto [w, x, y, z] = shapes.quaternion(i);
    const Vec3<double> own = Eigen::Quaterniond(w, x, y, z).conjugate() * VectorOfAtom(atom->angmom[i]);
    here += own.cwiseAbs2().dot(pair_->inverse_inertia(i)) / 2;
  }
  MPI_Allreduce(&here, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

void FixPlumbNve::grow_arrays(int atoms) {
  memories_.resize(static_cast<std::size_t>(atoms));
}

void FixPlumbNve::copy_arrays(int from, int to, int /*delflag*/) {
  memory_of(to) = memory_of(from);
}

void FixPlumbNve::set_arrays(int i) {
  memory_of(i).clear();
}

// For other processes and for restart files an atom has how many numbers there are, this one too, and then these.

int FixPlumbNve::pack_exchange(int i, double* out) {
  const std::vector<double>& memory = memory_of(i);
  out[0] = static_cast<double>(memory.size() + 1);
  std::ranges::copy(memory, out + 1);
  return static_cast<int>(memory.size()) + 1;
}

int FixPlumbNve::unpack_exchange(int i, double* in) {
  return take(i, in);
}

int FixPlumbNve::take(int i, const double* in) {
  const int size = static_cast<int>(in[0]);
  memory_of(i).assign(in + 1, in + size);
  return size;
}

int FixPlumbNve::pack_forward_comm(int count, int* list, double* out, int /*pbc_flag*/, int* /*pbc*/) {
  double* next = out;
  for (int k = 0; k < count; ++k) {
    next = std::copy_n(atom->f[list[k]], 3, next);
    next = std::copy_n(atom->torque[list[k]], 3, next);
  }
  return static_cast<int>(next - out);
}

void FixPlumbNve::unpack_forward_comm(int count, int first, double* in) {
  for (int i = first; i < first + count; ++i, in += sent_of_ghosts) {
    std::copy_n(in, 3, atom->f[i]);
    std::copy_n(in + 3, 3, atom->torque[i]);
  }
}

int FixPlumbNve::most_packed() const {
  std::size_t longest = 0;
  for (int i = 0; i < atom->nlocal; ++i) longest = std::max(longest, memories_[static_cast<std::size_t>(i)].size());
  return static_cast<int>(longest) + 1;
}

void FixPlumbNve::write_restart(FILE* file) {
  if (comm->me != 0) return;
  const int size = static_cast<int>(sizeof closed_at_ + names_.size() + 1);
  fwrite(&size, sizeof size, 1, file);
  fwrite(&closed_at_, sizeof closed_at_, 1, file);
  fwrite(names_.data(), 1, names_.size() + 1, file);
}

void FixPlumbNve::restart(char* in) {
  std::memcpy(&closed_at_, in, sizeof closed_at_);
  names_ = in + sizeof closed_at_;
}

/// The first that LAMMPS asks for, on every process: a run that writes while it goes on has what its contacts remember elsewhere.
int FixPlumbNve::size_restart(int i) {
  if (i == 0) pair_->store();
  return static_cast<int>(memory_of(i).size()) + 1;
}

int FixPlumbNve::maxsize_restart() {
  return most_packed();
}

int FixPlumbNve::pack_restart(int i, double* out) {
  return pack_exchange(i, out);
}

void FixPlumbNve::unpack_restart(int i, int place) {
  const double* in = atom->extra[i];
  for (; place > 0; --place) in += static_cast<int>(*in);
  maxexchange = std::max(maxexchange, take(i, in));
}

double FixPlumbNve::memory_usage() {
  std::size_t bytes = 0;
  for (const auto& memory : memories_) bytes += sizeof(memory) + memory.capacity() * sizeof(double);
  return static_cast<double>(bytes);
}

void FixPlumbNve::forget_all() {
  for (auto& memory : memories_) memory.clear();
}

void FixPlumbNve::keep_only(const std::string& names) {
  if (names_ != names) forget_all();
  names_ = names;
}

}  // namespace plumb::lammps
