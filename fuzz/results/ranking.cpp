#include "fuzz/results/ranking.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "corpus/command/program_folder.hpp"
#include "corpus/solvers/host/shell_words.hpp"
#include "properties/laws/accuracy_option.hpp"

namespace plumb {
namespace {

namespace fs = std::filesystem;

/// A case names a foreign solver but never its library: replay takes that from whoever runs it.
std::string options_for(const Results& results, const std::string& method) {
  const auto solver = results.foreign.find(method);
  return (solver == results.foreign.end() ? "" : solver->second.option) + accuracy_option(results.asked.accuracy);
}

}  // namespace

std::vector<RankedBucket> ranked_buckets(const Results& results) {
  const Tallies methods = results.methods();
  std::vector<RankedBucket> lines;
  for (const auto& [bucket, kept] : results.kept.buckets()) {
    const Expect& expect = kept.worst.kept.expect;
    const std::string name = expect.method.value_or("reference");
    const auto method = methods.find(name);
    const auto count = results.buckets.find(bucket);
    lines.push_back({method == methods.end() || !method->second.published,
                     count == results.buckets.end() ? 1 : count->second, bucket,
                     expect.finding.value_or(bucket.substr(0, bucket.find('-'))), name, options_for(results, name)});
  }
  std::stable_sort(lines.begin(), lines.end(), [](const RankedBucket& a, const RankedBucket& b) {
    return std::pair(a.own, a.count) > std::pair(b.own, b.count);
  });
  return lines;
}

std::string plumb_command() {
  const fs::path plumb = program_folder() / "plumb";
  const std::string here = fs::proximate(plumb).string();
  return shell_word(here.starts_with("..") ? plumb.string() : here);
}

std::string replay_command(const fs::path& cases, const std::string& options) {
  return fmt::format("{} replay {}{}", plumb_command(), shell_word(cases.string()), options);
}

}  // namespace plumb
