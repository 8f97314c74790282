// plumb report --study: what plumb report-study left, on a page of its own or beside campaigns.

#include "properties/tests/corpus/programs.hpp"

namespace plumb::reports {
namespace {

Json run_line() {
  return {
      {"kind", "run"},
      {"command", "plumb report-study"},
      {"host", {{"system", "Linux"}, {"machine", "x86_64"}, {"compiler", "g++"}, {"flags", "-O2"}, {"commit", "abc"}}}};
}

Json group_line() {
  return {{"kind", "group"},     {"group", "G1"},     {"shape", "spheroid"}, {"fails", "signs"},        {"aspect", 2.5},
          {"exponents", {2, 2}}, {"theta_L_deg", 35}, {"phi_L_deg", 0},      {"euler_deg", {0, 70, 0}}, {"drawn", 12}};
}

Json answer_line() {
  return {{"kind", "answer"},
          {"group", "G1"},
          {"ratio", 0.01},
          {"method", "original_cn"},
          {"status", "converged"},
          {"points", {{1, 0, 0}, {0.9, 0, 0}}},
          {"residues", {0, 0, 0, 0.8, 1.8}},
          {"angles_deg", {10, 20, 30}},
          {"off_deg", 12.5},
          {"certified", true}};
}

Json map_line() {
  return {{"kind", "map"},
          {"aspect", 2},
          {"phi_deg", 45},
          {"ratio", 0.01},
          {"method", "original_cn"},
          {"theta_L_deg", {0, 45}},
          {"theta_deg", {0, 45, 90}},
          {"not_certified", 0},
          {"off_deg", {{0, 1, 2}, {3, nullptr, 5}}}};
}

Json share_line() {
  return {{"kind", "share"}, {"aspect", 2},          {"ratio", 0.01}, {"method", "original_cn"},
          {"pairs", 1000},   {"answers", 990},       {"off", 612},    {"low", 0.58},
          {"high", 0.64},    {"median_deg", nullptr}};
}

Json limit_line() {
  return {{"kind", "limit"},         {"sweep", "ratio"}, {"shape", "aspect 2"}, {"x", 0.001},
          {"system", "first_touch"}, {"pairs", 20},      {"certified", 20},     {"angle_deg", 0.1},
          {"angle_max_deg", 0.3},    {"point", 1e-4},    {"overlap", nullptr}};
}

Json order_line() {
  return {{"kind", "order"}, {"shape", "aspect 2"}, {"system", "first_touch"}, {"angle", 1.0},
          {"point", 1.0},    {"overlap", nullptr},  {"limit_deg", 1e-5}};
}

Json cost_line() {
  return {{"kind", "cost"},       {"set", "spheroid"}, {"method", "new_cn"}, {"target_deg", 1e-6},
          {"tolerance", nullptr}, {"evaluations", 12}, {"share", 0.999}};
}

Json roots_line() {
  const Json root{{"kind", "signs"},    {"normal", {0, 0, 1}}, {"distance", 0.02},   {"residues", {0, 0.8, 1.8}},
                  {"off_deg", nullptr}, {"starts", 812},       {"documented", false}};
  return {{"kind", "roots"}, {"pair", "G1"},        {"complete", true}, {"reason", ""},
          {"starts", 2000},  {"not_converged", 31}, {"elsewhere", 0},   {"roots", {root}}};
}

std::string text_of(const std::vector<Json>& lines) {
  std::string out;
  for (const Json& line : lines) out += line.dump() + "\n";
  return out;
}

std::vector<Json> all_lines() {
  return {run_line(),   group_line(), answer_line(), map_line(),  share_line(),
          limit_line(), order_line(), cost_line(),   roots_line()};
}

Json without_kind(Json line) {
  line.erase("kind");
  return line;
}

class StudyReport : public Commands {
 protected:
  void write_study(const std::vector<Json>& lines) const { write_file(path_ / "study.jsonl", text_of(lines)); }
  void refuses(const std::vector<Json>& lines, const std::string& reason) const {
    write_study(lines);
    expect_refusal("report --study study.jsonl -o page.html", "study.jsonl:" + reason);
  }
  /// A line whose field is another.
  void refuses_field(Json line, const char* field, const Json& value, const std::string& reason) const {
    line[field] = value;
    refuses({run_line(), group_line(), line}, "3: " + reason);
  }
};

TEST_F(StudyReport, APageOfItsOwn) {
  write_study(all_lines());
  ASSERT_EQ(plumb("report --study study.jsonl -o page.html").code, 0);
  const Json report = json("page.json");
  const Json& study = report["study"];
  EXPECT_EQ(report["runs"], Json::array());
  EXPECT_EQ(report["made"]["command"], "plumb report --study study.jsonl -o page.html");
  EXPECT_EQ(study["commit"], "abc");
  EXPECT_EQ(study["interrupted"], false);
  Json group = without_kind(group_line()), answer = without_kind(answer_line());
  answer.erase("group");
  group["answers"] = {answer};
  EXPECT_EQ(study["groups"], Json({group}));
  const std::pair<const char*, Json> others[] = {{"maps", map_line()},     {"shares", share_line()},
                                                 {"limits", limit_line()}, {"orders", order_line()},
                                                 {"costs", cost_line()},   {"roots", roots_line()}};
  for (const auto& [name, line] : others) EXPECT_EQ(study[name], Json::array({without_kind(line)})) << name;
  EXPECT_NE(read("page.html").find("plumb/report-1"), std::string::npos);
  EXPECT_NE(read("page.md").find("- original_cn, aspect 2, overlap ratio 0.01: 612 of 990 answers"), std::string::npos)
      << read("page.md");
  EXPECT_FALSE(fs::exists(path_ / "page.csv"));
}

TEST_F(StudyReport, OfTheLastFolder) {
  ASSERT_EQ(plumb("campaign --family spheroid --cases 2 --method auto --out run 2>/dev/null").code, 0);
  ASSERT_EQ(plumb("report run -o page.html").code, 0);
  EXPECT_EQ(json("page.json")["study"], nullptr);
  write_file(path_ / "run" / "study.jsonl", text_of({run_line(), order_line(), {{"kind", "interrupted"}}}));
  ASSERT_EQ(plumb("report run -o page.html").code, 0);
  const Json study = json("page.json")["study"];
  EXPECT_EQ(study["interrupted"], true);
  EXPECT_EQ(study["orders"].size(), 1u);
  EXPECT_EQ(study["groups"], Json::array());
}

TEST_F(StudyReport, AFolderIsNeededWithoutIt) {
  expect_refusal("report -o page.html", "DIR: is required where there is neither --study nor --fem");
  expect_refusal("report --study none.jsonl -o page.html", "none.jsonl: No such file or directory");
}

TEST_F(StudyReport, WrongValuesAreRefused) {
  refuses_field(group_line(), "fails", "x", "fails: 'x' is none of signs, z, both, nothing");
  refuses_field(answer_line(), "group", "G9", "group: 'G9' is of no line before this one");
  refuses_field(answer_line(), "residues", {1, 2}, "residues: must be an array of 5 numbers, not 2");
  refuses_field(answer_line(), "points", {{1, 2, 3}, {1, 2}}, "points[1]: must be an array of 3 numbers, not 2");
  refuses_field(answer_line(), "off_deg", "far", "off_deg: must be a number, not a string");
  refuses_field(answer_line(), "certified", 1, "certified: must be true or false");
  refuses_field(map_line(), "off_deg", {{1, 2, 3}}, "off_deg: must be an array of 2 rows, not 1");
  refuses_field(map_line(), "off_deg", {{1, 2, 3}, {1, 2}}, "off_deg[1]: must be an array of 3 numbers, not 2");
  refuses_field(map_line(), "theta_deg", {0, 0, 90}, "theta_deg[1]: must be above the one before it");
  refuses_field(map_line(), "theta_deg", Json::array(), "theta_deg: is empty");
  refuses_field(share_line(), "answers", 1001, "answers: is above pairs");
  refuses_field(share_line(), "off", 991, "off: is above answers");
  refuses_field(limit_line(), "sweep", "size", "sweep: 'size' is none of ratio, aspect, exponent");
  refuses_field(limit_line(), "x", 0, "x: must be above 0");
  refuses_field(limit_line(), "certified", 21, "certified: is above pairs");
  refuses_field(order_line(), "angle", "one", "angle: must be a number, not a string");
  refuses_field(cost_line(), "target_deg", nullptr, "target_deg: must be a number, not null");
  refuses_field(roots_line(), "starts", 842, "starts: is below the number of their ends");
  Json bad = roots_line();
  bad["roots"][0]["kind"] = "none";
  refuses({run_line(), bad}, "2: roots[0].kind: 'none' is none of signs, z, both, common normal, common normal, apart");
  bad = share_line();
  bad.erase("low");
  refuses({run_line(), bad}, "2: low: missing");
}

TEST_F(StudyReport, LinesInAnotherOrderAreRefused) {
  const Json end{{"kind", "interrupted"}};
  refuses({group_line()}, "1: kind: 'group' comes before the line of kind run");
  refuses({run_line(), run_line()}, "2: kind: 'run' is there twice");
  refuses({run_line(), answer_line()}, "2: group: 'G1' is of no line before this one");
  refuses({run_line(), end, group_line()}, "3: kind: comes after the line of kind interrupted");
  refuses({run_line(), {{"kind", "row"}}},
          "2: kind: 'row' is none of run, group, answer, map, share, limit, order, cost, roots, interrupted");
  refuses({run_line()}, " holds no result of plumb report-study");
}

TEST_F(StudyReport, ALineThatIsThereTwiceIsRefused) {
  const std::pair<Json, const char*> doubled[] = {
      {group_line(), "group: is there twice"},
      {answer_line(), "method: is there twice, of group and ratio"},
      {map_line(), "method: is there twice, of aspect and phi_deg and ratio"},
      {share_line(), "method: is there twice, of aspect and ratio"},
      {limit_line(), "system: is there twice, of sweep and shape and x"},
      {order_line(), "system: is there twice, of shape"},
      {cost_line(), "target_deg: is there twice, of set and method"},
      {roots_line(), "pair: is there twice"}};
  for (const auto& [line, reason] : doubled) {
    std::vector<Json> lines = all_lines();
    lines.push_back(line);
    refuses(lines, "10: " + std::string(reason));
  }
}

}  // namespace
}  // namespace plumb::reports
