// The hunt by the libFuzzer program of a target (fuzz-contact, fuzz-pair) in the place of the loop of hunt.hpp.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fuzz/hunt/hunt.hpp"

namespace plumb::hunting {

struct Engine {
  std::filesystem::path program, seeds;
  std::filesystem::path folder;  ///< gets its log, its inputs and what stopped it; it is emptied first
};

/// What stopped it is judged again here. `environment` says to the target who is asked, and what stops it (target_settings.hpp). Throws InputFailure where the program is of no use.
[[nodiscard]] Hunted hunt_by_engine(const Solver& solver, const HuntOptions& options, const Engine& engine,
                                    std::vector<std::string> environment);

}  // namespace plumb::hunting
