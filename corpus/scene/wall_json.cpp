#include "corpus/scene/wall_json.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "corpus/case/body_json.hpp"
#include "corpus/scene/mesh_file.hpp"
#include "solver/shape/overloaded.hpp"

namespace plumb::scene {
namespace {

constexpr std::array<std::string_view, 4> shape_words{"mesh", "cylinder", "cone", "box"};

template <class Word, std::size_t N>
Word read_one_of(const Field& field, const std::array<std::string_view, N>& words) {
  const std::string text = field.text();
  const auto found = std::ranges::find(words, text);
  if (found != words.end()) return static_cast<Word>(found - words.begin());
  std::string all;
  for (const std::string_view word : words) all += (all.empty() ? "" : ", ") + std::string(word);
  field.fail("must be one of " + all);
}

template <class Round>
void read_side(const Field& field, Round& out) {
  if (const auto side = field.find("side")) out.side = read_one_of<Side>(*side, side_words);
}

template <class Round>
void read_side_and_ends(const Field& field, Round& out) {
  read_side(field, out);
  const auto ends = field.find("ends");
  if (ends && out.side == Side::outside) ends->fail("has no meaning outside: a solid has flat ends");
  if (ends && ends->value().is_array())
    for (const std::size_t k : {0, 1}) out.ends[k] = read_one_of<End>(ends->element(k, 2, "words"), end_words);
  else if (ends)
    out.ends.fill(read_one_of<End>(*ends, end_words));
}

Triangle read_triangle(const Field& field) {
  Triangle out;
  for (std::size_t k = 0; k < 3; ++k) out[k] = field.element(k, 3, "corners").vector();
  return out;
}

MeshWall read_mesh(const Field& field, const std::string& folder) {
  field.require_object({"file", "triangles", "smooth_deg"});
  const auto file = field.find("file"), given = field.find("triangles");
  if (file.has_value() == given.has_value()) field.fail("must hold one of file, triangles");
  MeshWall out;
  if (file) {
    const std::string path = (std::filesystem::path(folder) / file->text()).string();
    out = made_mesh(read_mesh_file(path), path);
    out.file = file->text();
  } else {
    std::vector<Triangle> triangles;
    for (const Field& one : given->elements()) triangles.push_back(read_triangle(one));
    try {
      out.mesh = std::make_shared<const Mesh>(std::move(triangles));
    } catch (const std::invalid_argument& error) {
      field.fail(error.what());
    }
  }
  if (const auto smooth = field.find("smooth_deg")) out.smooth_deg = smooth->number();
  return out;
}

CylinderWall read_cylinder(const Field& field) {
  field.require_object({"radius", "half_length", "side", "ends"});
  CylinderWall out{field.member("radius").number(), field.member("half_length").number()};
  read_side_and_ends(field, out);
  return out;
}

ConeWall read_cone(const Field& field) {
  field.require_object({"radii", "height", "side", "ends"});
  ConeWall out{field.member("radii").numbers<2>(), field.member("height").number()};
  read_side_and_ends(field, out);
  return out;
}

BoxWall read_box(const Field& field) {
  field.require_object({"half_extents", "side"});
  BoxWall out{field.member("half_extents").vector()};
  read_side(field, out);
  return out;
}

WallShape read_wall_shape(std::string_view word, const Field& field, const std::string& folder) {
  if (word == "mesh") return read_mesh(field, folder);
  if (word == "cylinder") return read_cylinder(field);
  if (word == "cone") return read_cone(field);
  return read_box(field);
}

Json triangles_json(const Mesh& mesh) {
  Json out = Json::array();
  for (const auto& [a, b, c] : mesh.triangles()) out.push_back({vector_json(a), vector_json(b), vector_json(c)});
  return out;
}

template <class Round>
void add_side_and_ends(Json& out, const Round& wall) {
  out["side"] = word_of(wall.side);
  if (wall.side == Side::inside) out["ends"] = {word_of(wall.ends[0]), word_of(wall.ends[1])};
}

Json shape_json(const WallShape& shape) {
  return std::visit(plumb::detail::Overloaded{[](const PlaneWall&) { return Json(); },
                                              [](const MeshWall& wall) {
                                                Json out;
                                                if (wall.file.empty())
                                                  out["triangles"] = triangles_json(*wall.mesh);
                                                else
                                                  out["file"] = wall.file;
                                                out["smooth_deg"] = wall.smooth_deg;
                                                return out;
                                              },
                                              [](const CylinderWall& wall) {
                                                Json out;
                                                out["radius"] = wall.radius;
                                                out["half_length"] = wall.half_length;
                                                add_side_and_ends(out, wall);
                                                return out;
                                              },
                                              [](const ConeWall& wall) {
                                                Json out;
                                                out["radii"] = wall.radii;
                                                out["height"] = wall.height;
                                                add_side_and_ends(out, wall);
                                                return out;
                                              },
                                              [](const BoxWall& wall) {
                                                Json out;
                                                out["half_extents"] = vector_json(wall.half_extents);
                                                out["side"] = word_of(wall.side);
                                                return out;
                                              }},
                    shape);
}

}  // namespace

Wall read_wall_place(const Field& field, const std::string& folder) {
  field.require_object(
      {"point", "normal", "mesh", "cylinder", "cone", "box", "position", "orientation", "temperature", "material"});
  Wall out;
  std::string_view shape;
  for (const std::string_view word : shape_words) {
    const auto given = field.find(word);
    if (given && !shape.empty()) given->fail("and " + std::string(shape) + " are two shapes: a wall has one");
    if (given) shape = word;
  }
  const std::array<std::string_view, 2> other = shape.empty()
                                                    ? std::array<std::string_view, 2>{"position", "orientation"}
                                                    : std::array<std::string_view, 2>{"point", "normal"};
  for (const std::string_view word : other)
    if (const auto given = field.find(word))
      given->fail(shape.empty() ? "is of walls with a shape: a plane has point and normal"
                                : "is a plane's: a shape has position and orientation");
  if (shape.empty()) {
    out.point = field.member("point").vector();
    out.normal = field.member("normal").vector();
    return out;
  }
  out.shape = read_wall_shape(shape, field.member(shape), folder);
  if (const auto position = field.find("position")) out.point = position->vector();
  if (const auto orientation = field.find("orientation")) out.quaternion = read_orientation(*orientation);
  return out;
}

Json wall_place_json(const Wall& wall) {
  Json out;
  out[wall.is_plane() ? "point" : "position"] = vector_json(wall.point);
  if (wall.is_plane()) {
    out["normal"] = vector_json(wall.normal);
    return out;
  }
  out["orientation"]["quaternion_wxyz"] = wall.quaternion;
  out[name_of(wall.shape)] = shape_json(wall.shape);
  return out;
}

}  // namespace plumb::scene
