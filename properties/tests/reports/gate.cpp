// plumb report-gate: what is worse than its table fails, and so does what is better; a table that is none is refused. The same of
// the counts that reports/gate compares.
#include <fmt/format.h>

#include <sstream>

#include "properties/tests/corpus/programs.hpp"
#include "solver/method/methods.hpp"

namespace plumb {
namespace {

/// Columns of a row.
enum Column : std::size_t { judged = 2, converged = 3, angle_p99 = 5, points_p50 = 8 };

class Gate : public Commands {
 protected:
  void SetUp() override {
    Commands::SetUp();
    ASSERT_EQ(plumb("report-gate --update --table t --cases 3 --threads 2").code, 0);
  }
  [[nodiscard]] std::string table() const { return run("cat " + (path_ / "t").string()).out; }

  /// The word of the row of spheroid and new_cn, in the table.
  [[nodiscard]] double cell(Column column) const {
    return std::stod(
        run(fmt::format("awk '/^spheroid *new_cn / {{ print ${} }}' {}", column + 1, (path_ / "t").string())).out);
  }
  void plant(Column column, const std::string& word) const {
    run(fmt::format("cd {} && awk '/^spheroid *new_cn / {{ ${} = \"{}\" }} {{ print }}' t >u && mv u t", path_.string(),
                    column + 1, word));
  }
  [[nodiscard]] Ran check() const { return plumb("report-gate --table t --family spheroid --method new_cn,auto"); }

  /// The check of the planted table fails with the one line that begins and ends so.
  void expect_deviation(const std::string& begin, const std::string& end) const {
    const Ran ran = check();
    EXPECT_EQ(ran.code, 1) << ran.out;
    const std::string line = ran.out.substr(0, ran.out.find('\n'));
    EXPECT_TRUE(line.starts_with("spheroid new_cn " + begin + ": ") && line.ends_with(end)) << ran.out;
    EXPECT_TRUE(ran.out.ends_with("2 rows, 1 deviations from t\n")) << ran.out;
  }
  void expect_refused(const std::string& line, const std::string& reason) const {
    write_file(path_ / "bad", "seed 1\ncases spheroid 3\n" + line + "\n");
    expect_refusal("report-gate --table bad", "bad:3: " + reason);
  }
};

constexpr const char* better = "better, plumb report-gate --update records it";

TEST_F(Gate, HoldsWhatWasWrittenAndWritesItAgain) {
  const std::string before = table();
  const Ran ran = plumb("report-gate --check --table t --threads 1");
  EXPECT_EQ(ran.code, 0);
  EXPECT_EQ(ran.out, fmt::format("{} rows, 0 deviations from t\n", 4 * methods().size()));
  EXPECT_EQ(plumb("report-gate --update --table t").code, 0);
  EXPECT_EQ(table(), before);
}

TEST_F(Gate, AnErrorAboveItsBoundIsWorseAndOneBelowHalfIsBetter) {
  const double bound = cell(angle_p99);
  ASSERT_GT(bound, 0);
  plant(angle_p99, fmt::format("{}", bound / 2));
  expect_deviation("angle_p99", ": worse");
  plant(angle_p99, fmt::format("{}", 4 * bound));
  expect_deviation("angle_p99", better);
  plant(angle_p99, "0");
  expect_deviation("angle_p99", ": worse");
}

TEST_F(Gate, OtherCountsAreDeviationsBothWays) {
  plant(converged, fmt::format("{}", cell(converged) - 1));
  expect_deviation("converged", better);
  plant(converged, "3");
  plant(judged, "2");
  expect_deviation("judged", better);
  run("cd " + path_.string() + " && sed -i '/^spheroid *new_cn/d' t");
  EXPECT_EQ(check().out,
            "spheroid new_cn: not in the table, plumb report-gate --update adds it\n2 rows, 1 deviations from t\n");
}

TEST_F(Gate, AnUpdateTakesInWhatChangedAndNothingElse) {
  const std::string before = table();
  plant(points_p50, "1");
  ASSERT_EQ(check().code, 1);
  EXPECT_EQ(plumb("report-gate --update --table t --family spheroid --method new_cn").code, 0);
  EXPECT_EQ(table(), before);
}

TEST_F(Gate, ATableThatIsNoneIsRefused) {
  expect_refused("cubes auto 3 3 0 0 0 0 0 0",
                 "cubes: is neither seed nor cases nor a family; plumb families lists them");
  expect_refused("hard auto 3 3 0 0 0 0 0 0", "hard: has no line 'cases' above");
  expect_refused("spheroid magic 3 3 0 0 0 0 0 0", "method: plumb has no method 'magic'");
  expect_refused("spheroid auto 4 3 0 0 0 0 0 0", "judged: '4' is not a whole number up to 3");
  expect_refused("spheroid auto 3 3 0 0 nan 0 0 0", "overlap_p50: 'nan' is no error, 0 or more, nor -");
  expect_refused("spheroid auto 3 3 0 0 0 0 0", "points_p99: '' is no error, 0 or more, nor -");
  expect_refused("spheroid auto 3 3 0 0 0 0 0 0 late=1", "late: no such finding");
  expect_refused("spheroid auto 3 3 0 0 0 0 0 0 slow=4", "slow: 'slow=4' is no count up to 3");
  expect_refused("cases spheroid 3", "cases: spheroid stands there twice");
  expect_refused("seed one", "seed: 'one' is not a whole number up to 18446744073709551615");
  write_file(path_ / "bad", "seed 1\n");
  expect_refusal("report-gate --table bad", "bad: cases: spheroid has no line");
  expect_refusal("report-gate --table none", "none: No such file or directory");
}

TEST_F(Gate, WhatItCannotDoIsTwo) {
  expect_refusal("report-gate --table t --family cubes", "--family: cubes: no such family; plumb families lists them");
  for (const char* arguments :
       {"--check --update", "--cases 3", "--update --cases 0", "--update --cases 3 --method auto"})
    EXPECT_EQ(plumb(std::string("report-gate --table t ") + arguments + " 2>/dev/null").code, 2) << arguments;
}

class Cost : public Commands {
 protected:
  /// bash COMMAND with the functions of reports/cost.sh.
  [[nodiscard]] Ran shell(const std::string& command) const {
    return run("cd " PLUMB_SOURCE_DIR " && bash -c 'source .ci/setup.sh; source reports/cost.sh; cd " + path_.string() +
               "; " + command + "' reports/gate");
  }
  [[nodiscard]] Ran compare(int count) const {
    write_file(path_ / "m", fmt::format("hard auto cold {}\n", count));
    return shell("cost_deviations t m");
  }
};

TEST_F(Cost, ACountLiesWithinItsBand) {
  write_file(path_ / "t", "# a table\nhard auto cold 1000\n");
  for (const int count : {971, 1000, 1010}) EXPECT_EQ(compare(count).code, 0) << count;
  EXPECT_EQ(compare(1011).out, "hard auto cold instructions: 1000 in the table, 1011 measured: worse\n");
  EXPECT_EQ(compare(970).out,
            "hard auto cold instructions: 1000 in the table, 970 measured: better, reports/gate --update records it\n");
  EXPECT_EQ(compare(970).code, 1);
}

TEST_F(Cost, ARowThatIsMissingIsADeviation) {
  write_file(path_ / "t", "hard auto warm 1000\n");
  const Ran ran = compare(1000);
  EXPECT_EQ(ran.code, 1);
  EXPECT_EQ(ran.out, "hard auto cold instructions: not in the table, reports/gate --update adds it\n"
                     "hard auto warm instructions: in the table, but not measured: reports/gate --update drops it\n");
}

TEST_F(Cost, AnUpdateKeepsTheCountsThatHold) {
  write_file(path_ / "t", "a auto cold 1000\nb auto cold 1000\nc auto cold 9\n");
  write_file(path_ / "m", "a auto cold 1005\nb auto cold 900\n");
  const Ran ran = shell("updated_cost t m | sed /^#/d | tr -s \" \"");
  EXPECT_EQ(ran.out, "a auto cold 1000\nb auto cold 900\n");
}

TEST_F(Cost, ATableThatIsNoneIsRefused) {
  write_file(path_ / "t", "# a table\nhard auto cold many\n");
  const Ran ran = shell("gate_cost t 2>&1");
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(ran.out, "t:2: instructions: \"many\" is not a whole number above 0\n");
  write_file(path_ / "t", "hard auto cold\n");
  EXPECT_EQ(shell("gate_cost t 2>&1").out, "t:1: hard: has 3 words; they are set, method, start, instructions\n");
  EXPECT_EQ(shell("gate_cost none 2>&1").code, 2);
}

}  // namespace
}  // namespace plumb
