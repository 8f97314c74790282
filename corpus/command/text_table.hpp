// Tables that people read: what each column is called and how its cells are written, once for the head and all rows.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace plumb {

struct Column {
  std::string head;
  std::string spec;        ///< fmt's, of a number: ">10.2f"; the head and texts take its side and width alone
  std::string after = {};  ///< of a cell: " %", or blanks before the next column

  /// ">10" of ">10.2f".
  [[nodiscard]] std::string side_and_width() const { return spec.substr(0, spec.find_first_not_of("<>^0123456789")); }
};

class TextTable {
 public:
  explicit TextTable(std::vector<Column> columns, std::string before = "")
      : columns_(std::move(columns)), before_(std::move(before)) {}

  [[nodiscard]] std::string head() const {
    std::string out = before_;
    for (std::size_t i = 0; i < columns_.size(); ++i) append(out, i, head_of(columns_[i]));
    return trimmed(std::move(out));
  }

  /// The cells of the first columns, or of all.
  template <class... Cells>
  [[nodiscard]] std::string row(const Cells&... cells) const {
    std::string out = before_;
    std::size_t i = 0;
    ((append(out, i, cell(columns_.at(i), cells)), ++i), ...);
    return trimmed(std::move(out));
  }
  [[nodiscard]] std::string row_of(const std::vector<std::string>& cells) const {
    std::string out = before_;
    for (std::size_t i = 0; i < cells.size(); ++i) append(out, i, cell(columns_.at(i), cells[i]));
    return trimmed(std::move(out));
  }

 private:
  /// What fills its column is still apart from the next.
  void append(std::string& line, std::size_t i, const std::string& text) const {
    const bool are_bare = i > 0 && columns_[i - 1].after.empty() && !text.empty();
    line += are_bare && !line.ends_with(' ') && !text.starts_with(' ') ? " " + text : text;
  }

  /// Right over a cell and its unit, or over the cell alone.
  static std::string head_of(const Column& column) {
    const bool has_unit = column.after.find_first_not_of(' ') != std::string::npos;
    if (!has_unit) return cell(column, column.head);
    const std::size_t width = cell(column, std::string_view()).size();
    return fmt::format("{:>{}}", column.head, width);
  }

  template <class Value>
  static std::string cell(const Column& column, const Value& value) {
    if constexpr (std::is_convertible_v<Value, std::string_view>)
      return fmt::format(fmt::runtime("{:" + column.side_and_width() + "}"), std::string_view(value)) + column.after;
    else
      return fmt::format(fmt::runtime("{:" + column.spec + "}"), value) + column.after;
  }

  static std::string trimmed(std::string line) { return line.erase(line.find_last_not_of(' ') + 1); }

  std::vector<Column> columns_;
  std::string before_;
};

}  // namespace plumb
