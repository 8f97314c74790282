#include "corpus/command/interrupt.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>

namespace plumb {
namespace {

volatile std::sig_atomic_t was_interrupted = 0;
volatile std::sig_atomic_t no_input = -1;  // /dev/null

// A read of standard input that has begun ends with EINTR; one that begins a moment later finds the end of the file.
extern "C" void note_interrupt(int) {
  was_interrupted = 1;
  if (no_input >= 0) (void)dup2(no_input, STDIN_FILENO);
}

}  // namespace

void catch_interrupt() {
  no_input = open("/dev/null", O_RDONLY | O_CLOEXEC);
  struct sigaction action{};
  action.sa_handler = note_interrupt;
  // Back to the default for the second; no SA_RESTART, so that a read from a silent pipe ends.
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  (void)sigaction(SIGINT, &action, nullptr);
}

bool interrupted() {
  return was_interrupted != 0;
}

}  // namespace plumb
