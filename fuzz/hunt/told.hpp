// The end of a hunt in words.
#pragma once

#include <filesystem>
#include <string>

#include "fuzz/hunt/hunt.hpp"
#include "fuzz/shrink/explain.hpp"

namespace plumb::hunting {

/// One line: nothing was found.
[[nodiscard]] std::string nothing_text(const Hunted& hunted, const std::string& solver);

/// What is expected for the shrunk case and what the solver says, in numbers that are read back as the same doubles.
[[nodiscard]] std::string expected_and_got(const Explained& explained, const Solver& solver);

}  // namespace plumb::hunting
