// dump.lammpstrj: the text of LAMMPS's dump custom, by dump_text; what moves stands after it. type 2: fixed.
#include "corpus/dump/dump_text.hpp"
#include "corpus/scene/scene_output.hpp"

namespace plumb::scene {
namespace {

class Dump : public SceneOutput {
 public:
  Dump(const Scene& scene, const std::filesystem::path& folder, std::uint64_t length)
      : SceneOutput(folder, "dump.lammpstrj", length) {
    for (const SceneBody& b : scene.bodies) is_fixed_.push_back(b.is_fixed);
  }

  void frame(const Simulation& run) override {
    const World& world = run.world();
    const Column* temperature = world.columns.find("temperature");
    const std::string columns = columns_of(world.state) + (temperature == nullptr ? "" : " temperature");
    std::string text = dump_head(run.steps(), run.time(), world.bodies.count, bounds_of(world), columns);
    for (std::size_t i = 0; i < world.bodies.count; ++i) {
      add_body(text, world, i);
      if (temperature != nullptr) add_dump_numbers(text, temperature->entry(i));
      text += "\n";
    }
    file().add(text);
  }

 private:
  static std::string columns_of(const State& state) {
    std::string out = dump_column_names(DumpFormat::lammps);
    if (state.velocity != nullptr) out += " vx vy vz";
    if (state.angular_momentum != nullptr) out += " angmomx angmomy angmomz";
    return out;
  }

  /// Around the bodies, walls left out; those of a box that repeats itself where there is one.
  static DumpBounds bounds_of(const World& world) {
    DumpBounds out;
    for (std::size_t i = 0; i < world.bodies.count; ++i)
      out.include(world.state.position->vector(i), world.bodies.radius[i]);
    for (int k = 0; k < 3 && world.state.box_sides != nullptr; ++k)
      if (const double side = world.state.box_sides->vector(0)[k]; side > 0) {
        out.low[k] = 0;
        out.high[k] = side;
        out.is_periodic[static_cast<std::size_t>(k)] = true;
      }
    return out;
  }

  void add_body(std::string& text, const World& world, std::size_t i) const {
    const State& state = world.state;
    Body body{world.bodies.shape[i], world.home(state.position->vector(i)), {}};
    std::ranges::copy(state.orientation->entry(i), body.quaternion.begin());
    add_dump_body(text, DumpFormat::lammps, i + 1, is_fixed_[i] ? 2 : 1, body);
    if (state.velocity != nullptr) add_dump_numbers(text, state.velocity->entry(i));
    if (state.angular_momentum != nullptr) add_dump_numbers(text, state.angular_momentum->entry(i));
  }

  std::vector<bool> is_fixed_;
};

}  // namespace

OpenedOutput open_dump(const Scene& scene, const std::filesystem::path& folder, std::uint64_t length) {
  return std::make_unique<Dump>(scene, folder, length);
}

}  // namespace plumb::scene
