// A command line as a shell would split it into words.
#pragma once

#include <string>
#include <vector>

namespace plumb {

/// Blanks part words; '..', ".." and backslashes keep them whole, by the rules of a POSIX shell. No shell is run: a word with a *, $
/// or ; is that word. Throws InputFailure (corpus/case.hpp), which names --solver-command, for an open quote and where there is no word.
[[nodiscard]] std::vector<std::string> split_command(const std::string& command);

}  // namespace plumb
