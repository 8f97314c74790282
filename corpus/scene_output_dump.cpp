// dump.lammpstrj: the text of LAMMPS's dump custom. Shapes are diameters, as LAMMPS has them and OVITO reads them (it halves
// columns of these names); OVITO draws superquadrics by the two columns of its own, 2/n2 and 2/n1.
#include "corpus/json_text.hpp"
#include "corpus/scene_output.hpp"

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
    std::string text = "ITEM: TIME\n" + shortest(run.time());
    text += "\nITEM: TIMESTEP\n" + std::to_string(run.steps());
    text += "\nITEM: NUMBER OF ATOMS\n" + std::to_string(world.bodies.count) + "\n" + box_of(world);
    const Column* temperature = world.columns.find("temperature");
    text += "ITEM: ATOMS " + columns_of(world.state) + (temperature == nullptr ? "\n" : " temperature\n");
    for (std::size_t i = 0; i < world.bodies.count; ++i) {
      add_body(text, world, i);
      if (temperature != nullptr) add_numbers(text, temperature->entry(i));
      text += "\n";
    }
    file().add(text);
  }

 private:
  static void add_numbers(std::string& text, std::span<const double> numbers) {
    for (const double x : numbers) text += " " + shortest(x);
  }

  static std::string columns_of(const State& state) {
    std::string out = "id type x y z quatw quati quatj quatk shapex shapey shapez block1 block2";
    out += " SuperquadricRoundness.Phi SuperquadricRoundness.Theta";
    if (state.velocity != nullptr) out += " vx vy vz";
    if (state.angular_momentum != nullptr) out += " angmomx angmomy angmomz";
    return out;
  }

  /// Around the bodies, walls left out.
  static std::string box_of(const World& world) {
    std::string out = "ITEM: BOX BOUNDS ss ss ss\n";
    for (int axis = 0; axis < 3; ++axis) {
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (std::size_t i = 0; i < world.bodies.count; ++i) {
        const double x = world.state.position->vector(i)[axis], radius = world.bodies.radius[i];
        low = std::min(low, x - radius);
        high = std::max(high, x + radius);
      }
      out += shortest(low) + " " + shortest(high) + "\n";
    }
    return out;
  }

  void add_body(std::string& text, const World& world, std::size_t i) const {
    const State& state = world.state;
    const Superellipsoid<double>& shape = world.bodies.shape[i];
    text += std::to_string(i + 1) + (is_fixed_[i] ? " 2" : " 1");
    add_numbers(text, state.position->entry(i));
    add_numbers(text, state.orientation->entry(i));
    add_numbers(text, std::array{2 * shape.semi_axes[0], 2 * shape.semi_axes[1], 2 * shape.semi_axes[2], shape.n1,
                                 shape.n2, 2 / shape.n2, 2 / shape.n1});
    if (state.velocity != nullptr) add_numbers(text, state.velocity->entry(i));
    if (state.angular_momentum != nullptr) add_numbers(text, state.angular_momentum->entry(i));
  }

  std::vector<bool> is_fixed_;
};

}  // namespace

OpenedOutput open_dump(const Scene& scene, const std::filesystem::path& folder, std::uint64_t length) {
  return std::make_unique<Dump>(scene, folder, length);
}

}  // namespace plumb::scene
