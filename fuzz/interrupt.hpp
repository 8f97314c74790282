// Ctrl-C: the first asks for a stop that keeps what is done, the second ends the process as usual.
#pragma once

namespace plumb {

void catch_interrupt();
[[nodiscard]] bool interrupted();

inline constexpr int kInterruptedExit = 130;

}  // namespace plumb
