// What the eye reads.
#include "fuzz/table.hpp"

#include <gtest/gtest.h>

#include "fuzz/shell_word.hpp"

namespace plumb {
namespace {

std::string table_of(std::uint64_t search_budget_ended) {
  Results results;
  results.families["spheroid"].cases = 2000;
  results.families["spheroid"].search_budget_ended = search_budget_ended;
  return table_text(results);
}

TEST(Table, TellsOfAnUnfinishedSearchWhereThereIsOne) {
  EXPECT_NE(table_of(3).find("spheroid: 2 000 cases, 3 with an unfinished search\n"), std::string::npos) << table_of(3);
  EXPECT_NE(table_of(0).find("spheroid: 2 000 cases\n"), std::string::npos) << table_of(0);
}

TEST(ShellWord, QuotesOnlyWhereTheShellWouldReadSomethingElse) {
  EXPECT_EQ(shell_word("/a/b-c_1.so"), "/a/b-c_1.so");
  EXPECT_EQ(shell_word("a b"), "'a b'");
  EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
  EXPECT_EQ(shell_word("$(x)"), "'$(x)'");
  EXPECT_EQ(shell_word(""), "''");
}

}  // namespace
}  // namespace plumb
