// fix plumb/nve: the scene library's leapfrog, with the moments of inertia of superquadrics. The atoms of its group move, all others are
// fixed bodies. It also carries what contacts remember from process to process, and ends the forces of each step (pair_plumb_cn.hpp).
#pragma once

#include <vector>

#include "solver/lammps/new_bodies.hpp"
#include "solver/lammps/pair_plumb_cn.hpp"

namespace plumb::lammps {

/// Simulated time, whose steps may change their length.
struct Clock {
  LAMMPS_NS::bigint origin = 0, last = 0;  ///< steps
  double time_at_origin = 0, length = 0;   ///< length: of the steps since the origin

  /// At a step to which steps of that length have led from the last that was asked for.
  [[nodiscard]] double at(LAMMPS_NS::bigint step, double length_now);
};

class FixPlumbNve : public LAMMPS_NS::Fix {
 public:
  FixPlumbNve(LAMMPS_NS::LAMMPS* lammps, int count, char** words);
  FixPlumbNve(const FixPlumbNve&) = delete;
  FixPlumbNve& operator=(const FixPlumbNve&) = delete;
  ~FixPlumbNve() override;

  int setmask() override;
  void init() override;
  void setup_pre_exchange() override;
  void setup(int vflag) override;
  void initial_integrate(int vflag) override;
  void post_force(int vflag) override;
  void final_integrate() override;
  void pre_exchange() override;
  void post_run() override;
  /// Kinetic energy of turning, of all atoms that move.
  double compute_scalar() override;
  /// Of those of them in these groups; on all processes.
  [[nodiscard]] double energy_of_turning(int groups) const;

  void grow_arrays(int atoms) override;
  void copy_arrays(int from, int to, int delflag) override;
  void set_arrays(int atom) override;
  int pack_exchange(int atom, double* out) override;
  int unpack_exchange(int atom, double* in) override;
  int pack_forward_comm(int count, int* list, double* out, int pbc_flag, int* pbc) override;
  void unpack_forward_comm(int count, int first, double* in) override;
  /// Restart files: the names of what contacts remember and when, and each atom's.
  void write_restart(FILE* file) override;
  void restart(char* in) override;
  int pack_restart(int atom, double* out) override;
  void unpack_restart(int atom, int place) override;
  int size_restart(int atom) override;
  int maxsize_restart() override;
  double memory_usage() override;

  /// Of each contact of an atom of this process: with whom, and its history.
  [[nodiscard]] std::vector<double>& memory_of(int atom) { return memories_[static_cast<std::size_t>(atom)]; }
  void forget_all();
  /// Rows of atoms, each of so many numbers and none beginning with 0, to their ghosts, which have none before.
  void share(std::vector<std::vector<double>>& rows, std::size_t width);
  /// Forgets what is not of these names, or at walls that are not of these IDs, by whose order walls are known.
  void keep_only(const std::string& names, const std::vector<std::string>& walls, std::size_t row_width);
  /// An ID may have been that of an atom which was deleted: forgets what others remember of atoms that are new. On all processes.
  void forget_new_atoms(std::size_t row_width);
  [[nodiscard]] const std::vector<NewBody>& new_bodies() const { return new_bodies_; }
  [[nodiscard]] double time() { return clock_.at(update->ntimestep, update->dt); }

 private:
  void kick();
  [[nodiscard]] bool moves(int atom) const;
  /// What pack_exchange() wrote, to an atom; how many numbers it took.
  int take(int atom, const double* in);
  [[nodiscard]] int most_packed() const;
  void refuse_order() const;
  void give_shape(int atom, const NewBody& body) const;
  [[nodiscard]] double* pack_shared(int atom, double* out) const;

  /// While share() runs; no rows else.
  struct Sharing {
    std::vector<std::vector<double>>* rows = nullptr;
    std::size_t width = 0, begin = 0;
  };

  PairPlumbCn* pair_ = nullptr;
  std::vector<NewBody> new_bodies_;
  std::vector<std::vector<double>> memories_;
  std::string names_;
  std::vector<std::string> walls_;
  Clock clock_;
  bool has_closed_ = false;  ///< whether forces of a step are there, from which a run goes on
  Sharing sharing_;
};

}  // namespace plumb::lammps
