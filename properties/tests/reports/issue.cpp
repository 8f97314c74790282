// plumb report --issue: a report that a maintainer can act on without plumb.
#include <gtest/gtest.h>

#include "properties/tests/corpus/programs.hpp"

namespace plumb {
namespace {

class IssueReport : public Commands {
 protected:
  /// The third of the source's group, at overlap ratio 0.005, in which the original converges to what is no common normal.
  [[nodiscard]] std::string wrong_case() const {
    std::ifstream in(std::string(PLUMB_SOURCE_DIR) + "/corpus/cases/published/g3.jsonl");
    std::string line;
    for (int third = 0; third < 3; ++third) std::getline(in, line);
    Json c = Json::parse(line);
    c["expect"] = {{"method", "original_cn"}};
    return file("wrong.json", c.dump());
  }
};

TEST_F(IssueReport, SaysWhatIsExpectedAndWhatCame) {
  const Ran ran = plumb("report --issue " + wrong_case());
  EXPECT_EQ(ran.code, 1);
  for (const char* words : {"# original_cn", "| body | semi-axes", "| | expected | got |", "```python",
                            "degrees from the right one. Until a plane parts the bodies", "its own normal gives",
                            "To see it again", "print(\"told\"", "Accuracy asked for: rounding"})
    EXPECT_NE(ran.out.find(words), std::string::npos) << words << "\n" << ran.out;
}

TEST_F(IssueReport, ItsPythonShowsTheLowerDirection) {
  const std::string text = plumb("report --issue " + wrong_case()).out;
  const std::size_t begin = text.find("```python\n") + 10, end = text.find("```", begin);
  const Ran python = run("/usr/bin/python3 " + file("by_hand.py", text.substr(begin, end - begin)) + " 2>&1");
  ASSERT_EQ(python.code, 0) << python.out;
  const double expected = std::stod(python.out.substr(python.out.find("expected ") + 9));
  const double got = std::stod(python.out.substr(python.out.find("got ") + 4));
  EXPECT_LT(expected, got);
  const Json answer = Json::parse(plumb("solve " + wrong_case() + " --method auto --json").out);
  EXPECT_NEAR(expected, answer.at("overlap").get<double>(), 1e-12);
}

TEST_F(IssueReport, WhereNothingIsWrongThereIsNothingToReport) {
  const Ran ran = plumb("report --issue " + wrong_case() + " --accuracy normal=200deg,overlap=10,points=10");
  EXPECT_EQ(ran.code, 0);
  EXPECT_NE(ran.out.find("nothing to report"), std::string::npos);
}

}  // namespace
}  // namespace plumb
