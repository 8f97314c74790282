#include "corpus/solvers/host/command_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include "corpus/solvers/host/confinement.hpp"

namespace plumb {
namespace {

constexpr std::size_t kLongestLine = 1 << 20;  // a reply takes less than 1 KiB
constexpr std::size_t kWordsKept = 4096;

struct Pipe {
  Descriptor to_read, to_write;
};

Pipe make_pipe() {
  std::array<int, 2> numbers{};
  if (pipe2(numbers.data(), O_CLOEXEC) != 0) throw NoLine(std::string("cannot be started: ") + std::strerror(errno));
  return {Descriptor(numbers[0]), Descriptor(numbers[1])};
}

/// Of the whole pipe's two ends only this one: the program's own waits, as programs expect.
Descriptor never_waiting(Descriptor end) {
  (void)fcntl(end.number(), F_SETFL, O_NONBLOCK);
  return end;
}

struct Pipes {
  Pipe input, output, words;
};

/// The forked child turns into the program: in a group of its own, with nothing of plumb's but three pipes, and not for longer than
/// this process. Returns where there is no such program.
void become(const std::vector<std::string>& words, const Pipes& pipes, const std::vector<pid_t>& spared) {
  (void)setpgid(0, 0);
  (void)prctl(PR_SET_PDEATHSIG, SIGKILL);
  (void)signal(SIGPIPE, SIG_DFL);
  (void)dup2(pipes.input.to_read.number(), STDIN_FILENO);
  (void)dup2(pipes.output.to_write.number(), STDOUT_FILENO);
  (void)dup2(pipes.words.to_write.number(), STDERR_FILENO);
  keep_signals_from(spared);
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  (void)execvp(argv[0], argv.data());
}

pid_t start(const std::vector<std::string>& words, const Pipes& pipes) {
  std::vector<pid_t> spared = parent_and_all();
  spared.insert(spared.end(), {getpid(), -getpgrp()});
  Pipe failure = make_pipe();  // an exec closes it
  const pid_t child = fork();
  if (child == 0) {
    become(words, pipes, spared);
    const int error = errno;
    (void)!write(failure.to_write.number(), &error, sizeof error);
    _exit(EXIT_FAILURE);
  }
  int error = errno;
  failure.to_write = Descriptor();
  if (child > 0 && read(failure.to_read.number(), &error, sizeof error) <= 0) return child;
  if (child > 0) (void)reap(child);
  throw NoLine(std::string("cannot be started: ") + std::strerror(error));
}

/// How many bytes came; 0 at the end of them, negative where there are none yet.
ssize_t read_some(const Descriptor& from, std::string& into) {
  std::array<char, 1 << 16> part{};
  const ssize_t n = read(from.number(), part.data(), part.size());
  if (n > 0) into.append(part.data(), static_cast<std::size_t>(n));
  return n;
}

/// As long as there is more, and not for ever.
void read_all(const Descriptor& from, std::string& into) {
  while (into.size() < kLongestLine && read_some(from, into) > 0) continue;
}

}  // namespace

std::string first_words(const std::string& text) {
  constexpr std::size_t most = 80;
  return text.substr(0, std::min(most, text.find('\n')));
}

CommandProcess::CommandProcess(const std::vector<std::string>& words, int plumb) : plumb_(plumb) {
  (void)signal(SIGPIPE, SIG_IGN);
  (void)prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0);  // what it leaves behind comes here
  Pipes pipes{make_pipe(), make_pipe(), make_pipe()};
  program_ = start(words, pipes);
  ended_ = end_of(program_);
  input_ = never_waiting(std::move(pipes.input.to_write));
  output_ = never_waiting(std::move(pipes.output.to_read));
  words_ = never_waiting(std::move(pipes.words.to_read));
}

CommandProcess::~CommandProcess() {
  constexpr int rounds = 500, pause = 1;  // ms: the kernel may take a while to end them
  for (int i = 0; i < rounds; ++i) {
    for (const pid_t one : descendants_of(getpid())) (void)kill(one, SIGKILL);
    while (waitpid(-1, nullptr, WNOHANG) > 0) continue;
    if (waitpid(-1, nullptr, WNOHANG) < 0) return;  // there are none
    (void)poll(nullptr, 0, pause);
  }
}

void CommandProcess::wait_for_plumb() {
  while (!plumb_calls(-1)) continue;
}

bool CommandProcess::plumb_calls(int patience) {
  const bool has_room = lines_.size() < kLongestLine;
  std::array<pollfd, 4> all{{{plumb_, POLLIN, 0},
                             {has_room ? output_.number() : -1, POLLIN, 0},
                             {words_.number(), POLLIN, 0},
                             {has_ended_ ? -1 : ended_.number(), POLLIN, 0}}};
  while (poll(all.data(), all.size(), patience) < 0 && errno == EINTR) continue;
  if (all[1].revents != 0 && read_some(output_, lines_) == 0) output_ = Descriptor();
  if (all[2].revents != 0 && read_some(words_, said_) == 0) words_ = Descriptor();
  if (all[3].revents != 0) hear_the_end();
  reap_orphans();
  if (said_.size() > kWordsKept) said_.erase(0, said_.size() - kWordsKept);
  return all[0].revents != 0;
}

/// What the program started and did not wait for is this process's, and ends as a zombie.
void CommandProcess::reap_orphans() const {
  constexpr int ended = WEXITED | WNOHANG;
  siginfo_t one{};
  while (waitid(P_ALL, 0, &one, ended | WNOWAIT) == 0 && one.si_pid != 0 && one.si_pid != program_)
    (void)waitid(P_PID, static_cast<id_t>(one.si_pid), &one, ended);
}

/// What it wrote before it ended is in the pipes.
void CommandProcess::hear_the_end() {
  has_ended_ = true;
  read_all(output_, lines_);
  read_all(words_, said_);
}

void CommandProcess::send(const std::string& line) {
  const std::string sent = line + "\n";
  const ssize_t taken = write(input_.number(), sent.data(), sent.size());
  if (taken == static_cast<ssize_t>(sent.size())) return;
  if (taken < 0 && errno == EPIPE) throw_end("closed its standard input");
  throw NoLine("does not read its standard input");
}

std::optional<std::string> CommandProcess::next_line() {
  for (;;) {
    if (const std::size_t end = lines_.find('\n'); end != std::string::npos) {
      const std::string line = lines_.substr(0, end);
      lines_.erase(0, end + 1);
      return line;
    }
    if (lines_.size() >= kLongestLine) throw NoLine("sent a line of more than 1 MiB");
    if (has_ended_ || output_.number() < 0) throw_end("closed its standard output");
    if (plumb_calls(-1)) return std::nullopt;
  }
}

/// One that ends says how; what else it did is `otherwise`.
void CommandProcess::throw_end(const std::string& otherwise) {
  if (!has_ended_ && !ends_soon(ended_)) throw NoLine(otherwise);
  hear_the_end();
  throw NoLine(ending(reap(program_)), said_);
}

}  // namespace plumb
