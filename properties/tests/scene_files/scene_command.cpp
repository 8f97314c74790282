// plumb scene and plumb scenes: what they print and write, the one line on stderr, the exit code.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "corpus/scene/run_folder.hpp"
#include "properties/tests/corpus/programs.hpp"
#include "properties/tests/scene_files/scene_sample.hpp"
#include "solver/scene/named.hpp"

namespace plumb::scene {
namespace {

class SceneCommand : public Commands {
 protected:
  void SetUp() override {
    Commands::SetUp();
    (void)file("s.json", sample_scene());
  }
  /// The last line of a run's summary.
  [[nodiscard]] std::string hash(const std::string& arguments) const {
    const std::string out = plumb("scene s.json " + arguments).out;
    const std::size_t at = out.rfind("hash ");
    return at == std::string::npos ? out : out.substr(at + 5, 16);
  }
};

const std::string at_rest = R"({"format": "plumb/scene-1", "name": "still", "bodies": [)"
                            R"({"shape": {"superellipsoid": {"semi_axes": [1, 1, 1]}}, "position": [0, 0, 0.5],)"
                            R"( "orientation": {"quaternion_wxyz": [1, 0, 0, 0]}, "fixed": true},)"
                            R"( {"shape": {"superellipsoid": {"semi_axes": [1, 1, 1]}}, "position": [1.5, 0, 3],)"
                            R"( "orientation": {"quaternion_wxyz": [1, 0, 0, 0]}, "fixed": true},)"
                            R"( {"shape": {"superellipsoid": {"semi_axes": [1, 1, 1]}}, "position": [1.5, 0, 1.5],)"
                            R"( "orientation": {"quaternion_wxyz": [1, 0, 0, 0]}, "fixed": true}],)"
                            R"( "walls": [{"point": [0, 0, 0], "normal": [0, 0, 2]}],)"
                            R"( "run": {"duration": 1, "outputs": {"write": ["WORD"]}}})";

std::string still_scene(const std::string& word) {
  std::string text = at_rest;
  return text.replace(text.find("WORD"), 4, word);
}

TEST_F(SceneCommand, ThePlanSaysWhatRunsAndWhy) {
  const Ran ran = plumb("scene s.json --plan");
  EXPECT_EQ(ran.code, 0);
  for (const char* text : {"sample: 3 bodies, 1 walls; ", "gravity       on ", "cohesion      off", "not asked for",
                           "needs contacts, points, spin, normal_force", "time step ", "broad phase "})
    EXPECT_NE(ran.out.find(text), std::string::npos) << text << "\n" << ran.out;
  EXPECT_EQ(ran.out.find("hash"), std::string::npos);
}

TEST_F(SceneCommand, ThePlanAsJsonHasEveryEffect) {
  const Json plan = lines_of(plumb("scene s.json --plan --json").out).at(0);
  EXPECT_EQ(plan["effects"].size(), effects().size());
  for (const Json& effect : plan["effects"]) {
    EXPECT_TRUE(effect.contains("why"));
    EXPECT_EQ(effect.contains("memory"), effect["on"].get<bool>()) << effect;
    EXPECT_FALSE(effect.contains("share"));
  }
  EXPECT_EQ(plan["analysis"], "motion");
  EXPECT_GT(plan["time_step"]["value"].get<double>(), 0);
  EXPECT_EQ(plan["turning"]["bodies"], 3);
}

TEST_F(SceneCommand, ARunMeasuresTheShareOfEachEffect) {
  const Json run = lines_of(plumb("scene s.json --json").out).at(0);
  double sum = 0;
  for (const Json& effect : run["plan"]["effects"]) sum += effect.value("share", 0.0);
  for (const auto& [owner, costs] : run["plan"]["others"].items()) sum += costs.value("share", 0.0);
  EXPECT_NEAR(sum, 1, 1e-9);
  EXPECT_EQ(run["complete"], true);
  EXPECT_EQ(run["totals"]["failed"], 0);
  EXPECT_EQ(run["totals"]["steps"], run["plan"]["steps"]);
  EXPECT_TRUE(run["energy"]["first"].contains("total"));
}

TEST_F(SceneCommand, TheHashIsThatOfAnyNumberOfThreads) {
  const std::string one = hash("--threads 1");
  EXPECT_EQ(one.size(), 16U);
  EXPECT_EQ(hash("--threads 2"), one);
  EXPECT_EQ(hash("--threads 3"), one);
  EXPECT_EQ(hash("--out a --record"), one);
  EXPECT_NE(hash("--accuracy 0.01"), one);
}

TEST_F(SceneCommand, WithoutAFolderNothingIsWritten) {
  EXPECT_EQ(plumb("scene s.json").code, 0);
  EXPECT_EQ(std::distance(fs::directory_iterator(path_), fs::directory_iterator()), 1);
}

TEST_F(SceneCommand, OutputsParseBack) {
  ASSERT_EQ(plumb("scene s.json --out a").code, 0);
  const Json run = json("a/run.json");
  EXPECT_EQ(run["complete"], true);
  const std::size_t frames = 11;
  const auto contacts = lines_of(read("a/contacts.jsonl")), touching = lines_of(read("a/touching.jsonl"));
  ASSERT_EQ(contacts.size(), frames);
  ASSERT_EQ(touching.size(), frames);
  std::size_t found = 0;
  for (std::size_t k = 0; k < frames; ++k) {
    EXPECT_NEAR(contacts[k]["time"].get<double>(), 0.05 * static_cast<double>(k), 1e-9);
    found += contacts[k]["contacts"].size();
    EXPECT_EQ(contacts[k]["contacts"].size(), touching[k]["touching"].size() + touching[k]["walls"].size());
    for (const Json& contact : contacts[k]["contacts"]) {
      EXPECT_TRUE(contact.contains("bodies") != contact.contains("wall")) << contact;
      EXPECT_GT(contact["overlap"].get<double>(), 0);
      EXPECT_EQ(contact["point"].size(), 3U);
      EXPECT_TRUE(contact["force"].is_number());
      EXPECT_EQ(contact["total_force"].size(), 3U);
    }
  }
  EXPECT_GT(found, 3U);
  EXPECT_EQ(parse_scene(read("a/scene.json"), "a").scene.bodies.size(), 3U);
}

TEST_F(SceneCommand, TheDumpHasAColumnForEachName) {
  ASSERT_EQ(plumb("scene s.json --out a").code, 0);
  std::istringstream in(read("a/dump.lammpstrj"));
  std::vector<std::string> names;
  int frames = 0, rows = 0;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    const std::vector<std::string> parts{std::istream_iterator<std::string>(words), {}};
    if (line.starts_with("ITEM: ATOMS")) {
      names.assign(parts.begin() + 2, parts.end());
      ++frames;
    } else if (parts.size() > 6) {
      ++rows;
      EXPECT_EQ(parts.size(), names.size());
    }
  }
  EXPECT_EQ(frames, 11);
  EXPECT_EQ(rows, 33);
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
}

TEST_F(SceneCommand, PlaybackHasTheFormatOfThePage) {
  ASSERT_EQ(plumb("scene s.json --out a").code, 0);
  const auto lines = lines_of(read("a/playback.jsonl"));
  ASSERT_EQ(lines.size(), 13U);
  const Json& head = lines.front();
  EXPECT_EQ(head["format"], "plumb/playback-1");
  EXPECT_EQ(head["bodies"][1]["semi_axes"], Json::parse("[1.0, 0.8, 0.6]"));
  EXPECT_EQ(head["bodies"][0]["exponents"], Json::parse("[4.0, 4.0]"));
  EXPECT_EQ(head["walls"].size(), 1U);
  EXPECT_EQ(head["accuracy"], 0.001);
  for (std::size_t k = 1; k + 1 < lines.size(); ++k) {
    EXPECT_EQ(lines[k]["position"].size(), 9U);
    EXPECT_EQ(lines[k]["orientation"].size(), 12U);
    EXPECT_EQ(lines[k]["wall"].size(), 3U);
    EXPECT_TRUE(lines[k]["energy"].contains("total"));
    for (const Json& contact : lines[k]["contacts"]) EXPECT_EQ(contact.size(), 10U);
  }
  const Json run = json("a/run.json");
  EXPECT_EQ(lines.back()["end"]["hash"], run["hash"]);
  EXPECT_EQ(lines.back()["end"]["steps"], run["totals"]["steps"]);
}

TEST_F(SceneCommand, VtkIndexesNameTheirFiles) {
  ASSERT_EQ(plumb("scene s.json --out a").code, 0);
  for (const char* what : {"bodies", "contacts"}) {
    const std::string index = read(fmt::format("a/vtk/{}.pvd", what));
    EXPECT_TRUE(index.ends_with("</Collection>\n</VTKFile>\n"));
    int files = 0;
    for (std::size_t at = 0; (at = index.find("file=\"", at)) != std::string::npos; ++files) {
      at += 6;
      const std::string frame = read("a/vtk/" + index.substr(at, index.find('"', at) - at));
      EXPECT_TRUE(frame.ends_with("</VTKFile>\n"));
    }
    EXPECT_EQ(files, 11);
  }
  const std::string bodies = read("a/vtk/bodies_0000000000.vtp");
  for (const char* name : {"semi_axes", "exponents", "axes", "roundness_phi", "quaternion_wxyz", "velocity"})
    EXPECT_NE(bodies.find(fmt::format("Name=\"{}\"", name)), std::string::npos) << name;
}

TEST_F(SceneCommand, StillBodiesAreAnAnalysis) {
  (void)file("t.json", still_scene("touching"));
  const Json touching = lines_of(plumb("scene t.json --json").out).at(0)["found"];
  EXPECT_EQ(touching["touching"], Json::parse("[[0, 2], [1, 2]]"));
  EXPECT_EQ(touching["walls"], Json::parse("[[0, 0]]"));
  EXPECT_NE(plumb("scene t.json").out.find("3 touching\n  0 2\n  0 wall 0\n  1 2\n"), std::string::npos);
  (void)file("c.json", still_scene("contacts"));
  const Json contacts = lines_of(plumb("scene c.json --json").out).at(0)["found"]["contacts"];
  ASSERT_EQ(contacts.size(), 3U);
  EXPECT_NEAR(contacts[2]["overlap"].get<double>(), 0.5, 1e-9);
  EXPECT_FALSE(contacts[0].contains("force"));
  EXPECT_EQ(plumb("scene c.json --out b").code, 0);
  EXPECT_EQ(lines_of(read("b/contacts.jsonl")).at(0)["contacts"], contacts);
}

TEST_F(SceneCommand, UnusableScenesAndUsageAreOneLineAndTwo) {
  (void)file("bad.json", sample_scene_with("10000", "-1"));
  expect_refusal("scene bad.json", "bad.json: effects.linear.stiffness: must be a number, 0 or more");
  expect_refusal("scene bad.json --plan", "bad.json: effects.linear.stiffness: must be a number, 0 or more");
  expect_refusal("scene - <bad.json", "standard input: effects.linear.stiffness: must be a number, 0 or more");
  (void)file("none.json", sample_scene_of(R"({"friction": {"coefficient": 1}})"));
  expect_refusal("scene none.json", "none.json: effects.friction: is a share of a normal force, and there is none: add "
                                    "linear, hertz, volume or foundation");
  expect_refusal("scene nowhere.json", "nowhere.json: No such file or directory");
  std::string effects;
  for (const Effect& effect : plumb::scene::effects())
    effects += (effects.empty() ? "" : ", ") + std::string(effect.name);
  expect_refusal("scene s.json --force lift",
                 "plumb scene: --force: lift: no such effect; there are " + effects + " (--help tells more)");
  expect_refusal("scene s.json --accuracy 2",
                 "plumb scene: --accuracy: must be a number between 0 and 1 (--help tells more)");
  for (const char* arguments : {"scene", "scene s.json --resume", "scene s.json --record", "scene s.json --threads 0",
                                "scene s.json --checkpoint 0", "scene s.json --accuracy much"}) {
    const Ran ran = plumb(std::string(arguments) + " 2>&1 >/dev/null");
    EXPECT_EQ(ran.code, 2) << arguments;
    EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 1) << ran.out;
  }
}

TEST_F(SceneCommand, WhatCannotBeWrittenIsOneLineAndTwo) {
  (void)file("b", "a file");
  expect_refusal("scene s.json --out b", "b: Not a directory");
  const Ran full = plumb("scene s.json 2>&1 >/dev/full");
  EXPECT_EQ(full.code, 2);
  EXPECT_EQ(full.out, "standard output: No space left on device\n");
}

// A step far too long for the drag: the run stops where a body is nowhere any more, and says so.
TEST_F(SceneCommand, ARunThatDivergesIsAFinding) {
  std::string text = sample_scene_of(R"({"gravity": {"acceleration": [0, 0, -10]}, "drag": {"viscosity": 1000}})");
  const std::string duration = R"("duration": 0.5)";
  text.replace(text.find(duration), duration.size(), R"("duration": 5000, "time_step": 1)");
  (void)file("far.json", text);
  const Ran ran = plumb("scene far.json --out far 2>&1 >/dev/null");
  EXPECT_EQ(ran.code, 1);
  EXPECT_TRUE(ran.out.starts_with("far.json: run.time_step: body ") &&
              ran.out.ends_with(" is too long for the forces\n"))
      << ran.out;
  EXPECT_EQ(json("far/run.json")["complete"], false);
  EXPECT_NE(plumb("scene far.json --plan").out.find("times as long as what the effects allow"), std::string::npos);
}

TEST_F(SceneCommand, EnergiesAreASeries) {
  (void)file("steps.json", sample_scene_with("0.05", "\"step\""));
  for (const char* name : {"s", "steps"}) {
    ASSERT_EQ(plumb(std::string("scene ") + name + ".json --out " + name).code, 0);
    const Json run = json(std::string(name) + "/run.json");
    const auto series = lines_of(read(std::string(name) + "/energy.jsonl"));
    EXPECT_EQ(series.front()["energy"], run["energy"]["first"]);
    EXPECT_EQ(series.back()["energy"], run["energy"]["last"]);
    EXPECT_EQ(series.size(), run["plan"]["frames"]);
    const double bytes = static_cast<double>(read(std::string(name) + "/energy.jsonl").size());
    EXPECT_LT(bytes / static_cast<double>(series.size()), 400);  // 200 are expected
  }
  const Json run = json("steps/run.json");
  EXPECT_EQ(run["plan"]["frames"], run["plan"]["steps"].get<int>() + 1);
  EXPECT_EQ(parse_scene(read("steps/scene.json"), "steps").scene.run.outputs.every_step, true);
}

TEST_F(SceneCommand, LivesAreALineEach) {
  ASSERT_EQ(plumb("scene s.json --out s").code, 0);
  const auto lives = lines_of(read("s/lives.jsonl"));
  ASSERT_FALSE(lives.empty());
  for (const Json& life : lives) {
    EXPECT_TRUE(life.contains("bodies") || (life.contains("body") && life.contains("wall"))) << life.dump();
    EXPECT_GT(life["duration"].get<double>(), 0);
    EXPECT_GT(life["greatest_overlap"].get<double>(), 0);
    EXPECT_GE(life["greatest_force"].get<double>(), 0);
    EXPECT_TRUE(life["ended"].is_boolean());
  }
}

TEST_F(SceneCommand, BulkIsALineAFrame) {
  (void)file("b.json", sample_scene_with_region("[-1, -1, 0]", "[1, 1, 3]"));
  ASSERT_EQ(plumb("scene b.json --out s").code, 0);
  const auto lines = lines_of(read("s/bulk.jsonl"));
  EXPECT_EQ(lines.size(), json("s/run.json")["plan"]["frames"]);
  EXPECT_EQ(lines.front()["region"], Json::parse(R"({"low": [-1.0, -1.0, 0.0], "high": [1.0, 1.0, 3.0]})"));
  EXPECT_EQ(lines.front()["bodies"], 1);  // the others' centres are above
  EXPECT_GT(lines.front()["packing_fraction"].get<double>(), 0.4);
  EXPECT_LT(lines.back()["stress"][2][2].get<double>(), 0);
  EXPECT_GE(lines.back()["coordination"].get<double>(), 1);
}

// A ball at -0.5 touches one at 9 through the side of a box of ten: what is written is within the box, and a playback goes on beyond it.
TEST_F(SceneCommand, APeriodicBoxHasAllOfItsBodiesWithinIt) {
  const auto body = [](const char* x) {
    return fmt::format(R"({{"shape": {{"superellipsoid": {{"semi_axes": [1, 1, 1]}}}}, "position": [{}, 5, 5],
      "orientation": {{"quaternion_wxyz": [1, 0, 0, 0]}}}})",
                       x);
  };
  (void)file("p.json",
             fmt::format(R"({{"format": "plumb/scene-1", "bodies": [{}, {}], "effects": {{"linear": {{"stiffness": 10}},
    "periodic_box": {{"sides": [10, 12, 0], "rate": [0.1, 0, 0]}}}},
    "run": {{"duration": 0.01, "outputs": {{"write": ["contacts", "dump", "vtk", "playback", "bulk"]}}}}}})",
                         body("-0.5"), body("9")));
  ASSERT_EQ(plumb("scene p.json --out s").code, 0);
  EXPECT_NE(read("s/dump.lammpstrj").find("BOX BOUNDS pp pp ss\n0 10\n0 12\n4 6\n"), std::string::npos);
  EXPECT_NE(read("s/dump.lammpstrj").find("\n1 1 9.5 5 5 "), std::string::npos);
  const Json contact = lines_of(read("s/contacts.jsonl")).front()["contacts"][0];
  EXPECT_EQ(contact["normal"], Json({-1.0, 0.0, 0.0}));
  EXPECT_NEAR(contact["point"][0].get<double>(), 9.25, 1e-12);
  EXPECT_NE(read("s/vtk/bodies_0000000000.vtp").find("\n9.5 5 5 "), std::string::npos);
  const Json frame = lines_of(read("s/playback.jsonl")).at(1);
  EXPECT_EQ(frame["position"][0], -0.5);
  EXPECT_NEAR(frame["contacts"][0][2].get<double>(), -0.75, 1e-9);
  EXPECT_GT(frame["bulk"]["packing_fraction"].get<double>(), 0);
  EXPECT_EQ(frame["bulk"]["coordination"], 1.0);
}

TEST_F(SceneCommand, ThePlanSaysWhatEachPairOfMaterialsHas) {
  (void)file("m.json", sample_with_materials());
  const std::string table = plumb("scene m.json --plan").out;
  EXPECT_NE(table.find("\nglass and glass: linear 10000, damping 0.5, friction 0.4\n"), std::string::npos) << table;
  EXPECT_NE(table.find("\nglass and floor: linear 20000, damping 0.5, friction 0.2 (given)\n"), std::string::npos)
      << table;
  const Json plan = lines_of(plumb("scene m.json --plan --json").out).at(0);
  EXPECT_EQ(plan["materials"].size(), 2U);
  EXPECT_EQ(plumb("scene m.json --out m").code, 0);
}

// The plan says what a run writes; what no disk holds is refused before anything is there.
TEST_F(SceneCommand, FramesBeyondTheDiskAreRefused) {
  EXPECT_NE(plumb("scene s.json --plan").out.find("; 11 frames, about "), std::string::npos);
  const Json plan = lines_of(plumb("scene s.json --plan --json").out).at(0);
  EXPECT_EQ(plan["frames"], 11);
  ASSERT_EQ(plumb("scene s.json --out a").code, 0);
  double written = 0;
  for (const auto& entry : fs::recursive_directory_iterator(path_ / "a"))
    if (entry.is_regular_file()) written += static_cast<double>(entry.file_size());
  EXPECT_LT(std::abs(std::log(plan["expected_bytes"].get<double>() / written)), std::log(4.0));
  std::string text = sample_scene_with("0.05", "1e-13");
  const std::string duration = R"("duration": 0.5)";
  text.replace(text.find(duration), duration.size(), R"("duration": 10)");
  (void)file("many.json", text);
  const Ran ran = plumb("scene many.json --out many 2>&1");
  EXPECT_EQ(ran.code, 2);
  EXPECT_TRUE(ran.out.starts_with("many.json: run.outputs.every: asks for 1000000") &&
              ran.out.find(" frames, about ") != std::string::npos &&
              ran.out.find("has room for about ") != std::string::npos)
      << ran.out;
  EXPECT_FALSE(fs::exists(path_ / "many"));
}

TEST_F(SceneCommand, AFolderIsOneRunsAtATime) {
  (void)file("s.json", sample_scene());
  ASSERT_EQ(plumb("scene s.json --out run").code, 0);
  {
    const FolderLock first(path_ / "run");
    std::string holder = read("run/.plumb-lock");
    holder.pop_back();
    EXPECT_TRUE(holder.starts_with(fmt::format("process {} on ", ::getpid()))) << holder;
    expect_refusal("scene s.json --out run --resume", "run: another run is writing there (" + holder + ")");
  }
  EXPECT_EQ(plumb("scene s.json --out run --resume").code, 0);
}

TEST_F(SceneCommand, ForcedEffectsAreOn) {
  (void)file("bare.json", sample_scene_of(R"({"linear": {"stiffness": 10000}})"));
  const Json plan = lines_of(plumb("scene bare.json --plan --json --force gravity --force cohesion").out).at(0);
  for (const Json& effect : plan["effects"])
    if (effect["name"] == "gravity" || effect["name"] == "cohesion") {
      EXPECT_TRUE(effect["on"].get<bool>() && effect["why"].get<std::string>().starts_with("forced on")) << effect;
    }
}

TEST(SceneFiles, AreTheNamedScenes) {
  for (const NamedScene& named : named_scenes()) {
    const std::string path = fmt::format("{}/corpus/scenes/{}.json", PLUMB_SOURCE_DIR, named.name);
    EXPECT_EQ(format_scene(read_scene(path)),
              format_scene({named.make(named.bodies), {{"named_scene", named.name}}, {}}))
        << "plumb scenes " << named.name << " > " << path;
  }
}

TEST_F(SceneCommand, NamedScenesAreListedAndWritten) {
  const Ran list = plumb("scenes");
  EXPECT_EQ(list.code, 0);
  EXPECT_EQ(static_cast<std::size_t>(std::count(list.out.begin(), list.out.end(), '\n')), named_scenes().size());
  for (const NamedScene& named : named_scenes()) {
    const std::string text = plumb(fmt::format("scenes {}", named.name)).out;
    const SceneFile read = parse_scene(text, "named");
    EXPECT_EQ(format_scene(read) + "\n", text) << named.name;
    EXPECT_EQ(read.scene.name, named.name);
  }
  EXPECT_EQ(parse_scene(plumb("scenes pile --bodies 7").out, "pile").scene.bodies.size(), 7U);
  expect_refusal("scenes nobody", "nobody: no such scene; plumb scenes lists them");
  expect_refusal("scenes impact --bodies 3", "--bodies: is fixed in impact");
}

}  // namespace
}  // namespace plumb::scene
