// What hunts seeded bugs in this process: an engine runs every bug that is asked for over the same cases, of which each has
// one reference, and says at which run the first finding is that the solver without a bug has not.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "corpus/case/case.hpp"
#include "reports/kills/seeded.hpp"
#include "solver/reference/reference.hpp"

namespace plumb::reports {

/// Of one bug in one sequence of runs.
struct Kill {
  std::uint64_t run = 0;  ///< the first that killed it, from 1; 0: none did
  std::string finding;    ///< in the contract's word, with the law
  bool changed = false;   ///< whether any cold answer had other bits than without the bug, or cost other work
};

/// One sequence of runs: kills[i] is of the i-th bug asked for.
struct Hunt {
  std::uint64_t runs = 0;  ///< that there were to survive
  std::vector<Kill> kills;
  std::uint64_t control_findings = 0;  ///< runs whose answer without a bug has a finding
};

/// Whom the engines hunt.
struct Quarry {
  const SeededSolver& seeded;
  std::vector<std::size_t> bugs;
  unsigned threads = 1;
  ReferenceSource source = {};
};

/// The control is not the program's own `auto`, bit for bit: nothing that follows would mean anything. what(): where.
class ControlDiffers : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// All laws on each case. `draw(i)` for i < cases, from any thread.
[[nodiscard]] Hunt hunt_cases(const Quarry& quarry, std::size_t cases, const std::function<Case(std::size_t)>& draw);

/// All laws of shapes on each pair. `draw` as above.
[[nodiscard]] Hunt hunt_shapes(const Quarry& quarry, std::size_t pairs,
                               const std::function<ConvexPair(std::size_t)>& draw);

/// A motion: its steps.
using Track = std::vector<Pair>;

/// All laws on each step, and those of paths, warm and cold. A run is a step.
[[nodiscard]] Hunt hunt_motions(const Quarry& quarry, const std::vector<Track>& tracks);

/// Evaluations and iterations over each set of pairs and over the motions, warm: a bug is killed by a sum that is above
/// `most_work` or below `least_work` times the control's, or by other work of more than `most_changed` of a hundred pairs or more: what
/// so many do otherwise is no rounding, though they may cost as much in sum. A run is a solve.
inline constexpr double least_work = 0.97, most_work = 1.01, most_changed = 0.05;
inline constexpr std::size_t many_pairs = 100;
struct WorkSet {
  std::string name;
  std::vector<Pair> pairs;
  bool is_motion = false;  ///< each solved from the answer before
};
[[nodiscard]] Hunt hunt_work(const Quarry& quarry, const std::vector<WorkSet>& sets);

/// Each pair in one of the floating-point modes that a host may be in, in turn: a bug is killed by other bits than in the standard mode,
/// or by another mode after the call. A run is a solve.
[[nodiscard]] Hunt hunt_in_modes(const Quarry& quarry, const std::vector<Pair>& pairs);

/// A libFuzzer program, a process for each bug, with the library as its solver. A run is an input. What stops it must not stop it
/// without a bug.
struct Fuzzer {
  std::filesystem::path program, library, seeds, out;
  std::uint64_t inputs = 0, seed = 1;
  bool sees_code_alone = false;  ///< without the thermometers
};
[[nodiscard]] Hunt hunt_with(const Fuzzer& fuzzer, const Quarry& quarry);

}  // namespace plumb::reports
