// plumb report-auto: is `auto` ever wrong? Every answer is held against the reference's rigorous bounds, which are cheap; each
// that is not well within them, and each of a sample, is judged by all laws.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <thread>

#include "corpus/command/command.hpp"
#include "corpus/command/interrupt.hpp"
#include "corpus/command/text_table.hpp"
#include "properties/generators/draft.hpp"
#include "properties/generators/families.hpp"
#include "properties/laws/allowance.hpp"
#include "properties/laws/laws_answer.hpp"
#include "reports/certified/by_family.hpp"
#include "reports/certified/parts.hpp"
#include "reports/report_lines.hpp"
#include "solver/method/methods.hpp"

namespace plumb::reports {
namespace {

struct Options {
  std::int64_t cases = 10000;
  std::uint64_t seed = 1;
  std::string family;
  double unit = 1, shift = 0;
  std::uint64_t sample = 1000;
  unsigned threads = std::max(1u, std::thread::hardware_concurrency());
  ReportLines lines;
};

void declare(CommandLine& app, Options& options) {
  app.add_option("--cases", options.cases, "cases of each family")->capture_default_str()->check(refuse_count);
  declare_seed(app, options.seed);
  app.add_option("--family", options.family, "one family in the place of all")->is_one_of("family", family_names());
  app.add_option("--unit", options.unit, "all lengths times this")->capture_default_str()->is_positive();
  app.add_option("--shift", options.shift, "both bodies moved by this many sizes along (1, 2, 3)")
      ->capture_default_str();
  app.add_option("--sample", options.sample, "judge one case in this many by all laws")
      ->capture_default_str()
      ->check(refuse_count);
  app.add_option("--threads", options.threads, "changes nothing but the time")->in_range(1, 1024);
  options.lines.declare(app, "one JSON object a family in the place of the table");
}

struct Counts {
  std::uint64_t cases = 0, lost = 0, suspicious = 0, judged = 0, undecided = 0;
  std::map<std::string, std::uint64_t> findings;
  std::vector<std::string> named;  ///< the cases with a finding
  std::array<std::uint64_t, 201> iterations{};

  void add(const Counts& other) {
    cases += other.cases;
    lost += other.lost;
    suspicious += other.suspicious;
    judged += other.judged;
    undecided += other.undecided;
    for (const auto& [word, n] : other.findings) findings[word] += n;
    named.insert(named.end(), other.named.begin(), other.named.end());
    for (std::size_t i = 0; i < iterations.size(); ++i) iterations[i] += other.iterations[i];
  }
  [[nodiscard]] std::size_t quantile(double share) const {
    if (cases == 0) return 0;
    const auto wanted = static_cast<std::uint64_t>(share * static_cast<double>(cases - 1));
    std::uint64_t seen = 0;
    for (std::size_t i = 0; i < iterations.size(); ++i) {
      seen += iterations[i];
      if (seen > wanted) return i;
    }
    return iterations.size() - 1;
  }
};

Pair moved(Pair pair, const Options& options) {
  if (options.unit != 1) scale(pair, options.unit);
  const Vec3<double> by = Vec3<double>(1, 2, 3) * (options.shift * size_of(pair) / Vec3<double>(1, 2, 3).norm());
  pair.body1.position += by;
  pair.body2.position += by;
  return pair;
}

/// Whether normal and points are a common normal's: opposite, along the line between points of the surfaces. No reference is
/// asked for that.
bool is_common_normal(const Pair& pair, const Contact<double>& answer, const Reference& reference) {
  if (!answer.normal.allFinite() || !answer.point1.allFinite() || !answer.point2.allFinite()) return false;
  const Evidence evidence{pair, Problem::common_normal, answer, reference, reference.common_normal, {}, false};
  const std::array<Finding (*)(const Evidence&), 5> laws{law::answers_are_finite, law::normals_are_opposite,
                                                         law::points_lie_on_the_normal, law::agrees_with_itself,
                                                         law::points_are_on_surfaces};
  return std::none_of(laws.begin(), laws.end(), [&](const auto& law) { return law(evidence).severity > 1; });
}

/// Whether the bounds alone show verdict and overlap to be right, to a few epsilon of the size, and the rest is in itself.
bool is_shown_right(const Pair& pair, const Contact<double>& answer, const Reference& reference) {
  if (answer.status != Status::converged || answer.evaluations > 1000) return false;
  if (!is_common_normal(pair, answer, reference)) return false;
  if (answer.verdict != reference.verdict || answer.verdict == Verdict::undecided) return false;
  const double allowed = law::few_of(size_of(pair) + std::abs(answer.overlap));
  return answer.overlap >= static_cast<double>(reference.overlap.lower) - allowed &&
         answer.overlap <= static_cast<double>(reference.overlap.upper) + allowed &&
         law::width_of(reference.overlap) <= 1e-9 * (size_of(pair) + std::abs(answer.overlap));
}

void examine(const Case& c, std::uint64_t index, const Options& options, Counts& counts) {
  const auto solve = [](const Pair& pair) { return find_method("auto")->solve(pair, {}, nullptr); };
  const Pair pair = moved(c.pair, options);
  if (!is_valid(pair)) return;  // a unit beyond the range of double
  const Contact<double> answer = solve(pair);
  ++counts.cases;
  counts.lost += answer.status == Status::converged ? 0 : 1;
  ++counts.iterations[static_cast<std::size_t>(std::clamp(answer.iterations, 0, 200))];
  const bool is_shown = is_shown_right(pair, answer, find_reference(pair, Effort::bounds));
  counts.suspicious += is_shown ? 0 : 1;
  if (is_shown && index % options.sample != 0) return;
  Judge judge(pair);
  const Judgement judgement = judge.judge(Problem::common_normal, answer, solve, true);
  ++counts.judged;
  counts.undecided += judgement.judged ? 0 : 1;
  if (judgement.finding.kind == FindingKind::none) return;
  const std::string word(name(judgement.finding.kind));
  ++counts.findings[word];
  counts.named.push_back(fmt::format("{}: {}, severity {:.3g}", c.name, word, judgement.finding.severity));
}

Counts run(const std::string& family, const Options& options) {
  std::atomic<std::uint64_t> next{0};
  const auto total = static_cast<std::uint64_t>(options.cases);
  std::vector<Counts> parts(std::max(1u, options.threads));
  {
    std::vector<std::jthread> threads;
    for (Counts& part : parts)
      threads.emplace_back([&] {
        for (std::uint64_t i = next++; i < total && !interrupted(); i = next++)
          examine(generate(family, options.seed, i), i, options, part);
      });
  }
  Counts counts;
  for (const Counts& part : parts) counts.add(part);
  std::sort(counts.named.begin(), counts.named.end());
  return counts;
}

Json to_json(const std::string& family, const Counts& c, const Options& options) {
  Json out = Json::object();
  out["family"] = family;
  out["seed"] = options.seed;
  out["unit"] = options.unit;
  out["shift"] = options.shift;
  out["cases"] = c.cases;
  out["not_converged"] = c.lost;
  out["not_shown_by_bounds"] = c.suspicious;
  out["judged_by_all_laws"] = c.judged;
  out["of_these_without_a_reference"] = c.undecided;
  out["findings"] = c.findings;
  out["iterations"] = {{"p50", c.quantile(0.5)}, {"p99", c.quantile(0.99)}, {"max", c.quantile(1)}};
  if (interrupted()) out["incomplete"] = true;
  return out;
}

const TextTable columns({{"family", "<12"},
                         {"cases", ">10"},
                         {"not converged", ">15"},
                         {"not by bounds", ">16"},
                         {"judged", ">10"},
                         {"undecidable", ">13"},
                         {"findings", ">10"},
                         {"iterations", ">13"}});

void print_row(const std::string& family, const Counts& c) {
  std::uint64_t findings = 0;
  for (const auto& [word, n] : c.findings) findings += n;
  print_line(columns.row(family, c.cases, c.lost, c.suspicious, c.judged, c.undecided, findings,
                         fmt::format("{}/{}/{}", c.quantile(0.5), c.quantile(0.99), c.quantile(1))));
  for (const std::string& line : c.named) print_line("    " + line);
}

}  // namespace

int report_auto(int argc, char** argv) {
  Options options;
  CommandLine app(
      "The answers of auto against the reference's bounds; what they do not show right, and a sample, by all laws",
      "plumb report-auto");
  declare(app, options);
  return run_command(app, argc, argv, [&] { return report_by_family(options, columns, run, to_json, print_row); });
}

}  // namespace plumb::reports
