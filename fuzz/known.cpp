#include "fuzz/known.hpp"

#include <array>
#include <limits>
#include <sstream>
#include <string>

#include "corpus/case.hpp"

namespace plumb {
namespace {

constexpr double kAny = std::numeric_limits<double>::infinity();
constexpr std::string_view kBranch =
    "one start and no global guard: another common normal, with the wrong sign when the bodies are apart";
constexpr std::string_view kOrder =
    "one start, which depends on the frame and on which body comes first: the related pair fails";
constexpr std::string_view kPointed =
    "exponents below 2: infinite derivatives at a zero coordinate; flagged by the status";
constexpr std::string_view kRounding =
    "ends at its residual's floor, some times above what the condition number allows";

constexpr std::array<KnownFault, 9> kKnown{{
    {"new_cn", FindingKind::wrong_branch, kAny, kBranch, "issue 4, item 1; seed concentric"},
    {"new_cn", FindingKind::false_contact, kAny, kBranch, "issue 4, item 1"},
    {"new_cn", FindingKind::missed_contact, kAny, kBranch, "issue 4, item 1"},
    {"new_cn", FindingKind::asymmetric, kAny, kOrder, "issue 4, item 1; seed size_ratio_1e4"},
    {"new_cn", FindingKind::not_finite, kAny, kPointed, "issue 4, item 2; seed pointed_exponent_1.5"},
    {"new_cn", FindingKind::misaligned, 1000, kRounding, "issue 4, item 2"},
    {"new_cn", FindingKind::off_surface, 1000, kRounding, "issue 4, item 2"},
    {"new_cn", FindingKind::overlap_error, 1000, kRounding, "issue 4, item 2"},
    {"new_cn", FindingKind::point_error, 1000, kRounding, "issue 4, item 2"},
}};

constexpr int kKinds = static_cast<int>(FindingKind::none);

std::set<FindingKind> all_kinds() {
  std::set<FindingKind> kinds;
  for (int i = 0; i < kKinds; ++i) kinds.insert(static_cast<FindingKind>(i));
  return kinds;
}

FindingKind kind_named(const std::string& word) {
  for (const FindingKind kind : all_kinds())
    if (name(kind) == word) return kind;
  throw InputFailure("PLUMB_FUZZ_ABORT", 0, word,
                     "is no finding; known: default, all, none and the findings of plumb check");
}

}  // namespace

std::span<const KnownFault> known_faults() {
  return kKnown;
}

AbortRule::AbortRule(std::string_view words) {
  if (words.empty() || words == "default") {
    use_table_ = true;
    kinds_ = all_kinds();
    kinds_.erase(FindingKind::nonconverged);
  } else if (words == "all") {
    kinds_ = all_kinds();
  } else if (words != "none") {
    std::stringstream list{std::string(words)};
    for (std::string word; std::getline(list, word, ',');) kinds_.insert(kind_named(word));
  }
}

bool AbortRule::stops(std::string_view method, const Finding& finding) const {
  if (!kinds_.contains(finding.kind)) return false;
  if (!use_table_) return true;
  for (const KnownFault& known : known_faults())
    if (known.method == method && known.kind == finding.kind && finding.severity <= known.severity) return false;
  return true;
}

}  // namespace plumb
