// The library's words, as C has them.
#pragma once

#include <cstdio>
#include <span>
#include <string_view>

#include "solver/contact.hpp"

namespace plumb {

/// Of a literal, which ends with a zero.
[[nodiscard]] inline const char* c_text(std::string_view literal) {
  return literal.data();
}

/// What is wrong with a pair, cut to the text's size (above 0); "" where nothing is.
inline void write_text(const InputError& error, std::span<char> text) {
  text[0] = '\0';
  if (!error.reason.empty())
    (void)std::snprintf(text.data(), text.size(), "bodies[%d].%s: %s", error.body, c_text(error.field),
                        c_text(error.reason));
}

}  // namespace plumb
