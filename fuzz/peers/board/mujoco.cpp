// MuJoCo's collision of two ellipsoid geoms: a model of two free bodies, loaded once, whose sizes and poses are the pair's.
#include <mujoco/mujoco.h>

#include <cstdio>
#include <memory>
#include <stdexcept>

#include "solver/plumb_adapter.hpp"

namespace plumb::board {
namespace {

void claim(plumb_abilities& abilities) {
  abilities.name = "mujoco";
  abilities.version = mj_versionString();
  abilities.licence = "Apache-2.0";
  abilities.shapes = PLUMB_ELLIPSOIDS;
  abilities.apart = PLUMB_APART_VERDICT;
  abilities.points = PLUMB_POINTS_MIDWAY;
  abilities.tolerance = 1e-6;  // mpr_tolerance, the default of mjOption
}

constexpr const char* kModel = "<mujoco><worldbody>"
                               "<body><freejoint/><geom type='ellipsoid' size='1 1 1'/></body>"
                               "<body><freejoint/><geom type='ellipsoid' size='1 1 1'/></body>"
                               "</worldbody></mujoco>";

struct World {
  std::unique_ptr<mjModel, void (*)(mjModel*)> model;
  std::unique_ptr<mjData, void (*)(mjData*)> data;
};

// MuJoCo reads models from files, or from what it calls a virtual file system.
mjModel* load_model() {
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  constexpr const char* name = "pair.xml";
  const int size = static_cast<int>(std::char_traits<char>::length(kModel));
  mj_makeEmptyFileVFS(files.get(), name, size);
  std::copy_n(kModel, size, static_cast<char*>(files->filedata[mj_findFileVFS(files.get(), name)]));
  std::array<char, 256> error{};
  mjModel* model = mj_loadXML(name, files.get(), error.data(), static_cast<int>(error.size()));
  mj_deleteVFS(files.get());
  if (model == nullptr) throw std::runtime_error(error.data());
  return model;
}

World make_world() {
  mjModel* model = load_model();
  return {{model, mj_deleteModel}, {mj_makeData(model), mj_deleteData}};
}

// geom_rbound, the sphere about a geom, is what the broad phase asks first.
void place(World& world, std::size_t i, const adapter::Body& body) {
  std::copy_n(body.semi_axes.begin(), 3, world.model->geom_size + 3 * i);
  world.model->geom_rbound[i] = *std::max_element(body.semi_axes.begin(), body.semi_axes.end());
  std::copy_n(body.centre.begin(), 3, world.data->qpos + 7 * i);
  std::copy_n(body.quaternion.begin(), 4, world.data->qpos + 7 * i + 3);
}

void solve(const adapter::Frame& frame, plumb_contact& contact) {
  static World world = make_world();
  place(world, 0, frame.bodies[0]);
  place(world, 1, frame.bodies[1]);
  mj_kinematics(world.model.get(), world.data.get());
  mj_comPos(world.model.get(), world.data.get());
  mj_collision(world.model.get(), world.data.get());
  if (world.data->ncon == 0) {
    adapter::Frame::write_separated(contact);
    return;
  }
  const mjContact& found = world.data->contact[0];
  const double sign = found.geom1 == 0 ? 1 : -1;  // its normal points from geom 1 to geom 2, the first row of its frame
  const mjtNum *n = found.frame, *x = found.pos;
  frame.write_midway(-found.dist, {sign * n[0], sign * n[1], sign * n[2]}, {x[0], x[1], x[2]}, contact);
}

}  // namespace
}  // namespace plumb::board

PLUMB_ADAPTER(plumb::board::claim, plumb::board::solve)
