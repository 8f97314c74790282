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
Failure checked_failure(Case c, const std::string& file, int line) {
  try {
    for (const char* field : {"law", "detail", "family"}) (void)c.provenance.value(field, "");  // must be text
    return failure_of(std::move(c));
  } catch (const FieldError& e) {
    throw InputFailure(file, line, e.field, e.what());
  } catch (const Json::exception& e) {
    throw InputFailure(file, line, "provenance", e.what());
  }
}

Failure read_failure(const std::filesystem::path& path) {
  std::optional<Case> c = CaseReader(path.string()).next();
  if (!c) throw InputFailure(path.string(), 0, "", "holds no case");
  return checked_failure(std::move(*c), path.string(), 0);
}

/// The bucket whose file has that name; none where it is another file.
std::optional<std::string> bucket_of(const std::string& file) {
  for (const std::string_view suffix : {kSimplest, kWorst})
    if (file.ends_with(suffix)) return file.substr(0, file.size() - suffix.size());
  return std::nullopt;
}

std::string line_of(const std::string& file, const Failure& failure) {
  return "{\"file\":" + Json(file).dump() + ",\"case\":" + format_case(failure.kept) + "}\n";
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
  for (const auto& path : find_case_files({folder.string()}))
    if (const auto bucket = bucket_of(path.filename().string())) add(*bucket, read_failure(path));
}

std::string KeptFailures::format() const {
  std::string text;
  for (const auto& [bucket, kept] : buckets_)
    text += line_of(bucket + std::string(kSimplest), kept.simplest) + line_of(bucket + std::string(kWorst), kept.worst);
  return text;
}

void KeptFailures::add_line(const std::string& text, const std::string& file, int line) {
  try {
    const Json json = read_json(text);
    const auto bucket = bucket_of(json.at("file").get<std::string>());
    if (!bucket) throw InputFailure(file, line, "file", "is no name of a kept failure");
    add(*bucket, checked_failure(parse_case(json.at("case").dump(), file, line), file, line));
  } catch (const FieldError& e) {
    throw InputFailure(file, line, e.field, e.what());
  } catch (const Json::exception& e) {
    throw InputFailure(file, line, "", e.what());
  }
}

}  // namespace plumb
