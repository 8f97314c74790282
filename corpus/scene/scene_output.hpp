// What a run writes down as it goes: one file each, and one line or block a frame. Formats: corpus/formats/run.md.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "corpus/file/append_file.hpp"
#include "solver/scene/simulation.hpp"

namespace plumb::scene {

/// What is known when a run has come to its end.
struct RunEnd {
  std::string hash;                      ///< 16 hex digits
  std::map<std::string, double> shares;  ///< of the time, by owner
};

class SceneOutput {
 public:
  virtual ~SceneOutput() = default;
  SceneOutput(const SceneOutput&) = delete;
  SceneOutput& operator=(const SceneOutput&) = delete;

  virtual void frame(const Simulation& run) = 0;
  /// After each step, before its frame.
  virtual void step(const Simulation& /*run*/) {}
  virtual void end(const Simulation& /*run*/, const RunEnd& /*end*/) {}

  void flush() { file_.flush(); }
  /// In the run's folder.
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] std::uint64_t length() const { return file_.length(); }

 protected:
  SceneOutput(const std::filesystem::path& folder, std::string name, std::uint64_t length)
      : name_(std::move(name)), file_(folder / name_, length) {}
  [[nodiscard]] AppendFile& file() { return file_; }

 private:
  std::string name_;
  AppendFile file_;
};

using Outs = std::vector<std::unique_ptr<SceneOutput>>;
/// How long each file was when a checkpoint was written; one that is not there begins anew.
using Lengths = std::map<std::string, std::uint64_t>;

/// Those that the scene asks for. Throws InputFailure.
[[nodiscard]] Outs open_outputs(const Scene& scene, const Plan& plan, const std::filesystem::path& folder,
                                const Lengths& lengths);
/// The names of all there can be.
[[nodiscard]] std::vector<std::string> output_names();

// One function for each file; each in a source of its own.
using OpenedOutput = std::unique_ptr<SceneOutput>;
[[nodiscard]] OpenedOutput open_touching(const std::filesystem::path& folder, std::uint64_t length);
[[nodiscard]] OpenedOutput open_contacts(const std::filesystem::path& folder, std::uint64_t length);
[[nodiscard]] OpenedOutput open_energy(const std::filesystem::path& folder, std::uint64_t length);
[[nodiscard]] OpenedOutput open_lives(const std::filesystem::path& folder, std::uint64_t length);
[[nodiscard]] OpenedOutput open_bulk(const Scene& scene, const std::filesystem::path& folder, std::uint64_t length);
[[nodiscard]] OpenedOutput open_dump(const Scene& scene, const std::filesystem::path& folder, std::uint64_t length);
[[nodiscard]] OpenedOutput open_vtk_bodies(const std::filesystem::path& folder, std::uint64_t length);
[[nodiscard]] OpenedOutput open_vtk_contacts(const std::filesystem::path& folder, std::uint64_t length);
[[nodiscard]] OpenedOutput open_playback(const Scene& scene, const Plan& plan, const std::filesystem::path& folder,
                                         std::uint64_t length);

}  // namespace plumb::scene
