// Names and messages of others in the text formats that plumb writes: one function for each format.
#pragma once

#include <string>
#include <string_view>

namespace plumb {

/// On one line, in a table or out of it (GitHub's Markdown), and never markup or HTML.
[[nodiscard]] std::string markdown_text(std::string_view text);

/// A cell of CSV (RFC 4180). What a sheet would take for a formula (=, +, -, @, or a tab or a line's end before it) gets an
/// apostrophe first, which a sheet takes for the sign of a text. Numbers of one's own need none of it.
[[nodiscard]] std::string csv_cell(std::string_view text);

/// In an attribute or between tags.
[[nodiscard]] std::string xml_text(std::string_view text);

}  // namespace plumb
