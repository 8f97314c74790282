// What keeps a foreign solver's process from harming plumb and the machine.
#pragma once

#include <sys/types.h>

#include <vector>

namespace plumb {

/// No core files by the thousand, and where memory runs out this process goes first.
void be_expendable();

/// plumb, its group, and the "all" of kill(2), as the process that plumb started sees them.
[[nodiscard]] std::vector<pid_t> parent_and_all();

/// What this process, and whatever it starts, sends to those does not arrive: the call fails with EPERM (see seccomp(2)), where
/// the kernel can do that. Others it may signal.
void keep_signals_from(const std::vector<pid_t>& spared);

}  // namespace plumb
