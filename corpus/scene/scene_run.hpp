// A scene run to its end: outputs, checkpoints, recorded contacts.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "corpus/command/progress.hpp"
#include "corpus/scene/run_folder.hpp"
#include "corpus/scene/scene_output.hpp"
#include "corpus/scene/scene_record.hpp"
#include "corpus/scene/scene_report.hpp"

namespace plumb::scene {

struct RunOptions {
  std::filesystem::path out;  ///< empty: nothing is written
  bool resume = false;
  bool record = false;
  int threads = 0;              ///< 0: as many as the scene can use
  std::int64_t checkpoint = 0;  ///< steps between two; 0: about a second's, by the number of bodies
};

class SceneRun {
 public:
  /// With --resume where the checkpoint in the folder stands. Throws InputFailure.
  SceneRun(const Scene& scene, const Plan& plan, const RunOptions& options);

  /// To its end, or until Ctrl-C: the run is in its folder then, to go on from there. Throws InputFailure.
  void go();

  [[nodiscard]] const Simulation& simulation() const { return run_; }
  [[nodiscard]] Seconds seconds() const;
  /// To its last step, and everything still somewhere.
  [[nodiscard]] bool is_complete() const { return run_.is_done() && !lost_body_; }
  /// Where the run ended before its time: a body that is nowhere any more.
  [[nodiscard]] std::optional<std::size_t> lost_body() const { return lost_body_; }
  /// run.json without its key.
  [[nodiscard]] Json json() const;

 private:
  struct Written {
    RunFolder folder;
    Recorder recorder;
    Outs outputs;
  };
  class Forecast;
  void begin_in_folder();
  void go_on_from(const Checkpoint& checkpoint);
  void advance(Progress& progress);
  void write_frame();
  void write_checkpoint();
  void end();
  [[nodiscard]] bool is_frame() const;
  [[nodiscard]] std::uint64_t steps_here() const { return static_cast<std::uint64_t>(run_.steps() - begun_at_); }

  Scene scene_;
  RunOptions options_;
  Simulation run_;
  std::map<std::string, double> energy_at_start_;
  Seconds seconds_before_;
  std::unique_ptr<Written> written_;  ///< none without a folder
  std::int64_t begun_at_ = 0;         ///< step
  std::optional<std::size_t> lost_body_;
};

}  // namespace plumb::scene
