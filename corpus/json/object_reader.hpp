// The JSON objects of a file as text, one after the other: what cases and answers are read from.
#pragma once

#include <optional>
#include <string>

#include "corpus/file/text_input.hpp"

namespace plumb {

/// A file that holds one object over any number of lines, or one object a line; which of them, its content says. A file of
/// lines is read line by line, so that the objects before a bad line, and of a stream that has not ended, are handed out.
class ObjectReader {
 public:
  enum class Layout { by_content, one_object };

  /// A file is one object unless its name (.jsonl) or the pipe says that it may be one a line.
  [[nodiscard]] static Layout layout_of(const std::string& path);

  /// "-" is standard input. Throws InputFailure (corpus/case/case.hpp) for what cannot be opened.
  ObjectReader(const std::string& path, Layout layout);
  ObjectReader(const ObjectReader&) = delete;
  ObjectReader& operator=(const ObjectReader&) = delete;

  /// nullopt at the end. Blank lines are skipped; the text need not be JSON.
  [[nodiscard]] std::optional<std::string> next();
  /// As errors name it.
  [[nodiscard]] const std::string& file() const { return in_.file(); }
  /// Line of what next() handed out last; 0 when it was all of the file.
  [[nodiscard]] int line() const { return whole_ ? 0 : in_.line(); }

 private:
  [[nodiscard]] std::optional<std::string> rest();

  TextInput in_;
  bool whole_;        ///< one object, over all of the file
  bool any_ = false;  ///< something has been handed out
};

}  // namespace plumb
