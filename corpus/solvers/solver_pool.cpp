#include "corpus/solvers/solver_pool.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace plumb {
namespace {

struct Memory {
  double heap = 0, resident = 0;
};

Memory memory_of(SolverProcess& process) {
  wire::Request request;
  request.kind = wire::Request::Kind::measure_memory;
  const wire::Reply reply = process.ask(request);
  return {static_cast<double>(reply.heap_bytes), static_cast<double>(reply.resident_bytes)};
}

/// The place of the pair without an answer.
std::optional<std::size_t> ask_in_turn(SolverProcess& process, const std::vector<plumb_pair>& pairs,
                                       std::size_t calls) {
  wire::Request request;
  for (std::size_t call = 0; call < calls; ++call) {
    request.pair = pairs[call % pairs.size()];
    try {
      (void)process.ask(request);
    } catch (const NoAnswer& e) {
      if (e.how == NoAnswer::How::hung) throw;
      return call % pairs.size();
    }
  }
  return std::nullopt;
}

constexpr std::size_t kLeastCalls = 64;  // in a pass
constexpr int kPasses = 6;               // that are measured
// Below this a pass's growth of resident memory is the allocator's unrest; the heap in use is exact.
constexpr double kLeastResident = 4.0 * 4096;

/// What the heap, or else the resident memory, grew by in each of the passes, least of all.
struct Growth {
  double heap = std::numeric_limits<double>::infinity(), resident = heap;
  void add(double heap_grew, double resident_grew) {
    heap = std::min(heap, heap_grew);
    resident = std::min(resident, resident_grew);
  }
  [[nodiscard]] double bytes() const { return std::max({0.0, heap, resident >= kLeastResident ? resident : 0.0}); }
};

/// Passes over the same pairs: what is taken once, or once for each pair, is taken in the first, which does not count. Or else the
/// place of the pair without an answer.
struct Measured {
  std::optional<std::size_t> failed_at;
  Growth growth;
};

Measured measure_growth(SolverProcess& process, const std::vector<plumb_pair>& pairs, std::size_t calls) {
  Measured out{ask_in_turn(process, pairs, calls), {}};
  Memory before;
  for (int pass = 0; pass <= kPasses && !out.failed_at; ++pass) {
    const Memory after = memory_of(process);
    if (pass > 0) out.growth.add(after.heap - before.heap, after.resident - before.resident);
    before = after;
    if (pass < kPasses) out.failed_at = ask_in_turn(process, pairs, calls);
  }
  return out;
}

/// Of a program only its resident memory is known, and one that collects its garbage grows for thousands of calls without a leak: what
/// looks like one is looked at again, in passes of four times the calls, unless six passes grew by more than a collector leaves lying.
constexpr int kProgramRounds = 4;
constexpr std::size_t kMoreCalls = 4;
constexpr double kNoGarbage = 16 << 20;  // bytes in each pass

struct Looked {
  std::optional<std::size_t> failed_at;
  std::optional<Leak> leak;
};

Looked look_for_leak(SolverProcess& process, const std::vector<plumb_pair>& pairs, int rounds) {
  std::size_t calls = std::max(kLeastCalls, pairs.size());
  for (int round = 1;; ++round, calls *= kMoreCalls) {
    const Measured measured = measure_growth(process, pairs, calls);
    const double bytes = measured.growth.bytes();
    if (measured.failed_at || !(bytes > 0)) return {measured.failed_at, std::nullopt};
    if (round == rounds || bytes >= kNoGarbage)
      return {std::nullopt, Leak{bytes / static_cast<double>(calls), kPasses * calls}};
  }
}

}  // namespace

SolverPool::SolverPool(SolverSource source, const SolverLimits& limits) : source_(std::move(source)), limits_(limits) {}

wire::Hello SolverPool::start() {
  auto process = std::make_unique<SolverProcess>(source_, limits_);
  const wire::Hello hello = process->hello();
  give_back(std::move(process));
  return hello;
}

SolverPool::Process SolverPool::take() {
  {
    const std::scoped_lock lock(mutex_);
    if (!idle_.empty()) {
      Process process = std::move(idle_.back());
      idle_.pop_back();
      return process;
    }
  }
  return std::make_unique<SolverProcess>(source_, limits_);
}

void SolverPool::give_back(Process process) {
  const std::scoped_lock lock(mutex_);
  idle_.push_back(std::move(process));
}

wire::Reply SolverPool::ask(const wire::Request& request) {
  if (hangs_ >= most_hangs)
    throw NoAnswer(NoAnswer::How::not_asked, fmt::format("not asked any more: {} times no answer before", most_hangs));
  Process process = take();
  try {
    wire::Reply reply = process->ask(request);
    give_back(std::move(process));
    if (reply.kind != wire::Reply::Kind::threw) return reply;
    throw NoAnswer(NoAnswer::How::crashed, "threw an exception through C: " + reply.what.text());
  } catch (const NoAnswer& e) {
    if (e.how == NoAnswer::How::hung) ++hangs_;
    if (process == nullptr || e.how == NoAnswer::How::hung || !answers_when_first(request)) throw;
    throw NoAnswer(e.how, std::string(e.what()) + "; but answers where this is the first pair that it is asked");
  }
}

/// Whether a process that knows no other pair answers: whoever looks for the bug wants to know.
bool SolverPool::answers_when_first(const wire::Request& request) {
  auto process = std::make_unique<SolverProcess>(source_, limits_);
  try {
    (void)process->ask(request);
  } catch (const NoAnswer&) {
    return false;
  }
  give_back(std::move(process));
  return true;
}

std::optional<Leak> SolverPool::find_leak(std::vector<plumb_pair> pairs) const {
  constexpr int most_failures = 16;
  if (source_.is_command() && pairs.size() > kLeastCalls) pairs.resize(kLeastCalls);
  try {
    for (int failures = 0; failures < most_failures && !pairs.empty(); ++failures) {
      SolverProcess process(source_, limits_);
      const Looked looked = look_for_leak(process, pairs, source_.is_command() ? kProgramRounds : 1);
      if (!looked.failed_at) return looked.leak;
      pairs.erase(pairs.begin() + static_cast<std::ptrdiff_t>(*looked.failed_at));
    }
  } catch (const NoAnswer&) {
    return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace plumb
