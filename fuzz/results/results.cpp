#include "fuzz/results/results.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <limits>
#include <system_error>

#include "corpus/command/interrupt.hpp"
#include "corpus/file/output_file.hpp"
#include "corpus/file/text_input.hpp"
#include "corpus/json/number_text.hpp"
#include "corpus/solvers/solver.hpp"
#include "fuzz/results/counts.hpp"
#include "properties/generators/families.hpp"

namespace plumb {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFormat = "plumb/bins-8";

void merge_tallies(Tallies& to, const Tallies& from) {
  for (const auto& [method, tally] : from) to[method].merge(tally);
}

template <class Map>
std::vector<std::string> ordered(const Map& map, const std::vector<std::string>& first) {
  std::vector<std::string> names;
  for (const std::string& name : first)
    if (map.contains(name)) names.push_back(name);
  for (const auto& entry : map)
    if (std::find(first.begin(), first.end(), entry.first) == first.end()) names.push_back(entry.first);
  return names;
}

Json tallies_json(const Tallies& tallies) {
  Json json = Json::object();
  for (const auto& [method, tally] : tallies) json[method] = tally.to_json();
  return json;
}

Tallies read_tallies(const Field& field) {
  Tallies tallies;
  for (const auto& [method, tally] : field.members()) tallies[method] = Tally::read(tally);
  return tallies;
}

Json family_json(const FamilyResults& family) {
  Json generators = Json::object();
  for (const auto& [name, tallies] : family.generators) generators[name] = tallies_json(tallies);
  Json ladders = Json::object();
  for (const auto& [name, ladder] : family.ladders) ladders[name] = ladder.to_json();
  return {{"cases", family.cases},
          {"digest", std::to_string(family.digest)},
          {"reference_unsolved", family.reference_unsolved},
          {"not_proved_lowest", family.not_proved_lowest},
          {"needed", family.needed},
          {"reference_beaten", family.reference_beaten},
          {"methods", tallies_json(family.methods)},
          {"generators", generators},
          {"ladders", ladders}};
}

std::uint64_t read_digest(const Field& field) {
  const auto digest = number_from<std::uint64_t>(field.text());
  if (!digest) field.fail("must be the digits of a whole number of 64 bits");
  return *digest;
}

FamilyResults read_family(const Field& field) {
  FamilyResults family;
  family.cases = count_at(field, "cases");
  family.digest = read_digest(field.member("digest"));
  family.reference_unsolved = count_at(field, "reference_unsolved");
  family.not_proved_lowest = count_at(field, "not_proved_lowest");
  read_counts(family.needed, field, "needed");
  family.reference_beaten = count_at(field, "reference_beaten");
  family.methods = read_tallies(field.member("methods"));
  for (const auto& [name, tallies] : field.member("generators").members())
    family.generators[name] = read_tallies(tallies);
  for (const auto& [name, ladder] : field.member("ladders").members()) {
    family.ladders[name] = Ladder::read(ladder);
    require_whole(family.ladders[name], family.generators[name], ladder);
  }
  return family;
}

Json foreign_json(const Results& results) {
  Json json = Json::object();
  for (const auto& [method, solver] : results.foreign)
    json[method] = {{"option", solver.option}, {"abilities", abilities_json(solver.abilities)}};
  return json;
}

Json leaks_json(const Results& results) {
  Json json = Json::object();
  for (const auto& [method, leak] : results.leaks) json[method] = leak_json(leak);
  return json;
}

Json bins_json(const Results& results) {
  Json families = Json::object();
  for (const auto& [name, family] : results.families) families[name] = family_json(family);
  return {{"format", kFormat},
          {"asked", results.asked.to_json()},
          {"interrupted", results.interrupted},
          {"families", families},
          {"buckets", results.buckets},
          {"harness_errors", results.harness_errors},
          {"foreign", foreign_json(results)},
          {"leaks", leaks_json(results)},
          {"given_up", results.given_up},
          {"hosts", results.hosts},
          {"timing", {{"seconds", results.seconds}, {"threads", results.threads}}}};
}

/// JSON in a string, as host_json() of corpus/command/build_info.hpp writes it.
std::string read_host(const Field& field) {
  const std::string text = field.text();
  try {
    const Json tree = read_json(text);
    const Field host(tree);
    for (const char* name : {"system", "machine", "compiler", "flags", "commit"}) (void)host.member(name).text();
  } catch (const FieldError& e) {
    field.fail(e.field.empty() ? e.what() : e.field + ": " + e.what());
  }
  return text;
}

std::map<std::string, std::uint64_t> read_named_counts(const Field& field) {
  std::map<std::string, std::uint64_t> out;
  for (const auto& [name, count] : field.members()) out[name] = read_count(count);
  return out;
}

void read_solvers(Results& results, const Field& root) {
  for (const auto& [method, solver] : root.member("foreign").members())
    results.foreign[method] = {solver.member("option").text(), read_abilities(solver.member("abilities"))};
  for (const auto& [method, leak] : root.member("leaks").members())
    results.leaks[method] = {leak.member("bytes_a_call").number(), count_at(leak, "calls")};
  for (const Field& method : root.member("given_up").elements()) results.given_up.insert(method.text());
}

Results read_bins(const Field& root) {
  Results results;
  const Field format = root.member("format");
  if (format.text() != kFormat) format.fail("is \"" + format.text() + "\", must be \"" + kFormat + "\"");
  results.asked = Asked::read(root.member("asked"));
  results.interrupted = root.member("interrupted").flag();
  for (const auto& [name, family] : root.member("families").members()) results.families[name] = read_family(family);
  results.buckets = read_named_counts(root.member("buckets"));
  results.harness_errors = read_named_counts(root.member("harness_errors"));
  read_solvers(results, root);
  for (const Field& host : root.member("hosts").elements()) results.hosts.insert(read_host(host));
  const Field timing = root.member("timing");
  results.seconds = timing.member("seconds").number();
  results.threads = static_cast<unsigned>(timing.member("threads").natural(std::numeric_limits<unsigned>::max()));
  return results;
}

/// Only what write_results() names, so that a folder with other files in it loses none.
void remove_old_results(const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = finished_name(entry);
    if (name == "summary.json" || name == "campaign.bins") fs::remove(entry);
  }
  for (const auto& entry : fs::directory_iterator(folder / "failures")) {
    const std::string name = finished_name(entry);
    if (name.ends_with(kSimplest) || name.ends_with(kWorst) || name.ends_with(kShrunk)) fs::remove(entry);
  }
}

}  // namespace

void FamilyResults::merge(const FamilyResults& other) {
  cases += other.cases;
  digest += other.digest;
  reference_unsolved += other.reference_unsolved;
  not_proved_lowest += other.not_proved_lowest;
  for (std::size_t i = 0; i < needed.size(); ++i) needed[i] += other.needed[i];
  reference_beaten += other.reference_beaten;
  add_methods(other);
}

/// What it took to judge is what the dearest of the two took, case by case unknown.
void FamilyResults::join(const FamilyResults& other) {
  reference_beaten = std::max(reference_beaten, other.reference_beaten);
  if (other.needed[2] + other.needed[1] > needed[2] + needed[1]) needed = other.needed;
  add_methods(other);
}

void FamilyResults::add_methods(const FamilyResults& other) {
  merge_tallies(methods, other.methods);
  for (const auto& [name, tallies] : other.generators) merge_tallies(generators[name], tallies);
  for (const auto& [name, ladder] : other.ladders) ladders[name].merge(ladder);
}

void Results::merge(Results&& other) {
  for (const auto& [name, family] : other.families) families[name].merge(family);
  add_the_rest(std::move(other));
}

void Results::join(Results&& other) {
  asked.methods.merge(other.asked.methods);
  for (auto& [message, n] : other.harness_errors) n -= std::min(n, harness_errors[message]);
  std::erase_if(other.harness_errors, [](const auto& error) { return error.second == 0; });
  std::erase_if(harness_errors, [](const auto& error) { return error.second == 0; });
  shards_missing = shards_missing || other.shards_missing;
  for (const auto& [name, family] : other.families) families[name].join(family);
  add_the_rest(std::move(other));
}

void Results::add_the_rest(Results&& other) {
  interrupted = interrupted || other.interrupted;
  for (const auto& [bucket, n] : other.buckets) buckets[bucket] += n;
  for (const auto& [message, n] : other.harness_errors) harness_errors[message] += n;
  foreign.insert(other.foreign.begin(), other.foreign.end());
  for (const auto& [method, leak] : other.leaks)  // each shard asked for the same pairs
    if (leak.bytes_a_call > leaks[method].bytes_a_call) leaks[method] = leak;
  given_up.insert(other.given_up.begin(), other.given_up.end());
  kept.merge(std::move(other.kept));
  answers.merge(other.answers);
  hosts.merge(other.hosts);
  seconds += other.seconds;
  threads = std::max(threads, other.threads);
}

std::uint64_t Results::cases() const {
  std::uint64_t n = 0;
  for (const auto& entry : families) n += entry.second.cases;
  return n;
}

Tallies Results::methods() const {
  Tallies all;
  for (const auto& entry : families) merge_tallies(all, entry.second.methods);
  return all;
}

Json Results::hosts_json() const {
  Json all = Json::array();
  for (const std::string& host : hosts) all.push_back(read_json(host));
  return all.size() == 1 ? all[0] : all;
}

bool has_finding(const Results& results) {
  bool found = !results.harness_errors.empty() || !results.leaks.empty();
  for (const auto& [name, family] : results.families) {
    found = found || family.reference_beaten > 0;
    for (const auto& [method, tally] : family.methods) found = found || (!tally.published && tally.failures() > 0);
  }
  return found;
}

int exit_code(const Results& results) {
  if (results.interrupted || results.shards_missing) return 130;
  return has_finding(results) ? 1 : 0;
}

std::vector<std::string> family_order(const Results& results) {
  std::vector<std::string> known{"real"};
  for (const Family& family : families()) known.emplace_back(family.name);
  return ordered(results.families, known);
}

std::vector<std::string> method_order(const Tallies& tallies) {
  return ordered(tallies, solver_names());
}

std::vector<std::string> ladder_order(const Ladders& ladders) {
  const auto known = hard_generators();
  return ordered(ladders, {known.begin(), known.end()});
}

std::string format_bins(const Results& results) {
  return bins_json(results).dump() + "\n";
}

Results parse_bins(const std::string& text, const std::string& file) {
  try {
    const Json tree = read_json(text);
    return read_bins(Field(tree));
  } catch (const FieldError& e) {
    throw InputFailure(file, 0, e.field, e.what());
  }
}

void prepare_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder / "failures", error);
  if (error) throw InputFailure(folder.string(), 0, "--out", "cannot make the folder: " + error.message());
  const fs::path probe = folder / "failures" / ".writable";
  if (!std::ofstream(probe)) throw InputFailure(folder.string(), 0, "--out", "cannot write there");
  fs::remove(probe, error);
  remove_old_results(folder);
}

void write_results(const Results& results, const fs::path& folder) {
  // The counts first: they are small, and what a disk that fills up during the many failures leaves is then still a result.
  write_file(folder / "summary.json", summary_json(results).dump(2) + "\n");
  write_file(folder / "campaign.bins", format_bins(results));
  results.kept.write(folder / "failures");
}

std::string format_part(const Results& results) {
  return format_bins(results) + results.kept.format();
}

Results read_part(const fs::path& file) {
  TextInput in(file.string());
  std::string line;
  if (!in.next_line(line)) throw InputFailure(file.string(), 0, "", "holds no part of a campaign");
  Results results = parse_bins(line, file.string());
  while (in.next_line(line)) results.kept.add_line(line, file.string(), in.line());
  return results;
}

Results read_results(const fs::path& folder) {
  if (fs::is_regular_file(folder)) return read_part(folder);
  const fs::path path = folder / "campaign.bins";
  if (!fs::exists(path))
    throw InputFailure(path.string(), 0, "campaign.bins",
                       fs::exists(folder / "chunks")
                           ? "is missing: the campaign was cut short; run it again with --resume"
                           : "cannot be read: is this the folder of a campaign?");
  Results results = parse_bins(read_text(path), path.string());
  results.kept.read(folder / "failures");
  return results;
}

}  // namespace plumb
