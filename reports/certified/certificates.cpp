// plumb report-certified: how much the reference proves, and whether anything found without it contradicts it.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>

#include "corpus/command/command.hpp"
#include "corpus/command/interrupt.hpp"
#include "corpus/command/text_table.hpp"
#include "properties/generators/families.hpp"
#include "reports/certified/compared.hpp"
#include "reports/certified/parts.hpp"
#include "reports/report_lines.hpp"

namespace plumb::reports {
namespace {

struct Options {
  std::string family = "all";
  std::string effort = "digits";
  std::int64_t cases = 0;
  std::uint64_t seed = 1;
  ReportLines lines;
};

void declare(CommandLine& app, Options& options) {
  std::vector<std::string> names = family_names();
  names.emplace_back("all");
  app.add_option("--cases", options.cases, "cases of each family")->required()->check(refuse_count);
  declare_seed(app, options.seed);
  app.add_option("--family", options.family, "one family, or all")->capture_default_str()->is_one_of("family", names);
  app.add_option("--effort", options.effort, "how far the reference goes: bounds, proof or digits")
      ->capture_default_str()
      ->is_one_of("effort", std::vector<std::string>{"bounds", "proof", "digits"});
  options.lines.declare(app, "one JSON object a family in the place of the table");
}

/// What a group of cases came to.
struct Tally {
  int cases = 0, global = 0, unique_or_tied = 0, both = 0, verdict = 0;
  std::array<int, 4> comparisons{};
  std::vector<double> gaps;

  void add(const Compared& c) {
    ++cases;
    global += c.global;
    unique_or_tied += c.unique_or_tied;
    both += c.global && c.unique_or_tied;
    verdict += c.verdict;
    ++comparisons[static_cast<std::size_t>(c.comparison)];
    gaps.push_back(c.gap);
  }
  [[nodiscard]] int compared(Comparison c) const { return comparisons[static_cast<std::size_t>(c)]; }
};

/// Cases with one thing in common, and the largest number that goes with it.
struct Named {
  std::vector<std::string> cases;
  double largest = 0;
};
using Reasons = std::map<std::string, Named>;

void add(Reasons& reasons, const std::string& reason, const std::string& name, double number) {
  Named& entry = reasons[reason];
  entry.cases.push_back(name);
  entry.largest = std::max(entry.largest, number);
}

struct Result {
  std::string family;
  std::vector<Tally> tallies = std::vector<Tally>(groups().size());
  Reasons open;      ///< with the widest gap
  Reasons unsolved;  ///< with the largest residual of the six equations
  Reasons contradictions;
  double seconds = 0;
  int cases = 0;

  void add(const Compared& c) {
    ++cases;
    tallies[static_cast<std::size_t>(c.group)].add(c);
    if (!c.reason.empty()) reports::add(open, c.reason, c.name, c.gap);
    if (c.comparison == Comparison::unsolved) reports::add(unsolved, c.stall, c.name, c.residual);
    for (const std::string& what : c.contradictions) reports::add(contradictions, what, c.name, 0);
  }
};

Effort effort_of(const Options& options) {
  return *std::find_if(efforts.begin(), efforts.end(), [&](Effort e) { return name(e) == options.effort; });
}

Result run(const std::string& family, const Options& options) {
  const auto start = std::chrono::steady_clock::now();
  const Effort effort = effort_of(options);
  Result result;
  result.family = family;
  for (std::int64_t i = 0; i < options.cases && !interrupted(); ++i)
    result.add(compare(generate(family, options.seed, static_cast<std::uint64_t>(i)), effort));
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  for (Tally& tally : result.tallies) std::sort(tally.gaps.begin(), tally.gaps.end());
  return result;
}

double quantile(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) return 0;
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

/// JSON has no infinity.
Json number(double x) {
  return std::isfinite(x) ? Json(x) : Json("infinite");
}

Json to_json(const Tally& tally, const std::string& group) {
  return {{"exponents", group},
          {"cases", tally.cases},
          {"global", tally.global},
          {"unique_or_tied", tally.unique_or_tied},
          {"global_and_unique_or_tied", tally.both},
          {"verdict", tally.verdict},
          {"gap_over_size",
           {{"p50", number(quantile(tally.gaps, 0.5))},
            {"p99", number(quantile(tally.gaps, 0.99))},
            {"max", number(quantile(tally.gaps, 1))}}},
          {"compared",
           {{"by_method", tally.compared(Comparison::by_method)},
            {"by_disturbed", tally.compared(Comparison::by_disturbed)},
            {"elsewhere", tally.compared(Comparison::elsewhere)},
            {"unsolved", tally.compared(Comparison::unsolved)}}}};
}

Json to_json(const Reasons& reasons, const char* largest) {
  Json out = Json::array();
  for (const auto& [reason, named] : reasons) {
    Json entry{{"reason", reason}, {"count", named.cases.size()}};
    if (*largest != '\0') entry[largest] = number(named.largest);
    entry["cases"] = named.cases;
    out.push_back(std::move(entry));
  }
  return out;
}

Json to_json(const Result& result, const Options& options) {
  Json out{{"family", result.family},
           {"effort", options.effort},
           {"seed", options.seed},
           {"cases", result.cases},
           {"seconds", result.seconds}};
  if (result.cases < options.cases) out["incomplete"] = true;
  out["groups"] = Json::array();
  for (std::size_t k = 0; k < groups().size(); ++k)
    if (result.tallies[k].cases > 0) out["groups"].push_back(to_json(result.tallies[k], groups()[k]));
  out["contradictions"] = to_json(result.contradictions, "");
  out["open"] = to_json(result.open, "widest_gap_over_size");
  out["six_equations_unsolved"] = to_json(result.unsolved, "largest_residual");
  return out;
}

/// What is not all must not look like it.
std::string percent(int part, int whole) {
  if (part == whole) return "100";
  return fmt::format("{:.2f}", std::min(99.99, 100.0 * part / whole));
}

void print_reasons(const std::string& title, const Reasons& reasons, const char* largest) {
  constexpr std::size_t shown = 3;
  for (const auto& [reason, named] : reasons) {
    const std::string number = *largest == '\0' ? "" : fmt::format(", {} {:.1e}", largest, named.largest);
    print_line(fmt::format("  {}: {} ({} cases{})", title, reason, named.cases.size(), number));
    for (std::size_t k = 0; k < std::min(shown, named.cases.size()); ++k) print_line("      " + named.cases[k]);
  }
}

const TextTable columns({{"exponents", "<10"},
                         {"cases", ">7"},
                         {"global%", ">9"},
                         {"unique%", ">9"},
                         {"both%", ">9"},
                         {"verdict%", ">9"},
                         {"gap p50", ">9"},
                         {"p99", ">9"},
                         {"max", ">9"},
                         {"method", ">8"},
                         {"disturbed", ">10"},
                         {"elsewhere", ">10"},
                         {"unsolved", ">9"}},
                        "  ");

void print_table(const Result& result, const Options& options) {
  print_line(fmt::format("{}: {} cases, seed {}, effort {}, {:.0f} s{}", result.family, result.cases, options.seed,
                         options.effort, result.seconds,
                         result.cases < options.cases ? " (interrupted: incomplete)" : ""));
  print_line(columns.head());
  for (std::size_t k = 0; k < groups().size(); ++k) {
    const Tally& t = result.tallies[k];
    if (t.cases == 0) continue;
    const auto gap = [&](double share) { return fmt::format("{:.1e}", quantile(t.gaps, share)); };
    print_line(columns.row(groups()[k], t.cases, percent(t.global, t.cases), percent(t.unique_or_tied, t.cases),
                           percent(t.both, t.cases), percent(t.verdict, t.cases), gap(0.5), gap(0.99), gap(1),
                           t.compared(Comparison::by_method), t.compared(Comparison::by_disturbed),
                           t.compared(Comparison::elsewhere), t.compared(Comparison::unsolved)));
  }
  print_line(fmt::format("  contradictions: {}", result.contradictions.size()));
  print_reasons("CONTRADICTION", result.contradictions, "");
  print_reasons("not proved", result.open, "widest gap");
  print_reasons("six equations unsolved", result.unsolved, "largest residual");
}

/// The least share of cases with both claims proved, in percent.
struct Goal {
  std::size_t group;
  double least;
};
constexpr std::array goals{Goal{0, 99.9}, Goal{1, 99.0}};

void print_goals(const std::vector<Result>& results) {
  for (const Goal& goal : goals)
    for (const Result& result : results) {
      const Tally& t = result.tallies[goal.group];
      if (t.cases == 0) continue;
      const bool met = 100.0 * t.both >= goal.least * t.cases;
      print_line(fmt::format("goal, exponents {}: both >= {} % of {}: {}", groups()[goal.group], goal.least,
                             result.family, met ? "met" : "NOT MET"));
    }
}

int report(Options& options) {
  std::vector<Result> results;
  bool contradicted = false;
  for (const Family& family : families()) {
    if ((options.family != "all" && options.family != family.name) || interrupted()) continue;
    results.push_back(run(std::string(family.name), options));
    const Result& result = results.back();
    contradicted |= !result.contradictions.empty();
    options.lines.add(to_json(result, options));
    if (!options.lines.is_json()) print_table(result, options);
    flush_output();
  }
  if (!options.lines.is_json() && effort_of(options) == Effort::digits) print_goals(results);
  options.lines.write();
  return contradicted ? exit_finding : exit_done;
}

}  // namespace

int report_certified(int argc, char** argv) {
  Options options;
  CommandLine app("What the reference proves of random cases, held against an independent 50-digit solution; 1 for a "
                  "contradiction.",
                  "plumb report-certified");
  declare(app, options);
  return run_command(app, argc, argv, [&] { return report(options); });
}

}  // namespace plumb::reports
