// Ctrl-C: the first asks for a stop that keeps what is done, the second ends the process as usual.
#pragma once

namespace plumb {

/// From here on interrupted() tells; a blocking read ends with what it has.
void catch_interrupt();
[[nodiscard]] bool interrupted();

}  // namespace plumb
