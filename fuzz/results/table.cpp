#include "fuzz/results/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "corpus/command/progress.hpp"
#include "corpus/command/text_table.hpp"
#include "fuzz/results/ranking.hpp"

namespace plumb {
namespace {

namespace fs = std::filesystem;

std::string percent(double share) {
  const double p = 100 * share;
  if (std::isnan(p)) return "-";
  if (p == 0 || p == 100) return fmt::format("{:.0f}", p);
  if (p > 99.94) return ">99.9";  // what is not all must not look like it
  return p >= 10 ? fmt::format("{:.1f}", p) : (p >= 0.1 ? fmt::format("{:.2f}", p) : fmt::format("{:.2g}", p));
}

std::string share_text(std::uint64_t k, std::uint64_t n) {
  const Share s = share_of(k, n);
  return fmt::format("{} [{}, {}]", percent(s.share), percent(s.low), percent(s.high));
}

/// The shares of a column one below the other.
std::string padded_share(std::uint64_t k, std::uint64_t n) {
  const std::string text = share_text(k, n);
  const std::size_t width = text.find(' ');
  return std::string(width < 6 ? 6 - width : 0, ' ') + text;
}

std::string angle(double degrees) {
  if (!(degrees >= 0)) return "-";
  if (degrees >= 10) return fmt::format("{:.1f}", degrees);
  return degrees >= 1e-3 ? fmt::format("{:.2g}", degrees) : fmt::format("{:.0e}", degrees);
}

std::string duration(double nanoseconds) {
  if (std::isnan(nanoseconds)) return "-";
  if (nanoseconds < 1e3) return fmt::format("{:.0f} ns", nanoseconds);
  return nanoseconds < 1e6 ? fmt::format("{:.1f} us", nanoseconds / 1e3) : fmt::format("{:.1f} ms", nanoseconds / 1e6);
}

std::string iterations(const Histogram& h) {
  if (h.count() == 0) return "-";
  return fmt::format("{:.0f}/{:.0f}", h.percentile(0.5), h.percentile(0.99));
}

/// (word, "share [interval]") with the failures first, the most frequent of them on top.
std::vector<std::pair<std::string, std::string>> finding_lines(const Tally& tally) {
  std::vector<std::size_t> kinds;
  for (std::size_t i = 0; i + 1 < kFindingKinds; ++i)
    if (tally.findings[i] > 0) kinds.push_back(i);
  std::stable_sort(kinds.begin(), kinds.end(), [&](auto a, auto b) { return tally.findings[a] > tally.findings[b]; });
  kinds.push_back(kFindingKinds - 1);
  std::vector<std::pair<std::string, std::string>> lines;
  for (const std::size_t i : kinds)
    lines.emplace_back(name(static_cast<FindingKind>(i)), padded_share(tally.findings[i], tally.judged()));
  if (tally.unjudged > 0) lines.emplace_back("(unjudged)", padded_share(tally.unjudged, tally.cases));
  return lines;
}

/// "right in 12.0 % to 1e-6rad, 99.8 % to 0.01deg, 100 % to 1deg", where it is not all to rounding; what it was not asked.
std::vector<std::string> accuracy_in_words(const Tally& tally) {
  std::vector<std::string> out;
  if (tally.judged() > 0 && tally.right.front() < tally.judged()) {
    std::string text = "right in";
    for (std::size_t i = 1; i < accuracy_levels.size(); ++i)
      text += fmt::format("{} {} % to {}", i > 1 ? "," : "", percent(share_of(tally.right[i], tally.judged()).share),
                          accuracy_levels[i].name);
    out.push_back(text);
  }
  if (tally.not_asked > 0)
    out.push_back(fmt::format("not asked {} pairs: it claims no answer to them", grouped(tally.not_asked)));
  if (tally.wrong_aside > 0)
    out.push_back(fmt::format("{} wrong verdicts where it did not converge", grouped(tally.wrong_aside)));
  return out;
}

const TextTable kColumns({{"method", "<26"},
                          {"conv.%", ">6", "  "},
                          {"finding", "<15"},
                          {"share % [95 %]", "<22"},
                          {">0.01deg", ">8"},
                          {"p50", ">8"},
                          {"p99", ">8"},
                          {"max", ">7"},
                          {"iter", ">8"},
                          {"time", ">9"}},
                         " ");
/// What stands below a method's row, under its finding.
const TextTable kBelow({{"", "<34"}, {"", ""}}, " ");

std::string method_rows(const std::string& method, const Tally& tally) {
  const auto lines = finding_lines(tally);
  const Histogram& angles = tally.angle_error_deg;
  const auto converged = share_of(tally.converged(), tally.cases);
  const auto wrong = share_of(tally.angles_wrong, angles.count());
  std::string text =
      kColumns.row(method, percent(converged.share), lines[0].first, lines[0].second, percent(wrong.share),
                   angle(angles.percentile(0.5)), angle(angles.percentile(0.99)), angle(angles.max()),
                   iterations(tally.iterations), duration(tally.nanoseconds.percentile(0.5))) +
      "\n";
  for (std::size_t i = 1; i < lines.size(); ++i) text += kColumns.row("", "", lines[i].first, lines[i].second) + "\n";
  for (const auto& all : {accuracy_in_words(tally), tally.habits.in_words()})
    for (const std::string& words : all) text += kBelow.row("", words) + "\n";
  return text;
}

std::string family_heading(const std::string& name, const FamilyResults& family) {
  std::string text = fmt::format("\n{}: {} cases", name, grouped(family.cases));
  if (family.reference_unsolved > 0)
    text += fmt::format(", {} without a reference ({} %)", grouped(family.reference_unsolved),
                        share_text(family.reference_unsolved, family.cases));
  if (family.not_proved_lowest > 0)
    text += fmt::format(", the reference of {} not proved to be the lowest minimum", grouped(family.not_proved_lowest));
  if (family.reference_beaten > 0)
    text += fmt::format(", the reference BEATEN in {}", grouped(family.reference_beaten));
  text += fmt::format("\n  judged by bounds {}, by a proof {}, by 50 digits {}", grouped(family.needed[0]),
                      grouped(family.needed[1]), grouped(family.needed[2]));
  return text + "\n";
}

std::string notes(const Results& results) {
  std::string text =
      "\n  conv.%: of all answers; share: of the judged answers, with its Clopper-Pearson interval;\n"
      "  >0.01deg: per cent of the converged answers; p50, p99, max: their angle to the certified common normal, "
      "degrees;\n  iter: p50/p99 of the iterations of all answers; time: median of one solve.\n";
  for (const auto& [message, n] : results.harness_errors) text += fmt::format("  HARNESS ERROR {}\n", message);
  for (const auto& [method, leak] : results.leaks)
    text += fmt::format("  LEAK {}: its memory grows by {:.6g} bytes a call, in {} calls for pairs that it knew.\n",
                        method, leak.bytes_a_call, leak.calls);
  for (const std::string& method : results.given_up)
    text += fmt::format("  INCOMPLETE: {} did not come back {} times; what was done is counted.\n", method, most_hangs);
  if (results.interrupted) text += "  INCOMPLETE: interrupted; what was done is counted.\n";
  if (results.shards_missing)
    text += fmt::format("  INCOMPLETE: {} of {} shards; what they did is counted.\n", results.asked.done.size(),
                        results.asked.shards);
  return text;
}

/// One command replays the whole folder only when the same solver, or none, is to be named for all of it.
std::string rest_of(const std::vector<RankedBucket>& lines, std::size_t shown, const fs::path& failures) {
  const std::string& options = lines.front().options;
  const bool alike =
      std::all_of(lines.begin(), lines.end(), [&](const RankedBucket& l) { return l.options == options; });
  return fmt::format("           and {} more; all of them: {}\n", lines.size() - shown,
                     alike ? replay_command(failures, options) : failures.string());
}

}  // namespace

std::exception_ptr failure_to(const std::function<void()>& write) {
  try {
    write();
    return nullptr;
  } catch (const InputFailure&) {
    return std::current_exception();
  }
}

std::string table_text(const Results& results) {
  std::string text;
  for (const std::string& name : family_order(results)) {
    const FamilyResults& family = results.families.at(name);
    text += family_heading(name, family) + kColumns.head() + "\n";
    for (const std::string& method : method_order(family.methods))
      text += method_rows(method, family.methods.at(method));
    text += ladders_text(family);
  }
  return text + notes(results);
}

std::string kept_text(const Results& results, const fs::path& folder) {
  constexpr std::size_t shown = 24;
  const auto lines = ranked_buckets(results);
  if (lines.empty()) return "\nno failures.\n";
  const fs::path failures = folder / "failures";
  std::string text = fmt::format(
      "\nkept failures: {} buckets, the simplest and the worst case of each; count, then the command:\n", lines.size());
  for (std::size_t i = 0; i < std::min(shown, lines.size()); ++i)
    text += fmt::format("{:>9}  {}\n", grouped(lines[i].count),
                        replay_command(failures / (lines[i].name + std::string(kWorst)), lines[i].options));
  return lines.size() > shown ? text + rest_of(lines, shown, failures) : text;
}

int report(const Results& results, const fs::path& folder) {
  const std::exception_ptr failed = failure_to([&] {
    if (!folder.empty()) write_results(results, folder);
  });
  fmt::print("{}", table_text(results));
  if (failed) std::rethrow_exception(failed);
  if (!folder.empty()) fmt::print("{}", kept_text(results, folder));
  return exit_code(results);
}

}  // namespace plumb
