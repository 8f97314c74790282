#include "fuzz/targets/abort_rule.hpp"

#include <sstream>
#include <string>

#include "corpus/case/case.hpp"

namespace plumb {
namespace {

constexpr int kKinds = static_cast<int>(FindingKind::none);

FindingKind kind_named(const std::string& word) {
  const std::optional<FindingKind> kind = finding_kind(word);
  if (kind && *kind != FindingKind::none) return *kind;
  throw InputFailure("PLUMB_FUZZ_ABORT", 0, word,
                     "is no finding; known: wrong, all, none and the findings of plumb check");
}

}  // namespace

AbortRule::AbortRule(std::string_view words) {
  if (words == "none") return;
  if (words.empty() || words == "wrong" || words == "all") {
    for (int i = 0; i < kKinds; ++i) kinds_.insert(static_cast<FindingKind>(i));
    if (words == "all") return;
    kinds_.erase(FindingKind::nonconverged);
    kinds_.erase(FindingKind::asymmetric);
    return;
  }
  std::stringstream list{std::string(words)};
  for (std::string word; std::getline(list, word, ',');) kinds_.insert(kind_named(word));
}

}  // namespace plumb
