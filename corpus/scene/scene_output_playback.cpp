// playback.jsonl, format plumb/playback-1: what the page shows. Nine digits are enough for eyes.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include "corpus/json/fields.hpp"
#include "corpus/scene/scene_output.hpp"
#include "corpus/scene/scene_view.hpp"
#include "solver/scene/bulk/bulk.hpp"
#include "solver/scene/wall/mesh.hpp"
#include "solver/shape/overloaded.hpp"

namespace plumb::scene {
namespace {

/// Of a mesh that is drawn: more of them make a slow page of some megabytes.
constexpr std::size_t most_drawn = 20'000;

/// Which ends are more than a rim: a solid has both.
template <class Round>
Json closed_ends(const Round& wall) {
  Json out = Json::array();
  for (const End end : wall.ends) out.push_back(wall.side == Side::outside || end == End::closed);
  return out;
}

/// Nine numbers a triangle; null of a mesh that is not drawn.
Json drawn_mesh_json(const Mesh& mesh) {
  if (mesh.triangles().size() > most_drawn) return nullptr;
  Json numbers = Json::array();
  for (const Triangle& triangle : mesh.triangles())
    for (const Vec3<double>& corner : triangle)
      for (const double x : corner) numbers.push_back(x);
  return {{"triangles", std::move(numbers)}};
}

/// What is needed to draw it; null where that is nothing.
Json drawn_shape_json(const WallShape& shape) {
  return std::visit(
      plumb::detail::Overloaded{
          [](const PlaneWall&) -> Json { return nullptr; },
          [](const MeshWall& wall) { return drawn_mesh_json(*wall.mesh); },
          [](const CylinderWall& wall) -> Json {
            return {{"radius", wall.radius}, {"half_length", wall.half_length}, {"closed", closed_ends(wall)}};
          },
          [](const ConeWall& wall) -> Json {
            return {{"radii", wall.radii}, {"height", wall.height}, {"closed", closed_ends(wall)}};
          },
          [](const BoxWall& wall) -> Json { return {{"half_extents", vector_json(wall.half_extents)}}; }},
      shape);
}

Json drawn_wall_json(const Wall& wall) {
  Json out;
  out["normal"] = vector_json(wall.normal);
  if (wall.is_plane()) return out;
  const char* name = name_of(wall.shape);
  out["shape"] = name;
  if (Json drawn = drawn_shape_json(wall.shape); !drawn.is_null()) out[name] = std::move(drawn);
  return out;
}

Json head_json(const Scene& scene, const Plan& plan) {
  Json bodies = Json::array(), walls = Json::array(), effects = Json::array();
  for (const SceneBody& b : scene.bodies) {
    const auto& shape = b.body.shape;
    bodies.push_back(
        {{"semi_axes", vector_json(shape.semi_axes)}, {"exponents", {shape.n1, shape.n2}}, {"fixed", b.is_fixed}});
  }
  for (const Wall& wall : scene.walls) walls.push_back(drawn_wall_json(wall));
  for (const PlannedEffect& planned : plan.effects)
    effects.push_back({{"name", planned.effect->name}, {"on", planned.is_on}, {"why", planned.why}});
  return {{"format", "plumb/playback-1"},
          {"scene", scene.name},
          {"bodies", bodies},
          {"walls", walls},
          {"effects", effects},
          {"time_step", plan.time_step},
          {"accuracy", scene.run.accuracy}};
}

/// Numbers with commas between them; one that JSON does not have is null.
class Numbers {
 public:
  explicit Numbers(std::string& text) : text_(text) {}
  Numbers& operator<<(double x) {
    if (std::isfinite(x))
      fmt::format_to(std::back_inserter(text_), "{}{:.9g}", separator_, x);
    else
      text_.append(separator_).append("null");
    separator_ = ",";
    return *this;
  }
  Numbers& operator<<(std::span<const double> numbers) {
    for (const double x : numbers) *this << x;
    return *this;
  }

 private:
  std::string& text_;
  const char* separator_ = "";
};

/// The entries first .. last - 1 of a column as a flat array.
void add_entries(std::string& text, const char* name, const Column& column, std::size_t first, std::size_t last) {
  text += fmt::format(",\"{}\":[", name);
  Numbers numbers(text);
  for (std::size_t i = first; i < last; ++i) numbers << column.entry(i);
  text += "]";
}

/// Those of planes, which have none, as if they did not turn.
void add_wall_orientations(std::string& text, const World& world) {
  constexpr std::array<double, 4> unturned{1, 0, 0, 0};
  text += ",\"wall_orientation\":[";
  Numbers numbers(text);
  for (std::size_t wall = 0; wall < world.bodies.walls; ++wall)
    if (std::holds_alternative<PlaneWall>(world.bodies.wall_shape[wall]))
      numbers << unturned;
    else
      numbers << world.state.orientation->entry(world.bodies.count + wall);
  text += "]";
}

void add_contacts(std::string& text, const Simulation& run) {
  text += ",\"contacts\":[";
  const char* separator = "";
  for (const ContactView& contact : contacts_of(run)) {
    text += fmt::format("{}[{},{},", separator, contact.body1, contact.body2);
    Numbers(text) << std::span(contact.point.data(), 3) << std::span(contact.normal.data(), 3) << contact.overlap
                  << contact.force.value_or(0);
    text += "]";
    separator = ",";
  }
  text += "]";
}

void add_energies(std::string& text, const Simulation& run) {
  text += ",\"energy\":{";
  const char* separator = "";
  for (const auto& [owner, energy] : energies_of(run)) {
    text += fmt::format("{}\"{}\":", separator, owner);
    Numbers(text) << energy;
    separator = ",";
  }
  text += "}";
}

void add_bulk(std::string& text, const Simulation& run, const std::optional<Region>& region) {
  const Bulk bulk = bulk_of(run.world(), region);
  text += ",\"bulk\":{\"packing_fraction\":";
  Numbers(text) << bulk.packing_fraction;
  text += ",\"coordination\":";
  Numbers(text) << bulk.coordination.value_or(std::numeric_limits<double>::quiet_NaN());
  text += "}";
}

class Playback : public SceneOutput {
 public:
  Playback(const Scene& scene, const Plan& plan, const std::filesystem::path& folder, std::uint64_t length)
      : SceneOutput(folder, "playback.jsonl", length), outputs_(scene.run.outputs),
        walls_turn_(!std::ranges::all_of(scene.walls, &Wall::is_plane)) {
    if (length == 0) file().add(write_json(head_json(scene, plan)) + "\n");
  }

  void frame(const Simulation& run) override {
    const World& world = run.world();
    std::string text = "{\"time\":";
    Numbers(text) << run.time();
    add_entries(text, "position", *world.state.position, 0, world.bodies.count);
    add_entries(text, "orientation", *world.state.orientation, 0, world.bodies.count);
    add_entries(text, "wall", *world.state.position, world.bodies.count, world.bodies.all());
    if (walls_turn_) add_wall_orientations(text, world);
    if (const Column* temperature = world.columns.find("temperature"))
      add_entries(text, "temperature", *temperature, 0, world.bodies.count);
    add_contacts(text, run);
    add_energies(text, run);
    if (outputs_.bulk) add_bulk(text, run, outputs_.region);
    file().add(text + "}\n");
  }

  void end(const Simulation& run, const RunEnd& end) override {
    const Json json = {
        {"steps", run.steps()},          {"time", run.time()},  {"hash", end.hash}, {"solves", run.totals().solves},
        {"failed", run.totals().failed}, {"shares", end.shares}};
    file().add(write_json({{"end", json}}) + "\n");
  }

 private:
  Outputs outputs_;
  bool walls_turn_;  ///< one of them, at least, is no plane
};

}  // namespace

OpenedOutput open_playback(const Scene& scene, const Plan& plan, const std::filesystem::path& folder,
                           std::uint64_t length) {
  return std::make_unique<Playback>(scene, plan, folder, length);
}

}  // namespace plumb::scene
