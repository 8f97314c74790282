#include "corpus/interrupt.hpp"

#include <csignal>

namespace plumb {
namespace {

volatile std::sig_atomic_t was_interrupted = 0;

extern "C" void note_interrupt(int) {
  was_interrupted = 1;
}

}  // namespace

void catch_interrupt() {
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
