// plumb import and plumb export: what they print and write, the one line on stderr, the exit code.
#include <fmt/format.h>
#include <rapidcheck/gtest.h>
#include <sys/stat.h>

#include "corpus/dump/dump_text.hpp"
#include "corpus/json/fields.hpp"
#include "properties/generators/generators.hpp"
#include "properties/tests/corpus/programs.hpp"
#include "properties/tests/dump/dumps.hpp"
#include "properties/tests/interrupting.hpp"

namespace plumb {
namespace {

class DumpCommands : public Commands {
 protected:
  [[nodiscard]] std::vector<Json> imported(const std::string& arguments) const {
    return lines_of(plumb("import " + arguments + " 2>/dev/null").out);
  }
  /// A named scene that is run, or looked at, for a short time; its pairs by the run and by its dump.
  void expect_agreement(const std::string& name, double duration) const;
};

const DumpText touching{
    .columns = lammps_columns + " element",
    .rows = {"57 1 1.5 0 0 2 0 0 0 2 2 2 2 2 Fe", "12 1 0 0 0 1 0 0 0 2 2 2 2 2 Ni", "9 1 5 5 5 1 0 0 0 2 2 2 2 2 Ni"},
    .before = "ITEM: UNITS\nsi\nITEM: TIME\n0.25\n"};

std::string at_step(const std::string& step) {
  DumpText out = touching;
  out.step = step;
  return out.text();
}

std::vector<std::string> names_of(const std::vector<Json>& cases) {
  std::vector<std::string> out;
  for (const Json& c : cases) out.push_back(c["name"]);
  return out;
}
using Names = std::vector<std::string>;

TEST_F(DumpCommands, ACaseNamesStepAndIdsAndWhereItIsFrom) {
  (void)file("d.dump", touching.text());
  const Ran ran = plumb("import d.dump 2>said");
  EXPECT_EQ(ran.code, 0);
  EXPECT_EQ(ran.out,
            R"({"format": "plumb/case-1", "name": "step100-12-57", "bodies": [)"
            R"({"shape": {"superellipsoid": {"semi_axes": [1, 1, 1], "exponents": [2, 2]}}, "position": [0, 0, 0],)"
            R"( "orientation": {"quaternion_wxyz": [1, 0, 0, 0]}},)"
            R"( {"shape": {"superellipsoid": {"semi_axes": [1, 1, 1], "exponents": [2, 2]}}, "position": [1.5, 0, 0],)"
            R"( "orientation": {"quaternion_wxyz": [2, 0, 0, 0]}}],)"
            R"( "provenance": {"source": "plumb import", "file": "d.dump", "format": "lammps", "step": 100,)"
            R"( "time": 0.25, "units": "si", "ids": [12, 57]}})"
            "\n");
  EXPECT_EQ(read("said"), "1 frames, 3 particles, 1 pairs\n");
}

TEST_F(DumpCommands, TheSameInAFile) {
  (void)file("d.dump", touching.text());
  EXPECT_EQ(plumb("import d.dump -o cases.jsonl 2>&1").out, "1 frames, 3 particles, 1 pairs\n");
  EXPECT_EQ(read("cases.jsonl"), plumb("import - 2>/dev/null < d.dump | sed 's/standard input/d.dump/'").out);
}

TEST_F(DumpCommands, PointsAreLeftOutAndCounted) {
  DumpText dump = touching;
  dump.rows.emplace_back("13 1 0 0 0 0 0 0 0 0 0 0 0 0 Ni");
  (void)file("d.dump", dump.text());
  EXPECT_EQ(plumb("import d.dump 2>&1 >/dev/null").out,
            "1 frames, 3 particles, 1 pairs; left out: 1 points (shape and radius 0)\n");
}

TEST_F(DumpCommands, StepsAreChosen) {
  (void)file("a.dump", at_step("100") + at_step("300"));
  (void)file("b.dump", at_step("200"));
  EXPECT_EQ(names_of(imported("a.dump b.dump")),
            (Names{"file1-step100-12-57", "file1-step300-12-57", "file2-step200-12-57"}));
  EXPECT_EQ(names_of(imported("a.dump b.dump --step last")), Names{"file1-step300-12-57"});
  EXPECT_EQ(names_of(imported("a.dump b.dump --step 200")), Names{"file2-step200-12-57"});
}

TEST_F(DumpCommands, ImagesOfOneParticleAreCasesOfTheirOwn) {
  DumpText dump{.columns = "id x y z radius", .rows = {"1 0.5 5 5 1", "2 2 5 5 1"}};
  dump.box = "ITEM: BOX BOUNDS pp ff ff\n0 3\n0 10\n0 10\n";
  (void)file("d.dump", dump.text());
  const std::vector<Json> cases = imported("d.dump");
  EXPECT_EQ(names_of(cases), (Names{"step100-1-2", "step100-1-2-image2"}));
  EXPECT_EQ(cases.at(0)["provenance"]["image"], Json({-1, 0, 0}));
}

TEST_F(DumpCommands, RefusalsAreOneLineAfterTheAnswersBefore) {
  DumpText broken = touching;
  broken.rows[0] = "57 1 x";
  (void)file("d.dump", touching.text() + broken.text());
  const Ran ran = plumb("import d.dump 2>said");
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(lines_of(ran.out).size(), 1U);
  EXPECT_EQ(read("said"), "d.dump:30: ATOMS: 3 values in a row of 15 columns\n");
  expect_refusal("import d.dump --step 7", "d.dump: step 7: holds no such frame");
  expect_refusal("import none.dump", "none.dump: No such file or directory");
  expect_refusal("import d.dump --column x", "--column: x: is not ROLE=NAME");
  expect_refusal("import d.dump --gap -1",
                 "plumb import: --gap: '-1' is not a number from 0 to 1e6 (--help tells more)");
  expect_refusal("import d.dump --step 1.5",
                 "plumb import: --step: '1.5' is no step: a whole number, last or all (--help tells more)");
  DumpText small{.columns = "id x y z radius", .rows = {"1 0 0 0 1e9"}};
  small.box = "ITEM: BOX BOUNDS pp pp pp\n0 1\n0 1\n0 1\n";
  (void)file("s.dump", small.text());
  expect_refusal("import s.dump", "s.dump: step 100: the box is too small for its particles: over 2e7 images");
  // What was taken for what is told of a dump that was read, not beside a refusal.
  DumpText shaped{.columns = "id x y z shapex shapey shapez", .rows = {"1 0 0 0 1e9 1e9 1e9"}};
  shaped.box = small.box;
  (void)file("s.dump", shaped.text());
  expect_refusal("import s.dump --format lammps --step last",
                 "s.dump: step 100: the box is too small for its particles: over 2e7 images");
  expect_refusal("import - </dev/null", "standard input: holds no such frame");
}

TEST_F(DumpCommands, AFileIsReplacedWhenAllOfItIsThere) {
  const auto expect_old = [&](const std::string& arguments, const std::string& said) {
    (void)file("out", "old\n");
    const Ran ran = plumb(arguments + " -o out 2>&1");
    EXPECT_EQ(ran.code, 2) << arguments;
    EXPECT_EQ(ran.out, said);
    EXPECT_EQ(read("out"), "old\n") << arguments;
    for (const auto& entry : fs::directory_iterator(path_)) EXPECT_NE(entry.path().extension(), ".tmp") << arguments;
  };
  DumpText broken = touching;
  broken.rows[0] = "57 1 x";
  (void)file("d.dump", touching.text() + broken.text());
  expect_old("import d.dump", "d.dump:30: ATOMS: 3 values in a row of 15 columns\n");
  std::string cases;
  for (int i = 0; i < 8; ++i) cases += sample_case() + "\n";
  (void)file("c.jsonl", cases + "{}\n");
  expect_old("export c.jsonl", "c.jsonl:9: format: missing\n");
  (void)file("good.jsonl", cases);
  // As a disk that is full: no file may grow beyond a kilobyte or two.
  expect_old("--version > /dev/null && trap '' XFSZ && ulimit -f 2 && " + plumb_program + "export good.jsonl",
             "out: File too large\n");
  EXPECT_EQ(plumb("export good.jsonl -o out").code, 0);
  EXPECT_EQ(read("out"), plumb("export good.jsonl").out);
}

TEST_F(DumpCommands, WhatIsNoRegularFileIsWrittenToAtOnce) {
  (void)file("c.json", sample_case());
  EXPECT_EQ(plumb("export c.json -o /dev/stdout").out, plumb("export c.json").out);
  expect_refusal("export c.json -o /dev/full", "/dev/full: No space left on device");
}

void DumpCommands::expect_agreement(const std::string& name, double duration) const {
  Json scene = Json::parse(std::ifstream(std::string(PLUMB_SOURCE_DIR) + "/corpus/scenes/" + name + ".json"));
  scene["run"]["duration"] = duration;
  scene["run"]["outputs"] = {{"every", duration / 4}, {"write", {"touching", "dump"}}};
  (void)file(name + ".json", write_json(scene));
  ASSERT_EQ(plumb("scene " + name + ".json --out " + name + " >/dev/null").code, 0);
  std::vector<std::array<std::int64_t, 3>> by_run, by_dump;
  for (const Json& frame : lines_of(read(name + "/touching.jsonl")))
    for (const Json& pair : frame["touching"])
      by_run.push_back({frame["step"], pair[0].get<int>() + 1, pair[1].get<int>() + 1});
  for (const Json& c : imported(name + "/dump.lammpstrj"))
    by_dump.push_back({c["provenance"]["step"], c["provenance"]["ids"][0], c["provenance"]["ids"][1]});
  std::ranges::sort(by_run);
  std::ranges::sort(by_dump);
  EXPECT_FALSE(by_run.empty()) << name;
  EXPECT_EQ(by_dump, by_run) << name;
}

TEST_F(DumpCommands, ADumpOfASceneHasThePairsThatTouchInIt) {
  expect_agreement("pile", 0.05);
  expect_agreement("tower", 0.02);
}

TEST_F(DumpCommands, EachCaseIsAFrameOfTwo) {
  (void)file("c.jsonl", sample_case() + "\n" + sample_case() + "\n");
  EXPECT_EQ(plumb("export c.jsonl --format liggghts | head -11").out,
            "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ss ss ss\n-1 2.5\n-1 1\n-1 1\n"
            "ITEM: ATOMS id type x y z quat1 quat2 quat3 quat4 shapex shapey shapez blockiness1 blockiness2\n"
            "1 1 0 0 0 1 0 0 0 1 1 1 2 2\n"
            "2 2 1.5 0 0 0.9689124217106447 0.24740395925452294 0 0 1 1 1 2 2\n");
  EXPECT_EQ(plumb("export c.jsonl | sed -n '9,10p;13p'").out,
            "ITEM: ATOMS id type x y z quatw quati quatj quatk shapex shapey shapez block1 block2 "
            "SuperquadricRoundness.Phi SuperquadricRoundness.Theta\n1 1 0 0 0 1 0 0 0 2 2 2 2 2 1 1\n1\n");
}

TEST_F(DumpCommands, ASceneIsOneFrameAndItsWallsAreTold) {
  const std::string scene = std::string(PLUMB_SOURCE_DIR) + "/corpus/scenes/dice.json";
  const Ran ran = plumb("export " + scene + " -o d.dump 2>&1");
  EXPECT_EQ(ran.code, 0);
  EXPECT_NE(ran.out.find(" walls left out: a dump holds none\n"), std::string::npos) << ran.out;
  const DumpFrame frame = frames_of(read("d.dump")).at(0);
  const Json bodies = Json::parse(std::ifstream(scene))["bodies"];
  ASSERT_EQ(frame.particles.size(), bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i)
    EXPECT_EQ(vector_json(frame.particles[i].body.position), bodies[i]["position"]);
}

TEST_F(DumpCommands, WhatNoDumpHoldsIsNotExported) {
  (void)file("c.json", sample_with("[1.5, 0, 0]", "[1e101, 0, 0]"));
  expect_refusal("export c.json", "c.json: bodies[1].position: is beyond 1e100");
  (void)file("c.json", "{}");
  expect_refusal("export c.json", "c.json: format: missing");
  (void)file("c.jsonl", "");
  expect_refusal("export c.jsonl", "c.jsonl: holds no case and no scene");
}

TEST_F(DumpCommands, AnInterruptEndsItWith130) {
  (void)file("d.dump", touching.text());
  ASSERT_EQ(::mkfifo((path_ / "pipe").c_str(), 0600), 0);
  const int pipe = ::open((path_ / "pipe").c_str(), O_RDWR | O_CLOEXEC);  // nobody writes to it
  const pid_t child = start_command("cd " + path_.string() + " && exec " + std::string(PLUMB_BINARY_DIR) +
                                    "/bin/plumb-import d.dump - < pipe > cases.jsonl 2> said");
  const auto waits_at_the_pipe = [&](pid_t process) { return !read("cases.jsonl").empty() && is_asleep(process); };
  EXPECT_EQ(interrupt_when(child, waits_at_the_pipe), 130);
  ::close(pipe);
  EXPECT_EQ(lines_of(read("cases.jsonl")).size(), 1U);
  EXPECT_EQ(read("said"), "1 frames, 3 particles, 1 pairs; interrupted: incomplete\n");
}

TEST_F(DumpCommands, AnInterruptLeavesTheOldFileAndWhatWasDoneBesideIt) {
  (void)file("d.dump", touching.text());
  (void)file("cases.jsonl", "old\n");
  ASSERT_EQ(::mkfifo((path_ / "pipe").c_str(), 0600), 0);
  const int pipe = ::open((path_ / "pipe").c_str(), O_RDWR | O_CLOEXEC);  // nobody writes to it
  const pid_t child = start_command("cd " + path_.string() + " && exec " + std::string(PLUMB_BINARY_DIR) +
                                    "/bin/plumb-import d.dump - -o cases.jsonl < pipe 2> said");
  const auto has_begun = [&](pid_t process) {
    for (const auto& entry : fs::directory_iterator(path_))
      if (entry.path().extension() == ".tmp" && fs::file_size(entry.path()) > 0 && is_asleep(process)) return true;
    return false;
  };
  EXPECT_EQ(interrupt_when(child, has_begun), 130);
  ::close(pipe);
  EXPECT_EQ(read("cases.jsonl"), "old\n");
  EXPECT_EQ(lines_of(read("cases.jsonl.incomplete")).size(), 1U);
}

RC_GTEST_PROP(DumpText, EveryCaseReadsBackToTheSameDoubles, ()) {
  const std::string family(*rc::gen::element<std::string_view>("spheroid", "ellipsoid", "superquadric", "hard"));
  const Pair pair = (*generators::case_of(family)).pair;
  for (const DumpFormat format : {DumpFormat::lammps, DumpFormat::liggghts}) {
    std::string text = dump_head(0, {}, 2, {Vec3<double>::Zero(), Vec3<double>::Ones()}, dump_column_names(format));
    add_dump_body(text, format, 1, 1, pair.body1);
    text += "\n";
    add_dump_body(text, format, 2, 2, pair.body2);
    const DumpFrame frame = frames_of(text + "\n").at(0);
    RC_ASSERT(frame.format == format);
    const Pair back{frame.particles.at(0).body, frame.particles.at(1).body};
    RC_ASSERT(write_json(bodies_json(back)) == write_json(bodies_json(pair)));
  }
}

}  // namespace
}  // namespace plumb
