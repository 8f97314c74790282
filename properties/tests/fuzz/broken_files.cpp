// What a campaign left, edited badly, one place at a time: merge, --resume and report tell it in one line.
#include <algorithm>

#include "fuzz/campaign/campaign.hpp"
#include "properties/generators/families.hpp"
#include "properties/tests/broken.hpp"
#include "properties/tests/corpus/programs.hpp"

namespace plumb {
namespace {

class BrokenCampaigns : public Commands {
 protected:
  void SetUp() override {
    Commands::SetUp();
    ASSERT_EQ(
        plumb("campaign --family spheroid,hard --cases 3 --seed 5 --method original_cn --out out >/dev/null 2>&1").code,
        0);
  }
  /// Some failures are kept.
  [[nodiscard]] fs::path kept() const {
    for (const auto& entry : fs::directory_iterator(path_ / "out" / "failures")) return entry.path();
    return {};
  }
  /// The part of a chunk: counts, then a line for each kept failure.
  [[nodiscard]] std::string part() const {
    std::string line = R"({"file": ")" + kept().filename().string() + R"(", "case": )" +
                       Json::parse(std::ifstream(kept())).dump() + "}\n";
    return json("out/campaign.bins").dump() + "\n" + line;
  }
};

TEST_F(BrokenCampaigns, Counts) {
  Json bins = json("out/campaign.bins");
  bins["leaks"] = {{"solver:a", {{"bytes_a_call", 1.5}, {"calls", 2}}}};
  bins["libraries"] = {{"solver:a", "/a"}};
  bins["harness_errors"] = {{"an error", 1}};
  bins["given_up"] = {"solver:a"};
  expect_all_read_or_told("f", bins, [](const std::string& text) {
    const Results results = parse_bins(text, "f");
    (void)summary_json(results);
    (void)format_bins(results);
  });
}

TEST_F(BrokenCampaigns, KeptFailures) {
  const Json line{{"file", kept().filename().string()}, {"case", Json::parse(std::ifstream(kept()))}};
  expect_all_read_or_told("f", line, [](const std::string& text) { KeptFailures().add_line(text, "f", 7); });
  fs::remove_all(path_ / "kept");
  fs::create_directories(path_ / "kept");
  const std::string name = (path_ / "kept" / kept().filename()).string();
  expect_all_read_or_told(name, line["case"], [&](const std::string& text) {
    std::ofstream(name) << text;
    KeptFailures().read(path_ / "kept");
  });
}

TEST_F(BrokenCampaigns, TheCommandsSayIt) {
  Json bins = json("out/campaign.bins");
  bins["families"]["spheroid"]["methods"]["original_cn"].erase("findings");
  (void)file("out/campaign.bins", bins.dump());
  expect_refusal("merge out --out all", "out/campaign.bins: families.spheroid.methods.original_cn.findings: missing");
  (void)file("a.part", part());
  expect_refusal("merge a.part --out all", "a.part: families.spheroid.methods.original_cn.findings: missing");
}

/// merge and --resume write each kept case under the name that a part gives it.
TEST_F(BrokenCampaigns, ANameThatLeavesTheFolderIsRefused) {
  const std::string kept_name = "\"" + kept().filename().string() + "\"";
  for (const std::string name : {"../../x--worst.json", "/tmp/x--worst.json", ".x--worst.json", "a\\nb--worst.json"}) {
    std::string text = part();
    text.replace(text.find(kept_name), kept_name.size(), "\"" + name + "\"");
    (void)file("a.part", text);
    expect_refusal("merge a.part --out all", "a.part:2: file: is no name of a kept failure");
  }
  EXPECT_FALSE(fs::exists(path_ / "all"));
}

TEST_F(BrokenCampaigns, EndlessOnesToo) {
  for (const char* place : {"a.part", "out/campaign.bins"}) {
    fs::remove(path_ / place);
    fs::create_symlink("/dev/zero", path_ / place);
  }
  expect_refusal("merge out --out all", "out/campaign.bins: is longer than 256 MiB");
  EXPECT_EQ(plumb("merge a.part --out all 2>/dev/null").code, 2);
}

/// A campaign goes through cases of the user's as well (plumb fuzz-run --real), whose provenance is anything.
TEST_F(BrokenCampaigns, TheProvenanceOfARealCaseIsAnything) {
  std::optional<Case> first = CaseReader(kept().string()).next();
  if (!first) FAIL() << "one was kept";
  Case& real = *first;
  std::vector<Case> cases;
  each_broken(generate("hard", 1, 2).provenance, [&](const std::string& text) {
    if (text.size() > 2000 || !Json::accept(text)) return;
    real.provenance = Json::parse(text);
    if (!real.provenance.is_object()) return;
    real.provenance.update({{"family", "real"}, {"index", cases.size()}});
    cases.push_back(real);
  });
  ASSERT_GT(cases.size(), 50U);
  const Source source{"real", cases.size(), [&](std::uint64_t i) { return cases[i]; }, "plumb fuzz-run"};
  const Results results = run_campaign({source}, {find_solvers("original_cn"), 1, 1, {}});
  EXPECT_EQ(results.cases(), cases.size());
  EXPECT_TRUE(results.harness_errors.empty()) << results.harness_errors.begin()->first;
}

}  // namespace
}  // namespace plumb
