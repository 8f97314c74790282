#include "corpus/command/help/command_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace plumb {

const CommandRow* find_command(std::string_view name) {
  const auto* const found =
      std::find_if(command_rows.begin(), command_rows.end(), [&](const CommandRow& row) { return row.name == name; });
  return found == command_rows.end() ? nullptr : &*found;
}

std::string examples_text(std::string_view command) {
  constexpr std::string_view before = "plumb ";
  const CommandRow* const row = command.starts_with(before) ? find_command(command.substr(before.size())) : nullptr;
  if (row == nullptr || row->examples.empty()) return {};
  std::string out = "Examples:\n";
  std::istringstream lines{std::string(row->examples)};
  for (std::string line; std::getline(lines, line);) {
    const std::size_t mark = line.find("  # ");
    out += fmt::format("  {} {}\n        {}\n", command, line.substr(0, mark), line.substr(mark + 4));
  }
  return out;
}

}  // namespace plumb
