// plumb report-certify-cost: what a certificate costs, at each effort and against a solve in double.
#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <array>

#include "corpus/command/command.hpp"
#include "corpus/command/interrupt.hpp"
#include "properties/generators/families.hpp"
#include "solver/method/methods.hpp"
#include "solver/reference/reference.hpp"

namespace plumb::reports {
namespace {

constexpr int repetitions = 3;  // of each measurement; the least counts

struct Options {
  std::int64_t cases = 200;
  std::uint64_t seed = 1;
  bool json = false;
  std::string out;
};

void declare(CommandLine& app, Options& options) {
  app.add_option("--cases", options.cases, "cases of each family")->capture_default_str()->check(refuse_count);
  declare_seed(app, options.seed);
  app.add_flag("--json", options.json, "one JSON object a family in the place of the table");
  app.add_option("--out", options.out, "file for the JSON objects, one a line");
}

/// A family with the budgets of its two cheaper efforts, ms.
struct Row {
  std::string_view family, cases;
  std::array<double, 2> budget;
};
constexpr std::array rows{Row{"spheroid", "aspect 1/3..3", {0.3, 1}}, Row{"ellipsoid", "aspect to 20", {0.3, 1}},
                          Row{"superquadric", "exponents 2..8", {3, 10}}};

bool is_within(const Pair& pair) {
  const auto fits = [](double n) { return n >= 2 && n <= 8; };
  return fits(pair.body1.shape.n1) && fits(pair.body1.shape.n2) && fits(pair.body2.shape.n1) &&
         fits(pair.body2.shape.n2);
}

/// Processor time of the process, ms: the machine may be shared.
double now() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

/// The least time of the repetitions, ms. What `work` returns is kept, so that none of it is left out.
template <class Work>
double least_time(const Work& work) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < repetitions; ++i) {
    const double start = now();
    [[maybe_unused]] const volatile bool kept = work();
    least = std::min(least, now() - start);
  }
  return least;
}

double median(std::vector<double> x) {
  if (x.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = x.begin() + static_cast<std::ptrdiff_t>(x.size() / 2);
  std::nth_element(x.begin(), middle, x.end());
  return *middle;
}

struct Times {
  std::vector<double> method;
  std::array<std::vector<double>, efforts.size()> effort, ratio, cells;
};

void measure(const Pair& pair, Times& times) {
  const auto new_cn = find_method("new_cn")->solve;
  const double method = least_time([&] { return new_cn(pair, {}, nullptr).iterations > 0; });
  times.method.push_back(method);
  for (std::size_t k = 0; k < efforts.size(); ++k) {
    int cells = 0;
    const double time = least_time([&] { return (cells = find_reference(pair, efforts[k]).cells) > 0; });
    times.cells[k].push_back(cells);
    times.effort[k].push_back(time);
    times.ratio[k].push_back(time / method);
  }
}

Times run(const Row& row, const Options& options) {
  Times times;
  for (std::uint64_t i = 0; times.method.size() < static_cast<std::size_t>(options.cases) && !interrupted(); ++i) {
    const Case c = generate(row.family, options.seed, i);
    if (is_within(c.pair)) measure(c.pair, times);
  }
  return times;
}

bool is_cut_short(const Times& times, const Options& options) {
  return times.method.size() < static_cast<std::size_t>(options.cases);
}

Json to_json(const Row& row, const Times& times, const Options& options) {
  Json out{{"family", row.family}, {"cases", times.method.size()}, {"of", row.cases}, {"seed", options.seed}};
  if (is_cut_short(times, options)) out["incomplete"] = true;
  out["new_cn_ms"] = median(times.method);
  for (std::size_t k = 0; k < efforts.size(); ++k) {
    Json entry{{"median_ms", median(times.effort[k])},
               {"median_ratio_to_new_cn", median(times.ratio[k])},
               {"median_cells", median(times.cells[k])}};
    if (k < row.budget.size()) entry["budget_ms"] = row.budget[k];
    out[std::string(name(efforts[k]))] = std::move(entry);
  }
  return out;
}

void print_row(const Row& row, const Times& times, const Options& options) {
  print_line(fmt::format("{}, {}: {} cases{}, new_cn {:.4f} ms", row.family, row.cases, times.method.size(),
                         is_cut_short(times, options) ? " (interrupted: incomplete)" : "", median(times.method)));
  for (std::size_t k = 0; k < efforts.size(); ++k) {
    const double ms = median(times.effort[k]);
    std::string budget;
    if (k < row.budget.size())
      budget = fmt::format("   budget {:>4} ms: {}", row.budget[k], ms <= row.budget[k] ? "met" : "NOT MET");
    print_line(fmt::format("  {:<8}{:>9.3f} ms{:>9.0f} x new_cn{:>7} cells{}", name(efforts[k]), ms,
                           median(times.ratio[k]), median(times.cells[k]), budget));
  }
}

int report(const Options& options) {
  std::string lines;
  for (const Row& row : rows) {
    if (interrupted()) break;
    const Times times = run(row, options);
    const std::string line = write_json(to_json(row, times, options));
    lines += line + "\n";
    if (options.json)
      print_line(line);
    else
      print_row(row, times, options);
    flush_output();
  }
  if (!options.out.empty()) write_file(options.out, lines);
  return exit_done;
}

}  // namespace
}  // namespace plumb::reports

int main(int argc, char** argv) {
  plumb::reports::Options options;
  plumb::CommandLine app("Median times of the reference at its three efforts, and of new_cn.",
                         "plumb report-certify-cost");
  plumb::reports::declare(app, options);
  return plumb::run_command(app, argc, argv, [&] { return plumb::reports::report(options); });
}
