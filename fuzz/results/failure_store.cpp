#include "fuzz/results/failure_store.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "corpus/file/output_file.hpp"
#include "corpus/json/fields.hpp"

namespace plumb {
namespace {

bool simpler_than(const Failure& a, const Failure& b) {
  return std::tie(a.simplicity, a.origin, a.index) < std::tie(b.simplicity, b.origin, b.index);
}

bool worse_than(const Failure& a, const Failure& b) {
  return std::tie(b.severity, a.origin, a.index) < std::tie(a.severity, b.origin, b.index);
}

double read_severity(const Field& field) {
  if (field.value() == "infinite") return std::numeric_limits<double>::infinity();
  if (!field.value().is_number()) field.fail("must be a number or \"infinite\"");
  return field.number();
}

/// As the name of where a case comes from; 0 where it says nothing.
std::string number_or_0(const Json& from, const char* field) {
  return from.contains(field) ? from[field].dump() : "0";
}

/// What a kept file says of itself: where it does, in these types.
void require_origin(const Field& from) {
  (void)read_severity(from.member("severity"));
  for (const char* text : {"law", "detail", "family"})
    if (const auto field = from.find(text)) (void)field->text();
  for (const char* number : {"seed", "index"})
    if (const auto field = from.find(number)) (void)field->natural();
}

/// A kept file is a case like any other, but it must say what orders it among the failures.
Failure checked_failure(Case c, const std::string& file, int line) {
  try {
    require_origin(Field(c.provenance, "provenance"));
    return failure_of(std::move(c));
  } catch (const FieldError& e) {
    throw InputFailure(file, line, e.field, e.what());
  }
}

Failure read_failure(const std::filesystem::path& path) {
  std::optional<Case> c = CaseReader(path.string(), CaseShapes::every).next();
  if (!c) throw InputFailure(path.string(), 0, "", "holds no case");
  return checked_failure(std::move(*c), path.string(), 0);
}

/// The bucket whose file has that name; none where it is another file.
std::optional<std::string> bucket_of(const std::string& file) {
  if (!is_file_name(file)) return std::nullopt;
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

Case failing_case(const Case& c, const std::string& method, const Finding& finding, const Accuracy& accuracy,
                  const std::string& command) {
  Case kept = c;
  if (!accuracy.is_rounding()) kept.extra["x_accuracy"] = accuracy_text(accuracy);
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
  failure.simplicity = kept.convex ? simplicity(*kept.convex) : simplicity(kept.pair);
  failure.severity = read_severity(Field(from, "provenance").member("severity"));
  failure.origin = from.value("family", "") + " " + number_or_0(from, "seed");
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
    const Json tree = read_json(text);
    const Field root(tree), name = root.member("file");
    const auto bucket = bucket_of(name.text());
    if (!bucket) name.fail("is no name of a kept failure");
    add(*bucket,
        checked_failure(parse_case(root.member("case").value().dump(), file, line, CaseShapes::every), file, line));
  } catch (const FieldError& e) {
    throw InputFailure(file, line, e.field, e.what());
  }
}

}  // namespace plumb
