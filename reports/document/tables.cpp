#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "corpus/json/escaped.hpp"
#include "corpus/solvers/solver.hpp"
#include "reports/document/formats.hpp"
#include "reports/document/sections.hpp"

namespace plumb::reports {
namespace {

/// A row of CSV while it grows.
class Row {
 public:
  Row& add(const std::string& text) { return put(csv_cell(text)); }
  Row& add(double x) { return put(std::isfinite(x) ? shortest(x) : ""); }
  Row& add(std::uint64_t n) { return put(std::to_string(n)); }
  Row& add(const Share& s) { return add(s.share).add(s.low).add(s.high); }
  [[nodiscard]] std::string line() const { return line_ + "\r\n"; }

 private:
  Row& put(const std::string& cell) {
    line_ += (line_.empty() ? "" : ",") + cell;
    return *this;
  }
  std::string line_;
};

/// NaN of who never counts his steps (a peer).
double steps(const Tally& t, double percentile) {
  return t.iterations.max() > 0 ? t.iterations.percentile(percentile) : std::nan("");
}

std::string heading() {
  Row row;
  for (const char* name : {"run",
                           "commit",
                           "seed",
                           "family",
                           "method",
                           "published",
                           "answers",
                           "judged",
                           "converged",
                           "converged_low",
                           "converged_high",
                           "failures",
                           "failures_low",
                           "failures_high",
                           "right_rounding",
                           "right_1e-6rad",
                           "right_0.01deg",
                           "right_1deg",
                           "not_asked",
                           "off_by_0.01_deg",
                           "off_low",
                           "off_high",
                           "angle_deg_p50",
                           "angle_deg_p99",
                           "angle_deg_max",
                           "overlap_error_p50",
                           "overlap_error_p99",
                           "overlap_error_max",
                           "iterations_p50",
                           "iterations_p99",
                           "ns_p50",
                           "ns_p99"})
    row.add(std::string(name));
  for (std::size_t i = 0; i < kFindingKinds; ++i) row.add(std::string(name(static_cast<FindingKind>(i))));
  return row.line();
}

std::string method_line(const Run& run, const std::string& family, const std::string& method, const Tally& t) {
  const Json host = host_of(run.results);
  Row row;
  row.add(run.folder.string()).add(host["commit"].get<std::string>()).add(run.results.asked.seed);
  row.add(family).add(method).add(std::string(t.published ? "yes" : "no")).add(t.cases).add(t.judged());
  row.add(share_of(t.converged(), t.cases)).add(share_of(t.failures(), t.judged()));
  for (const std::uint64_t right : t.right) row.add(right);
  row.add(t.not_asked);
  row.add(share_of(t.angles_wrong, t.angle_error_deg.count()));
  for (const Histogram* h : {&t.angle_error_deg, &t.overlap_error})
    row.add(h->percentile(0.5)).add(h->percentile(0.99)).add(h->count() > 0 ? h->max() : std::nan(""));
  row.add(steps(t, 0.5)).add(steps(t, 0.99)).add(t.nanoseconds.percentile(0.5)).add(t.nanoseconds.percentile(0.99));
  for (const std::uint64_t n : t.findings) row.add(n);
  return row.line();
}

std::string ladder_heading() {
  Row row;
  for (const char* name : {"run", "commit", "seed", "ladder", "knob", "step", "value", "method", "published", "answers",
                           "judged", "not_converged"})
    row.add(std::string(name));
  for (std::size_t i = 0; i < kFindingKinds; ++i) row.add(std::string(name(static_cast<FindingKind>(i))));
  return row.line();
}

/// A method's lines, the easiest step first.
std::string ladder_lines(const Run& run, const std::string& name, const Ladder& ladder, const std::string& method,
                         bool published) {
  const std::string commit = host_of(run.results)["commit"];
  std::string out;
  for (std::size_t i = 0; i < ladder.steps.size(); ++i) {
    const StepCounts& step = ladder.methods.at(method)[i];
    Row row;
    row.add(run.folder.string()).add(commit).add(run.results.asked.seed).add(name).add(ladder.knob);
    row.add(std::uint64_t{i + 1}).add(ladder.steps[i]).add(method).add(std::string(published ? "yes" : "no"));
    row.add(step.answers).add(step.judged()).add(step.not_converged);
    for (const std::uint64_t n : step.findings) row.add(n);
    out += row.line();
  }
  return out;
}

std::string percent(const Share& s) {
  if (std::isnan(s.share)) return "-";
  return fmt::format("{:.4g} [{:.3g}, {:.3g}]", 100 * s.share, 100 * s.low, 100 * s.high);
}

std::string figure(double x) {
  return std::isfinite(x) ? fmt::format("{:.2g}", x) : "-";
}

/// "misaligned 12, nonconverged 3"; the most frequent first.
std::string findings_text(const Tally& t) {
  std::vector<std::pair<std::uint64_t, std::string_view>> found;
  for (std::size_t i = 0; i + 1 < kFindingKinds; ++i)
    if (t.findings[i] > 0) found.emplace_back(t.findings[i], name(static_cast<FindingKind>(i)));
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::string out;
  for (const auto& [n, word] : found) out += fmt::format("{}{} {}", out.empty() ? "" : ", ", word, n);
  return out.empty() ? "none" : out;
}

/// " 12 | 99.8 | 100 |": per cent at the levels coarser than rounding.
std::string right_cells(const Tally& t) {
  std::string out;
  for (std::size_t i = 1; i < accuracy_levels.size(); ++i) {
    const double share = share_of(t.right[i], t.judged()).share;
    out += std::isnan(share) ? " - |" : fmt::format(" {:.4g} |", 100 * share);
  }
  return out;
}

std::string family_table(const std::string& name, const FamilyResults& family) {
  std::string out = fmt::format("\n### {}: {} cases\n\n", markdown_text(name), family.cases);
  out += "| method | right, % [95 %] | to 1e-6 rad | to 0.01 deg | to 1 deg | findings | angle p50, deg | p99 | max | "
         "iterations p50 |\n|---|---|---|---|---|---|---|---|---|---|\n";
  for (const std::string& method : method_order(family.methods)) {
    const Tally& t = family.methods.at(method);
    const Histogram& a = t.angle_error_deg;
    out += fmt::format("| {}{} | {} |{} {} | {} | {} | {} | {} |\n", markdown_text(method),
                       t.published || method.starts_with("solver:") ? "" : " (plumb)",
                       percent(share_of(t.of(FindingKind::none), t.judged())), right_cells(t), findings_text(t),
                       figure(a.percentile(0.5)), figure(a.percentile(0.99)),
                       figure(a.count() > 0 ? a.max() : std::nan("")), figure(steps(t, 0.5)));
  }
  return out;
}

std::string lets_go_cell(const Ladder& ladder, const std::string& method) {
  const auto row = ladder.methods.find(method);
  const auto step = row == ladder.methods.end() ? std::nullopt : lets_go(row->second);
  if (!step) return "-";
  return fmt::format("{:.3g} ({} of {})", ladder.steps[*step], *step + 1, ladder.steps.size());
}

std::string ladders_table(const FamilyResults& family) {
  if (family.ladders.empty()) return "";
  const std::vector<std::string> methods = method_order(family.methods);
  std::string out =
      "\n#### Where each method lets go: the easiest step of a ladder with a finding\n\n| ladder | knob |";
  for (const std::string& method : methods) out += " " + markdown_text(method) + " |";
  out += "\n|---|---|";
  for (std::size_t i = 0; i < methods.size(); ++i) out += "---|";
  for (const std::string& name : ladder_order(family.ladders)) {
    const Ladder& ladder = family.ladders.at(name);
    out += fmt::format("\n| {} | {} |", markdown_text(name), markdown_text(ladder.knob));
    for (const std::string& method : methods) out += " " + lets_go_cell(ladder, method) + " |";
  }
  return out + "\n";
}

std::string playback_line(const Json& playback) {
  const Json& end = playback["end"];
  const std::string frames =
      fmt::format("- scene {}: {} bodies, {} frames to t = {}", shown_text(playback["name"]), playback["bodies"].size(),
                  playback["times"].size(), playback["times"].back().dump());
  if (end.is_null()) return frames + " - INCOMPLETE\n";
  return fmt::format("{}, {} of {} solves failed, hash {}\n", frames, end["failed"].dump(), end["solves"].dump(),
                     shown_text(end["hash"]));
}

std::string run_tables(const Run& run, const Json& shown) {
  const Results& results = run.results;
  std::string out = fmt::format("## plumb: {} cases, seed {}, commit {}{}\n", results.cases(), results.asked.seed,
                                shown_text(shown["commit"]), results.incomplete() ? " - INCOMPLETE" : "");
  for (const auto& [message, n] : results.harness_errors)
    out += fmt::format("\n- HARNESS ERROR {} ({})\n", markdown_text(message), n);
  for (const std::string& family : family_order(results))
    out += family_table(family, results.families.at(family)) + ladders_table(results.families.at(family));
  return out;
}

std::string changes(const Json& comparison) {
  constexpr std::size_t shown = 20;
  std::string out = fmt::format(
      "\n### {} -> {}\n\n{}\n\n", shown_text(comparison["before"]), shown_text(comparison["after"]),
      comparison["same_cases"].get<bool>() ? "The same cases: no difference is chance."
                                           : "Other cases: what is not significant (Holm, 5 %) is left out.");
  std::size_t count = 0;
  for (const char* verdict : {"worse", "better"})
    for (const Json& row : comparison["rows"]) {
      if (row["verdict"] != verdict || ++count > shown) continue;
      out += fmt::format("- **{}** {} {} {}: {} -> {}\n", verdict, shown_text(row["family"]), shown_text(row["method"]),
                         shown_text(row["measure"]), row["before"].dump(), row["after"].dump());
    }
  if (count > shown) out += fmt::format("- and {} more\n", count - shown);
  return count == 0 ? out + "Nothing changed.\n" : out;
}

}  // namespace

std::string csv(const std::vector<Run>& runs) {
  std::string out = heading();
  for (const Run& run : runs)
    for (const std::string& family : family_order(run.results)) {
      const Tallies& methods = run.results.families.at(family).methods;
      for (const std::string& method : method_order(methods))
        out += method_line(run, family, method, methods.at(method));
    }
  return out;
}

std::string ladders_csv(const std::vector<Run>& runs) {
  std::string out = ladder_heading();
  for (const Run& run : runs)
    for (const auto& [family_name, family] : run.results.families)
      for (const std::string& name : ladder_order(family.ladders))
        for (const std::string& method : method_order(family.generators.at(name)))
          out +=
              ladder_lines(run, name, family.ladders.at(name), method, family.generators.at(name).at(method).published);
  return out;
}

std::string markdown(const std::vector<Run>& runs, const Json& report) {
  std::string out = runs.empty() ? "## plumb\n" : run_tables(runs.back(), report["runs"].back());
  for (const Section& section : all_sections())
    if (section.markdown != nullptr && !report[section.name].is_null()) out += section.markdown(report[section.name]);
  for (const Json& comparison : report["comparisons"]) out += changes(comparison);
  if (!report["playbacks"].empty()) out += "\n### Playback\n\n";
  for (const Json& playback : report["playbacks"]) out += playback_line(playback);
  return out;
}

}  // namespace plumb::reports
