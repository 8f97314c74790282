// Where the running program lies: what is built with it lies beside it.
#pragma once

#include <filesystem>

namespace plumb {

[[nodiscard]] inline std::filesystem::path program_folder() {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path();
}

}  // namespace plumb
