// Contacts of a run that are worth a case: those that no solve answered, always, and the hard ones where that is asked for. One
// for each bucket (reason, shapes, decade of the measure), the worst of it; ready for cases/.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "corpus/case/case.hpp"
#include "solver/scene/simulation.hpp"

namespace plumb::scene {

class Recorder {
 public:
  enum class Looks { for_failures, for_hard };

  /// Looks at the contacts as they stand, and from then on after each round of the solver. Both outlive it.
  Recorder(const Scene& scene, Simulation& run, Looks looks);
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// One round of the solver.
  void look(std::span<const SolveNote> notes);

  /// For a checkpoint, and back: what it looked at before is forgotten.
  [[nodiscard]] std::string state() const;
  /// Throws FieldError.
  void restore(const std::string& state);

  /// FOLDER/failures/ and FOLDER/cases/, a file a bucket. Throws InputFailure.
  void write(const std::filesystem::path& folder) const;

 private:
  struct Kept {
    double measure = 0;
    Case c;
  };
  using Buckets = std::map<std::string, Kept>;
  using PairOfBodies = std::pair<std::uint32_t, std::uint32_t>;

  void look_at_start();
  void look_for_hard(std::span<const SolveNote> notes);
  void look_at_condition(const SolveNote& note);
  void look_at_change(const SolveNote& note);
  void keep(Buckets& buckets, const SolveNote& note, const char* reason, double measure);
  [[nodiscard]] Case case_of(const SolveNote& note, const std::string& name, const char* reason, double measure) const;

  std::string scene_;
  Simulation& run_;
  Looks looks_;
  Buckets failures_, cases_;
  std::map<PairOfBodies, int> changes_;  ///< how often two bodies began or ceased to touch
};

}  // namespace plumb::scene
