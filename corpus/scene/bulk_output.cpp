// bulk.jsonl: what a packing is as a whole, a frame a line.
#include "corpus/scene/scene_output.hpp"
#include "corpus/scene/scene_view.hpp"
#include "solver/scene/bulk/bulk.hpp"

namespace plumb::scene {
namespace {

Json to_json(const Vec3<double>& v) {
  return {v[0], v[1], v[2]};
}

/// Rows.
Json to_json(const Eigen::Matrix3d& m) {
  return {to_json(Vec3<double>(m.row(0))), to_json(Vec3<double>(m.row(1))), to_json(Vec3<double>(m.row(2)))};
}

Json to_json(double x) {
  return x;
}

Json to_json(const ForceDistribution& forces) {
  Json out;
  out["mean"] = forces.mean;
  out["deciles"] = forces.deciles;
  out["greatest"] = forces.greatest;
  return out;
}

/// What is absent is not written.
template <class Measure>
void add(Json& out, const char* name, const std::optional<Measure>& measure) {
  if (measure) out[name] = to_json(*measure);
}

Json bulk_json(const Simulation& run, const std::optional<Region>& region) {
  const Bulk bulk = bulk_of(run.world(), region);
  Json out = {{"time", run.time()}, {"step", run.steps()}};
  out["region"] = {{"low", to_json(bulk.region.low)}, {"high", to_json(bulk.region.high)}};
  out["bodies"] = bulk.bodies;
  out["rattlers"] = bulk.rattlers;
  out["packing_fraction"] = bulk.packing_fraction;
  for (std::size_t k = 0; k < 3; ++k) out["profiles"][std::string(1, "xyz"[k])] = bulk.profiles[k];
  add(out, "coordination", bulk.coordination);
  add(out, "coordination_without_rattlers", bulk.coordination_without_rattlers);
  add(out, "fabric", bulk.fabric);
  add(out, "order", bulk.order);
  add(out, "stress", bulk.stress);
  add(out, "kinetic_stress", bulk.kinetic);
  add(out, "forces", bulk.forces);
  return out;
}

class BulkLines : public SceneOutput {
 public:
  BulkLines(const Scene& scene, const std::filesystem::path& folder, std::uint64_t length)
      : SceneOutput(folder, "bulk.jsonl", length), region_(scene.run.outputs.region) {}

  void frame(const Simulation& run) override { file().add(write_json(bulk_json(run, region_)) + "\n"); }

 private:
  std::optional<Region> region_;
};

}  // namespace

OpenedOutput open_bulk(const Scene& scene, const std::filesystem::path& folder, std::uint64_t length) {
  return std::make_unique<BulkLines>(scene, folder, length);
}

}  // namespace plumb::scene
