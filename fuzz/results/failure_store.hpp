// The failures that are kept: of each bucket the simplest case and the worst, whatever the order in which they were found.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "corpus/case/case.hpp"
#include "fuzz/results/bucket.hpp"
#include "properties/laws/laws.hpp"

namespace plumb {

/// A failing case: expect holds method and finding; provenance where it came from, severity, law, detail and the command of
/// the campaign. Everything that orders failures is in the case, so that a kept file can be merged again.
struct Failure {
  Case kept;
  Simplicity simplicity{};
  double severity = 0;
  std::string origin;       ///< family, then the generator's seed
  std::uint64_t index = 0;  ///< in the family: the last tie-break
};

[[nodiscard]] Failure failure_of(Case kept);

/// How the names of a bucket's two files end; and of the simplest's when it was shrunk, which no merge reads.
inline constexpr std::string_view kSimplest = "--simplest.json", kWorst = "--worst.json", kShrunk = "--shrunk.json";

/// JSON has no infinity, and a severity that is not a number is no smaller than any.
[[nodiscard]] Json severity_json(double severity);

struct KeptBucket {
  Failure simplest, worst;
};
/// The simplest is the worst.
[[nodiscard]] bool is_one_case(const KeptBucket& kept);

class KeptFailures {
 public:
  void add(const std::string& bucket, Failure failure);
  void merge(KeptFailures&& other);
  [[nodiscard]] const std::map<std::string, KeptBucket>& buckets() const { return buckets_; }
  /// DIR/BUCKET--simplest.json and --worst.json; throws InputFailure.
  void write(const std::filesystem::path& folder) const;
  /// Adds what write() left there.
  void read(const std::filesystem::path& folder);
  /// What write() writes as lines: { "file": its name, "case": what is in it }.
  [[nodiscard]] std::string format() const;
  /// Adds one of these lines; `file` and `line` name it in errors. Throws InputFailure.
  void add_line(const std::string& text, const std::string& file, int line);

 private:
  std::map<std::string, KeptBucket> buckets_;
};

/// The case to keep of a finding by a method at that accuracy; `command` repeats the campaign.
[[nodiscard]] Case failing_case(const Case& c, const std::string& method, const Finding& finding,
                                const Accuracy& accuracy, const std::string& command);

}  // namespace plumb
