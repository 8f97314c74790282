#include "corpus/solver_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <regex>
#include <sstream>
#include <vector>

#include "corpus/case.hpp"
#include "corpus/one_processor.hpp"
#include "corpus/program_folder.hpp"
#include "corpus/resident.hpp"

namespace plumb {
namespace {

// glibc 2.36 declares pidfd_open() for C alone, and older ones do not.
Descriptor end_of(pid_t child) {
  return Descriptor(static_cast<int>(syscall(SYS_pidfd_open, child, 0)));
}

/// Both ends are closed by an exec; what a child is to have is handed to it by its number.
struct Ends {
  Descriptor ours, theirs;
};

Ends ends_of(const std::array<int, 2>& numbers, int made) {
  if (made != 0) fail_with("a foreign solver's process", errno);
  return {Descriptor(numbers[0]), Descriptor(numbers[1])};
}

Ends make_socket() {
  std::array<int, 2> numbers{};
  return ends_of(numbers, socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, numbers.data()));
}

/// Neither end ever waits: a library that prints more than fits loses the rest, and not its time.
Ends make_output() {
  std::array<int, 2> numbers{};
  return ends_of(numbers, pipe2(numbers.data(), O_CLOEXEC | O_NONBLOCK));
}

Ends make_lifeline() {
  std::array<int, 2> numbers{};
  Ends ends = ends_of(numbers, pipe2(numbers.data(), O_CLOEXEC));
  std::swap(ends.ours, ends.theirs);  // ours is the end that is written to
  return ends;
}

/// A group of its own, so that Ctrl-C is plumb's to deal with. To copy a descriptor onto itself is how a spawn leaves it open.
pid_t spawn_host(std::vector<std::string> arguments, const std::array<int, 2>& kept, int output) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  for (const int number : {STDOUT_FILENO, STDERR_FILENO}) posix_spawn_file_actions_adddup2(&actions, output, number);
  for (const int number : kept) posix_spawn_file_actions_adddup2(&actions, number, number);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  pid_t child = -1;
  const int error = posix_spawn(&child, argv[0], &actions, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) fail_with(arguments[0], error);
  return child;
}

double seconds_of(const timespec& time) {
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Processor time while it runs, time on the wall while it sleeps.
class Patience {
 public:
  explicit Patience(double limit) : limit_(limit) {}
  /// After another wait of so many seconds; throws NoAnswer.
  void use(double waited, double processor_seconds) {
    constexpr double asleep = 6;  // times the limit: a machine that is short of processors looks a little like it
    if (first_ < 0) first_ = last_ = processor_seconds;
    asleep_ += std::max(0.0, waited - (processor_seconds - last_));
    last_ = processor_seconds;
    if (last_ - first_ >= limit_)
      throw NoAnswer(NoAnswer::How::hung, fmt::format("no answer after {} s of processor time", limit_));
    if (asleep_ >= asleep * limit_)
      throw NoAnswer(NoAnswer::How::hung, fmt::format("no answer, and {:.3g} s asleep", asleep * limit_));
  }

 private:
  double limit_, first_ = -1, last_ = -1, asleep_ = 0;
};

std::string ending(int status) {
  if (!WIFSIGNALED(status)) return fmt::format("ended the process with exit code {}", WEXITSTATUS(status));
  const char* words = sigdescr_np(WTERMSIG(status));
  return fmt::format("ended by signal {} ({})", WTERMSIG(status), words == nullptr ? "?" : words);
}

/// Without what is another one each time, so that two runs keep the same case with the same words.
std::string without_numbers_of_a_run(const std::string& line) {
  return std::regex_replace(std::regex_replace(line, std::regex("==[0-9]+=="), ""), std::regex("0x[0-9a-f]+"), "0x..");
}

std::string last_lines(const std::string& text) {
  constexpr std::size_t most = 300;
  std::istringstream in(text);
  std::string before, last;
  for (std::string line; std::getline(in, line);)
    if (line.find_first_not_of(" \t\r") != std::string::npos) before = std::exchange(last, line);
  const std::string both = before.empty() ? last : before + " / " + last;
  return without_numbers_of_a_run(both.substr(0, most));
}

}  // namespace

// By way of the other constructor, so that what throws here finds an object that is there to be destroyed.
SolverProcess::SolverProcess(const std::string& library, const SolverLimits& limits) : SolverProcess(limits) {
  start(library);
  try {
    hello_ = receive<wire::Hello>();
    if (!hello_.loaded) throw InputFailure(library, 0, hello_.field.text(), hello_.reason.text());
  } catch (const NoAnswer& e) {
    throw InputFailure(library, 0, "", std::string("cannot be loaded: ") + e.what());
  }
}

SolverProcess::~SolverProcess() {
  if (child_ < 0) return;
  (void)kill(child_, SIGKILL);
  while (waitpid(child_, nullptr, 0) < 0 && errno == EINTR) continue;
}

void SolverProcess::start(const std::string& library) {
  Ends socket = make_socket(), lifeline = make_lifeline(), output = make_output();
  child_ = spawn_host({(program_folder() / "plumb-solver-host").string(), library,
                       std::to_string(socket.theirs.number()), std::to_string(lifeline.theirs.number())},
                      {socket.theirs.number(), lifeline.theirs.number()}, output.theirs.number());
  socket_ = std::move(socket.ours);
  lifeline_ = std::move(lifeline.ours);
  output_ = std::move(output.ours);
  ended_ = end_of(child_);
}

wire::Reply SolverProcess::ask(wire::Request request) {
  (void)said();  // what it says from here on is about this request
  request.number = ++asked_;
  request.processor = sched_getcpu();
  const OneProcessor here(request.processor);
  if (send(socket_.number(), &request, sizeof request, MSG_NOSIGNAL) != sizeof request) throw_death();
  const auto reply = receive<wire::Reply>();
  if (reply.number != request.number)
    throw NoAnswer(NoAnswer::How::crashed, "sent an answer that is none to this pair");
  if (reply.peak_bytes > hello_.peak_bytes) require_memory(reply.peak_bytes);
  require_memory(reply.resident_bytes);  // the peak may be plumb's own, which exec handed on
  return reply;
}

void SolverProcess::require_memory(std::uint64_t bytes) const {
  constexpr double gibibyte = 1 << 30;
  if (static_cast<double>(bytes) > limits_.gibibytes * gibibyte)
    throw NoAnswer(NoAnswer::How::crashed, fmt::format("took more than {} GiB of memory", limits_.gibibytes));
}

template <class Message>
Message SolverProcess::receive() {
  wait_for_message();
  Message message;
  // A process that the library left behind may hold the socket open: there may be neither a message nor an end of them.
  if (recv(socket_.number(), &message, sizeof message, MSG_DONTWAIT) != sizeof message) throw_death();
  return message;
}

/// Until there is something to receive, if only the end.
void SolverProcess::wait_for_message() {
  constexpr int tick = 20;  // ms; below it nothing is measured
  std::array<pollfd, 2> either{{{socket_.number(), POLLIN, 0}, {ended_.number(), POLLIN, 0}}};
  for (Patience patience(limits_.seconds);;) {
    const int ready = poll(either.data(), either.size(), tick);
    if (ready > 0) return;
    if (ready != 0) continue;
    require_memory(resident_bytes_of(std::to_string(child_)));
    patience.use(1e-3 * tick, processor_seconds());
  }
}

double SolverProcess::processor_seconds() const {
  clockid_t clock{};
  timespec time{};
  if (clock_getcpuclockid(child_, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0;
  return seconds_of(time);
}

/// One that closed the socket and lives on has the time that an ending one takes, and is killed.
void SolverProcess::throw_death() {
  constexpr int time_to_end = 1000;  // ms
  pollfd ended{ended_.number(), POLLIN, 0};
  while (poll(&ended, 1, time_to_end) < 0 && errno == EINTR) continue;
  const bool has_ended = (ended.revents & POLLIN) != 0;
  if (!has_ended) (void)kill(child_, SIGKILL);
  int status = 0;
  while (waitpid(child_, &status, 0) < 0 && errno == EINTR) continue;
  child_ = -1;
  const std::string words = last_lines(said());
  throw NoAnswer(NoAnswer::How::crashed,
                 (has_ended ? ending(status) : "closed the descriptor that plumb asks through") +
                     (words.empty() ? "" : "; it said: " + words));
}

std::string SolverProcess::said() {
  std::string all;
  std::array<char, 4096> part{};
  for (ssize_t n = 0; (n = read(output_.number(), part.data(), part.size())) > 0;)
    all.append(part.data(), static_cast<std::size_t>(n));
  return all;
}

}  // namespace plumb
