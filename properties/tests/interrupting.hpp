// A program interrupted once it has come as far as a test wants, which the kernel tells: a clock tells nothing of a program on a
// machine that has other things to do.
#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <string>
#include <thread>

namespace plumb {

/// Its handler of SIGINT is installed.
inline bool catches_interrupts(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("SigCgt:")) return (std::stoull(line.substr(7), nullptr, 16) >> (SIGINT - 1) & 1U) != 0;
  return false;
}

/// It waits for something.
inline bool is_asleep(pid_t process) {
  std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
  std::string number, name, state;
  stat >> number >> name >> state;
  return state == "S";
}

/// What it has used of the processors, all its threads together; s.
inline double processor_seconds(pid_t process) {
  std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
  std::string word;
  constexpr int user_time = 14;  // the fourteenth field, proc(5); the one after it is the system's time
  for (int i = 1; i < user_time; ++i) stat >> word;
  double user = 0, system = 0;
  stat >> user >> system;
  return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

/// Interrupts the child once ready(child) holds; its exit code, -1 where a signal ended it. A child that ends before is not
/// interrupted.
template <class Ready>
int interrupt_when(pid_t child, const Ready& ready) {
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (ready(child)) {
      kill(child, SIGINT);
      waitpid(child, &status, 0);
      break;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// Starts a command of the shell, which becomes the program that it names last. SIGINT is ignored until that program catches it: a shell
/// would catch it too, and what is sent while the one becomes the other would end it.
inline pid_t start_command(const std::string& command) {
  const pid_t child = fork();
  if (child != 0) return child;
  (void)std::signal(SIGINT, SIG_IGN);
  execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
  _exit(127);
}

}  // namespace plumb
