// Where bodies touch walls, with a bug in it, in a library of its own.
#include <iterator>

#include "solver/scene/wall/mesh.cpp"
#include "solver/scene/wall/mesh_maker.cpp"
#include "solver/scene/wall/touch_inside.cpp"
#include "solver/scene/wall/touch_mesh.cpp"
#include "solver/scene/wall/touch_outside.cpp"
#include "solver/scene/wall/touches.cpp"
#include "solver/scene/wall/wall_shape.cpp"

namespace {

struct Row {
  std::string_view name;
  int number;
};

#define PLUMB_SEEDED_BUGS_MARK
#include "bugs.inc"

}  // namespace

#define PLUMB_EXPORT extern "C" [[gnu::visibility("default")]]

/// Bug 0 .. seeded_walls_bugs() - 1, and -1 for none. Of triangles, where there are any, and else of a shape that is no mesh: as many touches
/// as `to` may hold are written; how many there are.
PLUMB_EXPORT std::size_t seeded_touches(int bug, const std::vector<plumb::scene::Triangle>* triangles,
                                        const plumb::scene::WallShape* shape, const plumb::scene::BodyAtWall* body,
                                        plumb::scene::Touch* to, std::size_t most) {
  using namespace plumb::scene;
  plumb::bug_of_thread = bug < 0 ? 0 : kRows[bug].number;
  WallShape wall = *shape;
  if (!triangles->empty()) {
    MeshWall mesh;
    mesh.mesh = std::make_shared<const Mesh>(*triangles);
    wall = mesh;
  }
  std::vector<std::uint32_t> scratch;
  Touches found;
  find_touches(wall, *body, scratch, found);
  const std::size_t count = found.all().size();
  std::copy_n(found.all().begin(), std::min(count, most), to);
  return count;
}
PLUMB_EXPORT int seeded_walls_bugs() {
  return static_cast<int>(std::size(kRows));
}
PLUMB_EXPORT const char* seeded_walls_name(int bug) {
  return kRows[bug].name.data();
}
