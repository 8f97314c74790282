// fix plumb/nve: the scene library's leapfrog, with the moments of inertia of superquadrics. The atoms of its group move, all others are
// fixed bodies. It also carries what contacts remember from process to process, and ends the forces of each step (pair_plumb_cn.hpp).
#pragma once

#include <vector>

#include "solver/lammps/pair_plumb_cn.hpp"

namespace plumb::lammps {

class FixPlumbNve : public LAMMPS_NS::Fix {
 public:
  FixPlumbNve(LAMMPS_NS::LAMMPS* lammps, int count, char** words);
  FixPlumbNve(const FixPlumbNve&) = delete;
  FixPlumbNve& operator=(const FixPlumbNve&) = delete;
  ~FixPlumbNve() override;

  int setmask() override;
  void init() override;
  void setup(int vflag) override;
  void initial_integrate(int vflag) override;
  void post_force(int vflag) override;
  void final_integrate() override;
  void pre_exchange() override;
  void post_run() override;
  /// Kinetic energy of turning, of all atoms that move.
  double compute_scalar() override;

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
  /// Forgets what is not of these names.
  void keep_only(const std::string& names);

 private:
  void kick();
  [[nodiscard]] bool moves(int atom) const;
  /// What pack_exchange() wrote, to an atom; how many numbers it took.
  int take(int atom, const double* in);
  [[nodiscard]] int most_packed() const;

  PairPlumbCn* pair_ = nullptr;
  std::vector<std::vector<double>> memories_;
  std::string names_;
  LAMMPS_NS::bigint closed_at_ = -1;  ///< step
};

}  // namespace plumb::lammps
