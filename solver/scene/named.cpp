#include "solver/scene/named.hpp"

#include <algorithm>
#include <array>

#include "solver/scene/named/named_scenes.hpp"

namespace plumb::scene {
namespace {

constexpr std::array list{
    NamedScene{"impact", "two ellipsoids meet along their axes: a half sine of force, exactly known", 0, named::impact},
    NamedScene{"rolling", "an ellipsoid rolls down a slope with friction", 0, named::rolling},
    NamedScene{"rod", "a rod rolls on its side, a contact as long as itself", 0, named::rod},
    NamedScene{"needle", "a needle tumbles about its middle axis, free of all forces", 0, named::needle},
    NamedScene{"pile", "superquadrics fall into a box and come to rest", 200, named::pile},
    NamedScene{"hopper", "superquadrics flow through the slot between two plates", 75, named::hopper},
    NamedScene{"dice", "dice thrown onto a table: they come to rest on their faces", 4, named::dice},
    NamedScene{"tower", "dice on each other, face on face on an elastic foundation: they stand still", 5, named::tower},
    NamedScene{"wall", "bricks in bond, each on two, settle under their weight", 30, named::wall},
    NamedScene{"packing", "a box that repeats itself shrinks until its ellipsoids jam", 64, named::packing},
    NamedScene{"drum", "superquadrics in a drum of triangles that turns", 60, named::drum},
    NamedScene{"silo", "superquadrics flow out of a cylinder through a cone", 60, named::silo},
    NamedScene{"mixer", "a blade of triangles stirs superquadrics in a pot", 60, named::mixer},
    NamedScene{"chain", "a chain of touching ellipsoids between two fixed ones, which keeps its energy", 8,
               named::chain},
    NamedScene{"billiards", "balls between cushions, elastic, without gravity and friction", 16, named::billiards},
};

}  // namespace

std::span<const NamedScene> named_scenes() {
  return list;
}

const NamedScene* find_named_scene(std::string_view name) {
  const auto found = std::ranges::find(list, name, &NamedScene::name);
  return found == list.end() ? nullptr : &*found;
}

}  // namespace plumb::scene
