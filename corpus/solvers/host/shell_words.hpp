// Words of a POSIX shell: a command line split into them, and a text as one of them.
#pragma once

#include <string>
#include <vector>

namespace plumb {

/// Blanks part words; '..', ".." and backslashes keep them whole, by the rules of a POSIX shell. No shell is run: a word with a *, $
/// or ; is that word. Throws InputFailure (corpus/case/case.hpp), which names --solver-command, for an open quote and where there is no word.
[[nodiscard]] std::vector<std::string> split_command(const std::string& command);

/// The text as one word, in quotes only where it needs them: for commands that are printed and kept, and copied into a shell.
[[nodiscard]] std::string shell_word(const std::string& text);

}  // namespace plumb
