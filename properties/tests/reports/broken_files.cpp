// What plumb report reads, edited badly, one place at a time: a page, or one line that says where.
#include "properties/tests/broken.hpp"
#include "properties/tests/corpus/programs.hpp"
#include "reports/document/compare.hpp"
#include "reports/document/formats.hpp"
#include "reports/document/sections.hpp"

namespace plumb::reports {
namespace {

class BrokenReports : public Commands {
 protected:
  [[nodiscard]] static std::string kind_of(const Json& line) {
    return line.value("kind", line.contains("end") ? "end" : "");
  }

  /// The first line of each kind.
  [[nodiscard]] static std::vector<Json> one_of_each(const fs::path& file) {
    std::vector<Json> out;
    std::ifstream in(file);
    for (std::string text; std::getline(in, text);) {
      Json line = Json::parse(text);
      const auto is_known = [&](const Json& other) { return kind_of(other) == kind_of(line); };
      if (std::none_of(out.begin(), out.end(), is_known)) out.push_back(std::move(line));
    }
    return out;
  }

  void expect_told(const std::vector<Json>& lines, const std::string& name, const std::function<void()>& read) const {
    const std::string file = (path_ / name).string();
    for (std::size_t i = 0; i < lines.size(); ++i)
      each_broken(lines[i], [&](const std::string& text) {
        std::ofstream out(file);
        for (std::size_t k = 0; k < lines.size(); ++k) out << (k == i ? text : lines[k].dump()) << "\n";
        out.close();
        expect_read_or_told(file, text, read);
      });
  }
  void expect_told(const char* results, const char* section) const {
    const std::vector<Json> lines = one_of_each(fs::path(PLUMB_SOURCE_DIR) / results);
    ASSERT_GT(lines.size(), 1U);
    expect_told(lines, "f.jsonl", [&] { (void)section_json(section, path_ / "f.jsonl"); });
  }
};

TEST_F(BrokenReports, Fem) {
  expect_told("properties/tests/reports/made_up_fem.jsonl", "fem");
}

TEST_F(BrokenReports, Study) {
  expect_told("reports/results/study.jsonl", "study");
}

TEST_F(BrokenReports, Stability) {
  expect_told("reports/results/stability.jsonl", "stability");
}

TEST_F(BrokenReports, Precision) {
  expect_told("reports/results/precision.jsonl", "precision");
}

TEST_F(BrokenReports, Playbacks) {
  const Json head{
      {"format", "plumb/playback-1"},
      {"scene", "s"},
      {"time_step", 0.1},
      {"accuracy", 0.01},
      {"effects", {{{"name", "gravity"}, {"on", true}, {"why", "asked"}}}},
      {"bodies", {{{"semi_axes", {1, 1, 2}}, {"exponents", {2, 2}}, {"fixed", false}}}},
      {"walls",
       {{{"normal", {0, 0, 1}}},
        {{"normal", {0, 0, 1}},
         {"shape", "cone"},
         {"cone", {{"radii", {1, 2}}, {"height", 1}, {"closed", {true, false}}}}},
        {{"normal", {0, 0, 1}}, {"shape", "mesh"}, {"mesh", {{"triangles", {0, 0, 0, 1, 0, 0, 0, 1, 0}}}}}}}};
  const Json frame{{"time", 0},
                   {"position", {0, 0, 1}},
                   {"orientation", {1, 0, 0, 0}},
                   {"wall", {0, 0, 0, 0, 0, 0, 0, 0, 0}},
                   {"wall_orientation", {1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1}},
                   {"contacts", {{0, 1, 0, 0, 0, 0, 0, 1, 0.5, 2}}},
                   {"energy", {{"kinetic", 1}}}};
  const Json end{{"end",
                  {{"steps", 3},
                   {"time", 1},
                   {"hash", "0123456789abcdef"},
                   {"solves", 4},
                   {"failed", 0},
                   {"shares", {{"solver", 1}}}}}};
  expect_told({head, frame, end}, "playback.jsonl", [&] { (void)playback_json(path_); });
}

TEST_F(BrokenReports, Counts) {
  ASSERT_EQ(
      plumb("campaign --family spheroid,hard --cases 3 --seed 5 --method original_cn --out out >/dev/null 2>&1").code,
      0);
  const reports::Run whole{path_ / "out", read_results(path_ / "out")};
  expect_all_read_or_told("f", json("out/campaign.bins"), [&](const std::string& text) {
    const reports::Run run{path_ / "out", parse_bins(text, "f")};
    (void)run_json(run, {0, {}});
    (void)comparison_json(whole, run);
    for (const auto& format : {csv, ladders_csv}) (void)format({run});
    (void)junit(run);
    (void)sarif(run);
  });
}

}  // namespace
}  // namespace plumb::reports
