// plumb report-certify-cost: what a certificate costs, at each effort and against a solve in double.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "corpus/command/command.hpp"
#include "corpus/command/interrupt.hpp"
#include "corpus/command/text_table.hpp"
#include "properties/generators/families.hpp"
#include "reports/bench/quantile.hpp"
#include "reports/certified/parts.hpp"
#include "reports/processor_time.hpp"
#include "reports/report_lines.hpp"
#include "solver/method/methods.hpp"
#include "solver/reference/reference.hpp"

namespace plumb::reports {
namespace {

constexpr int repetitions = 3;  // of each measurement; the least counts

struct Options {
  std::int64_t cases = 200;
  std::uint64_t seed = 1;
  ReportLines lines;
};

void declare(CommandLine& app, Options& options) {
  app.add_option("--cases", options.cases, "cases of each family")->capture_default_str()->check(refuse_count);
  declare_seed(app, options.seed);
  options.lines.declare(app, "one JSON object a family in the place of the table");
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

/// The least time of the repetitions, ms. What `work` returns is kept, so that none of it is left out.
template <class Work>
double least_time(const Work& work) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < repetitions; ++i) {
    const double start = processor_time();
    [[maybe_unused]] const volatile bool kept = work();
    least = std::min(least, 1e3 * (processor_time() - start));
  }
  return least;
}

double median(const std::vector<double>& x) {
  return quantile(x, 0.5);
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

/// Without a head: each cell says what it is.
const TextTable columns({{"", "<8"}, {"", ">9.3f", " ms"}, {"", ">9.0f", " x new_cn"}, {"", ">7", " cells"}, {"", ""}},
                        "  ");

void print_row(const Row& row, const Times& times, const Options& options) {
  print_line(fmt::format("{}, {}: {} cases{}, new_cn {:.4f} ms", row.family, row.cases, times.method.size(),
                         is_cut_short(times, options) ? " (interrupted: incomplete)" : "", median(times.method)));
  for (std::size_t k = 0; k < efforts.size(); ++k) {
    const double ms = median(times.effort[k]);
    std::string budget;
    if (k < row.budget.size())
      budget = fmt::format("   budget {:>4} ms: {}", row.budget[k], ms <= row.budget[k] ? "met" : "NOT MET");
    print_line(columns.row(name(efforts[k]), ms, median(times.ratio[k]), median(times.cells[k]), budget));
  }
}

int report(Options& options) {
  for (const Row& row : rows) {
    if (interrupted()) break;
    const Times times = run(row, options);
    options.lines.add(to_json(row, times, options));
    if (!options.lines.is_json()) print_row(row, times, options);
    flush_output();
  }
  options.lines.write();
  return exit_done;
}

}  // namespace

int report_certify_cost(int argc, char** argv) {
  Options options;
  CommandLine app("Median times of the reference at its three efforts, and of new_cn.", "plumb report-certify-cost");
  declare(app, options);
  return run_command(app, argc, argv, [&] { return report(options); });
}

}  // namespace plumb::reports
