// A scene in time.
//
//   Simulation run(scene, make_plan(scene), threads);
//   while (!run.is_done()) run.step();
//
// Deterministic: the same scene gives the same bits with any number of threads. hash() is of the kept state.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "solver/scene/body/world.hpp"
#include "solver/scene/contact/lives.hpp"
#include "solver/scene/plan.hpp"

namespace plumb::scene {

/// What has been done so far.
struct Totals {
  std::int64_t solves = 0;       ///< calls of the solver
  std::int64_t evaluations = 0;  ///< of its residual
  std::int64_t failed = 0;       ///< contacts without a converged answer, cold as well as warm
  std::int64_t failed_warm = 0;  ///< contacts whose last answer was no start: solved cold
  std::int64_t lists = 0;        ///< contact lists built

  /// Adds what another part of the run took.
  Totals& operator+=(const Totals& more) {
    solves += more.solves;
    evaluations += more.evaluations;
    failed += more.failed;
    failed_warm += more.failed_warm;
    lists += more.lists;
    return *this;
  }
};

/// All that a run needs to go on: what is kept, and nothing that follows from the scene.
struct Snapshot {
  std::int64_t step = 0;
  Totals totals;
  std::vector<std::array<std::uint32_t, 2>> pairs;
  std::vector<std::pair<std::string, std::vector<double>>> columns;
};

/// One call of the solver, for who looks for hard contacts.
struct SolveNote {
  std::uint32_t contact = 0;  ///< index in the contact list
  Status status = Status::stalled;
  int iterations = 0, evaluations = 0;    ///< evaluations over all that was tried
  bool touched = false, touches = false;  ///< in the step before, and now
  bool failed_warm = false;
};

/// Bytes for each body and for each pair of the contact list, by owner.
struct Memory {
  std::size_t body = 0, pair = 0;
};
/// What a run of this plan holds.
[[nodiscard]] std::map<std::string, Memory> memory_of(const Scene& scene, const Plan& plan);

/// A run. Not copied; one thread calls it.
class Simulation {
 public:
  /// A plan of this scene; `threads` share the contacts, their list and the motion.
  Simulation(const Scene& scene, Plan plan, int threads = 1);
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// One time step.
  void step();
  /// Whether all of the plan's steps are done.
  [[nodiscard]] bool is_done() const { return step_ >= plan_.steps; }
  /// Steps done.
  [[nodiscard]] std::int64_t steps() const { return step_; }
  /// Reached, in the scene's unit.
  [[nodiscard]] double time() const { return world_->time; }

  /// The plan as given.
  [[nodiscard]] const Plan& plan() const { return plan_; }
  /// The state, columns by body and by contact.
  [[nodiscard]] const World& world() const { return *world_; }
  /// What has been done so far.
  [[nodiscard]] Totals totals() const { return totals_; }

  /// Kinetic, and what each effect stores.
  [[nodiscard]] std::map<std::string, double> energy() const;
  [[nodiscard]] Vec3<double> momentum() const;          ///< of the bodies that move
  [[nodiscard]] Vec3<double> angular_momentum() const;  ///< about the origin

  /// Of the kept state: equal for equal bits.
  [[nodiscard]] std::uint64_t hash() const;
  /// For each kept column, and "pairs" where there is a contact list.
  [[nodiscard]] std::map<std::string, std::uint64_t> hashes() const;

  /// What restore takes.
  [[nodiscard]] Snapshot snapshot() const;
  /// Why a snapshot is none of this scene and plan: its field, and the reason.
  struct Misfit {
    std::string field, reason;
  };
  /// nullopt: it fits.
  [[nodiscard]] std::optional<Misfit> misfit(const Snapshot& snapshot) const;
  /// Of this scene and plan; false, and nothing changed, when it does not fit.
  [[nodiscard]] bool restore(const Snapshot& snapshot);

  /// A body whose place or velocity is no longer a finite number: the time step is too long for the forces.
  [[nodiscard]] std::optional<std::size_t> lost_body() const;

  /// Of contacts, where the scene asks for lives: those that ended in the last step, and those that go on.
  [[nodiscard]] const std::vector<Life>& ended_lives() const { return ended_lives_; }
  /// As far as they have come.
  [[nodiscard]] std::vector<Life> lasting_lives() const;

  /// From now on `look` is called after each round of the solver, with every call in it but those that proved two bodies apart.
  void observe(std::function<void(std::span<const SolveNote>)> look);
  /// The two bodies of a contact as a case holds them; no wall.
  [[nodiscard]] Pair pair_of(std::size_t contact) const;

  /// Seconds spent in each pass so far, by owner ("solver", "broad phase", "motion", effects).
  [[nodiscard]] std::map<std::string, double> seconds() const;

 private:
  void list_passes();
  void use_pairs(std::vector<std::array<std::uint32_t, 2>> pairs);
  void update_list();
  void solve();

  Plan plan_;
  std::unique_ptr<World> world_;
  std::vector<Pass> kicks_, drifts_, forces_;
  std::function<void(std::span<const SolveNote>)> look_;
  std::vector<Life> ended_lives_;
  std::int64_t step_ = 0;
  Totals totals_;
};

}  // namespace plumb::scene
