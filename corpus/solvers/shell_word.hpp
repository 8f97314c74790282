// For the commands that are printed and kept: they are copied into a shell.
#pragma once

#include <string>

namespace plumb {

/// The text as one word of a POSIX shell, in quotes only where it needs them.
[[nodiscard]] std::string shell_word(const std::string& text);

}  // namespace plumb
