// plumb report-patch: is a patch ever wrong? Each is held against the certified bounds of the lens, and judged by the patch's laws.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <thread>

#include "corpus/command/command.hpp"
#include "corpus/command/in_parallel.hpp"
#include "corpus/command/text_table.hpp"
#include "properties/generators/families.hpp"
#include "properties/laws/laws_patch.hpp"
#include "reports/certified/by_family.hpp"
#include "reports/certified/parts.hpp"
#include "reports/report_lines.hpp"
#include "solver/method/methods.hpp"

namespace plumb::reports {
namespace {

std::vector<std::string> names_of_patch_laws() {
  std::vector<std::string> out;
  for (const PatchLaw& law : patch_laws()) out.emplace_back(law.name);
  return out;
}

struct PatchOptions {
  std::int64_t cases = 1000;
  std::uint64_t seed = 1;
  std::string family;
  std::vector<std::string> laws = names_of_patch_laws();
  int level = 2;
  double tolerance = Want{}.patch_tolerance;
  unsigned threads = std::max(1u, std::thread::hardware_concurrency());
  ReportLines lines;

  [[nodiscard]] bool asks(std::string_view law) const { return std::find(laws.begin(), laws.end(), law) != laws.end(); }
};

void declare(CommandLine& app, PatchOptions& options) {
  app.add_option("--cases", options.cases, "cases of each family")->capture_default_str()->check(refuse_count);
  declare_seed(app, options.seed);
  app.add_option("--family", options.family, "one family in the place of all")->is_one_of("family", family_names());
  app.add_option("--laws", options.laws, "these of the patch's laws, in the place of all")
      ->delimiter(',')
      ->is_one_of("law", names_of_patch_laws());
  app.add_option("--level", options.level, "the bounds' polyhedra have 8 4^level triangles")
      ->capture_default_str()
      ->in_range(0, 7);
  app.add_option("--tolerance", options.tolerance, "to which patches are asked for")
      ->capture_default_str()
      ->is_positive();
  app.add_option("--threads", options.threads, "changes nothing but the time")->in_range(1, 1024);
  options.lines.declare(app, "one JSON object a family in the place of the table");
}

struct PatchCounts {
  std::uint64_t cases = 0, without = 0, patches = 0, coarse = 0, judged_by_bounds = 0, unbounded = 0;
  double widest = 0;  ///< of the volume's bounds
  std::map<std::string, std::uint64_t> findings;
  std::vector<std::string> named;  ///< the cases with a finding
};

/// What is counted of a case.
struct JudgedPatch {
  bool is_overlapping = false;
  std::optional<Patch> patch;
  std::optional<BoundsSaid> bounds;
  std::vector<Finding> findings;
};

Patch solve_for_patch(const Pair& pair, double tolerance) {
  Want want;
  want.patch = true;
  want.patch_tolerance = tolerance;
  return find_method("auto")->solve(pair, want, nullptr).patch.value_or(Patch{});
}

Finding by_law(const PatchLaw& law, const PatchEvidence& evidence, const PatchOptions& options, JudgedPatch& out) {
  if (law.name != "bounds") return law.check(evidence);
  out.bounds = against_bounds(evidence, options.level);
  return out.bounds->finding;
}

JudgedPatch judged(const Pair& pair, const PatchOptions& options) {
  JudgedPatch out;
  const Contact<double> contact = find_method("auto")->solve(pair, {}, nullptr);
  out.is_overlapping =
      contact.status == Status::converged && contact.verdict == Verdict::overlapping && has_volumes(pair);
  if (!out.is_overlapping) return out;
  const Patch patch = solve_for_patch(pair, options.tolerance);
  if (!std::isfinite(patch.error)) return out;
  out.patch = patch;
  const PatchEvidence evidence{pair, patch, options.tolerance, solve_for_patch};
  for (const PatchLaw& law : patch_laws()) {
    if (!options.asks(law.name)) continue;
    Finding found = by_law(law, evidence, options, out);
    if (found.kind == FindingKind::none) continue;
    found.law = law.name;
    out.findings.push_back(found);
  }
  return out;
}

void add(PatchCounts& counts, const std::string& case_name, const JudgedPatch& of, double tolerance) {
  ++counts.cases;
  counts.without += of.is_overlapping && !of.patch ? 1 : 0;
  counts.patches += of.patch ? 1 : 0;
  counts.coarse += of.patch && of.patch->error > tolerance ? 1 : 0;
  if (of.bounds) {
    ++counts.judged_by_bounds;
    if (std::isfinite(of.bounds->width)) counts.widest = std::max(counts.widest, of.bounds->width);
    counts.unbounded += std::isfinite(of.bounds->width) ? 0 : 1;
  }
  for (const Finding& found : of.findings) {
    ++counts.findings[found.law];
    counts.named.push_back(
        fmt::format("{}: {}, severity {:.3g}: {}", case_name, found.law, found.severity, found.detail));
  }
}

PatchCounts counts_of(const std::string& family, const PatchOptions& options) {
  PatchCounts counts;
  std::mutex counting;
  in_parallel(static_cast<std::size_t>(options.cases), options.threads, [&](std::size_t i) {
    const Case c = generate(family, options.seed, i);
    const JudgedPatch of = judged(c.pair, options);
    const std::scoped_lock lock(counting);
    add(counts, c.name, of, options.tolerance);
  });
  std::sort(counts.named.begin(), counts.named.end());
  return counts;
}

Json patch_json(const std::string& family, const PatchCounts& c, const PatchOptions& options) {
  Json out = Json::object();
  out["family"] = family;
  out["seed"] = options.seed;
  out["laws"] = options.laws;
  out["level"] = options.level;
  out["tolerance"] = options.tolerance;
  out["cases"] = c.cases;
  out["patches"] = c.patches;
  out["overlapping_without_a_patch"] = c.without;
  out["above_tolerance"] = c.coarse;
  out["held_against_bounds"] = c.judged_by_bounds;
  out["of_these_without_bounds"] = c.unbounded;
  out["widest_bounds_over_volume"] = c.widest;
  out["findings"] = c.findings;
  out["named"] = c.named;
  if (interrupted()) out["incomplete"] = true;
  return out;
}

const TextTable patch_columns({{"family", "<12"},
                               {"cases", ">10"},
                               {"patches", ">10"},
                               {"none", ">6"},
                               {"coarse", ">8"},
                               {"bounded", ">10"},
                               {"unbounded", ">10"},
                               {"widest", ">9.2g"},
                               {"findings", ">10"}});

void print_patch_row(const std::string& family, const PatchCounts& c) {
  print_line(patch_columns.row(family, c.cases, c.patches, c.without, c.coarse, c.judged_by_bounds - c.unbounded,
                               c.unbounded, c.widest, c.named.size()));
  for (const std::string& line : c.named) print_line("    " + line);
}

}  // namespace

int report_patch(int argc, char** argv) {
  PatchOptions options;
  CommandLine app("The patches of auto against certified bounds of the lens, and by the laws of patches",
                  "plumb report-patch");
  declare(app, options);
  return run_command(app, argc, argv,
                     [&] { return report_by_family(options, patch_columns, counts_of, patch_json, print_patch_row); });
}

}  // namespace plumb::reports
