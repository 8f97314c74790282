// plumb report --fem: what reports/fem/run left, on a page of its own or beside campaigns. The lines, made_up_fem.jsonl, are made up.

#include "properties/tests/corpus/programs.hpp"

namespace plumb::reports {
namespace {

enum : std::size_t { kFemRun, kFemGeometry, kFemCheck, kFemConvergence, kFemAnswer, kFemHalfSpace };

std::vector<Json> fem_lines() {
  std::ifstream in(PLUMB_SOURCE_DIR "/properties/tests/reports/made_up_fem.jsonl");
  std::stringstream text;
  text << in.rdbuf();
  return lines_of(text.str());
}

Json fem_line(std::size_t index) {
  return fem_lines().at(index);
}

/// As the document holds it.
Json fem_shown(std::size_t index, const Json& judged = Json::object()) {
  Json out = fem_line(index);
  out.erase("kind");
  out.update(judged);
  return out;
}

class FemReport : public Commands {
 protected:
  void write_fem(const std::vector<Json>& lines) const {
    std::string text;
    for (const Json& line : lines) text += line.dump() + "\n";
    write_file(path_ / "fem.jsonl", text);
  }
  [[nodiscard]] Json fem(const std::vector<Json>& lines) const {
    write_fem(lines);
    EXPECT_EQ(plumb("report --fem fem.jsonl -o page.html").code, 0);
    return json("page.json")["fem"];
  }
  void refuses(const std::vector<Json>& lines, const std::string& reason) const {
    write_fem(lines);
    expect_refusal("report --fem fem.jsonl -o page.html", "fem.jsonl:" + reason);
  }
  /// Behind the geometry, a line of which a field is another; it is the third.
  void refuses_field(std::size_t index, const char* field, const Json& value, const std::string& reason) const {
    Json line = fem_line(index);
    line[Json::json_pointer(field)] = value;
    refuses({fem_line(kFemRun), fem_line(kFemGeometry), line}, "3: " + reason);
  }
  void refuses_run(const char* field, const Json& value, const std::string& reason) const {
    Json line = fem_line(kFemRun);
    line[Json::json_pointer(field)] = value;
    refuses({line}, "1: " + reason);
  }
};

TEST_F(FemReport, APageOfItsOwn) {
  const Json shown_fem = fem(fem_lines());
  EXPECT_EQ(json("page.json")["runs"], Json::array());
  EXPECT_EQ(json("page.json")["made"]["command"], "plumb report --fem fem.jsonl -o page.html");
  EXPECT_EQ(shown_fem["commit"], "0fe0fe0");
  EXPECT_EQ(shown_fem["host"], Json({{"ccx", "2.20"}, {"gmsh", "4.8.4"}, {"machine", "x86_64"}}));
  for (const char* field : {"command", "mode", "young", "poisson", "held"})
    EXPECT_EQ(shown_fem[field], fem_line(kFemRun)[field]) << field;
  EXPECT_EQ(shown_fem["interrupted"], false);
  EXPECT_EQ(shown_fem["geometries"], Json::array({fem_shown(kFemGeometry)}));
  EXPECT_EQ(shown_fem["checks"], Json::array({fem_shown(kFemCheck, {{"within", false}})}));
  EXPECT_EQ(shown_fem["convergence"], Json::array({fem_shown(kFemConvergence)}));
  EXPECT_EQ(shown_fem["answers"], Json::array({fem_shown(kFemAnswer, {{"cn_within", true}, {"gp_beyond", true}})}));
  EXPECT_EQ(shown_fem["half_space"], Json::array({fem_shown(kFemHalfSpace, {{"bends", 2.0}})}));
  EXPECT_NE(read("page.html").find("plumb/report-1"), std::string::npos);
  EXPECT_FALSE(fs::exists(path_ / "page.csv"));
}

TEST_F(FemReport, InTheSummary) {
  write_fem(fem_lines());
  ASSERT_EQ(plumb("report --fem fem.jsonl -o page.html").code, 0);
  EXPECT_EQ(
      read("page.md"),
      "## plumb\n\n### Against finite elements, CalculiX 2.20, commit 0fe0fe0, quick\n\n"
      "- overlap ratio above 0 up to 0.005: force less than 0.2 degrees from CN in 1 of 1\n"
      "- overlap ratio above 0.005 up to 0.02: force less than 1 degrees from CN in 0 of 0\n"
      "- where GP is more than 5 degrees from CN, or has no answer: more than 5 times as far from the force in 1 of 1\n"
      "- checks within their limits: 0 of 1\n- **check hertz_force**: 3.5 %, limit 2\n");
}

TEST_F(FemReport, OfTheLastFolder) {
  ASSERT_EQ(plumb("campaign --family spheroid --cases 2 --method auto --out run 2>/dev/null").code, 0);
  ASSERT_EQ(plumb("report run -o page.html").code, 0);
  EXPECT_EQ(json("page.json")["fem"], nullptr);
  write_file(path_ / "run" / "fem.jsonl",
             fem_line(kFemRun).dump() + "\n" + fem_line(kFemCheck).dump() + "\n{\"kind\": \"interrupted\"}\n");
  ASSERT_EQ(plumb("report run -o page.html").code, 0);
  const Json beside = json("page.json")["fem"];
  EXPECT_EQ(beside["interrupted"], true);
  EXPECT_EQ(beside["checks"].size(), 1u);
  EXPECT_EQ(beside["answers"], Json::array());
}

TEST_F(FemReport, AFileIsNeededWithoutAFolder) {
  expect_refusal("report -o page.html", "DIR: is required where there is neither --study nor --fem");
  expect_refusal("report --fem none.jsonl -o page.html", "none.jsonl: No such file or directory");
}

/// An answer at this ratio, with these angles to the force.
Json fem_answer_at(double ratio, const Json& cn, const Json& gp, const Json& apart_deg) {
  Json out = fem_line(kFemAnswer);
  out["ratio"] = ratio;
  out["angles_deg"] = {{"auto", cn}, {"geometric_potential", gp}};
  out["cn_to_gp_deg"] = apart_deg;
  return out;
}

TEST_F(FemReport, WhatIsAskedIsCountedAndMarked) {
  const Json found = fem({fem_line(kFemRun), fem_line(kFemGeometry), fem_answer_at(0.002, 0.3, 20, 20),
                          fem_answer_at(0.005, 0.2, 1, 5.1), fem_answer_at(0.01, 0.1, 0.2, 5),
                          fem_answer_at(0.02, 0.99, nullptr, nullptr), fem_answer_at(0.05, nullptr, 20, 20)});
  const std::vector<std::pair<Json, Json>> verdicts{
      {false, true}, {false, false}, {true, nullptr}, {true, false}, {nullptr, false}};
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    EXPECT_EQ(found["answers"][i]["cn_within"], verdicts[i].first) << i;
    EXPECT_EQ(found["answers"][i]["gp_beyond"], verdicts[i].second) << i;
  }
  EXPECT_EQ(found["asked"], Json::parse(R"({"cn": [{"above": 0.0, "ratio": 0.005, "below_deg": 0.2, "held": 0, "of": 2},
      {"above": 0.005, "ratio": 0.02, "below_deg": 1.0, "held": 2, "of": 2}],
      "gp": {"times": 5.0, "apart_deg": 5.0, "held": 1, "of": 4}})"));
}

TEST_F(FemReport, TheRunLineSaysWhatIsAsked) {
  Json run = fem_line(kFemRun);
  run["limits"] = Json::parse(R"({"cn": [{"ratio": 0.002, "below_deg": 0.5}], "times": 2, "apart_deg": 0})");
  const Json found =
      fem({run, fem_line(kFemGeometry), fem_answer_at(0.002, 0.4, 0.9, 1), fem_answer_at(0.003, 3, 4, 2)});
  EXPECT_EQ(found["asked"],
            Json::parse(R"({"cn": [{"above": 0.0, "ratio": 0.002, "below_deg": 0.5, "held": 1, "of": 1}],
      "gp": {"times": 2.0, "apart_deg": 0.0, "held": 1, "of": 2}})"));
  EXPECT_EQ(found["answers"][1]["cn_within"], nullptr);
}

TEST_F(FemReport, NumbersThatAreNotThereAreNull) {
  std::vector<Json> lines = fem_lines();
  lines[kFemAnswer].erase("cn_to_gp_deg");
  for (const char* field : {"fem_deg", "fem_patch", "curvatures"}) lines[kFemHalfSpace].erase(field);
  for (const char* field : {"fem_force", "centre_off"}) lines[kFemHalfSpace][field] = nullptr;
  const Json found = fem(lines);
  EXPECT_EQ(found["answers"][0]["cn_to_gp_deg"], nullptr);
  EXPECT_EQ(found["answers"][0]["gp_beyond"], false);
  for (const char* field : {"fem_deg", "fem_force", "fem_patch", "centre_off", "curvatures", "bends"})
    EXPECT_EQ(found["half_space"][0].at(field), nullptr) << field;
}

TEST_F(FemReport, AFlatSideHasNoRatioOfCurvatures) {
  std::vector<Json> lines = fem_lines();
  lines[kFemHalfSpace]["curvatures"] = {3, 2, 0};
  EXPECT_EQ(fem(lines)["half_space"][0]["bends"], nullptr);
}

TEST_F(FemReport, AReasonInThePlaceOfFigures) {
  const Json place{{"geometry", "S01"}, {"ratio", 0.01}};
  Json answer{{"kind", "answer"}, {"reason", "did not converge"}},
      plane{{"kind", "half_space"}, {"reason", "turns on"}};
  answer.update(place);
  plane.update(place);
  plane["start"] = "auto";
  const Json found = fem({fem_line(kFemRun), fem_line(kFemGeometry), fem_line(kFemAnswer), answer, plane});
  EXPECT_EQ(found["answers"].size(), 1u);
  EXPECT_EQ(found["half_space"], Json::array());
  ASSERT_EQ(found["unanswered"].size(), 2u);
  EXPECT_EQ(found["unanswered"][0]["reason"], "did not converge");
  EXPECT_EQ(found["unanswered"][0]["start"], nullptr);
  EXPECT_EQ(found["unanswered"][1]["start"], "auto");
  refuses({fem_line(kFemRun), answer}, "2: geometry: 'S01' is of no line before this one");
  answer["reason"] = 1;
  refuses({fem_line(kFemRun), fem_line(kFemGeometry), answer}, "3: reason: must be a string, not a number");
}

TEST_F(FemReport, WrongValuesAreRefused) {
  refuses_run("/mode", "slow", "mode: 'slow' is none of quick, full");
  refuses_run("/young", 0, "young: must be above 0");
  refuses_run("/poisson", 0.5, "poisson: must lie between -1 and 0.5");
  refuses_run("/held", nullptr, "held: must be a string, not null");
  refuses_run("/host", {{"commit", "abc"}, {"gmsh", "4.8.4"}}, "host.ccx: missing");
  refuses_run("/host/nodes", 12, "host.nodes: must be a string, not a number");
  refuses_field(kFemGeometry, "/shape", "cube", "shape: 'cube' is none of spheroid, ellipsoid, superquadric");
  refuses_field(kFemGeometry, "/bodies", Json::array({Json::object()}), "bodies: must be an array of 2 bodies, not 1");
  refuses_field(kFemGeometry, "/bodies/1/semi_axes/2", 0, "bodies[1].semi_axes: must be above 0");
  refuses_field(kFemGeometry, "/bodies/0/exponents", {2}, "bodies[0].exponents: must be an array of 2 numbers, not 1");
  refuses_field(kFemGeometry, "/quaternion", {1, 0, 0}, "quaternion: must be an array of 4 numbers, not 3");
  refuses_field(kFemCheck, "/limit", "2", "limit: must be a number, not a string");
  refuses_field(kFemConvergence, "/geometry", "S09", "geometry: 'S09' is of no line before this one");
  refuses_field(kFemConvergence, "/turned_deg", 181, "turned_deg: must lie in 0 to 180");
  refuses_field(kFemConvergence, "/patch_change", nullptr, "patch_change: must be a number, not null");
  refuses_field(kFemConvergence, "/centre_shift", -1, "centre_shift: must not be below 0");
  refuses_field(kFemAnswer, "/ratio", 0, "ratio: must be above 0");
  refuses_field(kFemAnswer, "/geometry", "S09", "geometry: 'S09' is of no line before this one");
  refuses_field(kFemAnswer, "/direction", {0, 1}, "direction: must be an array of 3 numbers, not 2");
  refuses_field(kFemAnswer, "/angles_deg/auto", "far", "angles_deg.auto: must be a number, not a string");
  refuses_field(kFemAnswer, "/angles_deg", Json::object(),
                "angles_deg: must be an object with a number for each method");
  refuses_field(kFemAnswer, "/centre_off", {1, 2}, "centre_off: must be an object with a number for each method");
  refuses_field(kFemAnswer, "/cn_to_gp_deg", -1, "cn_to_gp_deg: must lie in 0 to 180");
  refuses_field(kFemAnswer, "/fem_patch_radius", 0, "fem_patch_radius: must be above 0");
  refuses_field(kFemAnswer, "/nodes", 1.5, "nodes: must be a whole number from 0 to 2147483647");
  refuses_field(kFemHalfSpace, "/start", "first_touch",
                "start: 'first_touch' is none of auto, geometric_potential, centre_line");
  refuses_field(kFemHalfSpace, "/geometry", "S09", "geometry: 'S09' is of no line before this one");
  refuses_field(kFemHalfSpace, "/patch_radius", 0, "patch_radius: must be above 0");
  refuses_field(kFemHalfSpace, "/fem_force", 0, "fem_force: must be above 0");
  refuses_field(kFemHalfSpace, "/fem_patch", -1, "fem_patch: must be above 0");
  refuses_field(kFemHalfSpace, "/curvatures", {1, 2}, "curvatures: must be an array of 3 numbers, not 2");
  Json bad = fem_line(kFemAnswer);
  bad.erase("balance");
  refuses({fem_line(kFemRun), fem_line(kFemGeometry), bad}, "3: balance: missing");
}

TEST_F(FemReport, WrongLimitsAreRefused) {
  refuses_run("/limits", nullptr, "limits: must be an object, not null");
  refuses_run("/limits/cn", Json::array(), "limits.cn: is empty");
  refuses_run("/limits/cn", 0.2, "limits.cn: must be an array, not a number");
  refuses_run("/limits/cn/0/ratio", 0, "limits.cn[0].ratio: must be above 0");
  refuses_run("/limits/cn/1/ratio", 0.005, "limits.cn[1].ratio: must be above the one before it");
  refuses_run("/limits/cn/1/below_deg", 0, "limits.cn[1].below_deg: must be above 0");
  refuses_run("/limits/times", 0, "limits.times: must be above 0");
  refuses_run("/limits/apart_deg", -1, "limits.apart_deg: must not be below 0");
  Json run = fem_line(kFemRun);
  run["limits"].erase("apart_deg");
  refuses({run}, "1: limits.apart_deg: missing");
  run.erase("limits");
  refuses({run}, "1: limits: missing");
}

TEST_F(FemReport, LinesInAnotherOrderAreRefused) {
  refuses({fem_line(kFemGeometry)}, "1: kind: 'geometry' comes before the line of kind run");
  refuses({fem_line(kFemRun), fem_line(kFemRun)}, "2: kind: 'run' is there twice");
  refuses({fem_line(kFemRun), {{"kind", "interrupted"}}, fem_line(kFemCheck)},
          "3: kind: comes after the line of kind interrupted");
  refuses({fem_line(kFemRun), {{"kind", "row"}}},
          "2: kind: 'row' is none of run, geometry, check, convergence, answer, half_space, interrupted");
  refuses({fem_line(kFemRun)}, " holds no result of reports/fem/run");
}

TEST_F(FemReport, ALineThatIsThereTwiceIsRefused) {
  const std::pair<std::size_t, const char*> doubled[] = {
      {kFemGeometry, "name: is there twice"},
      {kFemCheck, "check: is there twice"},
      {kFemConvergence, "setting: is there twice, of geometry and ratio and varied"},
      {kFemAnswer, "ratio: is there twice, of geometry"},
      {kFemHalfSpace, "start: is there twice, of geometry and ratio"}};
  for (const auto& [index, reason] : doubled) {
    std::vector<Json> lines = fem_lines();
    lines.push_back(fem_line(index));
    refuses(lines, "7: " + std::string(reason));
  }
}

}  // namespace
}  // namespace plumb::reports
