// plumb-solver-host LIBRARY SOCKET LIFELINE: answers for a foreign solver in a process of its own, so that whatever the library
// does ends this process and not plumb. Started by solver_process.cpp and by nobody else; all that it has of plumb's is the
// two descriptors.
#include <fcntl.h>
#include <malloc.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>

#include "corpus/solvers/host/confinement.hpp"
#include "corpus/solvers/one_processor.hpp"
#include "corpus/solvers/resident.hpp"
#include "corpus/solvers/solver_library.hpp"
#include "corpus/solvers/solver_wire.hpp"

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
  plumb::keep_signals_from(plumb::parent_and_all());
  (void)std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);  // what it printed is there when it crashes
  if (const auto library = plumb::load(argv[1], socket)) plumb::serve(*library, socket);
  // Past the library's destructors: plumb has asked for the last time, and nobody would hear of what they do.
  std::_Exit(EXIT_SUCCESS);
}
