// pair_style plumb/cn: contacts of ellipsoids and superquadrics by `auto`, with the forces of the scene library's effects.
//
// Each process has a part of the scene (solver/scene/part.hpp): its own atoms and the ghosts that they may touch, in the order of their
// IDs. A contact across a border is solved on both sides, from the same numbers to the same bits, so that no force has to be sent and
// a run's bits are those of any number of processes.
#pragma once

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "solver/lammps/ellipsoid_bonus.hpp"
#include "solver/lammps/pair_arguments.hpp"
#include "solver/scene/part.hpp"

namespace plumb::lammps {

class FixPlumbNve;

class PairPlumbCn : public LAMMPS_NS::Pair {
 public:
  explicit PairPlumbCn(LAMMPS_NS::LAMMPS* lammps);
  PairPlumbCn(const PairPlumbCn&) = delete;
  PairPlumbCn& operator=(const PairPlumbCn&) = delete;
  ~PairPlumbCn() override;

  void compute(int eflag, int vflag) override;
  void settings(int count, char** words) override;
  void coeff(int count, char** words) override;
  void init_style() override;
  double init_one(int type1, int type2) override;

  // For fix plumb/nve, which comes after all forces but the dashpots'.

  /// Forces of bodies and dashpots, onto the atoms; those of the ghosts have been sent.
  void close();
  [[nodiscard]] bool is_ready() const { return part_ != nullptr; }
  /// Whether fix plumb/nve goes to the end of all forces by itself; else it must stand there.
  [[nodiscard]] virtual bool puts_motion_last() const { return false; }
  [[nodiscard]] bool has_closing() const { return part_->has_closing(); }
  /// Once all forces of contacts are there.
  void tally_virial();
  /// What the contacts remember, to the atoms and back; store() on all processes. remember(): the atoms are about to move between them.
  void store();
  void remember();
  void recall();
  /// Of what an atom remembers of a contact: whom it is with, and the contact's history.
  [[nodiscard]] std::size_t row_width() const { return part_->history_width() + 1; }
  /// The body that an atom of this process is, in bodies().
  [[nodiscard]] std::size_t body_of(int atom) const { return static_cast<std::size_t>(body_of_atom_[index(atom)]); }
  /// Of an atom of this process, also between two runs: principal, body axes.
  [[nodiscard]] Vec3<double> inverse_inertia(int atom) const;
  [[nodiscard]] const scene::Bodies& bodies() const { return part_->world().bodies; }
  /// Contacts whose solver did not converge, over all processes.
  [[nodiscard]] long long failed_contacts() const;

 protected:
  /// From the lowest type to the highest, of both words of pair_coeff.
  struct TypeRanges {
    std::array<int, 2> low{}, high{};
  };

  /// As a script has it.
  [[nodiscard]] virtual const char* name() const { return "plumb/cn"; }
  /// What an error says of this style.
  [[nodiscard]] std::string said(const std::string& reason) const;
  /// Of pair_coeff's words, of which the first has made room.
  [[nodiscard]] TypeRanges types_of(int count, char** words);
  /// Whether it is of a type that this style has. With pair_style hybrid others may be there.
  [[nodiscard]] bool is_body(int atom) const;
  /// In the place of what was given before; where nothing is, materials have nothing of their own and pairs are mixed.
  void give(int type1, int type2, const scene::MaterialArguments& arguments, bool has_any);

 private:
  using AtomPair = std::pair<int, int>;

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  void require(bool holds, const char* reason) const;
  [[nodiscard]] bool is_ellipsoid(int atom) const;
  void find_shapes();
  [[nodiscard]] std::vector<scene::PartMaterial> counted_materials() const;
  void make_part();
  void weigh_atoms();
  void measure_types();
  void renew();
  [[nodiscard]] bool is_bonded_apart(int kind) const;
  [[nodiscard]] std::vector<AtomPair> listed_pairs() const;
  void number_bodies(const std::vector<AtomPair>& listed);
  [[nodiscard]] scene::SceneBody body(int atom) const;
  [[nodiscard]] std::vector<std::array<std::uint32_t, 2>> contact_pairs(const std::vector<AtomPair>& listed) const;
  void refuse_two_images() const;
  void refuse_left_over_shapes() const;
  [[nodiscard]] Vec3<double> told_angular_velocity(int atom) const;
  void place_bodies();
  void add_forces() const;
  void share_energy();
  void add_virial_to(Pair& all) const;
  [[nodiscard]] bool is_fixed(int atom) const;
  void find_frozen();
  [[nodiscard]] bool is_owned(std::uint32_t body) const;
  /// The atom's ID, or for a wall -1, -2, .., less a part of 1 for each place of it before.
  [[nodiscard]] double key_of(std::uint32_t body, std::size_t place = 0) const;
  void note(std::uint32_t mine, double other, std::span<const double> row);
  void ask_ghosts();
  /// Which of a pair's contacts it is.
  [[nodiscard]] std::size_t place_of(std::size_t contact) const;

  scene::PairArguments arguments_;
  std::vector<scene::Material> materials_;  ///< of the types, in their order; none: all are of one
  std::vector<scene::MaterialPair> material_pairs_;
  std::unique_ptr<scene::Part> part_;
  FixPlumbNve* motion_ = nullptr;
  EllipsoidBonus shapes_;
  int n1_ = -1, n2_ = -1, density_ = -1;  ///< which of the atoms' custom vectors
  int frozen_ = 0;                        ///< the groups that a fix freeze makes fixed bodies
  int frozen_before_ = 0;                 ///< those of them whose forces were replaced before dashpots add theirs
  std::vector<double> radius_;            ///< of each type, from 1
  std::vector<int> atom_of_body_, body_of_atom_;
  bool is_stale_ = true, has_warned_ = false;
};

}  // namespace plumb::lammps
