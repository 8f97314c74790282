// The life of a case: what open, incubating and regressions ask of it, and how plumb promote moves it on.
#include <fmt/format.h>

#include "properties/tests/corpus/programs.hpp"

namespace plumb {
namespace {

class Promote : public Commands {
 protected:
  void SetUp() override {
    Commands::SetUp();
    for (const char* folder : {"open", "incubating", "regressions"}) fs::create_directories(path_ / "corpus" / folder);
  }
  [[nodiscard]] Ran promote(const std::string& file, const std::string& to) const {
    return plumb("promote " + file + " --to " + to + " --why 'because' --corpus corpus 2>&1");
  }
  [[nodiscard]] bool exists(const std::string& name) const { return fs::exists(path_ / name); }
};

/// auto solves it, whatever is expected.
std::string solved(const std::string& finding) {
  return sample_plus(fmt::format(R"("expect": {{"finding": "{}", "verdict": "overlapping"}})", finding));
}

/// A pair whose search does not end.
std::string failing() {
  CaseReader reader(PLUMB_SOURCE_DIR "/corpus/cases/open/search-at-a-fold.jsonl");
  const std::optional<Case> first = reader.next();
  return first ? format_case(*first) : "";
}

TEST_F(Promote, ReplayNoticesThatAKnownFailureFailsNoLonger) {
  (void)file("corpus/open/a.json", solved("nonconverged"));
  const Ran ran = plumb("replay corpus/open");
  EXPECT_EQ(ran.code, 1);
  EXPECT_NE(ran.out.find("; no longer fails: promote it\n"), std::string::npos) << ran.out;
  // From inside the folder as well.
  EXPECT_NE(plumb("--version >/dev/null; cd corpus/open && " + plumb_program + "replay a.json").out.find("promote it"),
            std::string::npos);
}

TEST_F(Promote, WhatHoldsMovesOnWithARecordWhy) {
  (void)file("corpus/open/a.json", solved("nonconverged"));
  EXPECT_EQ(promote("corpus/open/a.json", "incubating").code, 0);
  EXPECT_FALSE(exists("corpus/open/a.json"));
  EXPECT_EQ(promote("corpus/incubating/a.json", "regressions").code, 0);
  const Json moved = json("corpus/regressions/a.json");
  EXPECT_EQ(moved["expect"], Json::parse(R"({"method": "auto", "verdict": "overlapping", "finding": "none"})"));
  const Json& records = moved["provenance"]["promotions"];
  ASSERT_EQ(records.size(), 2U);
  EXPECT_EQ(records[0]["from"], "open");
  EXPECT_EQ(records[0]["to"], "incubating");
  EXPECT_EQ(records[0]["why"], "because");
  EXPECT_EQ(records[0]["finding"], Json::parse(R"({"before": "nonconverged", "after": "none"})"));
  EXPECT_FALSE(records[0]["commit"].get<std::string>().empty());
  EXPECT_EQ(records[1]["from"], "incubating");
  EXPECT_EQ(plumb("replay corpus").code, 0);
}

TEST_F(Promote, AFoundFailureIsCopiedIntoOpenAndStaysThereWhileItFails) {
  (void)file("found.json", failing());
  EXPECT_EQ(promote("found.json", "open").code, 0);
  EXPECT_TRUE(exists("found.json"));
  EXPECT_EQ(json("corpus/open/found.json")["expect"],
            Json::parse(R"({"method": "auto", "status": "stalled", "finding": "nonconverged"})"));
  EXPECT_EQ(json("corpus/open/found.json")["provenance"]["promotions"].back()["from"], "found.json");
  EXPECT_EQ(plumb("replay corpus/open").code, 0);
  const std::string before = read("corpus/open/found.json");
  const Ran refused = promote("corpus/open/found.json", "regressions");
  EXPECT_EQ(refused.code, 1);
  EXPECT_NE(refused.out.find("its place is open/"), std::string::npos) << refused.out;
  EXPECT_EQ(read("corpus/open/found.json"), before);
  EXPECT_FALSE(exists("corpus/regressions/found.json"));
}

TEST_F(Promote, AKnownFailureAmongRegressionsDiffers) {
  (void)file("corpus/regressions/a.json", failing());
  const Ran ran = plumb("replay corpus");
  EXPECT_EQ(ran.code, 1);
  EXPECT_NE(ran.out.find("; fails or cannot be judged: its place is open/"), std::string::npos) << ran.out;
}

TEST_F(Promote, WhatAPublishedMethodGetsWrongIsNoFailureOfPlumbs) {
  (void)file("a.json", sample_plus(R"("expect": {"method": "geometric_potential", "finding": "nonconverged"})"));
  EXPECT_EQ(promote("a.json", "open").code, 1);
  EXPECT_FALSE(exists("corpus/open/a.json"));
}

TEST_F(Promote, OneCaseThatDoesNotHoldKeepsAllOfItsFile) {
  (void)file("corpus/open/two.jsonl", solved("nonconverged") + "\n" + failing() + "\n");
  EXPECT_EQ(promote("corpus/open/two.jsonl", "incubating").code, 1);
  EXPECT_TRUE(exists("corpus/open/two.jsonl"));
  EXPECT_FALSE(exists("corpus/incubating/two.jsonl"));
}

TEST_F(Promote, WhatIsOfNoUseIsRefusedInOneLine) {
  (void)file("corpus/open/a.json", solved("nonconverged"));
  (void)file("corpus/incubating/a.json", sample_case());
  const std::string why = " --why because --corpus corpus";
  expect_refusal("promote corpus/open/a.json --to incubating" + why,
                 "corpus/incubating/a.json: --to: is there already");
  expect_refusal("promote corpus/open/a.json --to open" + why, "corpus/open/a.json: --to: is there already");
  expect_refusal("promote corpus/open/a.json --to regressions --why because --corpus none",
                 "none/regressions: --to: is no folder");
  expect_refusal("promote b.json --to open" + why, "b.json: No such file or directory");
  (void)file("c.json", sample_plus(R"("provenance": "somewhere")"));
  expect_refusal("promote c.json --to regressions" + why, "c.json: provenance: must be an object, to take the record");
  EXPECT_EQ(plumb("promote corpus/open/a.json --to regressions --why '' --corpus corpus 2>/dev/null").code, 2);
  EXPECT_TRUE(exists("corpus/open/a.json"));
}

}  // namespace
}  // namespace plumb
