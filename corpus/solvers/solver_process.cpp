#include "corpus/solvers/solver_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <regex>
#include <sstream>
#include <utility>
#include <vector>

#include "corpus/case/case.hpp"
#include "corpus/command/program_folder.hpp"
#include "corpus/solvers/one_processor.hpp"

namespace plumb {
namespace {

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
pid_t spawn_host(std::vector<std::string> arguments, const std::vector<int>& kept, int output) {
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

std::vector<std::string> library_host(const std::string& path, int socket, int lifeline) {
  return {program_folder() / "plumb-solver-host", path, std::to_string(socket), std::to_string(lifeline)};
}

std::vector<std::string> command_host(const std::vector<std::string>& words, int socket) {
  std::vector<std::string> out{program_folder() / "plumb-command-host", std::to_string(socket)};
  out.insert(out.end(), words.begin(), words.end());
  return out;
}

SolverPatience of_an_answer(const SolverLimits& limits) {
  constexpr double asleep = 6;  // times the limit: a machine that is short of processors looks a little like it
  return {limits.seconds, asleep * limits.seconds};
}

/// A process takes longer to start than a quick answer, also where the machine is short of processors; an interpreter, with what it
/// imports, longer still.
SolverPatience of_a_start(const SolverLimits& limits, bool of_a_command) {
  constexpr double to_load = 1;             // seconds of processor time
  constexpr double of_an_interpreter = 20;  // times the limit
  return {of_a_command ? of_an_interpreter * limits.seconds : std::max(to_load, limits.seconds),
          std::max(limits.start, of_an_answer(limits).asleep)};
}

/// Processor time while it runs, time on the wall while it sleeps; while it waits for a processor neither.
class Patience {
 public:
  explicit Patience(const SolverPatience& limits) : limits_(limits) {}
  /// After another wait of so many seconds; throws NoAnswer.
  void use(double waited, const Usage& usage) {
    if (first_ < 0) first_ = last_ = usage.processor_seconds;
    const double now =
        std::max(last_, usage.processor_seconds);  // the time of a child that nobody waits for is lost with it
    if (!usage.is_ready) asleep_ += std::max(0.0, waited - (now - last_));
    last_ = now;
    if (last_ - first_ >= limits_.processor)
      throw NoAnswer(NoAnswer::How::hung, fmt::format("no answer after {} s of processor time", limits_.processor));
    if (asleep_ >= limits_.asleep)
      throw NoAnswer(NoAnswer::How::hung, fmt::format("no answer, and {:.3g} s asleep", limits_.asleep));
  }

 private:
  SolverPatience limits_;
  double first_ = -1, last_ = -1, asleep_ = 0;
};

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
SolverProcess::SolverProcess(SolverSource source, const SolverLimits& limits)
    : SolverProcess(NotStarted(), std::move(source), limits) {
  start();
  greet();
}

/// A command's host ends once nobody is at the other end of its socket, after the program and all that this started.
SolverProcess::~SolverProcess() {
  if (child_ < 0) return;
  socket_ = Descriptor();
  if (!source_.is_command() || !ends_soon(ended_)) (void)kill(child_, SIGKILL);
  (void)reap(child_);
}

void SolverProcess::start() {
  Ends socket = make_socket(), lifeline = make_lifeline(), output = make_output();
  const int asked_by = socket.theirs.number(), lives_by = lifeline.theirs.number();
  child_ = source_.is_command() ? spawn_host(command_host(source_.words, asked_by), {asked_by}, output.theirs.number())
                                : spawn_host(library_host(source_.text, asked_by, lives_by), {asked_by, lives_by},
                                             output.theirs.number());
  socket_ = std::move(socket.ours);
  lifeline_ = std::move(lifeline.ours);
  output_ = std::move(output.ours);
  ended_ = end_of(child_);
}

void SolverProcess::greet() try {
  wait_for_message(of_a_start(limits_, source_.is_command()));
  hello_ = receive<wire::Hello>();
  if (!hello_.loaded) throw InputFailure(source_.text, 0, hello_.field.text(), with_last_words(hello_.reason.text()));
} catch (const NoAnswer& e) {
  const bool says_nothing = source_.is_command() && e.how == NoAnswer::How::hung;
  throw InputFailure(source_.text, 0, "",
                     std::string("cannot be loaded: ") + e.what() +
                         (says_nothing ? "; its first line is to be its abilities, printed and flushed" : ""));
}

wire::Reply SolverProcess::ask(wire::Request request) {
  (void)said();  // what it says from here on is about this request
  request.number = ++asked_;
  request.processor = sched_getcpu();
  const OneProcessor here(request.processor);
  if (send(socket_.number(), &request, sizeof request, MSG_NOSIGNAL) != sizeof request) throw_death();
  wait_for_message(of_an_answer(limits_));
  const auto reply = receive<wire::Reply>();
  if (reply.kind == wire::Reply::Kind::broken)
    throw NoAnswer(NoAnswer::How::crashed, with_last_words(reply.what.text()));
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
  Message message;
  // A process that the library left behind may hold the socket open: there may be neither a message nor an end of them.
  if (recv(socket_.number(), &message, sizeof message, MSG_DONTWAIT) != sizeof message) throw_death();
  return message;
}

/// Until there is something to receive, if only the end.
void SolverProcess::wait_for_message(const SolverPatience& limits) {
  constexpr int tick = 20;  // ms; below it nothing is measured
  std::array<pollfd, 2> either{{{socket_.number(), POLLIN, 0}, {ended_.number(), POLLIN, 0}}};
  for (Patience patience(limits);;) {
    const int ready = poll(either.data(), either.size(), tick);
    if (ready > 0) return;
    if (ready != 0) continue;
    const Usage usage = usage_of(child_);
    require_memory(usage.resident_bytes);
    patience.use(1e-3 * tick, usage);
  }
}

/// One that closed the socket and lives on has the time that an ending one takes, and is killed.
void SolverProcess::throw_death() {
  const bool has_ended = ends_soon(ended_);
  if (!has_ended) (void)kill(child_, SIGKILL);
  const int status = reap(std::exchange(child_, -1));
  throw NoAnswer(NoAnswer::How::crashed,
                 with_last_words(has_ended ? ending(status) : "closed the descriptor that plumb asks through"));
}

std::string SolverProcess::with_last_words(const std::string& what) {
  const std::string words = last_lines(said());
  return what + (words.empty() ? "" : "; it said: " + words);
}

std::string SolverProcess::said() {
  std::string all;
  std::array<char, 4096> part{};
  for (ssize_t n = 0; (n = read(output_.number(), part.data(), part.size())) > 0;)
    all.append(part.data(), static_cast<std::size_t>(n));
  return all;
}

}  // namespace plumb
