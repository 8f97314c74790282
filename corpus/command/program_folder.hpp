// Where the running program lies: what is built with it lies beside it.
#pragma once

#include <filesystem>

namespace plumb {

[[nodiscard]] inline std::filesystem::path program_folder() {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path();
}

/// A file of share/plumb, beside the folder of the programs: build/release/bin, or where they are installed, libexec/plumb.
[[nodiscard]] inline std::filesystem::path data_file(const char* name) {
  const std::filesystem::path beside = program_folder().parent_path(),
                              below = std::filesystem::path("share/plumb") / name;
  return std::filesystem::exists(beside / below) ? beside / below : beside.parent_path() / below;
}

}  // namespace plumb
