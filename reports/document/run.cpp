#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "corpus/solvers/host/shell_words.hpp"
#include "corpus/solvers/solver.hpp"
#include "properties/laws/accuracy_option.hpp"
#include "reports/document/document.hpp"
#include "solver/method/methods.hpp"

namespace plumb::reports {
namespace {

template <class Word, std::size_t N>
Json shares_json(const std::array<std::uint64_t, N>& counts, std::uint64_t of) {
  Json out = Json::object();
  for (std::size_t i = 0; i < N; ++i)
    if (counts[i] > 0) out[std::string(name(static_cast<Word>(i)))] = share_json(counts[i], of);
  return out;
}

/// The findings that there are, and always those that broke no law.
Json findings_of(const Tally& t) {
  Json out = shares_json<FindingKind>(t.findings, t.judged());
  out[std::string(name(FindingKind::none))] = share_json(t.of(FindingKind::none), t.judged());
  return out;
}

/// At each level of accuracy, the finest first.
Json right_shares(const Tally& t) {
  Json out = Json::object();
  for (std::size_t i = 0; i < accuracy_levels.size(); ++i)
    out[std::string(accuracy_levels[i].name)] = share_json(t.right[i], t.judged());
  return out;
}

/// Who never counts his steps (a peer) says nothing of them.
Json counts_json(const Histogram& h) {
  return h.max() > 0 ? h.summary() : Json();
}

Json method_json(const std::string& method, const Tally& t) {
  return {{"method", method},
          {"published", t.published},
          {"answers", t.cases},
          {"judged", t.judged()},
          {"unjudged", t.unjudged},
          {"converged", share_json(t.converged(), t.cases)},
          {"findings", findings_of(t)},
          {"failures", share_json(t.failures(), t.judged())},
          {"right", right_shares(t)},
          {"not_asked", t.not_asked},
          {"angle_above", share_json(t.angles_wrong, t.angle_error_deg.count())},
          {"angle_error_deg", t.angle_error_deg.summary()},
          {"overlap_error", t.overlap_error.summary()},
          {"iterations", counts_json(t.iterations)},
          {"evaluations", counts_json(t.evaluations)},
          {"ns_per_solve", t.nanoseconds.summary()}};
}

/// " --method A,B --solver L" as it was asked.
std::string options_of(const Results& results) {
  std::string methods, foreign;
  bool all = true;
  for (const std::string& name : solver_names()) {
    const bool asked = results.asked.methods.contains(name);
    if (asked) methods += (methods.empty() ? "" : ",") + name;
    all = all && asked;
  }
  for (const auto& [method, solver] : results.foreign) foreign += solver.option;
  return (methods.empty() ? "" : " --method " + (all ? "all" : methods)) + foreign +
         accuracy_option(results.asked.accuracy);
}

/// The pairs of corpus/cases/real come with ./fuzz/run alone.
/// One shard is its own campaign; several that were merged are one.
std::string shard_of(const Asked& asked) {
  return asked.shards > 1 && asked.done.size() == 1 ? fmt::format(" --shard {}/{}", *asked.done.begin(), asked.shards)
                                                    : "";
}

std::string command_of(const Results& results, const std::string& family) {
  const auto asked = results.asked.cases.find(family);
  if (family == "real" || asked == results.asked.cases.end()) return "plumb fuzz-run";
  return fmt::format("plumb campaign --family {} --cases {} --seed {}{}{}", family, asked->second, results.asked.seed,
                     options_of(results), shard_of(results.asked));
}

Json family_json(const Results& results, const std::string& family_name) {
  const FamilyResults& family = results.families.at(family_name);
  Json methods = Json::array();
  for (const std::string& method : method_order(family.methods))
    methods.push_back(method_json(method, family.methods.at(method)));
  return {{"name", family_name},
          {"cases", family.cases},
          {"command", command_of(results, family_name)},
          {"reference",
           {{"unsolved", family.reference_unsolved},
            {"not_proved_lowest", family.not_proved_lowest},
            {"beaten", family.reference_beaten},
            {"needed", needed_json(family)}}},
          {"methods", methods}};
}

/// Over all families: counts add up, and so do the bins of the percentiles.
Json totals_json(const Results& results) {
  const Tallies methods = results.methods();
  Json out = Json::array();
  for (const std::string& method : method_order(methods)) out.push_back(method_json(method, methods.at(method)));
  return out;
}

Json axis_json(Property property) {
  const Scale scale = scale_of(property);
  Json labels = Json::array();
  for (std::size_t i = 0; i < scale.cells(); ++i) labels.push_back(scale.label(i));
  return {{"title", scale.title}, {"labels", labels}};
}

/// `counts_steps`: whether the method counts its iterations at all.
Json cells_json(const Atlas::Cells& cells, bool counts_steps) {
  Json out = Json::array();
  for (const auto& [at, cell] : cells)
    out.push_back(
        {{"x", at.first},
         {"y", at.second},
         {"answers", cell.answers},
         {"judged", cell.judged},
         {"failures", cell.failures},
         {"not_converged", cell.not_converged},
         {"iterations",
          counts_steps ? Json(static_cast<double>(cell.iterations) / static_cast<double>(cell.answers)) : Json()}});
  return out;
}

Json atlases_json(const Results& results) {
  Json out = Json::array();
  for (const std::string& family : family_order(results))
    for (const auto& [method, tally] : results.families.at(family).methods)
      for (std::size_t i = 0; i < kAtlasMaps.size(); ++i)
        out.push_back({{"family", family},
                       {"method", method},
                       {"map", kAtlasMaps[i].name},
                       {"x", axis_json(kAtlasMaps[i].x)},
                       {"y", axis_json(kAtlasMaps[i].y)},
                       {"cells", cells_json(tally.atlas.map(i), tally.iterations.max() > 0)}});
  return out;
}

/// Of each bucket the simplest and the worst, which may be one.
std::size_t kept_cases(const Results& results) {
  std::size_t n = 0;
  for (const auto& [bucket, kept] : results.kept.buckets()) n += is_one_case(kept) ? 1 : 2;
  return n;
}

}  // namespace

std::string folder_name(const std::filesystem::path& folder) {
  const std::filesystem::path plain = folder.lexically_normal();
  return (plain.has_filename() ? plain.filename() : plain.parent_path().filename()).string();
}

Json host_of(const Results& results) {
  Json out{{"system", ""}, {"machine", ""}, {"processors", 0}, {"compiler", ""}, {"flags", ""}, {"commit", "unknown"}};
  std::map<std::string, std::set<std::string>> texts;
  for (const std::string& host : results.hosts) {
    const Json said = read_json(host);
    for (const auto& [field, value] : said.items()) {
      if (value.is_string())
        texts[field].insert(value.get<std::string>());
      else
        out[field] = value;
    }
  }
  for (const auto& [field, values] : texts) out[field] = fmt::format("{}", fmt::join(values, ", "));
  return out;
}

Json number_json(double x) {
  return std::isfinite(x) ? Json(x) : Json();
}

Json share_json(std::uint64_t count, std::uint64_t of) {
  const Share s = share_of(count, of);
  return {{"count", count}, {"of", of}, {"share", number_json(s.share)}, {"low", s.low}, {"high", s.high}};
}

Json run_json(const Run& run, const Shown& shown) {
  const Results& results = run.results;
  Json families = Json::array(), commands = Json::array();
  for (const std::string& family : family_order(results)) {
    families.push_back(family_json(results, family));
    commands.push_back(families.back()["command"]);
  }
  const Json host = host_of(results);
  const double seconds = results.seconds;
  return {{"name", folder_name(run.folder)},
          {"folder", run.folder.string()},
          {"commit", host["commit"]},
          {"seed", std::to_string(results.asked.seed)},
          {"cases", results.cases()},
          {"incomplete", results.incomplete()},
          {"commands", commands},
          {"host", host},
          {"harness_errors", results.harness_errors},
          {"timing",
           {{"seconds", seconds},
            {"threads", results.threads},
            {"cases_per_second", seconds > 0 ? static_cast<double>(results.cases()) / seconds : 0.0}}},
          {"totals", totals_json(results)},
          {"families", families},
          {"atlases", atlases_json(results)},
          {"ladders", ladders_json(results)},
          {"kept_failures", kept_cases(results)},
          {"failures", failures_json(run, shown)}};
}

Json findings_json() {
  Json out = Json::array();
  for (std::size_t i = 0; i < kFindingKinds; ++i) {
    const auto kind = static_cast<FindingKind>(i);
    out.push_back({{"word", name(kind)}, {"meaning", meaning(kind)}});
  }
  return out;
}

Json methods_json() {
  Json out = Json::array();
  for (const Method& method : methods())
    out.push_back({{"name", method.name},
                   {"published_by", method.published_by},
                   {"problem", name(method.problem)},
                   {"light", method.look.light},
                   {"dark", method.look.dark},
                   {"symbol", method.look.symbol}});
  return out;
}

Json laws_json() {
  Json out = Json::array();
  for (const Law& law : laws())
    out.push_back({{"name", law.name}, {"statement", law.statement}, {"file", law_file}, {"line", law.line}});
  return out;
}

}  // namespace plumb::reports
