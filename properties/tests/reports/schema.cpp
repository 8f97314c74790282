// report-1.schema.json: what plumb report writes is what it says.
#include "properties/tests/corpus/json_schema.hpp"
#include "properties/tests/corpus/programs.hpp"
#include "reports/document/sections.hpp"

namespace plumb::reports {
namespace {

Json file_json(const char* path) {
  std::ifstream in(std::string(PLUMB_SOURCE_DIR) + "/" + path);
  return Json::parse(in);
}

class ReportSchema : public Commands {
 protected:
  /// Two campaigns, a section of each kind, a scene.
  [[nodiscard]] Json document() const {
    for (const char* seed : {"1", "2"})
      EXPECT_LE(plumb(std::string("campaign --family all --cases 5 --seed ") + seed + " --out run" + seed +
                      " >/dev/null 2>&1")
                    .code,
                1);
    EXPECT_EQ(plumb("report run1 run2 " + options_of_sections() + "-o page.html >/dev/null").code, 0);
    return json("page.json");
  }
  static std::string options_of_sections() {
    std::string out;
    for (const Section& section : all_sections()) {
      const bool is_recorded = std::string(section.name) != "fem";
      const std::string file = is_recorded ? "reports/results/" + std::string(section.name) + ".jsonl"
                                           : "properties/tests/reports/made_up_fem.jsonl";
      out += "--" + std::string(section.name) + " " PLUMB_SOURCE_DIR "/" + file + " ";
    }
    return out;
  }

  const JsonSchema schema_{file_json("reports/document/report-1.schema.json")};
};

TEST_F(ReportSchema, TheDocumentIsWhatItSays) {
  const Json whole = document();
  for (const auto& [name, part] : whole.items())
    EXPECT_TRUE(schema_.allows_as(schema_.root()["$defs"]["Report"]["properties"][name], part)) << name;
  EXPECT_TRUE(schema_.allows(whole));
}

TEST_F(ReportSchema, ADocumentWithoutAFieldOrWithAnotherIsNot) {
  const Json whole = document();
  for (const auto& [name, part] : whole.items()) {
    Json less = whole;
    less.erase(name);
    EXPECT_FALSE(schema_.allows(less)) << name;
  }
  Json more = whole;
  more["runs"][0]["families"][0]["methods"][0]["colour"] = "red";
  EXPECT_FALSE(schema_.allows(more));
}

TEST_F(ReportSchema, AllThatIsDescribedIsRequiredOrNamedOptional) {
  const std::vector<std::string> optional{"KeptCase.name",
                                          "Failure.reason",
                                          "Failure.shrunk",
                                          "Shrunk.reason",
                                          "ComparisonRow.before_interval",
                                          "ComparisonRow.after_interval"};
  std::vector<std::string> found;
  const std::function<void(const Json&, const std::string&)> look = [&](const Json& part, const std::string& name) {
    if (!part.is_structured()) return;
    if (part.is_object() && part.contains("properties"))
      for (const auto& [field, property] : part["properties"].items()) {
        const Json required = part.value("required", Json::array());
        if (std::find(required.begin(), required.end(), field) == required.end()) found.push_back(name + "." + field);
      }
    for (const auto& [key, inner] : part.items()) look(inner, part.is_object() ? key : name);
  };
  look(schema_.root()["$defs"], "");
  EXPECT_EQ(std::set(found.begin(), found.end()), std::set(optional.begin(), optional.end()));
}

}  // namespace
}  // namespace plumb::reports
