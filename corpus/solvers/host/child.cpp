#include "corpus/solvers/host/child.hpp"

#include <poll.h>
#include <sys/syscall.h>
#include <sys/wait.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <limits>

#include "corpus/solvers/resident.hpp"

namespace plumb {
namespace {

std::string folder_of(pid_t process) {
  return "/proc/" + std::to_string(process);
}

/// What its `stat` says from the state on: the name before it ends at the last ')'.
std::ifstream stat_of(pid_t process) {
  std::ifstream in(folder_of(process) + "/stat");
  in.ignore(std::numeric_limits<std::streamsize>::max(), ')');
  return in;
}

/// Of its first thread.
bool is_ready(pid_t process) {
  std::string state;
  stat_of(process) >> state;
  return state == "R";
}

/// Of those that it waited for; 0 where there is no such process.
double seconds_of_ended_children(pid_t process) {
  constexpr int before = 13;  // fields from the state to cutime
  std::ifstream in = stat_of(process);
  std::string skipped;
  for (int i = 0; i < before; ++i) in >> skipped;
  double user = 0, system = 0;
  in >> user >> system;
  return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

double own_seconds(pid_t process) {
  clockid_t clock{};
  timespec time{};
  if (clock_getcpuclockid(process, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// A process may end while it is looked at: then it has no children.
void add_children(pid_t process, std::vector<pid_t>& all) {
  std::error_code gone;
  for (std::filesystem::directory_iterator task(folder_of(process) + "/task", gone), end; !gone && task != end;
       task.increment(gone)) {
    std::ifstream children(task->path() / "children");
    for (pid_t child = 0; children >> child;) all.push_back(child);
  }
}

}  // namespace

// glibc 2.36 declares pidfd_open() for C alone, and older ones do not.
Descriptor end_of(pid_t child) {
  return Descriptor(static_cast<int>(syscall(SYS_pidfd_open, child, 0)));
}

bool ends_soon(const Descriptor& end) {
  constexpr int time_to_end = 1000;  // ms
  pollfd ended{end.number(), POLLIN, 0};
  while (poll(&ended, 1, time_to_end) < 0 && errno == EINTR) continue;
  return (ended.revents & POLLIN) != 0;
}

int reap(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  return status;
}

std::string ending(int status) {
  if (!WIFSIGNALED(status)) return "ended the process with exit code " + std::to_string(WEXITSTATUS(status));
  const char* words = sigdescr_np(WTERMSIG(status));
  return "ended by signal " + std::to_string(WTERMSIG(status)) + " (" + (words == nullptr ? "?" : words) + ")";
}

std::vector<pid_t> descendants_of(pid_t process) {
  std::vector<pid_t> all;
  add_children(process, all);
  for (std::size_t i = 0; i < all.size(); ++i) add_children(all[i], all);
  return all;
}

Usage usage_of(pid_t process) {
  std::vector<pid_t> all = descendants_of(process);
  all.push_back(process);
  Usage out;
  for (const pid_t one : all) {
    out.processor_seconds += own_seconds(one) + seconds_of_ended_children(one);
    out.is_ready = out.is_ready || is_ready(one);
    out.resident_bytes += resident_bytes_of(std::to_string(one));
  }
  return out;
}

}  // namespace plumb
