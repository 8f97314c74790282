// Which seeded bug a solve has. Included before every source of the mutated solver (CMakeLists.txt), whose own files know
// nothing of it.
#pragma once

namespace plumb {

/// The number of a row of bugs.inc, 0: none. The process's choice is made once, when the library is loaded; a thread may
/// choose otherwise, so that several bugs are judged at once. Volatile, so that no two tests of it are seen as one: a
/// compiler that does writes the rest of a function anew for each bug in it, and takes minutes.
inline constinit volatile int bug_of_process = 0;
inline constinit thread_local volatile int bug_of_thread = -1;

[[nodiscard]] inline int seeded_bug() {
  const int chosen = bug_of_thread;
  return chosen < 0 ? bug_of_process : chosen;
}

}  // namespace plumb
