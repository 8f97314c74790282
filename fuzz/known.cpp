#include "fuzz/known.hpp"

#include <array>
#include <sstream>
#include <string>

#include "corpus/case.hpp"

namespace plumb {
namespace {

constexpr std::array<KnownFault, 1> kKnown{{
    {"new_cn", FindingKind::wrong_branch,
     "one start and no global guard: a common normal, but not the one of lowest overlap", "issue 4"},
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

bool AbortRule::stops(std::string_view method, FindingKind kind) const {
  if (!kinds_.contains(kind)) return false;
  if (!use_table_) return true;
  for (const KnownFault& known : known_faults())
    if (known.method == method && known.kind == kind) return false;
  return true;
}

}  // namespace plumb
