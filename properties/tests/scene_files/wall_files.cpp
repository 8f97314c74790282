// Walls with a shape in scene files, and the files of triangles that they name.
#include <gtest/gtest.h>

#include <bit>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>

#include "corpus/case/case.hpp"
#include "corpus/scene/mesh_file.hpp"
#include "properties/tests/corpus/programs.hpp"
#include "properties/tests/scene_files/scene_sample.hpp"
#include "solver/scene/named/named_scenes.hpp"

namespace plumb::scene {
namespace {

std::string refusal_of(const std::function<void()>& reads) {
  try {
    reads();
  } catch (const InputFailure& error) {
    return error.what();
  }
  return "none";
}

std::string scene_refusal(const std::string& old_text, const std::string& new_text) {
  std::string text = sample_with_walls();
  text.replace(text.find(old_text), old_text.size(), new_text);
  return refusal_of([&] { (void)parse_scene(text, "s.json"); });
}

TEST(WallFiles, EveryShapeIsReadAndWrittenAgain) {
  const SceneFile file = parse_scene(sample_with_walls(), "s.json");
  const std::vector<Wall>& walls = file.scene.walls;
  ASSERT_EQ(walls.size(), 7U);
  const auto& mesh = std::get<MeshWall>(walls[1].shape);
  EXPECT_EQ(mesh.mesh->triangles().size(), 1U);
  EXPECT_EQ(mesh.smooth_deg, 10);
  EXPECT_EQ(walls[1].quaternion, (std::array<double, 4>{2, 0, 0, 1}));
  EXPECT_EQ(walls[1].temperature, 3);
  EXPECT_EQ(std::get<CylinderWall>(walls[2].shape).ends, (std::array{End::closed, End::bare}));
  EXPECT_EQ(std::get<ConeWall>(walls[3].shape).side, Side::inside);
  EXPECT_EQ(std::get<ConeWall>(walls[4].shape).side, Side::outside);
  EXPECT_EQ(std::get<BoxWall>(walls[5].shape).half_extents, Vec3<double>::Constant(9));
  const std::string text = format_scene(file);
  EXPECT_EQ(format_scene(parse_scene(text, "s.json")), text);
}

TEST(WallFiles, RefusalsSayWhichField) {
  EXPECT_EQ(scene_refusal(R"("radius": 9)", R"("radius": 0)"),
            "s.json: walls[2].cylinder.radius: must be a positive number");
  EXPECT_EQ(scene_refusal(R"("side": "inside")", R"("side": "within")"),
            "s.json: walls[2].cylinder.side: must be one of inside, outside");
  EXPECT_EQ(
      scene_refusal(R"("side": "outside"}, "position": [7)", R"("side": "outside", "ends": "open"}, "position": [7)"),
      "s.json: walls[4].cone.ends: has no meaning outside: a solid has flat ends");
  EXPECT_EQ(scene_refusal(R"("radii": [1, 0])", R"("radii": [0, 0])"), "s.json: walls[4].cone.radii: are both 0");
  EXPECT_EQ(scene_refusal("[0, 1, -5]", "[2, 0, -5]"), "s.json: walls[1].mesh: triangles[0]: has no area");
  EXPECT_EQ(scene_refusal(R"({"box": {"half_extents": [9, 9, 9]}})",
                          R"({"box": {"half_extents": [9, 9, 9]}, "point": [0, 0, 0]})"),
            "s.json: walls[5].point: is a plane's: a shape has position and orientation");
  EXPECT_EQ(scene_refusal(R"("triangles")", R"("file": "no.stl", "triangles")"),
            "s.json: walls[1].mesh: must hold one of file, triangles");
}

const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1/1 2/2/2 4//3\n";

std::string obj_refusal(const std::string& text) {
  return refusal_of([&] { (void)made_mesh(parse_obj(text, "m.obj"), "m.obj"); });
}

TEST(MeshFiles, AnObjIsRead) {
  const auto triangles = parse_obj("# a comment\n\n" + obj + "vn 0 0 1\r\nf -4 -2 -1\n", "m.obj");
  ASSERT_EQ(triangles.size(), 3U);
  EXPECT_EQ(triangles[1][2], (Vec3<double>{0, 0, 1}));
  EXPECT_EQ(triangles[2][1], (Vec3<double>{0, 1, 0}));
}

TEST(MeshFiles, AnObjIsRefusedInALine) {
  EXPECT_EQ(obj_refusal(obj), "none");
  EXPECT_EQ(obj_refusal("v 0 0 nan\n"), "m.obj:1: v: must be a finite number");
  EXPECT_EQ(obj_refusal("v 0 0\n"), "m.obj:1: v: must be a finite number");
  EXPECT_EQ(obj_refusal("v 0 0 1e999\n"), "m.obj:1: v: must be a finite number");
  EXPECT_EQ(obj_refusal(obj + "f 1 2 5\n"), "m.obj:7: f: has a corner that is not there");
  EXPECT_EQ(obj_refusal(obj + "f 0 1 2\n"), "m.obj:7: f: has a corner that is not there");
  EXPECT_EQ(obj_refusal(obj + "f 1 2\n"), "m.obj:7: f: must hold three corners");
  EXPECT_EQ(obj_refusal(obj + "f 1 2 3 4\n"), "m.obj:7: f: has more than three corners: cut it into triangles");
  EXPECT_EQ(obj_refusal(obj + "f 1 1 2\n"), "m.obj: triangles[2]: has no area");
  EXPECT_EQ(obj_refusal(obj + "curv 1\n"), "m.obj:7: curv: is no line of an OBJ file that is known");
  EXPECT_EQ(obj_refusal(""), "m.obj: triangles: there is none");
}

/// Binary, whatever is in it.
std::string stl_of(const std::vector<Triangle>& triangles, std::uint32_t count) {
  std::string out(80, ' ');
  const auto add = [&](std::uint32_t bits, int bytes) {
    for (int k = 0; k < bytes; ++k) out += static_cast<char>(bits >> (8 * k) & 255U);
  };
  add(count, 4);
  for (const Triangle& t : triangles) {
    for (int k = 0; k < 3; ++k) add(0, 4);
    for (const Vec3<double>& corner : t)
      for (const double x : corner) add(std::bit_cast<std::uint32_t>(static_cast<float>(x)), 4);
    add(0, 2);
  }
  return out;
}

std::string stl_refusal(const std::string& bytes) {
  return refusal_of([&] { (void)made_mesh(parse_stl(bytes, "m.stl"), "m.stl"); });
}

const Triangle one{Vec3<double>(0, 0, 0), Vec3<double>(1, 0, 0), Vec3<double>(0, 1, 0.5)};
const std::string in_words = "solid a name\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   "
                             "vertex 0 1 5e-1\n  endloop\n endfacet\n"
                             "endsolid a name\n";

TEST(MeshFiles, AnStlIsReadInWordsAndNumbers) {
  for (const std::string& bytes : {in_words, stl_of({one}, 1)}) {
    const auto read = parse_stl(bytes, "m.stl");
    ASSERT_EQ(read.size(), 1U);
    EXPECT_EQ(read[0], one);
  }
  EXPECT_EQ(parse_stl("solid" + stl_of({one}, 1).substr(5), "m.stl").size(), 1U);  // as some programs begin
}

TEST(MeshFiles, AnStlIsRefusedInALine) {
  const std::string numbers = stl_of({one}, 1);
  EXPECT_EQ(stl_refusal(numbers.substr(0, 40)), "m.stl: is no STL file: it ends within its head");
  EXPECT_EQ(stl_refusal(numbers.substr(0, 100)),
            "m.stl: triangles: are 1 by its head, and the file's length is that of another number");
  EXPECT_EQ(stl_refusal(stl_of({one}, 0xffffffffU)),
            "m.stl: triangles: are 4294967295 by its head, and the file's length is that of another number");
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(stl_refusal(stl_of({one, {one[0], one[1], Vec3<double>(0, infinity, 0)}}, 2)),
            "m.stl: triangles[1]: must be finite numbers");
  EXPECT_EQ(stl_refusal(stl_of({{one[0], one[1], one[1]}}, 1)), "m.stl: triangles[0]: has no area");
  EXPECT_EQ(stl_refusal(stl_of({}, 0)), "m.stl: triangles: there is none");
  const auto words = [&](const std::string& old_text, const std::string& new_text) {
    std::string text = in_words;
    return stl_refusal(text.replace(text.find(old_text), old_text.size(), new_text));
  };
  EXPECT_EQ(words("vertex 1 0 0", "vertex 1 0 inf"), "m.stl:5: vertex: must be a finite number");
  EXPECT_EQ(words("   vertex 0 1 5e-1\n", ""), "m.stl:6: vertex: is missing");
  EXPECT_EQ(words("endsolid a name\n", ""), "m.stl:8: endsolid: is missing: the file ends");
  EXPECT_EQ(words("endfacet", "endface"), "m.stl:8: endfacet: is missing");
}

TEST(MeshFiles, ASceneFindsThemInItsFolder) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(testing::TempDir()) / "plumb_mesh_files";
  fs::create_directories(folder);
  std::ofstream(folder / "m.stl", std::ios::binary) << stl_of({one}, 1);
  std::string text = sample_with_walls();
  const std::string old_text = R"("triangles": [[[0, 0, -5], [1, 0, -5], [0, 1, -5]]])";
  text.replace(text.find(old_text), old_text.size(), R"("file": "m.stl")");
  const SceneFile file = parse_scene(text, (folder / "s.json").string());
  EXPECT_EQ(std::get<MeshWall>(file.scene.walls[1].shape).mesh->triangles()[0], one);
  EXPECT_NE(format_scene(file).find(R"("file": "m.stl")"), std::string::npos) << format_scene(file);
  fs::remove(folder / "m.stl");
  EXPECT_NE(refusal_of([&] { (void)parse_scene(text, (folder / "s.json").string()); }).find("m.stl"),
            std::string::npos);
}

TEST(MeshFiles, TheBladeIsTheMixers) {
  const auto blade = read_mesh_file(PLUMB_SOURCE_DIR "/corpus/scenes/blade.stl");
  EXPECT_EQ(blade, named::blade());
}

class PlaybackOfWalls : public Commands {
 protected:
  /// The lines of the sample's playback, with its walls as they are given.
  [[nodiscard]] std::vector<Json> lines(const std::string& scene) const {
    (void)file("s.json", scene);
    EXPECT_LE(plumb("scene s.json --out out 2>/dev/null").code, 1);
    return lines_of(read("out/playback.jsonl"));
  }
};

TEST_F(PlaybackOfWalls, TheHeadHasWhatIsDrawn) {
  const auto all = lines(sample_with_walls());
  ASSERT_GE(all.size(), 3U);
  const Json& walls = all.front()["walls"];
  ASSERT_EQ(walls.size(), 7U);
  EXPECT_EQ(walls[0], Json::parse(R"({"normal": [0, 0, 1]})"));
  EXPECT_EQ(walls[1]["shape"], "mesh");
  EXPECT_EQ(walls[1]["mesh"]["triangles"].size(), 9U);
  EXPECT_EQ(walls[2]["cylinder"], Json::parse(R"({"radius": 9, "half_length": 8, "closed": [true, false]})"));
  EXPECT_EQ(walls[3]["cone"], Json::parse(R"({"radii": [8, 9], "height": 20, "closed": [false, false]})"));
  EXPECT_EQ(walls[4]["cone"], Json::parse(R"({"radii": [1, 0], "height": 2, "closed": [true, true]})"));
  EXPECT_EQ(walls[5]["box"], Json::parse(R"({"half_extents": [9, 9, 9]})"));
}

TEST_F(PlaybackOfWalls, FramesHaveOrientationsWhereAWallIsNoPlane) {
  std::string turning = sample_with_walls();
  const std::string effects = R"("effects": {)";
  turning.insert(turning.find(effects) + effects.size(),
                 R"("moving_walls": {"motions": [{"wall": 2, "angular_velocity": [0, 0, 2]}]}, )");
  const auto all = lines(turning);
  for (std::size_t k = 1; k + 1 < all.size(); ++k) {
    const Json& q = all[k]["wall_orientation"];
    ASSERT_EQ(q.size(), 28U);
    EXPECT_EQ(q[0], 1.0) << "of a plane";
    EXPECT_NEAR(q[4].get<double>(), 2 / std::sqrt(5), 1e-8);
    EXPECT_NEAR(q[8].get<double>(), std::cos(all[k]["time"].get<double>()), 1e-8);
    EXPECT_NEAR(q[11].get<double>(), std::sin(all[k]["time"].get<double>()), 1e-8);
  }
}

TEST_F(PlaybackOfWalls, OfPlanesAloneItHasNone) {
  for (const Json& line : lines(sample_scene())) EXPECT_FALSE(line.contains("wall_orientation"));
}

// A square of 101 x 100 x 2 triangles: more than are drawn.
TEST_F(PlaybackOfWalls, ALargeMeshIsNotDrawn) {
  std::ofstream mesh(path_ / "m.obj");
  for (int j = 0; j <= 100; ++j)
    for (int i = 0; i <= 101; ++i) mesh << "v " << i << " " << j << " -20\n";
  for (int j = 0; j < 100; ++j)
    for (int i = 0; i < 101; ++i) {
      const int at = 102 * j + i + 1;
      mesh << "f " << at << " " << at + 1 << " " << at + 102 << "\nf " << at + 1 << " " << at + 103 << " " << at + 102
           << "\n";
    }
  mesh.close();
  const auto all =
      lines(sample_scene_with(R"("normal": [0, 0, 1]}])", R"("normal": [0, 0, 1]}, {"mesh": {"file": "m.obj"}}])"));
  EXPECT_EQ(all.front()["walls"][1], Json::parse(R"({"normal": [0, 0, 1], "shape": "mesh"})"));
  EXPECT_EQ(all.at(1)["wall_orientation"].size(), 8U);
}

}  // namespace
}  // namespace plumb::scene
