#include "corpus/scene/scene_output.hpp"

#include "corpus/scene/scene_view.hpp"

namespace plumb::scene {
namespace {

/// JSON, a frame a line.
class Lines : public SceneOutput {
 public:
  using ToJson = Json (*)(const Simulation&);
  Lines(const std::filesystem::path& folder, std::string name, std::uint64_t length, ToJson to_json)
      : SceneOutput(folder, std::move(name), length), to_json_(to_json) {}

  void frame(const Simulation& run) override { file().add(write_json(to_json_(run)) + "\n"); }

 private:
  ToJson to_json_;
};

/// A line a contact, as it ends; as a run does, those that go on.
class Lives : public SceneOutput {
 public:
  Lives(const std::filesystem::path& folder, std::uint64_t length) : SceneOutput(folder, "lives.jsonl", length) {}

  void frame(const Simulation& /*run*/) override {}
  void step(const Simulation& run) override { add(run, run.ended_lives()); }
  void end(const Simulation& run, const RunEnd& /*end*/) override { add(run, run.lasting_lives()); }

 private:
  void add(const Simulation& run, const std::vector<Life>& lives) {
    for (const Life& life : lives) file().add(write_json(life_json(run, life)) + "\n");
  }
};

std::uint64_t length_in(const Lengths& lengths, const std::string& name) {
  const auto found = lengths.find(name);
  return found == lengths.end() ? 0 : found->second;
}

}  // namespace

OpenedOutput open_touching(const std::filesystem::path& folder, std::uint64_t length) {
  return std::make_unique<Lines>(folder, "touching.jsonl", length, touching_json);
}

OpenedOutput open_contacts(const std::filesystem::path& folder, std::uint64_t length) {
  return std::make_unique<Lines>(folder, "contacts.jsonl", length, contacts_json);
}

OpenedOutput open_energy(const std::filesystem::path& folder, std::uint64_t length) {
  return std::make_unique<Lines>(folder, "energy.jsonl", length, energy_json);
}

OpenedOutput open_lives(const std::filesystem::path& folder, std::uint64_t length) {
  return std::make_unique<Lives>(folder, length);
}

std::vector<std::string> output_names() {
  return {"touching.jsonl", "contacts.jsonl", "dump.lammpstrj", "vtk/bodies.pvd", "vtk/contacts.pvd",
          "playback.jsonl", "energy.jsonl",   "lives.jsonl",    "bulk.jsonl"};
}

Outs open_outputs(const Scene& scene, const Plan& plan, const std::filesystem::path& folder, const Lengths& lengths) {
  const Outputs& asked = scene.run.outputs;
  const auto length = [&](const char* name) { return length_in(lengths, name); };
  Outs out;
  if (asked.touching) out.push_back(open_touching(folder, length("touching.jsonl")));
  if (asked.contacts) out.push_back(open_contacts(folder, length("contacts.jsonl")));
  if (asked.dump) out.push_back(open_dump(scene, folder, length("dump.lammpstrj")));
  if (asked.vtk) {
    std::filesystem::create_directories(folder / "vtk");
    out.push_back(open_vtk_bodies(folder, length("vtk/bodies.pvd")));
    out.push_back(open_vtk_contacts(folder, length("vtk/contacts.pvd")));
  }
  if (asked.playback) out.push_back(open_playback(scene, plan, folder, length("playback.jsonl")));
  if (asked.energy) out.push_back(open_energy(folder, length("energy.jsonl")));
  if (asked.lives) out.push_back(open_lives(folder, length("lives.jsonl")));
  if (asked.bulk) out.push_back(open_bulk(scene, folder, length("bulk.jsonl")));
  return out;
}

}  // namespace plumb::scene
