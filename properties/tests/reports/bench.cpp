// plumb bench: its sets are what they say, its lines hold the figures, and what it cannot do is one line and exit code 2.
#include <algorithm>
#include <map>

#include "properties/tests/corpus/programs.hpp"

namespace plumb {
namespace {

class Bench : public Commands {
 protected:
  void SetUp() override {
    Commands::SetUp();
    if (!fs::exists(std::string(PLUMB_BINARY_DIR) + "/bin/plumb-bench")) GTEST_SKIP() << "no Google Benchmark";
  }
};

TEST_F(Bench, ALineForEachMethodColdAndWarm) {
  const Ran ran = plumb("bench --set ellipsoid --cases 3 --repeat 1 --method new_cn,original_cn --json --out a.jsonl");
  EXPECT_EQ(ran.code, 0);
  const auto lines = lines_of(ran.out);
  ASSERT_EQ(lines.size(), 6U);
  for (const Json& line : lines) {
    EXPECT_EQ(line["set"], "ellipsoid");
    EXPECT_EQ(line["pairs"], 3);
    EXPECT_GT(line["median_ns"].get<double>(), 0);
    EXPECT_GE(line["p99_ns"].get<double>(), line["median_ns"].get<double>());
    EXPECT_GE(line["iterations"]["max"].get<double>(), line["iterations"]["median"].get<double>());
  }
  EXPECT_EQ(lines[0]["start"], "cold");
  EXPECT_EQ(lines[1]["start"], "warm");
  EXPECT_EQ(lines[2]["start"], "moving");
  EXPECT_EQ(lines[2]["solves"], 120);
  EXPECT_LT(lines[1]["iterations"]["median"].get<double>(), lines[0]["iterations"]["median"].get<double>());
  EXPECT_EQ(lines_of(run("cat " + (path_ / "a.jsonl").string()).out).size(), 6U);
}

TEST_F(Bench, TheRatioIsToEpaInTheSameRun) {
  const auto lines = lines_of(plumb("bench --set spheroid --cases 3 --repeat 1 --json").out);
  const auto epa =
      std::find_if(lines.begin(), lines.end(), [](const Json& line) { return line["method"] == "peer_libccd_epa"; });
  if (epa == lines.end()) GTEST_SKIP() << "built without libccd";
  EXPECT_EQ((*epa)["ratio_to_peer_libccd_epa"], 1.0);
  EXPECT_EQ(std::ranges::count(lines, "auto, with patch", [](const Json& line) { return line["method"]; }), 2);
  for (const Json& line : lines)
    if (line["method"] != "batch") {
      EXPECT_EQ(line.contains("ratio_to_peer_libccd_epa"), line["not_converged"] < 1);
    } else {
      EXPECT_GT(line["ratio_of_auto"], 0);
    }
}

TEST_F(Bench, ShapesAreTimedBesidePeersAndJudgedByBounds) {
  std::map<std::string, int> count;
  for (const Json& line : lines_of(plumb("bench --set boxes,capsules,hulls --cases 4 --repeat 1 --json").out)) {
    ++count[line["method"]];
    EXPECT_EQ(line["start"], "cold");
    if (line["not_converged"] == 1) continue;
    EXPECT_LE(line["overlap_error"]["median"], line["overlap_error"]["max"]);
    if (line["method"] == "auto") {
      EXPECT_LT(line["overlap_error"]["max"].get<double>(), 1e-13) << line;
    }
  }
  EXPECT_EQ(count["auto"], 3);
  EXPECT_EQ(count.size(), count.contains("peer_fcl") ? 4U : count.contains("peer_libccd_epa") ? 2U : 1U);
}

TEST_F(Bench, TheSetsAreOfTheirExponents) {
  for (const auto& [set, above, upto] : {std::tuple("spheroid", 0, 2), std::tuple("exponents-8", 2, 8),
                                         std::tuple("whole", 0, 10), std::tuple("exponents-40", 8, 40)}) {
    const auto cases = lines_of(plumb(std::string("bench --print --cases 5 --set ") + set).out);
    EXPECT_EQ(cases.size(), 5U) << set;
    for (const Json& c : cases) {
      double greatest = 0;
      for (const Json& body : c["bodies"])
        for (const Json& n : body["shape"]["superellipsoid"].value("exponents", Json{2, 2}))
          greatest = std::max(greatest, n.get<double>());
      EXPECT_TRUE(greatest > above && greatest <= upto) << c;
      EXPECT_GE(c["provenance"]["overlap_ratio"].get<double>(), 1e-3);
      EXPECT_LE(c["provenance"]["overlap_ratio"].get<double>(), 5e-2);
    }
  }
}

TEST_F(Bench, CountsTheSolvesOfCasesThatAFileHolds) {
  EXPECT_EQ(plumb("bench --print --cases 4 --set ellipsoid >a.jsonl").code, 0);
  EXPECT_EQ(plumb("bench --count-only --pairs a.jsonl --method new_cn --times 3").out, "3 x 4 cold solves by new_cn\n");
  EXPECT_EQ(plumb("bench --count-only --pairs a.jsonl --method auto --warm").out, "1 x 4 warm solves by auto\n");
  EXPECT_EQ(plumb("bench --count-only --pairs a.jsonl --method auto --moving").out, "1 x 120 moving solves by auto\n");
}

TEST_F(Bench, WhatItCannotDoIsOneLineAndTwo) {
  expect_refusal(
      "bench --set cubes",
      "--set: cubes: no such set; there are spheroid, ellipsoid, exponents-8, whole, exponents-40, boxes, capsules, "
      "hulls");
  for (const char* how : {"--warm", "--moving", "--batch"})
    expect_refusal(std::string("bench --count-only --set boxes --method auto ") + how,
                   "plumb bench: --set: boxes: shapes are solved cold, one pair after the other");
  expect_refusal("bench --count-only --set boxes --method new_cn",
                 "plumb bench: --method: new_cn: takes no shapes here; auto does");
  expect_refusal("bench --set hulls --cases 1 --method new_cn",
                 "plumb bench: --method: none of them takes the shapes of hulls");
  expect_refusal("bench --pairs none.jsonl", "none.jsonl: No such file or directory");
  expect_refusal("bench --count-only", "plumb bench: --count-only: needs one --method, and one --set or --pairs");
  for (const char* arguments : {"bench --method nobody", "bench --cases 0", "bench --repeat 0", "bench --times -1"})
    EXPECT_EQ(plumb(std::string(arguments) + " 2>/dev/null").code, 2) << arguments;
}

}  // namespace
}  // namespace plumb
