// What built the programs: every result says which code it is of.
#pragma once

#include "corpus/json/json_text.hpp"

namespace plumb {

struct BuildInfo {
  const char* commit;    ///< git describe --always --dirty when it was linked; "unknown" outside of a repository
  const char* compiler;  ///< name and version
  const char* flags;     ///< of the build type
};
[[nodiscard]] BuildInfo build_info();

/// This machine and build: { "system", "machine", "processors", "compiler", "flags", "commit" }.
[[nodiscard]] Json host_json();

}  // namespace plumb
