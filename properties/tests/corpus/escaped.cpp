// Names of others in Markdown, CSV and XML: text, whatever they hold.
#include "corpus/json/escaped.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace plumb {
namespace {

/// What a reader of RFC 4180 takes a cell for.
std::string read_cell(const std::string& cell) {
  if (!cell.starts_with('"')) return cell;
  std::string out;
  for (std::size_t i = 1; i + 1 < cell.size(); ++i) {
    out += cell[i];
    if (cell[i] == '"') ++i;
  }
  return out;
}

TEST(Escaped, MarkdownIsNoMarkup) {
  EXPECT_EQ(markdown_text("new_cn, auto 0.01 of build/fuzz-run"), "new_cn, auto 0.01 of build/fuzz-run");
  EXPECT_EQ(markdown_text("_a_b_ *c* `d` ~e~ $f$"), "\\_a_b\\_ \\*c\\* \\`d\\` \\~e\\~ \\$f\\$");
  EXPECT_EQ(markdown_text("[a](b) <script> & \\|"), "\\[a\\](b) &lt;script&gt; &amp; \\\\\\|");
  EXPECT_EQ(markdown_text("# a"), "\\# a");
  EXPECT_EQ(markdown_text("- a"), "\\- a");
  EXPECT_EQ(markdown_text("1. a"), "1\\. a");
  EXPECT_EQ(markdown_text("1.5 a"), "1.5 a");
  EXPECT_EQ(markdown_text("@a"), "@&#8203;a");
  EXPECT_EQ(markdown_text("one\n# two\r\tthree\x7f"), "one # two  three ");
}

RC_GTEST_PROP(Escaped, MarkdownIsOneLineAndNoHtml, (const std::string& text)) {
  const std::string out = markdown_text(text);
  RC_ASSERT(out.find_first_of("<>\n\r\t") == std::string::npos);
  for (std::size_t i = 0; i < out.size(); ++i)
    if (out[i] == '\\')
      ++i;
    else
      RC_ASSERT(out[i] != '|' && out[i] != '`');
}

TEST(Escaped, ACellIsNoFormula) {
  EXPECT_EQ(csv_cell("auto"), "auto");
  EXPECT_EQ(csv_cell(""), "");
  EXPECT_EQ(csv_cell("a=b"), "a=b");
  for (const char first : {'=', '+', '-', '@'})
    EXPECT_EQ(csv_cell(first + std::string("1")), std::string("'") + first + "1");
  EXPECT_EQ(csv_cell("\t=1"), "\"'\t=1\"");
  EXPECT_EQ(csv_cell("=\"a\",1"), "\"'=\"\"a\"\",1\"");
}

RC_GTEST_PROP(Escaped, ACellReadsBack, (const std::string& text)) {
  const std::string back = read_cell(csv_cell(text));
  RC_ASSERT(back == text || (back == "'" + text && std::string("=+-@\t\r\n").find(text[0]) != std::string::npos));
}

TEST(Escaped, XmlIsNoTag) {
  EXPECT_EQ(xml_text("a<b a=\"c\">&\n"), "a&lt;b a=&quot;c&quot;&gt;&amp; ");
}

}  // namespace
}  // namespace plumb
