// Where a body touches a wall: all places, found anew from the poses.
#pragma once

#include "solver/scene/wall/body_at_wall.hpp"
#include "solver/scene/wall/wall_shape.hpp"

namespace plumb::scene {

/// Of any wall but a plane. `scratch` is for a mesh: what it holds before does not count.
void find_touches(const WallShape& wall, const BodyAtWall& body, std::vector<std::uint32_t>& scratch, Touches& out);

/// Of each kind; see the sources for what counts as a contact.
void touch_mesh(const MeshWall& wall, const BodyAtWall& body, std::vector<std::uint32_t>& scratch, Touches& out);
void touch_inside(const CylinderWall& wall, const BodyAtWall& body, Touches& out);
void touch_inside(const ConeWall& wall, const BodyAtWall& body, Touches& out);
void touch_outside(const CylinderWall& wall, const BodyAtWall& body, Touches& out);
void touch_outside(const ConeWall& wall, const BodyAtWall& body, Touches& out);
void touch_outside(const BoxWall& wall, const BodyAtWall& body, Touches& out);

}  // namespace plumb::scene
