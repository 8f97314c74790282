// plumb report-precision: its points are what their names say.
#include <algorithm>
#include <cmath>
#include <set>

#include "properties/tests/corpus/programs.hpp"
#include "properties/tests/interrupting.hpp"

namespace plumb {
namespace {

class Precision : public Commands {
 protected:
  void SetUp() override {
    Commands::SetUp();
    if (!fs::exists(std::string(PLUMB_BINARY_DIR) + "/bin/plumb-report-precision"))
      GTEST_SKIP() << "no Google Benchmark";
  }
};

/// Those of one set, method and scalar without a certificate, from the loosest tolerance to none.
std::vector<Json> points_of(const std::vector<Json>& lines, const std::string& set, const std::string& method,
                            const std::string& scalar) {
  std::vector<Json> out;
  for (const Json& line : lines)
    if (line["kind"] == "point" && line["set"] == set && line["method"] == method && line["scalar"] == scalar &&
        line["certificate"] == "")
      out.push_back(line);
  return out;
}

std::vector<Json> of_kind(const std::vector<Json>& lines, const std::string& kind) {
  std::vector<Json> out;
  for (const Json& line : lines)
    if (line["kind"] == kind) out.push_back(line);
  return out;
}

std::set<std::string> keys(const Json& object) {
  std::set<std::string> out;
  for (const auto& item : object.items()) out.insert(item.key());
  return out;
}

double error(const Json& point) {
  return point["normal_error_rad"]["p99"].get<double>();
}

TEST_F(Precision, ATighterToleranceIsNoWorseAndTheEndIsRounding) {
  const std::string sets = "--set spheroid,ellipsoid,exponents-8,exponents-40 ";
  const Ran ran = plumb("report-precision " + sets + "--method auto --cases 4 --repeat 1 --json");
  EXPECT_EQ(ran.code, 0);
  const std::vector<Json> lines = lines_of(ran.out);
  for (const char* set : {"spheroid", "ellipsoid", "exponents-8", "exponents-40"})
    for (const auto& [scalar, rounding] :
         {std::pair("float", 1e-4), std::pair("double", 1e-13), std::pair("long double", 1e-16)}) {
      const std::vector<Json> points = points_of(lines, set, "auto", scalar);
      ASSERT_EQ(points.size(), 8U) << set;
      EXPECT_LE(error(points.back()), rounding) << set << ", " << scalar;
      EXPECT_LE(error(points.back()), error(points.front())) << set << ", " << scalar;
      for (const Json& point : points) EXPECT_EQ(point["not_converged"], 0) << point;
    }
}

TEST_F(Precision, FiftyDigitsAreFifty) {
  const auto lines =
      lines_of(plumb("report-precision --set spheroid --method auto,new_cn --cases 2 --repeat 1 --json").out);
  for (const char* method : {"auto", "new_cn"}) {
    const std::vector<Json> points = points_of(lines, "spheroid", method, "50 digits");
    ASSERT_EQ(points.size(), 3U) << method;
    EXPECT_LE(error(points.back()), 1e-48) << method;
    EXPECT_GT(error(points.front()), error(points.back())) << method;
  }
}

TEST_F(Precision, ADominatedPointIsNotOnTheFront) {
  const auto lines = lines_of(
      plumb("report-precision --set spheroid,exponents-8 --method auto,new_cn --cases 3 --repeat 1 --json").out);
  const std::vector<Json> points = of_kind(lines, "point");
  const auto is_candidate = [](const Json& p) {
    return p["problem"] == "common_normal" && p["certificate"] == "" && p["not_converged"] <= 0.01 &&
           p["normal_error_rad"]["p99"].is_number();
  };
  const auto time = [](const Json& p) { return p["median_ns"].get<double>(); };
  int on_front = 0;
  for (const Json& p : points) {
    const bool is_dominated = std::any_of(points.begin(), points.end(), [&](const Json& q) {
      return is_candidate(q) && is_candidate(p) && q["set"] == p["set"] && time(q) < time(p) && error(q) < error(p);
    });
    EXPECT_FALSE(is_dominated && p["pareto"].get<bool>()) << p;
    EXPECT_TRUE(is_candidate(p) || !p["pareto"].get<bool>()) << p;
    on_front += p["pareto"].get<bool>() ? 1 : 0;
  }
  EXPECT_GE(on_front, 2);  // one a set at least
}

TEST_F(Precision, EachLineHoldsWhatItsKindPromises) {
  const std::string arguments = "--method auto --cases 3 --seed 2 --repeat 1";
  const Ran ran = plumb("report-precision --set ellipsoid,hard " + arguments + " --json --out a.jsonl");
  EXPECT_EQ(ran.code, 0);
  EXPECT_EQ(run("cat " + (path_ / "a.jsonl").string()).out, ran.out);
  const auto lines = lines_of(ran.out);
  ASSERT_EQ(of_kind(lines, "set").size(), 2U);
  for (const Json& line : of_kind(lines, "set")) {
    EXPECT_EQ(keys(line),
              (std::set<std::string>{"kind", "set", "of", "pairs", "envelopes", "auto_on_front", "front_note"}));
    ASSERT_EQ(line["envelopes"].size(), 4U);
    EXPECT_EQ(keys(line["envelopes"][0]), (std::set<std::string>{"scalar", "normal", "overlap", "points"}));
    EXPECT_EQ(line["pairs"], 3);
  }
  for (const Json& line : of_kind(lines, "point")) {
    EXPECT_EQ(keys(line),
              (std::set<std::string>{"kind", "set", "method", "scalar", "tolerance", "certificate", "problem",
                                     "command", "median_ns", "p99_ns", "iterations", "judged", "not_converged",
                                     "off_by_0.01_deg", "overlap_error", "normal_error_rad", "point_error", "pareto"}));
    EXPECT_EQ(line["command"], "plumb report-precision --set " + line["set"].get<std::string>() + " " + arguments);
  }
  const auto certificates = [&](const std::string& set) {
    std::vector<std::string> out;
    for (const Json& line : of_kind(lines, "point"))
      if (line["set"] == set && line["certificate"] != "") out.push_back(line["certificate"]);
    return out;
  };
  EXPECT_EQ(certificates("hard"), (std::vector<std::string>{"residual", "bounds", "proof", "digits"}));
  EXPECT_EQ(of_kind(lines, "path").size(), 8U);  // auto in four scalars
}

TEST_F(Precision, APathShowsQuadraticConvergence) {
  const auto lines =
      lines_of(plumb("report-precision --set ellipsoid --method new_cn --cases 8 --repeat 1 --json").out);
  const std::vector<Json> paths = of_kind(lines, "path");
  ASSERT_EQ(paths.size(), 4U);
  EXPECT_EQ(keys(paths[0]), (std::set<std::string>{"kind", "set", "method", "scalar", "command", "steps"}));
  EXPECT_EQ(paths[3]["scalar"], "50 digits");
  const Json& steps = paths[3]["steps"];
  const auto median = [&](std::size_t k) { return steps[k]["normal_error_rad"]["median"].get<double>(); };
  int squared = 0;
  for (std::size_t k = 1; k < steps.size(); ++k) {
    EXPECT_EQ(steps[k]["iterations"], k);
    const bool is_asymptotic = median(k - 1) < 1e-3 && median(k) > 1e-48;
    if (!is_asymptotic) continue;
    EXPECT_LT(median(k), std::pow(median(k - 1), 1.5)) << k;
    ++squared;
  }
  EXPECT_GE(squared, 2);
}

TEST_F(Precision, WhatItCannotDoIsOneLineAndTwo) {
  expect_refusal("report-precision --set cubes",
                 "--set: cubes: no such set; there are spheroid, ellipsoid, exponents-8, whole, exponents-40, hard");
  const Ran unknown = plumb("report-precision --method nobody 2>&1 >/dev/null");
  EXPECT_EQ(unknown.code, 2);
  EXPECT_EQ(std::count(unknown.out.begin(), unknown.out.end(), '\n'), 1);
  for (const char* arguments :
       {"--cases 0", "--repeat 0", "--out /nonexistent/a.jsonl --set spheroid --method auto --cases 1 --repeat 1"})
    EXPECT_EQ(plumb(std::string("report-precision ") + arguments + " >/dev/null 2>&1").code, 2) << arguments;
}

TEST_F(Precision, CtrlCKeepsTheSetsThatAreDone) {
  const pid_t child =
      start_command("cd " + path_.string() + " && exec " + plumb_program +
                    "report-precision --method auto --cases 30 --repeat 1000 --json --out a.jsonl 2>said >/dev/null");
  EXPECT_EQ(interrupt_when(child, catches_interrupts), 130);
  const std::string said = read("said");
  EXPECT_EQ(said.rfind("interrupted: incomplete, without ", 0), 0U) << said;
  EXPECT_TRUE(fs::exists(path_ / "a.jsonl"));
}

}  // namespace
}  // namespace plumb
