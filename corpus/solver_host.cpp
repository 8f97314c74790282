// plumb-solver-host LIBRARY SOCKET LIFELINE: answers for a foreign solver in a process of its own, so that whatever the library
// does ends this process and not plumb. Started by solver_process.cpp and by nobody else; all that it has of plumb's is the
// two descriptors.
#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <malloc.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <optional>
#include <vector>

#include "corpus/one_processor.hpp"
#include "corpus/resident.hpp"
#include "corpus/solver_library.hpp"
#include "corpus/solver_wire.hpp"

namespace plumb {
namespace {

using wire::Hello;
using wire::Reply;
using wire::Request;

/// The lifeline is a pipe that plumb holds the other end of: when plumb ends, however it does, the kernel kills this process, in
/// the middle of a call as well. (PR_SET_PDEATHSIG would do so at the end of the thread that started it.)
void end_with_plumb(int lifeline) {
  (void)fcntl(lifeline, F_SETOWN, getpid());
  (void)fcntl(lifeline, F_SETSIG, SIGKILL);
  (void)fcntl(lifeline, F_SETFL, O_ASYNC);
}

/// No core files by the thousand, and where memory runs out this process goes first.
void be_expendable() {
  const rlimit none{0, 0};
  (void)setrlimit(RLIMIT_CORE, &none);
  std::ofstream("/proc/self/oom_score_adj") << 1000;
}

/// A rule of the filter that goes on at one of two later places.
sock_filter jump_if(std::uint32_t value, std::size_t then) {
  return BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value, static_cast<std::uint8_t>(then), 0);
}

/// What a library sends to its parent, or to all processes, does not arrive: the call fails with EPERM (see seccomp(2)), where the
/// kernel can do that. Its own process, its group and what it starts it may signal.
void keep_signals_from_plumb() {
  constexpr std::array<std::uint32_t, 6> calls{
      SYS_kill, SYS_tkill, SYS_tgkill, SYS_rt_sigqueueinfo, SYS_rt_tgsigqueueinfo, SYS_pidfd_open};
  const pid_t plumb = getppid();
  const std::array<pid_t, 3> spared{plumb, -getpgid(plumb), -1};
  const sock_filter allow = BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
  std::vector<sock_filter> rules{BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr))};
  for (std::size_t i = 0; i < calls.size(); ++i) rules.push_back(jump_if(calls[i], calls.size() - i));
  rules.push_back(allow);
  rules.push_back(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, args)));
  for (std::size_t i = 0; i < spared.size(); ++i)
    rules.push_back(jump_if(static_cast<std::uint32_t>(spared[i]), spared.size() - i));
  rules.push_back(allow);
  rules.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM));
  const sock_fprog program{static_cast<unsigned short>(rules.size()), rules.data()};
  (void)prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  (void)syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_SPEC_ALLOW, &program);
}

std::uint64_t peak_bytes() {
  rusage used{};
  (void)getrusage(RUSAGE_SELF, &used);
  return static_cast<std::uint64_t>(used.ru_maxrss) * 1024;
}

template <class Message>
void say(int socket, const Message& message) {
  if (send(socket, &message, sizeof message, MSG_NOSIGNAL) == sizeof message) return;
  (void)std::fputs("plumb-solver-host: the library closed the socket that it answers through\n", stderr);
  std::_Exit(EXIT_FAILURE);
}

std::optional<Request> next_request(int socket) {
  Request request;
  if (recv(socket, &request, sizeof request, 0) != sizeof request) return std::nullopt;
  return request;
}

std::optional<SolverLibrary> load(const char* path, int socket) {
  Hello hello;
  hello.peak_bytes = peak_bytes();
  std::optional<SolverLibrary> library;
  try {
    library = open_solver_library(path);
    introduce(hello, *library);
  } catch (const UnusableLibrary& e) {
    hello.field.set(e.field);
    hello.reason.set(e.what());
  }
  say(socket, hello);
  return library;
}

Reply threw(std::string_view what) {
  Reply reply;
  reply.kind = Reply::Kind::threw;
  reply.what.set(what);
  return reply;
}

Reply timed_answer(const SolverLibrary& library, const Request& request) {
  using Clock = std::chrono::steady_clock;
  Reply reply;
  const plumb_contact* last = request.kind == Request::Kind::solve_warm ? &request.last : nullptr;
  const auto start = Clock::now();
  const int refused = ask(library, request.pair, last, reply.contact);
  reply.nanoseconds = std::chrono::duration<double, std::nano>(Clock::now() - start).count();
  reply.kind = refused == 0 ? Reply::Kind::answered : Reply::Kind::refused;
  return reply;
}

Reply answer(const SolverLibrary& library, const Request& request) {
  try {
    return timed_answer(library, request);
  } catch (const std::exception& e) {
    return threw(e.what());
  } catch (...) {
    return threw("what it threw is no std::exception");
  }
}

Reply memory() {
  Reply reply;
  reply.kind = Reply::Kind::measured;
  const auto heap = mallinfo2();
  reply.heap_bytes = heap.uordblks + heap.hblkhd;
  return reply;
}

/// It waits where plumb waits; the library may run anywhere. Of a library that comes back twice, from a process that it forked as
/// well, only this process is heard.
void serve(const SolverLibrary& library, int socket) {
  const pid_t self = getpid();
  std::optional<Request> request = next_request(socket);
  while (request) {
    Reply reply = request->kind == Request::Kind::measure_memory ? memory() : answer(library, *request);
    if (getpid() != self) return;
    reply.number = request->number;
    reply.peak_bytes = peak_bytes();
    reply.resident_bytes = resident_bytes_of("self");
    const OneProcessor beside_plumb(request->processor);
    say(socket, reply);
    request = next_request(socket);
  }
}

}  // namespace
}  // namespace plumb

int main(int argc, char** argv) {
  if (argc != 4) {
    (void)std::fputs("plumb-solver-host: started by plumb where a --solver is named, not by hand\n", stderr);
    return 2;
  }
  const int socket = std::atoi(argv[2]);
  plumb::end_with_plumb(std::atoi(argv[3]));
  plumb::be_expendable();
  plumb::keep_signals_from_plumb();
  (void)std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);  // what it printed is there when it crashes
  if (const auto library = plumb::load(argv[1], socket)) plumb::serve(*library, socket);
  // Past the library's destructors: plumb has asked for the last time, and nobody would hear of what they do.
  std::_Exit(EXIT_SUCCESS);
}
