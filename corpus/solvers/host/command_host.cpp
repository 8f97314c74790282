// plumb-command-host SOCKET PROGRAM ARGUMENTS..: answers for a foreign program (--solver-command). It stands between plumb and the program:
// speaks lines with the one (solve_line.hpp) and structs with the other, never waits for one of them alone, and ends the program
// and all that it started when plumb ends, however that does. Started by solver_process.cpp and by nobody else.
#include <fcntl.h>
#include <sys/socket.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include "corpus/json/fields.hpp"
#include "corpus/solvers/host/command_process.hpp"
#include "corpus/solvers/host/confinement.hpp"
#include "corpus/solvers/host/solve_line.hpp"
#include "corpus/solvers/resident.hpp"
#include "corpus/solvers/solver_wire.hpp"

namespace plumb {
namespace {

using wire::Hello;
using wire::Reply;
using wire::Request;

/// plumb has ended, or wants nothing more of this program.
struct PlumbIsGone {};

template <class Message>
void say(int socket, const Message& message) {
  if (send(socket, &message, sizeof message, MSG_NOSIGNAL) != sizeof message) throw PlumbIsGone();
}

Request next_request(CommandProcess& program, int socket) {
  program.wait_for_plumb();
  Request request;
  if (recv(socket, &request, sizeof request, 0) != sizeof request) throw PlumbIsGone();
  return request;
}

std::string line_of(CommandProcess& program) {
  if (auto line = program.next_line()) return *line;
  throw PlumbIsGone();
}

/// Noise says what it is. Of an object there is nothing that would be another in each run, as its number and so all columns are.
std::string wrong(const FieldError& error, const std::string& line) {
  if (!line.starts_with("{")) return first_words(line);
  const std::string reason = error.what();
  return (error.field.empty() ? "" : error.field + ": ") + reason.substr(0, reason.find(": parse error"));
}

Reply ask(CommandProcess& program, const Request& request) {
  using Clock = std::chrono::steady_clock;
  const std::string question = request_line(request);
  const auto start = Clock::now();
  program.send(question);
  const std::string line = line_of(program);
  const double round_trip = std::chrono::duration<double, std::nano>(Clock::now() - start).count();
  try {
    Reply reply = read_reply(line, request.number);
    if (!(reply.nanoseconds > 0)) reply.nanoseconds = round_trip;
    return reply;
  } catch (const FieldError& e) {
    throw NoLine("sent an answer that is none to this pair: " + wrong(e, line));
  }
}

Reply memory(const CommandProcess& program) {
  Reply reply;
  reply.kind = Reply::Kind::measured;
  reply.resident_bytes = usage_of(program.number()).resident_bytes;
  return reply;
}

Reply answer(CommandProcess& program, const Request& request) {
  if (request.kind == Request::Kind::measure_memory) return memory(program);
  Reply reply = ask(program, request);
  reply.resident_bytes = resident_bytes_of(std::to_string(program.number()));
  return reply;
}

/// plumb reads what the program said from standard error, as it does of a library.
std::string in_words(const NoLine& e) {
  (void)std::fputs(e.said.c_str(), stderr);
  return e.what();
}

/// What it says of itself, told to plumb.
Hello greet(CommandProcess& program, int socket) {
  Hello hello;
  std::string line;
  try {
    line = line_of(program);
    read_hello(line, hello);
  } catch (const FieldError& e) {
    hello.reason.set("its first line is not its abilities: " + wrong(e, line));
  } catch (const NoLine& e) {
    hello.reason.set("cannot be used: " + in_words(e));
  }
  say(socket, hello);
  return hello;
}

void serve(CommandProcess& program, int socket) {
  const Hello hello = greet(program, socket);
  for (bool is_sound = hello.loaded; is_sound;) {
    Request request = next_request(program, socket);
    if (request.kind == Request::Kind::solve_warm && !hello.warm) request.kind = Request::Kind::solve;
    Reply reply;
    try {
      reply = answer(program, request);
    } catch (const NoLine& e) {
      is_sound = false;
      reply.kind = Reply::Kind::broken;
      reply.what.set(in_words(e));
    }
    reply.number = request.number;
    say(socket, reply);
  }
}

void run(const std::vector<std::string>& words, int socket) try {
  CommandProcess program(words, socket);
  serve(program, socket);
} catch (const NoLine& e) {
  Hello hello;
  hello.reason.set(e.what());
  say(socket, hello);
}

}  // namespace
}  // namespace plumb

int main(int argc, char** argv) {
  if (argc < 3) {
    (void)std::fputs("plumb-command-host: started by plumb where a --solver-command is named, not by hand\n", stderr);
    return 2;
  }
  const int socket = std::atoi(argv[1]);
  (void)fcntl(socket, F_SETFD, FD_CLOEXEC);
  plumb::be_expendable();
  try {
    plumb::run({argv + 2, argv + argc}, socket);
  } catch (const plumb::PlumbIsGone&) {
  }
  return EXIT_SUCCESS;
}
