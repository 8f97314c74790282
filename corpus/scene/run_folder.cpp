#include "corpus/scene/run_folder.hpp"

#include "corpus/case/case.hpp"
#include "corpus/file/output_file.hpp"
#include "corpus/file/text_input.hpp"
#include "corpus/json/fields.hpp"
#include "corpus/scene/scene_file.hpp"
#include "corpus/scene/scene_output.hpp"
#include "corpus/scene/scene_report.hpp"
#include "corpus/scene/scene_view.hpp"

namespace plumb::scene {
namespace {

namespace fs = std::filesystem;

constexpr const char* run_file = "run.json";
constexpr const char* scene_file = "scene.json";
constexpr const char* checkpoint_file = "checkpoint.bin";

/// What a run writes, files and folders.
std::vector<std::string> written_names() {
  std::vector<std::string> out = output_names();
  out.insert(out.end(), {scene_file, checkpoint_file, "vtk", "failures", "cases"});
  return out;
}

std::string key_in(const fs::path& path) {
  const std::string text = read_text(path);
  try {
    const Json tree = read_json(text);
    return Field(tree).member("key").text();
  } catch (const FieldError& error) {
    throw InputFailure(path.string(), 0, error.field, std::string(error.what()) + ": is no run of plumb");
  }
}

/// Of writes that were cut off.
void remove_temporaries(const fs::path& folder) {
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    const std::string name = finished_name(entry);
    if (name == entry.path().filename()) continue;
    if (name == run_file || name == scene_file || name == checkpoint_file) fs::remove(entry.path(), none);
  }
}

/// A run goes on from its checkpoint, and writes its cases at its end.
void remove_cases(const fs::path& folder) {
  std::error_code none;
  for (const char* name : {"failures", "cases"})
    for (const auto& entry : fs::directory_iterator(folder / name, none))
      if (entry.path().extension() == ".json" || entry.path().extension() == ".tmp") fs::remove(entry.path(), none);
}

/// With its triangles in the place of the files that they came from.
std::string whole_text(Scene scene) {
  for (Wall& wall : scene.walls)
    if (auto* mesh = std::get_if<MeshWall>(&wall.shape)) mesh->file.clear();
  return format_scene({std::move(scene), {}, {}});
}

}  // namespace

std::uint64_t run_key(const Scene& scene, const Plan& plan) {
  return hash_of_text(whole_text(scene) + write_json(plan_json(scene, plan, {})));
}

RunFolder::RunFolder(fs::path path, std::uint64_t key, bool resume) : path_(std::move(path)), key_(key) {
  std::error_code error;
  fs::create_directories(path_, error);
  if (error) fail_with(path_.string(), error.value());
  lock_.emplace(path_);
  if (fs::exists(path_ / run_file)) {
    if (!resume) throw InputFailure(path_.string(), 0, "", "holds a run; --resume goes on with it");
    if (key_in(path_ / run_file) != hash_text(key))
      throw InputFailure(path_.string(), 0, "", "holds a run of another scene, or of another plan of it");
    remove_cases(path_);
    remove_temporaries(path_);
    return;
  }
  for (const std::string& name : written_names())
    if (fs::exists(path_ / name))
      throw InputFailure((path_ / name).string(), 0, "", "stands where a run would write, and belongs to none");
  remove_temporaries(path_);
}

std::optional<Checkpoint> RunFolder::checkpoint() const {
  const fs::path path = path_ / checkpoint_file;
  auto out = read_checkpoint(path);
  if (out && out->key != key_)
    throw InputFailure(path.string(), 0, "key", "is of another scene, or of another plan of it");
  return out;
}

void RunFolder::write_checkpoint(Checkpoint checkpoint) const {
  checkpoint.key = key_;
  write_file(path_ / checkpoint_file, format_checkpoint(checkpoint));
}

void RunFolder::write_run(const Json& run) const {
  Json out = run;
  out["key"] = hash_text(key_);
  write_file(path_ / run_file, out.dump(2) + "\n");
}

void RunFolder::write_scene(const Scene& scene) const {
  write_file(path_ / scene_file, whole_text(scene) + "\n");
}

}  // namespace plumb::scene
