#include "reports/kills/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "corpus/command/text_table.hpp"
#include "corpus/json/json_text.hpp"
#include "fuzz/results/tally.hpp"

namespace plumb::reports {
namespace {

/// "12", "12 [3, 40]" of several seeds, ">400" where a seed has none.
std::string run_text(std::uint64_t run, std::uint64_t runs) {
  return run == 0 ? fmt::format(">{}", runs) : std::to_string(run);
}

std::string cell(const EngineHunts& engine, std::size_t bug) {
  const Killed k = killed(engine, bug);
  const std::uint64_t runs = engine.hunts.front().runs;
  if (!k.any()) return "-";
  if (k.hunts == 1) return run_text(k.median, runs);
  return fmt::format("{} [{}, {}]", run_text(k.median, runs), k.least, run_text(k.greatest, runs));
}

bool changes_answers(const std::vector<EngineHunts>& engines, std::size_t bug) {
  return std::ranges::any_of(engines, [&](const EngineHunts& engine) {
    return std::ranges::any_of(engine.hunts, [&](const Hunt& hunt) { return hunt.kills[bug].changed; });
  });
}

std::string share_text(std::size_t k, std::size_t n) {
  const Share share = share_of(k, n);
  return fmt::format("{} of {}, {:.1f} % [{:.1f}, {:.1f}]", k, n, 100 * share.share, 100 * share.low, 100 * share.high);
}

/// Its row says that it cannot change an answer. One that is killed all the same is a complaint.
bool is_equivalent(const SeededBug& bug) {
  return bug.survives.starts_with("equivalent: ");
}

std::size_t count_killed(const std::vector<EngineHunts>& engines, std::size_t bugs) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < bugs; ++i) count += is_killed(engines, i) ? 1 : 0;
  return count;
}

/// Those that need no solver without the bug to tell that an answer is wrong.
std::vector<EngineHunts> without_work(std::vector<EngineHunts> engines) {
  std::erase_if(engines, [](const EngineHunts& engine) { return engine.name == "work"; });
  return engines;
}

TextTable table_of(const std::vector<EngineHunts>& engines) {
  std::vector<Column> columns{{"bug", "<36"}};
  for (const EngineHunts& engine : engines) columns.push_back({engine.name, ">26"});
  columns.push_back({"   first finding", ""});
  return TextTable(columns);
}

/// Of the engine that comes first in the table.
std::string first_finding(const std::vector<EngineHunts>& engines, std::size_t bug) {
  for (const EngineHunts& engine : engines)
    for (const Hunt& hunt : engine.hunts)
      if (hunt.kills[bug].run != 0) return hunt.kills[bug].finding;
  return "";
}

std::string of_engine(const EngineHunts& engine, std::size_t bugs) {
  std::uint64_t control = 0;
  for (const Hunt& hunt : engine.hunts) control += hunt.control_findings;
  return fmt::format("  {:<24}{} {}, {} seed{}: kills {}; {} with a finding of the solver without a bug\n", engine.name,
                     engine.hunts.front().runs, engine.runs_are, engine.hunts.size(),
                     engine.hunts.size() == 1 ? "" : "s", share_text(count_killed({engine}, bugs), bugs), control);
}

Json engine_line(const EngineHunts& engine) {
  Json out = {
      {"kind", "engine"}, {"engine", engine.name}, {"runs_are", engine.runs_are}, {"seeds", engine.hunts.size()}};
  out["runs"] = engine.hunts.front().runs;
  return out;
}

Json bug_line(const SeededBug& bug, const std::vector<EngineHunts>& engines, std::size_t index) {
  Json kills = Json::object();
  for (const EngineHunts& engine : engines) {
    Json runs = Json::array();
    for (const Hunt& hunt : engine.hunts)
      runs.push_back(hunt.kills[index].run == 0 ? Json(nullptr) : Json(hunt.kills[index].run));
    kills[engine.name] = runs;
  }
  return {{"kind", "bug"},
          {"bug", bug.name},
          {"is", bug.kind},
          {"file", bug.file},
          {"seen", bug.seen},
          {"survives", bug.survives},
          {"changes_answers", changes_answers(engines, index)},
          {"runs_to_kill", kills},
          {"finding", first_finding(engines, index)}};
}

}  // namespace

Killed killed(const EngineHunts& engine, std::size_t bug) {
  constexpr auto never = std::numeric_limits<std::uint64_t>::max();
  std::vector<std::uint64_t> runs;
  for (const Hunt& hunt : engine.hunts) runs.push_back(hunt.kills[bug].run == 0 ? never : hunt.kills[bug].run);
  std::sort(runs.begin(), runs.end());
  const auto shown = [](std::uint64_t run) { return run == never ? 0 : run; };
  Killed out;
  out.hunts = runs.size();
  out.kills = static_cast<std::size_t>(std::count_if(runs.begin(), runs.end(), [](auto run) { return run != never; }));
  out.least = shown(runs.front());
  out.median = shown(runs[runs.size() / 2]);
  out.greatest = shown(runs.back());
  return out;
}

bool is_killed(const std::vector<EngineHunts>& engines, std::size_t bug) {
  return std::any_of(engines.begin(), engines.end(), [&](const EngineHunts& e) { return killed(e, bug).any(); });
}

std::string kill_table(const Bugs& bugs, const std::vector<EngineHunts>& engines) {
  const TextTable table = table_of(engines);
  std::string out = table.head() + "\n";
  for (std::size_t i = 0; i < bugs.size(); ++i) {
    std::vector<std::string> cells{bugs[i].name};
    for (const EngineHunts& engine : engines) cells.push_back(cell(engine, i));
    cells.push_back("   " + first_finding(engines, i));
    out += table.row_of(cells) + "\n";
  }
  const std::size_t dead = count_killed(engines, bugs.size());
  const auto equivalent =
      static_cast<std::size_t>(std::ranges::count_if(bugs, [](const auto& b) { return is_equivalent(b); }));
  out += fmt::format("\nkilled: {}; of those that can change an answer: {}\n", share_text(dead, bugs.size()),
                     share_text(dead, bugs.size() - equivalent));
  const std::vector<EngineHunts> by_laws = without_work(engines);
  if (by_laws.size() < engines.size() && !by_laws.empty())
    out += fmt::format("by laws, without the work: {}\n", share_text(count_killed(by_laws, bugs.size()), bugs.size()));
  for (const EngineHunts& engine : engines) out += of_engine(engine, bugs.size());
  for (std::size_t i = 0; i < bugs.size(); ++i)
    if (!is_killed(engines, i) && !bugs[i].survives.empty())
      out +=
          fmt::format("{} survives, {}: {}\n", bugs[i].name,
                      changes_answers(engines, i) ? "its answers differ" : "no cold answer differs", bugs[i].survives);
  return out;
}

std::string kill_lines(const Bugs& bugs, const std::vector<EngineHunts>& engines) {
  std::string out;
  for (const EngineHunts& engine : engines) out += write_json(engine_line(engine)) + "\n";
  for (std::size_t i = 0; i < bugs.size(); ++i) out += write_json(bug_line(bugs[i], engines, i)) + "\n";
  return out;
}

std::vector<std::string> complaints(const Bugs& bugs, const std::vector<EngineHunts>& engines) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < bugs.size(); ++i) {
    const bool is_dead = is_killed(engines, i);
    if (!is_dead && bugs[i].survives.empty()) out.push_back(bugs[i].name + " survives, and nobody says why");
    if (is_dead && !bugs[i].survives.empty())
      out.push_back(bugs[i].name + " is killed, and its row says why it cannot be");
  }
  return out;
}

}  // namespace plumb::reports
