// plumb report of failures of any shapes: what the document says of pairs that are not of two superellipsoids.
#include <set>

#include "properties/tests/corpus/json_schema.hpp"
#include "properties/tests/corpus/programs.hpp"

namespace plumb::reports {
namespace {

Json parsed(const fs::path& path) {
  std::ifstream in(path);
  return Json::parse(in);
}

std::string word_of(const Json& body) {
  const Json& shape = body["shape"];
  return shape.contains("sphere_swept") ? word_of({{"shape", shape["sphere_swept"]["core"]}}) : shape.begin().key();
}

/// Such a pair is one of plumb/case-1.
bool is_of_superellipsoids(const Json& c) {
  return std::ranges::all_of(c["bodies"], [](const Json& body) { return body["shape"].contains("superellipsoid"); });
}

class ShapeFailures : public Commands {
 protected:
  void SetUp() override {
    Commands::SetUp();
    ASSERT_EQ(plumb("campaign --family shapes_face_on_face --cases 3 --method auto --out run 2>/dev/null").code, 0);
    fs::create_directories(path_ / "run" / "failures");
  }

  /// As a campaign keeps it.
  void keep(Json c, const std::string& method, const std::string& bucket, const std::string& kind) const {
    c["expect"] = {{"method", method}, {"finding", "misaligned"}};
    c["provenance"] = {{"family", "shapes"}, {"severity", 3}, {"law", "opposite"}, {"detail", "made up"}};
    write_file(path_ / "run" / "failures" / (bucket + "--" + kind + ".json"), c.dump());
  }

  /// A pair of each two shapes that those cases have, in the bucket of its shapes.
  void keep_cases_by_hand() const {
    for (const fs::path& file : find_case_files({PLUMB_SOURCE_DIR "/corpus/cases/shapes"})) {
      if (file.stem() == "mended") continue;  // bounds of these take seconds
      std::ifstream in(file);
      for (std::string line; std::getline(in, line);) {
        const Json c = Json::parse(line);
        if (c["format"] != "plumb/case-2" || is_of_superellipsoids(c)) continue;
        const std::string words = word_of(c["bodies"][0]) + "-" + word_of(c["bodies"][1]);
        const bool is_swept = line.find("sphere_swept") != std::string::npos;
        keep(c, "auto", "misaligned-auto-" + words + (is_swept ? "-swept" : ""), "worst");
      }
    }
  }

  [[nodiscard]] Json failures() const {
    EXPECT_EQ(plumb("report run -o page.html >/dev/null").code, 0);
    return json("page.json")["runs"][0]["failures"];
  }
};

TEST_F(ShapeFailures, AreNamedSolvedAndHeldAgainstBounds) {
  keep_cases_by_hand();
  const Json all = failures();
  std::set<std::string> seen;
  for (const Json& failure : all) {
    const Json& bodies = failure["case"]["bodies"];
    EXPECT_EQ(failure["shapes"], word_of(bodies[0]) + " against " + word_of(bodies[1]));
    const bool is_swept = failure["bucket"].get<std::string>().ends_with("-swept");
    EXPECT_EQ(failure["regime"], is_swept ? "swept" : "");
    seen.insert({word_of(bodies[0]), word_of(bodies[1]), is_swept ? "swept" : "box"});
    const Json &answer = failure["answer"], &reference = failure["reference"];
    ASSERT_EQ(answer["status"], "converged") << failure["file"];
    EXPECT_NEAR(answer["overlap"].get<double>(), reference["overlap"].get<double>(), 1e-6) << failure["file"];
    EXPECT_TRUE(answer["points"].is_array() && answer["normals"].is_null() && answer["angle_error_deg"].is_null());
    EXPECT_TRUE(reference["normal"].is_null());
    EXPECT_TRUE(reference["status"].get<std::string>().starts_with("bounds of the overlap alone: "));
    EXPECT_EQ(failure["right_from"], "rounding") << failure["file"];
  }
  EXPECT_EQ(seen.size(), 11u) << "ten shapes, and swept ones";
  const JsonSchema schema(parsed(PLUMB_SOURCE_DIR "/reports/document/report-1.schema.json"));
  EXPECT_TRUE(schema.allows(json("page.json")));
}

TEST_F(ShapeFailures, ThatWhoKnowsSuperellipsoidsAloneCannotSolveHaveAReason) {
  const Json box{{"shape", {{"box", {{"half_extents", {1, 1, 1}}}}}},
                 {"position", {0, 0, 0}},
                 {"orientation", {{"quaternion_wxyz", {1, 0, 0, 0}}}}};
  Json above = box;
  above["position"] = {0, 0, 1.5};
  keep({{"format", "plumb/case-2"}, {"bodies", {box, above}}}, "new_cn", "misaligned-new_cn-box-box", "worst");
  const Json all = failures();
  ASSERT_EQ(all.size(), 1u);
  EXPECT_TRUE(all[0]["answer"].is_null() && all[0]["right_from"].is_null());
  EXPECT_EQ(all[0]["reason"], "new_cn takes superellipsoids alone");
  EXPECT_NEAR(all[0]["reference"]["overlap"].get<double>(), 0.5, 1e-9);
}

TEST_F(ShapeFailures, AreShownAsSimpleAsTheyCouldBeMade) {
  std::ifstream in(PLUMB_SOURCE_DIR "/corpus/cases/shapes/boxes.jsonl");
  std::string line;
  std::getline(in, line);
  for (const char* kind : {"worst", "shrunk"}) keep(Json::parse(line), "auto", "misaligned-auto-box-box", kind);
  const Json all = failures();
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0]["shrunk"]["answer"], all[0]["answer"]);
  EXPECT_EQ(all[0]["shrunk"]["case"]["format"], "plumb/case-2");
}

}  // namespace
}  // namespace plumb::reports
