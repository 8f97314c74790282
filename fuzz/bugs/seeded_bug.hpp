// Which seeded bug a solve has. Included before every source of the mutated solver (CMakeLists.txt), whose own files know
// nothing of it.
#pragma once

namespace plumb {

/// The process's choice, made once when the library is loaded; a thread may choose otherwise, so that several bugs are
/// judged at once. The number of a row of bugs.inc, 0: none.
inline constinit int bug_of_process = 0;
inline constinit thread_local int bug_of_thread = -1;

[[nodiscard]] inline int seeded_bug() {
  return bug_of_thread < 0 ? bug_of_process : bug_of_thread;
}

}  // namespace plumb
