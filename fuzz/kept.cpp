#include "fuzz/kept.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

namespace plumb {
namespace {

bool simpler_than(const Failure& a, const Failure& b) {
  return std::tie(a.simplicity, a.origin, a.index) < std::tie(b.simplicity, b.origin, b.index);
}

bool worse_than(const Failure& a, const Failure& b) {
  return std::tie(b.severity, a.origin, a.index) < std::tie(a.severity, b.origin, b.index);
}

double read_severity(const Json& json) {
  if (json.is_number()) return json.get<double>();
  if (json != "infinite")
    throw FieldError("provenance.severity", json.dump() + " is neither a number nor \"infinite\"");
  return std::numeric_limits<double>::infinity();
}

/// A kept file is a case like any other, but it must say what orders it among the failures.
Failure read_failure(const std::filesystem::path& path) {
  try {
    std::optional<Case> c = CaseReader(path.string()).next();
    if (!c) throw InputFailure(path.string(), 0, "", "holds no case");
    for (const char* field : {"law", "detail", "family"}) (void)c->provenance.value(field, "");  // must be text
    return failure_of(std::move(*c));
  } catch (const FieldError& e) {
    throw InputFailure(path.string(), 0, e.field, e.what());
  } catch (const Json::exception& e) {
    throw InputFailure(path.string(), 0, "provenance", e.what());
  }
}

}  // namespace

Json severity_json(double severity) {
  if (std::isfinite(severity)) return severity;
  return "infinite";
}

Case failing_case(const Case& c, const std::string& method, const Finding& finding, const std::string& command) {
  Case kept = c;
  kept.expect = {};
  kept.expect.method = method;
  kept.expect.finding = std::string(name(finding.kind));
  if (!kept.provenance.is_object()) kept.provenance = Json::object();
  kept.provenance["severity"] = severity_json(finding.severity);
  kept.provenance["law"] = finding.law;
  kept.provenance["detail"] = finding.detail;
  kept.provenance["command"] = command;
  return kept;
}

Failure failure_of(Case kept) {
  Failure failure;
  const Json& from = kept.provenance;
  failure.simplicity = simplicity(kept.pair);
  failure.severity = read_severity(from.at("severity"));
  failure.origin = from.value("family", "") + " " + std::to_string(from.value("seed", std::uint64_t{0}));
  failure.index = from.value("index", std::uint64_t{0});
  failure.kept = std::move(kept);
  return failure;
}

bool is_one_case(const KeptBucket& kept) {
  return format_case(kept.simplest.kept) == format_case(kept.worst.kept);
}

void KeptFailures::add(const std::string& bucket, Failure failure) {
  const auto at = buckets_.find(bucket);
  if (at == buckets_.end()) {
    buckets_.emplace(bucket, KeptBucket{failure, failure});
    return;
  }
  if (worse_than(failure, at->second.worst)) at->second.worst = failure;
  if (simpler_than(failure, at->second.simplest)) at->second.simplest = std::move(failure);
}

void KeptFailures::merge(KeptFailures&& other) {
  for (auto& [bucket, kept] : other.buckets_) {
    add(bucket, std::move(kept.simplest));
    add(bucket, std::move(kept.worst));
  }
}

void KeptFailures::write(const std::filesystem::path& folder) const {
  for (const auto& [bucket, kept] : buckets_) {
    write_file(folder / (bucket + std::string(kSimplest)), format_case(kept.simplest.kept) + "\n");
    write_file(folder / (bucket + std::string(kWorst)), format_case(kept.worst.kept) + "\n");
  }
}

void KeptFailures::read(const std::filesystem::path& folder) {
  if (!std::filesystem::exists(folder)) return;  // an empty one is lost on the way through many stores
  for (const auto& path : find_case_files({folder.string()})) {
    const std::string file = path.filename().string();
    for (const std::string_view suffix : {kSimplest, kWorst}) {
      if (!file.ends_with(suffix)) continue;
      add(file.substr(0, file.size() - suffix.size()), read_failure(path));
    }
  }
}

}  // namespace plumb
