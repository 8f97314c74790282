// What the eye reads.
#include "fuzz/results/table.hpp"

#include <gtest/gtest.h>

#include "corpus/solvers/host/shell_words.hpp"

namespace plumb {
namespace {

std::string table_of(std::uint64_t not_proved_lowest) {
  Results results;
  results.families["spheroid"].cases = 2000;
  results.families["spheroid"].not_proved_lowest = not_proved_lowest;
  results.families["spheroid"].needed = {5, 1990, 5};
  return table_text(results);
}

TEST(Table, TellsWhatIsNotProvedAndWhatTheProofsTook) {
  const std::string taken = "\n  judged by bounds 5, by a proof 1 990, by 50 digits 5\n";
  EXPECT_NE(table_of(3).find("spheroid: 2 000 cases, the reference of 3 not proved to be the lowest minimum" + taken),
            std::string::npos)
      << table_of(3);
  EXPECT_NE(table_of(0).find("spheroid: 2 000 cases" + taken), std::string::npos) << table_of(0);
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
