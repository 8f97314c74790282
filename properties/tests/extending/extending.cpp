// Each list once: a dummy method, family and law, added as extending.md says (tests.cmake), are in every view of them; and that page names
// the very files that it took. The effect is in effect/.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>

#include "corpus/solvers/solver.hpp"
#include "fuzz/campaign/arguments.hpp"
#include "fuzz/campaign/campaign.hpp"
#include "fuzz/results/results.hpp"
#include "fuzz/results/table.hpp"
#include "properties/generators/families.hpp"
#include "properties/laws/judged_answer.hpp"
#include "reports/document/document.hpp"
#include "reports/study/bed.hpp"
#include "solver/method/methods.hpp"

namespace plumb {
namespace {

/// The one row of that name.
Json row_of(const Json& rows, const std::string& name) {
  Json found;
  for (const Json& row : rows)
    if (row.at("name") == name) found = row;
  return found;
}

template <class Names>
bool holds(const Names& names, const std::string& name) {
  return std::ranges::find(names, name) != std::ranges::end(names);
}

const Results& campaign_of_dummies() {
  static const Results results = run_campaign({family_source("dummy", 12, 1, "")}, {find_solvers("dummy"), 1, 1, {}});
  return results;
}

TEST(Extending, AMethodIsASolver) {
  ASSERT_NE(find_method("dummy"), nullptr);
  const std::vector<Solver> all = all_solvers();
  const auto solver = std::ranges::find(all, "dummy", &Solver::name);
  ASSERT_NE(solver, all.end());
  EXPECT_TRUE(solver->published);
  EXPECT_EQ(solver->summary, "a method for tests");
  try {
    (void)find_solvers("none_of_this_name");
    ADD_FAILURE();
  } catch (const InputFailure& failure) {
    EXPECT_NE(std::string(failure.what()).find(", dummy"), std::string::npos) << failure.what();
  }
}

TEST(Extending, AMethodIsInTheReports) {
  const Json row = row_of(reports::methods_json(), "dummy");
  EXPECT_EQ(row, (Json{{"name", "dummy"},
                       {"published_by", "Nobody 2000"},
                       {"problem", "common_normal"},
                       {"light", "#010203"},
                       {"dark", "#040506"},
                       {"symbol", "diamond-tall"}}));
  EXPECT_TRUE(holds(reports::studied(), "dummy"));
  Tallies tallies;
  for (const char* name : {"a_foreign_one", "dummy", "auto"}) tallies[name];
  EXPECT_EQ(method_order(tallies), (std::vector<std::string>{"auto", "dummy", "a_foreign_one"}));
}

TEST(Extending, MethodAndFamilyAreInACampaign) {
  const Json summary = summary_json(campaign_of_dummies());
  EXPECT_EQ(summary.at("cases"), 12);
  EXPECT_EQ(summary.at("methods").at("dummy").at("findings").at("none"), 12);
  const std::string table = table_text(campaign_of_dummies());
  EXPECT_TRUE(std::regex_search(table, std::regex("dummy[^]*dummy"))) << table;
}

TEST(Extending, AFamilyIsInEveryViewOfThem) {
  EXPECT_TRUE(holds(find_families("all"), "dummy"));
  ASSERT_NE(find_family("dummy"), nullptr);
  EXPECT_EQ(find_family("dummy")->per_minute, 10);
  EXPECT_EQ(find_family("dummy")->gated, 20u);
  EXPECT_EQ(generate("dummy", 3, 4).name, "dummy seed 3 index 4");
  Results results;
  for (const char* name : {"a_foreign_one", "dummy", "spheroid"}) results.families[name];
  EXPECT_EQ(family_order(results), (std::vector<std::string>{"spheroid", "dummy", "a_foreign_one"}));
}

TEST(Extending, ALawIsHeldAndTold) {
  const Pair pair = generate("dummy", 1, 0).pair;
  Contact<double> answer = find_method("auto")->solve(pair, {}, nullptr);
  Judge judge(pair);
  EXPECT_EQ(judge.judge({}, answer).finding.kind, FindingKind::none);
  answer.iterations = 13;
  const Finding finding = judge.judge({}, answer).finding;
  EXPECT_EQ(finding.kind, FindingKind::slow);
  EXPECT_EQ(finding.law, "dummy");
  EXPECT_EQ(row_of(reports::laws_json(), "dummy").at("statement"), "no answer takes 13 iterations");
}

// ---- the page ----

/// What stands between `code marks` in the numbered list below the heading, and looks like a path.
std::set<std::string> files_of_page(const std::string& anchor) {
  std::ifstream in(std::string(PLUMB_SOURCE_DIR) + "/reports/docs/pages/extending.md");
  const std::string page{std::istreambuf_iterator<char>(in), {}};
  std::size_t at = page.find("{#" + anchor + "}");
  EXPECT_NE(at, std::string::npos) << anchor;
  std::istringstream section(page.substr(at, page.find("\n# ", at) - at));
  std::set<std::string> files;
  static const std::regex path("`([^` ]+/[^` ]+)`");
  for (std::string line; std::getline(section, line);)
    if (!line.empty() && line[0] >= '1' && line[0] <= '9')
      for (std::sregex_iterator it(line.begin(), line.end(), path), end; it != end; ++it) files.insert((*it)[1]);
  return files;
}

/// Of a list with commas, the dummy's name as the page writes it.
std::set<std::string> touched(const std::string& list) {
  std::set<std::string> files;
  std::istringstream in(list);
  for (std::string file; std::getline(in, file, ',');)
    files.insert(std::regex_replace(file, std::regex("dummy"), "NAME"));
  return files;
}

struct Added {
  const char *anchor, *files;
  std::size_t most;
};

TEST(Extending, ThePageNamesTheFilesThatItTook) {
  for (const Added& added : {Added{"addmethod", PLUMB_TOUCHED_method, 3}, Added{"addfamily", PLUMB_TOUCHED_family, 2},
                             Added{"addlaw", PLUMB_TOUCHED_law, 3}, Added{"addeffect", PLUMB_TOUCHED_effect, 4}}) {
    EXPECT_EQ(files_of_page(added.anchor), touched(added.files)) << added.anchor;
    EXPECT_LE(touched(added.files).size(), added.most) << added.anchor;
  }
}

}  // namespace
}  // namespace plumb
