#include "corpus/scene/scene_run.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "corpus/case/case.hpp"
#include "corpus/command/build_info.hpp"
#include "corpus/command/interrupt.hpp"
#include "corpus/scene/scene_view.hpp"

namespace plumb::scene {
namespace {

/// Below so many bodies threads wait for each other longer than they work.
constexpr std::size_t few_bodies = 1000;

int threads_for(const Scene& scene, int asked) {
  if (asked > 0) return asked;
  return scene.bodies.size() < few_bodies ? 1 : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

/// By counting and not by the clock, so that the same run writes the same checkpoints.
std::int64_t steps_between_checkpoints(const Scene& scene, std::int64_t asked) {
  if (asked > 0) return asked;
  return std::clamp<std::int64_t>(400'000 / static_cast<std::int64_t>(scene.bodies.size()), 20, 100'000);
}

Json hashes_json(const Simulation& run) {
  Json out = Json::object();
  for (const auto& [name, hash] : run.hashes()) out[name] = hash_text(hash);
  return out;
}

Json totals_json(const Simulation& run) {
  const Totals totals = run.totals();
  return {{"steps", run.steps()},    {"time", run.time()},
          {"solves", totals.solves}, {"evaluations", totals.evaluations},
          {"failed", totals.failed}, {"failed_warm", totals.failed_warm},
          {"lists", totals.lists}};
}

}  // namespace

SceneRun::SceneRun(const Scene& scene, const Plan& plan, const RunOptions& options)
    : scene_(scene), options_(options), run_(scene, plan, threads_for(scene, options.threads)),
      energy_at_start_(energies_of(run_)) {
  options_.checkpoint = steps_between_checkpoints(scene, options.checkpoint);
  if (!options_.out.empty()) begin_in_folder();
}

void SceneRun::begin_in_folder() {
  RunFolder folder(options_.out, run_key(scene_, run_.plan()), options_.resume);
  const std::optional<Checkpoint> checkpoint = folder.checkpoint();
  const auto looks = options_.record ? Recorder::Looks::for_hard : Recorder::Looks::for_failures;
  written_.reset(new Written{std::move(folder), Recorder(scene_, run_, looks), {}});
  if (checkpoint) go_on_from(*checkpoint);
  if (!checkpoint)
    written_->folder.write_run(json());  // the restored state has no contacts yet, and what stands there has
  written_->folder.write_scene(scene_);
  const std::filesystem::path& path = written_->folder.path();
  written_->outputs = open_outputs(scene_, run_.plan(), path, checkpoint ? checkpoint->lengths : Lengths{});
}

void SceneRun::go_on_from(const Checkpoint& checkpoint) {
  const std::string file = (options_.out / "checkpoint.bin").string();
  if (const auto misfit = run_.misfit(checkpoint.snapshot))
    throw InputFailure(file, 0, "snapshot." + misfit->field, misfit->reason);
  if (!run_.restore(checkpoint.snapshot)) throw InputFailure(file, 0, "snapshot", "does not fit the scene");
  try {
    written_->recorder.restore(checkpoint.record);
  } catch (const FieldError& error) {
    throw InputFailure(file, 0, error.field, error.what());
  }
  seconds_before_ = checkpoint.seconds;
  begun_at_ = run_.steps();
}

Seconds SceneRun::seconds() const {
  Seconds out = run_.seconds();
  for (const auto& [owner, spent] : seconds_before_) out[owner] += spent;
  return out;
}

bool SceneRun::is_frame() const {
  const std::int64_t every = run_.plan().steps_per_output;
  return run_.is_done() || (every > 0 && run_.steps() % every == 0);
}

void SceneRun::write_frame() {
  if (written_ == nullptr) return;
  for (const auto& output : written_->outputs) {
    output->frame(run_);
    output->flush();
  }
}

void SceneRun::write_checkpoint() {
  if (written_ == nullptr) return;
  Checkpoint out{0, run_.snapshot(), {}, seconds(), written_->recorder.state()};
  for (const auto& output : written_->outputs) output->flush();
  for (const auto& output : written_->outputs) out.lengths[output->name()] = output->length();
  written_->folder.write_checkpoint(std::move(out));
}

/// Once, after the first second, what the run takes at the speed so far: of a long one, and where no bar stands.
class SceneRun::Forecast {
 public:
  void show(std::int64_t done, std::int64_t left) {
    if (is_told_ || elapsed() < first_look) return;
    is_told_ = true;
    const double expected = elapsed() / static_cast<double>(done) * static_cast<double>(left);
    if (expected >= worth_telling)
      fmt::print(stderr, "{} steps to go: {} at the speed of the first {}\n", left, time_text(expected), done);
  }

 private:
  static constexpr double first_look = 1, worth_telling = 60;  // seconds
  using Clock = std::chrono::steady_clock;
  [[nodiscard]] double elapsed() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

  Clock::time_point start_ = Clock::now();
  bool is_told_ = isatty(STDERR_FILENO) != 0;
};

void SceneRun::advance(Progress& progress) {
  Forecast forecast;
  while (!run_.is_done()) {
    run_.step();
    lost_body_ = run_.lost_body();
    if (written_ != nullptr)
      for (const auto& output : written_->outputs) output->step(run_);
    if (lost_body_) break;
    if (is_frame()) write_frame();
    if (run_.is_done()) break;
    if (run_.steps() % options_.checkpoint == 0 || interrupted()) write_checkpoint();
    if (interrupted()) break;
    forecast.show(run_.steps() - begun_at_, run_.plan().steps - run_.steps());
    if (progress.is_due()) progress.show(steps_here(), fmt::format("  time {:.6g}", run_.time()));
  }
}

void SceneRun::go() {
  if (begun_at_ == 0) write_frame();
  if (!run_.is_done()) {
    Progress progress("steps", static_cast<std::uint64_t>(run_.plan().steps - begun_at_), Progress::Elsewhere::nothing);
    advance(progress);
    progress.finish(steps_here(), fmt::format("  time {:.6g}", run_.time()));
  }
  end();
}

void SceneRun::end() {
  if (written_ == nullptr) return;
  const RunEnd end{hash_text(run_.hash()), shares_of(seconds())};
  for (const auto& output : written_->outputs) {
    if (is_complete()) output->end(run_, end);
    output->flush();
  }
  written_->recorder.write(options_.out);
  written_->folder.write_run(json());
}

Json SceneRun::json() const {
  const Seconds spent = seconds();
  double sum = 0;
  for (const auto& [owner, seconds] : spent) sum += seconds;
  return {{"format", "plumb/run-1"},
          {"scene", scene_.name},
          {"complete", is_complete()},
          {"accuracy", scene_.run.accuracy},
          {"plan", plan_json(scene_, run_.plan(), spent)},
          {"totals", totals_json(run_)},
          {"hash", hash_text(run_.hash())},
          {"hashes", hashes_json(run_)},
          {"energy", {{"first", energy_at_start_}, {"last", energies_of(run_)}}},
          {"timing", {{"seconds", sum}, {"by_owner", spent}}},
          {"host", host_json()}};
}

}  // namespace plumb::scene
