// plumb report-precision: its points are what their names say.
#include <algorithm>

#include "properties/tests/corpus/programs.hpp"

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
    if (line["set"] == set && line["method"] == method && line["scalar"] == scalar && !line.contains("certificate"))
      out.push_back(line);
  return out;
}

double error(const Json& point) {
  return point["normal_error_rad"]["p99"].get<double>();
}

TEST_F(Precision, ATighterToleranceIsNoWorseAndTheEndIsRounding) {
  const Ran ran = plumb("report-precision --cases 4 --repeat 1 --json");
  EXPECT_EQ(ran.code, 0);
  const std::vector<Json> lines = lines_of(ran.out);
  for (const char* set : {"spheroid", "ellipsoid", "exponents-8", "exponents-40"})
    for (const auto& [scalar, rounding] : {std::pair("double", 1e-13), std::pair("long double", 1e-16)}) {
      const std::vector<Json> points = points_of(lines, set, "auto", scalar);
      ASSERT_EQ(points.size(), 8U) << set;
      EXPECT_LE(error(points.back()), rounding) << set << ", " << scalar;
      EXPECT_LE(error(points.back()), error(points.front())) << set << ", " << scalar;
      for (const Json& point : points) EXPECT_EQ(point["not_converged"], 0) << point;
    }
}

TEST_F(Precision, ADominatedPointIsNotOnTheFront) {
  const std::vector<Json> lines = lines_of(plumb("report-precision --cases 3 --repeat 1 --json").out);
  const auto is_candidate = [](const Json& p) {
    return p["problem"] == "common_normal" && !p.contains("certificate") && p["not_converged"] <= 0.01 &&
           p["normal_error_rad"]["p99"].is_number();
  };
  const auto time = [](const Json& p) { return p["median_ns"].get<double>(); };
  int on_front = 0;
  for (const Json& p : lines) {
    const bool is_dominated = std::any_of(lines.begin(), lines.end(), [&](const Json& q) {
      return is_candidate(q) && is_candidate(p) && q["set"] == p["set"] && time(q) < time(p) && error(q) < error(p);
    });
    EXPECT_FALSE(is_dominated && p["pareto"].get<bool>()) << p;
    EXPECT_TRUE(is_candidate(p) || !p["pareto"].get<bool>()) << p;
    on_front += p["pareto"].get<bool>() ? 1 : 0;
  }
  EXPECT_GE(on_front, 4);  // one a set at least
}

TEST_F(Precision, WhatItCannotDoIsTwo) {
  for (const char* arguments : {"--cases 0", "--repeat 0", "--out /nonexistent/a.jsonl --cases 1 --repeat 1"})
    EXPECT_EQ(plumb(std::string("report-precision ") + arguments + " >/dev/null 2>&1").code, 2) << arguments;
}

}  // namespace
}  // namespace plumb
