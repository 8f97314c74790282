// Where bodies touch walls, with a bug in it, in a library of its own.
#include "solver/scene/wall/mesh.cpp"
#include "solver/scene/wall/mesh_maker.cpp"
#include "solver/scene/wall/touch_inside.cpp"
#include "solver/scene/wall/touch_mesh.cpp"
#include "solver/scene/wall/touch_outside.cpp"
#include "solver/scene/wall/touches.cpp"
#include "solver/scene/wall/wall_shape.cpp"

#include "fuzz/bugs/seeded_rows.hpp"

/// Of triangles, where there are any, and else of a shape that is no mesh: as many touches
/// as `to` may hold are written; how many there are.
PLUMB_EXPORT std::size_t seeded_touches(int bug, const std::vector<plumb::scene::Triangle>* triangles,
                                        const plumb::scene::WallShape* shape, const plumb::scene::BodyAtWall* body,
                                        plumb::scene::Touch* to, std::size_t most) {
  using namespace plumb::scene;
  select_bug(bug);
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
