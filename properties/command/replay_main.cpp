// plumb replay: every kept case against what it expects.
#include <fmt/format.h>

#include <atomic>
#include <exception>
#include <map>
#include <mutex>
#include <thread>

#include "corpus/certificate/reference_store.hpp"
#include "corpus/command/command.hpp"
#include "corpus/command/in_parallel.hpp"
#include "properties/command/replay_case.hpp"
#include "properties/command/replay_reports.hpp"
#include "properties/laws/accuracy_option.hpp"

namespace plumb {
namespace {

struct Options {
  std::vector<std::string> paths;
  std::string method;
  ForeignOption foreign;
  std::string junit;
  std::string sarif;
  std::string cache;
  std::string accuracy;
  unsigned threads = std::max(1u, std::thread::hardware_concurrency());
  bool quiet = false;
};

void declare(CommandLine& app, Options& options) {
  app.add_option("PATH", options.paths, "case files, and folders of them")->required();
  auto* method = app.add_option("--method", options.method, "instead of the method that each case names");
  declare_solver(app, options.foreign, "the same, a shared library (solver/plumb_solver.h)", method);
  declare_accuracy_of_cases(app, options.accuracy);
  app.add_option("--junit", options.junit, "write JUnit XML to this file");
  app.add_option("--sarif", options.sarif, "write SARIF 2.1.0 to this file");
  app.add_option("--cache", options.cache, cache_help);
  app.add_option("--threads", options.threads, "changes nothing but the time")->in_range(1, 1024);
  app.add_flag("--quiet", options.quiet, "print the cases that differ or were not judged, and the last line, only");
}

/// How every case is replayed.
struct By {
  std::optional<Solver> instead;
  ReferenceSource source;
  std::optional<Accuracy> accuracy;  ///< none: that of each case
};

struct Kept {
  Case c;
  std::string file;
  int line = 0;
};

/// What is read before a line that is none, and that line's failure.
struct Reading {
  std::vector<Kept> cases;
  std::exception_ptr failure;
};

Reading read_all(const std::vector<std::string>& paths) {
  Reading out;
  try {
    for (const auto& file : find_case_files(paths)) {
      CaseReader reader(file.string(), CaseShapes::every);
      for (std::optional<Case> c = reader.next(); c; c = reader.next())
        out.cases.push_back({*std::move(c), file.string(), reader.line()});
    }
  } catch (const InputFailure&) {
    out.failure = std::current_exception();
  }
  return out;
}

/// Replays the cases on several threads, and prints them in their order, each as soon as those before it are done.
class InOrder {
 public:
  InOrder(const std::vector<Kept>& cases, const By& by, bool quiet) : cases_(cases), by_(by), quiet_(quiet) {}

  /// Those that are done, up to the first that is not: all of them but after Ctrl-C, or before one that cannot be replayed.
  [[nodiscard]] std::vector<Replayed> run(unsigned threads) {
    in_parallel(cases_.size(), threads, [this](std::size_t i) { work(i); });
    return std::move(printed_);
  }
  /// Why one could not be replayed; null: all could.
  [[nodiscard]] std::exception_ptr failure() const { return failure_; }

 private:
  void work(std::size_t i) {
    if (has_failed_) return;
    const auto& [c, file, line] = cases_[i];
    Ended ended;
    try {
      const Accuracy accuracy = by_.accuracy ? *by_.accuracy : accuracy_of_case(c, file, line);
      ended.done = replay_case(c, file, line, by_.instead, by_.source, accuracy);
    } catch (...) {
      ended.failure = std::current_exception();
    }
    const std::scoped_lock lock(mutex_);
    waiting_.emplace(i, std::move(ended));
    try {
      print_ready();
    } catch (...) {  // what cannot be written
      failure_ = std::current_exception();
    }
    has_failed_ = failure_ != nullptr;
  }

  void print_ready() {
    for (auto first = waiting_.begin(); first != waiting_.end() && first->first == printed_.size() && !failure_;
         first = waiting_.erase(first)) {
      failure_ = first->second.failure;
      if (failure_) return;
      printed_.push_back(std::move(first->second.done));
      if (!quiet_ || outcome(printed_.back()) != Outcome::as_expected) print_line(replay_line(printed_.back()));
    }
  }

  struct Ended {
    Replayed done;
    std::exception_ptr failure;
  };

  const std::vector<Kept>& cases_;
  const By& by_;
  bool quiet_;
  std::atomic<bool> has_failed_{false};
  std::mutex mutex_;
  std::map<std::size_t, Ended> waiting_;
  std::vector<Replayed> printed_;
  std::exception_ptr failure_;
};

void write_reports(const Options& options, const std::vector<Replayed>& done) {
  if (!options.junit.empty()) write_file(options.junit, junit_report(done, !interrupted()));
  if (!options.sarif.empty()) write_file(options.sarif, sarif_report(done, !interrupted()));
}

int replay(const Options& options) {
  const auto store = open_store(options.cache);
  const By by{solver_instead(options.foreign, options.method, "replay"), references_of(store),
              accuracy_instead(options.accuracy)};
  const Reading reading = read_all(options.paths);
  InOrder in_order(reading.cases, by, options.quiet);
  const std::vector<Replayed> done = in_order.run(options.threads);
  if (in_order.failure()) std::rethrow_exception(in_order.failure());
  if (reading.failure && !interrupted()) std::rethrow_exception(reading.failure);
  if (done.empty() && !interrupted()) throw InputFailure(options.paths.front(), 0, "", "holds no case");
  write_reports(options, done);
  if (store) fmt::print(stderr, "{}\n", in_words(store->counts()));
  print_line(replay_total(done, !interrupted()));
  return count_of(done, Outcome::differs) > 0 ? exit_finding : exit_done;
}

}  // namespace
}  // namespace plumb

int main(int argc, char** argv) {
  plumb::Options options;
  plumb::CommandLine app("Run kept cases against what they expect; 1 when one differs.", "plumb replay");
  plumb::declare(app, options);
  return plumb::run_command(app, argc, argv, [&] { return plumb::replay(options); });
}
