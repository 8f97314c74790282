// plumb report: what plumb scene left, alone and beside campaigns.

#include "properties/tests/corpus/json_schema.hpp"
#include "properties/tests/corpus/programs.hpp"

namespace plumb::reports {
namespace {

Json head() {
  return {{"format", "plumb/playback-1"},
          {"scene", "two"},
          {"bodies",
           {{{"semi_axes", {1.0, 2.0, 4.0}}, {"exponents", {2.0, 8.0}}, {"fixed", false}},
            {{"semi_axes", {1.0, 2.0, 4.0}}, {"exponents", {2.0, 8.0}}, {"fixed", true}}}},
          {"walls", {{{"normal", {0.0, 0.0, 2.0}}}}},
          {"effects", {{{"name", "gravity"}, {"on", true}, {"why", "asked for"}}}},
          {"time_step", 1e-4},
          {"accuracy", 1e-3},
          {"x_note", "what is not known is no harm"}};
}

Json frame(double time, double height) {
  return {{"time", time},
          {"position", {0.0, 0.0, height, 4.0, 0.0, 0.0}},
          {"orientation", {2.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0}},
          {"wall", {0.0, 0.0, -4.0}},
          {"contacts",
           {{0, 1, 2.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.01, 5.0}, {0, 2, 4.0, 0.0, -4.0, 0.0, 0.0, -1.0, 0.02, 10.0}}},
          {"energy", {{"kinetic", 1.5}}}};
}

Json end() {
  return {{"end",
           {{"steps", 3e9},
            {"time", 2.0},
            {"hash", "0123456789abcdef"},
            {"solves", 100},
            {"failed", 1},
            {"shares", {{"solver", 0.9}}}}}};
}

/// The scene's wall, and one of each kind that is no plane.
Json head_with_shapes() {
  Json out = head();
  const auto add = [&](const char* shape, const Json& numbers) {
    Json wall;
    wall["normal"] = {0.0, 0.0, 1.0};
    wall["shape"] = shape;
    if (!numbers.is_null()) wall[shape] = numbers;
    out["walls"].push_back(wall);
  };
  add("cylinder", {{"radius", 2.0}, {"half_length", 8.0}, {"closed", {true, false}}});
  add("cone", {{"radii", {0.0, 4.0}}, {"height", 2.0}, {"closed", {false, false}}});
  add("box", {{"half_extents", {4.0, 2.0, 1.0}}});
  add("mesh", {{"triangles", {0.0, 0.0, 0.0, 4.0, 0.0, 0.0, 0.0, -2.0, 0.0}}});
  add("mesh", nullptr);
  return out;
}

Json frame_with_shapes() {
  Json out = frame(0, 8);
  out["wall"] = std::vector<double>(18, 0.0);
  Json& q = out["wall_orientation"] = Json::array();
  for (int wall = 0; wall < 6; ++wall)
    for (const double part : {0.0, 0.0, 0.0, 2.0}) q.push_back(part);
  return out;
}

std::string lines(const std::vector<Json>& all) {
  std::string out;
  for (const Json& line : all) out += line.dump() + "\n";
  return out;
}

class PlaybackReport : public Commands {
 protected:
  void write(const std::string& folder, const std::string& text) const {
    fs::create_directories(path_ / folder);
    write_file(path_ / folder / "playback.jsonl", text);
  }
  [[nodiscard]] Json report_of(const std::vector<Json>& all) const {
    write("scene", lines(all));
    const Ran ran = plumb("report scene -o page.html");
    EXPECT_EQ(ran.code, 0) << ran.out;
    return json("page.json");
  }
  void refuses(const std::vector<Json>& all, const std::string& reason) const {
    write("bad", lines(all));
    expect_refusal("report bad -o page.html", "bad/playback.jsonl:" + reason);
  }
};

TEST_F(PlaybackReport, HoldsTheSceneAndPacksItsFrames) {
  const Json report = report_of({head(), frame(0, 8), frame(0.5, 4), end()});
  EXPECT_TRUE(report["runs"].empty());
  const Json& scene = report["playbacks"][0];
  EXPECT_EQ(scene["name"], "scene");
  EXPECT_EQ(scene["scene"], "two");
  EXPECT_EQ(scene["shapes"], Json({{{"semi_axes", {1.0, 2.0, 4.0}}, {"exponents", {2.0, 8.0}}}}));
  EXPECT_EQ(scene["bodies"], Json({0, 0}));
  EXPECT_EQ(scene["fixed"], Json({1}));
  EXPECT_EQ(scene["walls"], Json({{0.0, 0.0, 1.0}}));
  EXPECT_EQ(scene["origin"], Json({2.0, 0.0, 4.0}));
  EXPECT_EQ(scene["size"], 4.0);
  EXPECT_EQ(scene["times"], Json({0.0, 0.5}));
  // -1/2, 0, 1, 1/2, 0, -1 and -1/2, 0, 0, 1/2, 0, -1 as floats.
  EXPECT_EQ(scene["positions"], "AAAAvwAAAAAAAIA/AAAAPwAAAAAAAIC/AAAAvwAAAAAAAAAAAAAAPwAAAAAAAIC/");
  // 32767, 0, 0, 0 and 0, -32767, 0, 0, twice.
  EXPECT_EQ(scene["orientations"], "/38AAAAAAAAAAAGAAAAAAP9/AAAAAAAAAAABgAAAAAA=");
  EXPECT_EQ(scene["wall_points"], "AAAAvwAAAAAAAADAAAAAvwAAAAAAAADA");
  const Json& contacts = scene["contacts"];
  EXPECT_EQ(contacts["counts"], Json({2, 2}));
  EXPECT_EQ(contacts["deepest"], Json({0.02, 0.02}));
  EXPECT_EQ(contacts["largest_force"], 10.0);
  EXPECT_EQ(contacts["pairs"], "AAABAAAAAgAAAAEAAAACAA==");
  EXPECT_EQ(contacts["forces"], "AED/fwBA/38=");
  EXPECT_EQ(scene["end"]["steps"].get<double>(), 3e9);
  EXPECT_EQ(scene["end"]["hash"], "0123456789abcdef");
}

TEST_F(PlaybackReport, HasTheShapesOfWallsAndHowTheyTurn) {
  const Json scene = report_of({head_with_shapes(), frame_with_shapes()})["playbacks"][0];
  EXPECT_EQ(scene["walls"][0], Json({0.0, 0.0, 1.0}));
  EXPECT_EQ(scene["walls"][1], Json({0.0, 0.0, 0.0}));
  const Json& shapes = scene["wall_shapes"];
  ASSERT_EQ(shapes.size(), 6U);
  EXPECT_TRUE(shapes[0].is_null());
  EXPECT_EQ(shapes[1], Json::parse(R"({"radii": [0.5, 0.5], "heights": [-2.0, 2.0], "closed": [true, false]})"));
  EXPECT_EQ(shapes[2], Json::parse(R"({"radii": [0.0, 1.0], "heights": [0.0, 0.5], "closed": [false, false]})"));
  EXPECT_EQ(shapes[3], Json::parse(R"({"half_extents": [1.0, 0.5, 0.25]})"));
  // 0, 0, 0, 1, 0, 0, 0, -1/2, 0 as floats.
  EXPECT_EQ(shapes[4]["triangles"], "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAAL8AAAAA");
  EXPECT_TRUE(shapes[5].is_null());
  // 0, 0, 0, 32767, six times.
  EXPECT_EQ(scene["wall_orientations"], "AAAAAAAA/38AAAAAAAD/fwAAAAAAAP9/AAAAAAAA/38AAAAAAAD/fwAAAAAAAP9/");
}

TEST_F(PlaybackReport, IsWhatTheSchemaSays) {
  std::ifstream text(PLUMB_SOURCE_DIR "/reports/document/report-1.schema.json");
  const JsonSchema schema(Json::parse(text));
  Json report = report_of({head_with_shapes(), frame_with_shapes(), end()});
  EXPECT_TRUE(schema.allows(report));
  report["playbacks"][0]["wall_shapes"][1]["half_extents"] = {1.0, 1.0, 1.0};
  EXPECT_FALSE(schema.allows(report)) << "a wall of two shapes";
}

TEST_F(PlaybackReport, AFileOfBeforeHasNoShapesOfWalls) {
  Json old = head();
  old["walls"].push_back({{"normal", {0.0, 0.0, 1.0}}, {"shape", "cylinder"}});
  Json first = frame(0, 8);
  first["wall"] = {0.0, 0.0, -4.0, 0.0, 0.0, 0.0};
  const Json scene = report_of({old, first})["playbacks"][0];
  EXPECT_EQ(scene["wall_shapes"], Json({nullptr, nullptr}));
  EXPECT_EQ(scene["walls"][1], Json({0.0, 0.0, 0.0}));
  EXPECT_EQ(scene["wall_orientations"], "");
}

TEST_F(PlaybackReport, AWallThatCannotBeDrawnIsNamed) {
  const auto refuses_wall = [&](std::size_t wall, const char* shape, const Json& numbers, const std::string& reason) {
    Json bad = head_with_shapes();
    bad["walls"][wall][shape] = numbers;
    refuses({bad, frame_with_shapes()}, "1: walls[" + std::to_string(wall) + "]." + reason);
  };
  refuses_wall(1, "shape", "torus", "shape: must be one of mesh, cylinder, cone, box");
  refuses_wall(1, "cylinder", {{"radius", 1.0}}, "cylinder.half_length: missing");
  refuses_wall(1, "cylinder", {{"radius", 0.0}, {"half_length", 1.0}}, "cylinder.radius: must be above 0");
  refuses_wall(1, "cylinder", {{"radius", 1.0}, {"half_length", 1.0}, {"closed", {true, 0}}},
               "cylinder.closed[1]: must be true or false");
  refuses_wall(2, "cone", {{"radii", {0.0, 0.0}}}, "cone.radii: must not be below 0, nor both 0");
  refuses_wall(3, "box", {{"half_extents", {1.0, 1.0}}}, "box.half_extents: must be an array of 3 numbers, not 2");
  refuses_wall(4, "mesh", {{"triangles", {1.0, 1.0}}}, "mesh.triangles: must hold nine numbers a triangle");
  Json less = frame_with_shapes();
  less.erase("wall_orientation");
  refuses({head_with_shapes(), less}, "2: wall_orientation: missing");
}

TEST_F(PlaybackReport, AnEnergyThatAFrameDoesNotHaveIsNull) {
  Json first = frame(0, 8), second = frame(1, 4);
  first["energy"] = {{"kinetic", 1.0}};
  second["energy"] = {{"elastic", 2.0}, {"lost", nullptr}};
  const Json energy = report_of({head(), first, second})["playbacks"][0]["energy"];
  EXPECT_EQ(energy["kinetic"], Json({1.0, nullptr}));
  EXPECT_EQ(energy["elastic"], Json({nullptr, 2.0}));
  EXPECT_EQ(energy["lost"], Json({nullptr, nullptr}));
}

TEST_F(PlaybackReport, HasThePackingWhereTheSceneWroteIt) {
  Json first = frame(0, 8), second = frame(1, 4);
  second["bulk"] = {{"packing_fraction", 0.5}, {"coordination", nullptr}};
  const Json scene = report_of({head(), first, second})["playbacks"][0];
  EXPECT_EQ(scene["bulk"], Json({{"packing_fraction", {nullptr, 0.5}}, {"coordination", {nullptr, nullptr}}}));
  EXPECT_EQ(report_of({head(), first})["playbacks"][0]["bulk"], Json::object());
}

TEST_F(PlaybackReport, OfScenesAloneNothingOfCampaignsIsWritten) {
  const Json report = report_of({head(), frame(0, 8)});
  EXPECT_TRUE(report["playbacks"][0]["end"].is_null());
  EXPECT_NE(read("page.html").find("plumb/report-1"), std::string::npos);
  EXPECT_NE(read("page.md").find("- scene scene: 2 bodies, 1 frames to t = 0.0 - INCOMPLETE"), std::string::npos)
      << read("page.md");
  for (const char* absent : {"page.csv", "page.ladders.csv", "page.junit.xml", "page.sarif"})
    EXPECT_FALSE(fs::exists(path_ / absent)) << absent;
}

TEST_F(PlaybackReport, BesideACampaign) {
  ASSERT_EQ(plumb("campaign --family spheroid --cases 20 --seed 1 --method new_cn --out run 2>/dev/null").code, 0);
  fs::create_directories(path_ / "more");
  write("scene", lines({head(), frame(0, 8), end()}));
  write("more/scene", lines({head(), frame(0, 8)}));
  ASSERT_EQ(plumb("report scene run more/scene -o page.html").code, 0);
  const Json report = json("page.json");
  ASSERT_EQ(report["runs"].size(), 1u);
  EXPECT_EQ(report["runs"][0]["cases"], 20);
  ASSERT_EQ(report["playbacks"].size(), 2u);
  EXPECT_EQ(report["playbacks"][0]["name"], "scene") << "folders of one name are called by their paths";
  EXPECT_EQ(report["playbacks"][1]["name"], "more/scene");
  EXPECT_TRUE(fs::exists(path_ / "page.junit.xml"));
  EXPECT_NE(read("page.md").find("1 of 100 solves failed, hash 0123456789abcdef"), std::string::npos);
}

TEST_F(PlaybackReport, ADamagedLineIsNamed) {
  const auto with = [](Json line, const char* field, const Json& value) {
    line[field] = value;
    return line;
  };
  const Json good = frame(0, 8);
  refuses({frame(0, 8)}, "1: format: missing");
  refuses({with(head(), "format", "plumb/playback-2")}, R"(1: format: must be "plumb/playback-1")");
  refuses({with(head(), "bodies", Json::array())}, "1: bodies: is empty");
  refuses({with(head(), "walls", {{{"normal", {0.0, 0.0, 0.0}}}})}, "1: walls[0].normal: has a normal of length 0");
  refuses({head(), with(good, "position", {1.0, 2.0})}, "2: position: must be an array of 6 numbers, not 2");
  refuses({head(), with(good, "position", {0, 0, nullptr, 0, 0, 0})}, "2: position[2]: must be a number, not null");
  refuses({head(), with(good, "orientation", {0, 0, 0, 0, 1, 0, 0, 0})},
          "2: orientation[0]: begins a quaternion of length 0");
  refuses({head(), with(good, "contacts", {{1, 1, 0, 0, 0, 1, 0, 0, 0, 0}})},
          "2: contacts[0][1]: must be above the first body's");
  refuses({head(), with(good, "contacts", {{0, 3, 0, 0, 0, 1, 0, 0, 0, 0}})},
          "2: contacts[0][1]: must be a whole number from 0 to 2");
  refuses({head(), with(good, "energy", {1.0})}, "2: energy: must be an object");
  refuses({head(), frame(1, 8), frame(0.5, 8)}, "3: time: is before the frame before it");
  refuses({head(), good, end(), frame(1, 8)}, "4: end: stands in a line before, which is to be the last");
  Json bad_end = end();
  bad_end["end"]["hash"] = "short";
  refuses({head(), good, bad_end}, "3: end.hash: must be 16 hexadecimal digits");
  write("bad", head().dump() + "\n" + good.dump().substr(0, 40) + "\n");
  EXPECT_EQ(plumb("report bad -o page.html 2>/dev/null").code, 2);
  write("bad", head().dump() + "\n");
  expect_refusal("report bad -o page.html", "bad/playback.jsonl: holds no frame of plumb scene");
}

}  // namespace
}  // namespace plumb::reports
