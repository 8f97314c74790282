#include "fuzz/targets/abort_rule.hpp"

#include <sstream>
#include <string>

#include "corpus/case/case.hpp"
#include "corpus/json/nearest_word.hpp"

namespace plumb {
namespace {

constexpr int kKinds = static_cast<int>(FindingKind::none);

FindingKind kind_named(const std::string& word) {
  const std::optional<FindingKind> kind = finding_kind(word);
  if (kind && *kind != FindingKind::none) return *kind;
  std::vector<std::string> known{"wrong", "all"};
  for (const FindingRow& row : finding_rows) known.emplace_back(row.word);
  throw InputFailure("PLUMB_FUZZ_ABORT", 0, word, no_such("finding", word, known));
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
