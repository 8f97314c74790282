// plumb bench: the time of one cold solve, by every method and every peer, over fixed sets of pairs.
#include <fmt/format.h>

#include <algorithm>

#include "corpus/command/command.hpp"
#include "corpus/command/interrupt.hpp"
#include "corpus/command/text_table.hpp"
#include "fuzz/peers/shape_peers.hpp"
#include "reports/bench/bench_batch.hpp"
#include "reports/bench/bench_measure.hpp"
#include "reports/bench/bench_sets.hpp"
#include "reports/bench/bench_shapes.hpp"
#include "reports/report_lines.hpp"
#include "solver/method/methods.hpp"

namespace plumb::reports {
namespace {

constexpr std::string_view yardstick = "peer_libccd_epa";

struct Options {
  std::vector<std::string> sets;
  std::string pairs, method = "all";
  ReportLines lines;
  std::int64_t count = 1000;
  std::uint64_t seed = 1;
  bool print = false, count_only = false, warm = false, moving = false, batch = false;
  int repeat = 5, times = 1;
};

void declare(CommandLine& app, Options& options) {
  app.add_option("--set", options.sets,
                 "spheroid, ellipsoid, exponents-8, whole, exponents-40, boxes, capsules, hulls; default: all of them")
      ->delimiter(',');
  app.add_option("--pairs", options.pairs, "cases of a file, .jsonl or one, in the place of the sets");
  app.add_option("--method", options.method, "NAME,.. or all (plumb methods lists them)")->capture_default_str();
  app.add_option("--cases", options.count, "pairs of each set")->capture_default_str()->check(refuse_count);
  declare_seed(app, options.seed, "same seed, same pairs");
  app.add_option("--repeat", options.repeat, "time each pair so often; the least counts")
      ->capture_default_str()
      ->in_range(1, 1000);
  options.lines.declare(app, "one JSON object a line in the place of the table");
  app.add_flag("--print", options.print, "print the cases of the sets, one a line, and time nothing");
  app.add_flag("--count-only", options.count_only, "one method over one set without a clock, for callgrind");
  app.add_option("--times", options.times, "with --count-only: passes over the set")
      ->capture_default_str()
      ->in_range(0, 1'000'000);
  app.add_flag("--batch", options.batch, "with --count-only: all pairs in one batch, in the place of a method");
  app.add_flag("--warm", options.warm, "with --count-only: solve moved pairs from the answers before the move");
  app.add_flag("--moving", options.moving,
               "with --count-only: solve the steps of slow motions, each from the answer before it");
}

struct Named {
  std::string name, of;
  std::vector<Case> cases;
};

std::vector<PairSet> sets_asked(const Options& options) {
  if (options.sets.empty() && !options.pairs.empty()) return {};
  std::vector<PairSet> all = find_sets(pair_sets(), {});
  std::ranges::copy(shape_sets(), std::back_inserter(all));
  return find_sets(all, options.sets);
}

Named drawn(const PairSet& set, const Options& options) {
  return {std::string(set.name), fmt::format("{}, overlap ratio 1e-3..5e-2, seed {}", set.of, options.seed),
          draw(set, static_cast<std::size_t>(options.count), options.seed)};
}

Named read(const std::string& file) {
  Named out{file, "from this file", {}};
  each_case(file, [&](const Case& c, int) { out.cases.push_back(c); });
  return out;
}

/// Hands over each set that was asked for, until Ctrl-C.
template <class Work>
void each_set(const Options& options, const Work& work) {
  if (!options.pairs.empty()) work(read(options.pairs));
  for (const PairSet& set : sets_asked(options)) {
    const Named named = drawn(set, options);
    if (interrupted()) break;
    work(named);
  }
}

Job cold_job(const Named& set, const Solver& solver) {
  Job job{solver, Start::cold, {}};
  for (const Case& c : set.cases) job.tasks.push_back({c.pair, {}, c.convex});
  return job;
}

/// Each pair moved a little, with the answer from before; cold where that did not converge.
Job warm_job(const Named& set, const Solver& solver, std::uint64_t seed) {
  Job job{solver, Start::warm, {}};
  for (std::size_t i = 0; i < set.cases.size(); ++i) {
    const Pair& pair = set.cases[i].pair;
    const Contact<double> before = solver.solve(pair, {}, nullptr);
    job.tasks.push_back({moved(pair, seed, i), {}});
    if (before.status == Status::converged) job.tasks.back().last = before;
  }
  return job;
}

/// Of one pair in twenty, along 60 steps of 1e-3 of the size and along 60 of 1e-4.
Job moving_job(const Named& set, const Solver& solver, std::uint64_t seed) {
  constexpr std::size_t every = 20;
  Job job{solver, Start::moving, {}};
  for (std::size_t i = 0; i < set.cases.size(); i += every)
    for (const double step : {1e-3, 1e-4}) {
      const std::vector<Pair> pairs = motion(set.cases[i].pair, step, seed, i);
      Contact<double> last = solver.solve(pairs[0], {}, nullptr);
      for (std::size_t k = 1; k < pairs.size(); ++k) {
        job.tasks.push_back({pairs[k], {}});
        if (last.status == Status::converged) job.tasks.back().last = last;
        last = solver.solve(pairs[k], {}, last.status == Status::converged ? &last : nullptr);
      }
    }
  return job;
}

// The C door has no `last`.
bool takes_last(const Solver& solver) {
  return find_method(solver.name) != nullptr;
}

/// `auto`, asked for the patch as well: at its default tolerance.
Solver with_patch(Solver solver) {
  solver.name = "auto, with patch";
  solver.solve = [solve = solver.solve](const Pair& pair, Want want, const Contact<double>* last) {
    want.patch = true;
    return solve(pair, want, last);
  };
  return solver;
}

bool is_of_shapes(const Named& set) {
  return !set.cases.empty() && set.cases[0].convex;
}

/// Of those asked for what takes shapes: `auto`, and peers in a form of their own.
std::vector<Solver> solvers_of_shapes(const std::vector<Solver>& asked) {
  std::vector<Solver> out;
  const std::vector<Solver> peers = peers::shape_peers();
  for (const Solver& solver : asked) {
    if (solver.solve_convex) out.push_back(solver);
    std::ranges::copy_if(peers, std::back_inserter(out),
                         [&](const Solver& peer) { return peer.name.starts_with(solver.name); });
  }
  return out;
}

std::vector<Job> jobs_of(const Named& set, const std::vector<Solver>& solvers, std::uint64_t seed) {
  std::vector<Job> jobs;
  if (is_of_shapes(set)) {
    for (const Solver& solver : solvers_of_shapes(solvers)) jobs.push_back(cold_job(set, solver));
    if (jobs.empty()) throw InputFailure("plumb bench", 0, "--method", "none of them takes the shapes of " + set.name);
    return jobs;
  }
  for (const Solver& solver : solvers) {
    jobs.push_back(cold_job(set, solver));
    if (!takes_last(solver)) continue;
    jobs.push_back(warm_job(set, solver, seed));
    jobs.push_back(moving_job(set, solver, seed));
    if (solver.name != "auto") continue;
    jobs.push_back(cold_job(set, with_patch(solver)));
    jobs.push_back(warm_job(set, with_patch(solver), seed));
  }
  return jobs;
}

std::string_view name(Start start) {
  return start == Start::cold ? "cold" : start == Start::warm ? "warm" : "moving";
}

/// To the cold yardstick's median of the same set in the same run, the median, or the mean of a motion's steps; NaN where that was not
/// measured.
double ratio(const Measurement& measured, const std::vector<Measurement>& all) {
  for (const Measurement& other : all)
    if (other.method == yardstick && other.start == Start::cold)
      return (measured.start == Start::moving ? measured.mean_ns : measured.median_ns) / other.median_ns;
  return std::numeric_limits<double>::quiet_NaN();
}

/// How long a refusal takes is no answer to how long an answer does.
bool answers(const Measurement& measured) {
  return measured.not_converged < 1;
}

Json to_json(const Named& set, const Measurement& m, const std::vector<Measurement>& all) {
  Json line{{"set", set.name},    {"of", set.of},           {"pairs", set.cases.size()},       {"solves", m.solves},
            {"method", m.method}, {"start", name(m.start)}, {"not_converged", m.not_converged}};
  if (!answers(m)) return line;
  line["mean_ns"] = m.mean_ns;
  line["median_ns"] = m.median_ns;
  line["p99_ns"] = m.p99_ns;
  if (const double r = ratio(m, all); r > 0) line["ratio_to_" + std::string(yardstick)] = r;
  if (m.most_iterations > 0) line["iterations"] = {{"median", m.median_iterations}, {"max", m.most_iterations}};
  return line;
}

/// The peers count no iterations.
std::string iterations_text(const Measurement& m) {
  return m.most_iterations > 0 ? fmt::format("{:.0f}/{:.0f}", m.median_iterations, m.most_iterations) : "-";
}

const TextTable measured({{"method", "<27"},
                          {"start", "<6"},
                          {"mean", ">8.3f", " us"},
                          {"median", ">8.3f", " us"},
                          {"p99", ">11.3f", " us"},
                          {"p99/med", ">9.1f"},
                          {"/EPA", ">9"},
                          {"iter", ">10"},
                          {"not conv.%", ">12.1f"}},
                         "  ");
const TextTable refused({{"", "<27"}, {"", "<6"}, {"", ">54", " "}, {"", ">10"}, {"", ">12.1f"}}, "  ");

std::string row_text(const Measurement& m, double ratio) {
  const double lost = 100 * m.not_converged;
  if (!answers(m)) return refused.row(m.method, name(m.start), "no answer", iterations_text(m), lost);
  return measured.row(m.method, name(m.start), m.mean_ns * 1e-3, m.median_ns * 1e-3, m.p99_ns * 1e-3,
                      m.p99_ns / m.median_ns, ratio > 0 ? fmt::format("{:.4f}", ratio) : "-", iterations_text(m), lost);
}

void print_table(const Named& set, const std::vector<Measurement>& all) {
  print_line(fmt::format("{}: {} pairs, {}", set.name, set.cases.size(), set.of));
  print_line(measured.head());
  for (const Measurement& m : all) print_line(row_text(m, ratio(m, all)));
}

/// The batch beside the loop that it is to beat.
void print_batches(const std::vector<BatchMeasurement>& all) {
  for (const BatchMeasurement& m : all)
    print_line(fmt::format("  {:<27}{:<6}{:>7.3f} us a pair, {:.2f} x auto in a loop, {:.1f} % handed to auto",
                           fmt::format("batch, {}", m.set), name(m.start), m.ns * 1e-3, m.ratio, 100 * m.alone));
}

Json to_json(const Named& set, const BatchMeasurement& m) {
  return {{"set", set.name},
          {"of", set.of},
          {"pairs", set.cases.size()},
          {"method", "batch"},
          {"start", name(m.start)},
          {"instructions", m.set},
          {"ns", m.ns},
          {"ratio_of_auto", m.ratio},
          {"alone", m.alone}};
}

/// Only where `auto` is measured as well, of superellipsoids.
std::vector<BatchMeasurement> batches(const std::vector<Job>& jobs, int repeats) {
  std::vector<BatchMeasurement> out;
  for (const Job& job : jobs)
    if (job.solver.name == "auto" && job.start != Start::warm && !job.tasks[0].convex)
      std::ranges::copy(measure_batches(job, repeats), std::back_inserter(out));
  return out;
}

/// Of the start that was asked for.
Job job_asked(const Named& set, const Solver& solver, const Options& options) {
  if (is_of_shapes(set) && (options.moving || options.warm || options.batch))
    throw InputFailure("plumb bench", 0, "--set", set.name + ": shapes are solved cold, one pair after the other");
  if (is_of_shapes(set) && !solver.solve_convex)
    throw InputFailure("plumb bench", 0, "--method", solver.name + ": takes no shapes here; auto does");
  return options.moving ? moving_job(set, solver, options.seed)
         : options.warm ? warm_job(set, solver, options.seed)
                        : cold_job(set, solver);
}

int count_batch(const Options& options) {
  each_set(options, [&](const Named& set) {
    const Job job = job_asked(set, find_solvers("auto")[0], options);
    solve_batches(job, options.times);
    print_line(fmt::format("{} x {} {} solves by batch, {}", options.times, job.tasks.size(), name(job.start),
                           name(best_instruction_set())));
  });
  return exit_done;
}

int print_cases(const Options& options) {
  each_set(options, [](const Named& set) {
    for (const Case& c : set.cases) print_line(format_case(c));
  });
  return exit_done;
}

/// Each call is timed from outside.
std::vector<Solver> solvers_here(const std::string& names) {
  std::vector<Solver> solvers = find_solvers(names);
  for (Solver& solver : solvers) solver = in_process(solver);
  return solvers;
}

int count(const Options& options) {
  const std::vector<Solver> solvers = solvers_here(options.method);
  if (solvers.size() != 1 || options.sets.size() + (options.pairs.empty() ? 0 : 1) != 1)
    throw InputFailure("plumb bench", 0, "--count-only", "needs one --method, and one --set or --pairs");
  each_set(options, [&](const Named& set) {
    const Job job = job_asked(set, solvers[0], options);
    for (int pass = 0; pass < options.times && !interrupted(); ++pass)
      for (const Task& task : job.tasks) solve(job.solver, task);
    print_line(
        fmt::format("{} x {} {} solves by {}", options.times, job.tasks.size(), name(job.start), job.solver.name));
  });
  return exit_done;
}

/// Of each job on shapes; empty of a set of superellipsoids.
std::vector<OverlapErrors> errors_in(const Named& set, const std::vector<Job>& jobs) {
  std::vector<OverlapErrors> out;
  if (is_of_shapes(set)) std::ranges::transform(jobs, std::back_inserter(out), overlap_errors_of);
  return out;
}

void print_errors(const std::vector<Measurement>& all, const std::vector<OverlapErrors>& errors) {
  for (std::size_t i = 0; i < errors.size(); ++i)
    if (answers(all[i]))
      print_line(fmt::format("  {:<27}overlap off by {:.1e} of the size, {:.1e} at most", all[i].method,
                             errors[i].median, errors[i].most));
}

int bench(Options& options) {
  const std::vector<Solver> solvers = solvers_here(options.method);
  each_set(options, [&](const Named& set) {
    const std::vector<Job> jobs = jobs_of(set, solvers, options.seed);
    const std::vector<Measurement> all = measure(jobs, options.repeat);
    const std::vector<BatchMeasurement> of_batch = batches(jobs, options.repeat);
    const std::vector<OverlapErrors> errors = errors_in(set, jobs);
    if (interrupted()) return;
    if (!options.lines.is_json()) print_table(set, all);
    if (!options.lines.is_json()) print_batches(of_batch);
    if (!options.lines.is_json()) print_errors(all, errors);
    for (std::size_t i = 0; i < all.size(); ++i) {
      Json line = to_json(set, all[i], all);
      if (i < errors.size() && answers(all[i]))
        line["overlap_error"] = {{"median", errors[i].median}, {"max", errors[i].most}};
      options.lines.add(line);
    }
    for (const BatchMeasurement& m : of_batch) options.lines.add(to_json(set, m));
    flush_output();
  });
  options.lines.write();
  return exit_done;
}

int run(Options& options) {
  if (options.print) return print_cases(options);
  if (options.count_only) return options.batch ? count_batch(options) : count(options);
  return bench(options);
}

}  // namespace
}  // namespace plumb::reports

int main(int argc, char** argv) {
  plumb::reports::Options options;
  plumb::CommandLine app("The time of one solve, cold and warm, by every method and peer, over fixed sets of pairs.",
                         "plumb bench");
  plumb::reports::declare(app, options);
  return plumb::run_command(app, argc, argv, [&] { return plumb::reports::run(options); });
}
