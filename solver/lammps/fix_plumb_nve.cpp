#include "solver/lammps/fix_plumb_nve.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <optional>
#include <span>
#include <sstream>

#include "solver/lammps/refusals.hpp"
#include "solver/scene/body/mass.hpp"
#include "solver/scene/body/rotation.hpp"

namespace plumb::lammps {
namespace {

using VectorOfAtom = Eigen::Map<Vec3<double>>;

/// Force and torque.
constexpr int sent_of_ghosts = 6;

/// The names of its pair styles, as LAMMPS looks for them.
constexpr const char* of_plumb = "^plumb/";

/// In the place of an atom's ID before what it remembers: it has remembered nothing yet.
constexpr double new_atom = 0;

/// Which fixes act at a place of a step, in their order.
struct OrderOf : LAMMPS_NS::Modify {
  static std::span<int> before_exchange(LAMMPS_NS::Modify& modify) {
    return {modify.*(&OrderOf::list_pre_exchange), static_cast<std::size_t>(modify.n_pre_exchange)};
  }
  static std::span<int> after_forces(LAMMPS_NS::Modify& modify) {
    return {modify.*(&OrderOf::list_post_force), static_cast<std::size_t>(modify.n_post_force)};
  }
};

/// Where the next one is.
std::size_t erase_row(std::vector<double>& memory, std::size_t at, std::size_t width) {
  const auto first = memory.begin() + static_cast<std::ptrdiff_t>(at);
  memory.erase(first, first + static_cast<std::ptrdiff_t>(width));
  return at;
}

/// Sorted.
std::vector<double> of_all_processes(const std::vector<double>& here, MPI_Comm processes) {
  int size = 0, count = static_cast<int>(here.size()), sum = 0;
  MPI_Comm_size(processes, &size);
  std::vector<int> counts(static_cast<std::size_t>(size)), starts(counts.size());
  MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, processes);
  for (std::size_t k = 0; k < counts.size(); sum += counts[k++]) starts[k] = sum;
  std::vector<double> all(static_cast<std::size_t>(sum));
  if (sum > 0)
    MPI_Allgatherv(here.data(), count, MPI_DOUBLE, all.data(), counts.data(), starts.data(), MPI_DOUBLE, processes);
  std::ranges::sort(all);
  return all;
}

}  // namespace

double Clock::at(LAMMPS_NS::bigint step, double length_now) {
  if (step < last) *this = {};
  if (length_now != length) {
    time_at_origin += static_cast<double>(last - origin) * length;
    origin = last;
    length = length_now;
  }
  last = step;
  return time_at_origin + static_cast<double>(step - origin) * length;
}

FixPlumbNve::FixPlumbNve(LAMMPS_NS::LAMMPS* lammps, int count, char** words) : Fix(lammps, count, words) {
  try {
    new_bodies_ = parse_new_bodies(std::span(words, static_cast<std::size_t>(count)).subspan(3), atom->ntypes);
  } catch (const scene::SceneError& refusal) {
    error->all(FLERR, fmt::format("fix plumb/nve: {}: {}", refusal.field, refusal.what()));
  }
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
  pair_ = dynamic_cast<PairPlumbCn*>(force->pair_match(of_plumb, 0));
  if (pair_ == nullptr)
    error->all(FLERR, std::string("fix plumb/nve: needs pair_style plumb/cn or plumb/superellipsoid, one of them"));
  comm_forward = std::max(sent_of_ghosts, static_cast<int>(pair_->row_width()));
  if (!pair_->puts_motion_last()) refuse_order();
}

void FixPlumbNve::refuse_order() const {
  bool is_behind = false;
  for (int k = 0; k < modify->nfix; ++k) {
    const LAMMPS_NS::Fix& fix = *modify->fix[k];
    if (is_behind && (modify->fmask[k] & LAMMPS_NS::FixConst::POST_FORCE) != 0 && !replaces_forces(fix.style))
      error->all(FLERR, fmt::format("fix plumb/nve: must stand after fix {}: dashpots go by all other forces", fix.id));
    is_behind = is_behind || &fix == this;
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
  has_closed_ = true;
  if (pair_->has_closing()) {
    comm->forward_comm_fix(this);
    pair_->close();
  }
  pair_->tally_virial();
}

/// A run that goes on computes the forces of its last step again: what contacts remember stays as it was.
void FixPlumbNve::setup(int vflag) {
  const bool goes_on = has_closed_;
  post_force(vflag);
  if (goes_on) pair_->recall();
}

/// Fixes that move, make or delete atoms, as they do then, come after what takes contacts from where atoms are.
void FixPlumbNve::setup_pre_exchange() {
  const auto is_self = [&](int k) { return modify->fix[k] == this; };
  const auto order = OrderOf::before_exchange(*modify);
  const auto self = std::ranges::find_if(order, is_self);
  std::rotate(order.begin(), self, self + 1);
  if (!pair_->puts_motion_last()) return;
  // To the end of what adds forces: up to what replaces them, or tells them.
  const auto forces = OrderOf::after_forces(*modify);
  const auto motion = std::ranges::find_if(forces, is_self);
  const auto stop = std::find_if(motion + 1, forces.end(), [&](int k) {
    const std::string_view style = modify->fix[k]->style;
    return replaces_forces(style) || style == "store/force";
  });
  std::rotate(motion, motion + 1, stop);
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
  return energy_of_turning(groupbit);
}

double FixPlumbNve::energy_of_turning(int groups) const {
  if (pair_ == nullptr || force->pair_match(of_plumb, 0) != pair_ || !pair_->is_ready())
    error->all(FLERR, fmt::format("fix plumb/nve: f_{} is there once a run was prepared", id));
  const EllipsoidBonus shapes(*atom);
  double here = 0, all = 0;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!moves(i) || (atom->mask[i] & groups) == 0) continue;
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
  memory_of(i) = {new_atom};
  const auto body = std::ranges::find(new_bodies_, atom->type[i], &NewBody::type);
  if (body != new_bodies_.end() && atom->ellipsoid[i] < 0) give_shape(i, *body);
}

void FixPlumbNve::give_shape(int i, const NewBody& body) const {
  const EllipsoidBonus shapes(*atom);
  shapes.set_semi_axes(i, body.shape.semi_axes);
  shapes.set_quaternion(i, orientation_drawn_at(atom->x[i]));
  atom->rmass[i] = body.density * scene::mass_properties(body.shape).volume;
  for (const auto& [name, value] :
       {std::pair("n1", body.shape.n1), std::pair("n2", body.shape.n2), std::pair("density", body.density)})
    if (const int at = vector_of(*atom, name); at >= 0) atom->dvector[at][i] = value;
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

void FixPlumbNve::share(std::vector<std::vector<double>>& rows, std::size_t width) {
  std::size_t most = 0, here = 0;
  for (const auto& row : rows) here = std::max(here, row.size());
  MPI_Allreduce(&here, &most, 1, MPI_UNSIGNED_LONG, MPI_MAX, world);
  for (std::size_t begin = 0; begin < most; begin += width) {
    sharing_ = {&rows, width, begin};
    comm->forward_comm_fix(this, static_cast<int>(width));
  }
  sharing_ = {};
}

/// Its row of this round, or zeros.
double* FixPlumbNve::pack_shared(int i, double* out) const {
  const std::vector<double>& rows = (*sharing_.rows)[static_cast<std::size_t>(i)];
  if (rows.size() <= sharing_.begin) return std::fill_n(out, sharing_.width, 0.0);
  return std::copy_n(rows.begin() + static_cast<std::ptrdiff_t>(sharing_.begin), sharing_.width, out);
}

int FixPlumbNve::pack_forward_comm(int count, int* list, double* out, int /*pbc_flag*/, int* /*pbc*/) {
  double* next = out;
  for (int k = 0; k < count; ++k) {
    if (sharing_.rows != nullptr) {
      next = pack_shared(list[k], next);
      continue;
    }
    next = std::copy_n(atom->f[list[k]], 3, next);
    next = std::copy_n(atom->torque[list[k]], 3, next);
  }
  return static_cast<int>(next - out);
}

void FixPlumbNve::unpack_forward_comm(int count, int first, double* in) {
  for (int i = first; sharing_.rows != nullptr && i < first + count; ++i, in += sharing_.width) {
    std::vector<double>& rows = (*sharing_.rows)[static_cast<std::size_t>(i)];
    if (in[0] != 0) rows.insert(rows.end(), in, in + sharing_.width);
  }
  if (sharing_.rows != nullptr) return;
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

/// On every process, before what the atoms have is asked for: a run that goes on has what its contacts remember elsewhere.
void FixPlumbNve::write_restart(FILE* file) {
  pair_->store();
  if (comm->me != 0) return;
  const std::string text = names_ + "\n" + fmt::format("{}", fmt::join(walls_, " "));
  const int size = static_cast<int>(sizeof has_closed_ + sizeof clock_ + text.size() + 1);
  fwrite(&size, sizeof size, 1, file);
  fwrite(&has_closed_, sizeof has_closed_, 1, file);
  fwrite(&clock_, sizeof clock_, 1, file);
  fwrite(text.data(), 1, text.size() + 1, file);
}

void FixPlumbNve::restart(char* in) {
  std::memcpy(&has_closed_, in, sizeof has_closed_);
  std::memcpy(&clock_, in + sizeof has_closed_, sizeof clock_);
  std::istringstream text(in + sizeof has_closed_ + sizeof clock_);
  std::getline(text, names_);
  walls_.assign(std::istream_iterator<std::string>(text), {});
}

int FixPlumbNve::size_restart(int i) {
  return static_cast<int>(memory_of(i).size()) + 1;
}

/// LAMMPS asks all processes, and writes what the first says for all atoms.
int FixPlumbNve::maxsize_restart() {
  const int here = most_packed();
  int all = 0;
  MPI_Allreduce(&here, &all, 1, MPI_INT, MPI_MAX, world);
  return all;
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

void FixPlumbNve::keep_only(const std::string& names, const std::vector<std::string>& walls, std::size_t row_width) {
  if (names_ != names) forget_all();
  names_ = names;
  if (walls_ == walls) return;
  std::vector<std::optional<double>> shift;  // of the keys of each wall that was; none: it is gone
  for (std::size_t k = 0; k < walls_.size(); ++k) {
    const auto found = std::ranges::find(walls, walls_[k]);
    if (found == walls.end())
      shift.emplace_back();
    else
      shift.emplace_back(static_cast<double>(k) - static_cast<double>(found - walls.begin()));
  }
  for (auto& memory : memories_)
    for (std::size_t at = 1; at < memory.size();) {
      const auto of_wall = memory[at] < 0 ? shift.at(static_cast<std::size_t>(-memory[at] - 1)) : 0.0;
      if (of_wall) memory[at] += *of_wall;
      at = of_wall ? at + row_width : erase_row(memory, at, row_width);
    }
  walls_ = walls;
}

void FixPlumbNve::forget_new_atoms(std::size_t row_width) {
  std::vector<double> here;
  for (int i = 0; i < atom->nlocal; ++i)
    if (memory_of(i) == std::vector{new_atom}) {
      here.push_back(static_cast<double>(atom->tag[i]));
      memory_of(i).clear();
    }
  const std::vector<double> all = of_all_processes(here, world);
  if (all.empty()) return;
  for (auto& memory : memories_)
    for (std::size_t at = 1; at < memory.size();)
      at = std::ranges::binary_search(all, memory[at]) ? erase_row(memory, at, row_width) : at + row_width;
}

}  // namespace plumb::lammps
