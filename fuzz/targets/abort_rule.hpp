// When the fuzz target stops.
#pragma once

#include <set>
#include <string_view>

#include "properties/laws/laws.hpp"

namespace plumb {

/// Which findings stop the engine: "wrong" (or ""), "all", "none", or the words of the kinds, comma-separated. "wrong" leaves out
/// `nonconverged`, where the solver says itself that it has no answer, and `asymmetric`, which is that of a related pair:
/// corpus/cases/open has what is known of both, and a hunt that stops there finds nothing else.
class AbortRule {
 public:
  explicit AbortRule(std::string_view words);
  [[nodiscard]] bool stops(const Finding& finding) const { return stops(finding.kind); }
  [[nodiscard]] bool stops(FindingKind kind) const { return kinds_.contains(kind); }

 private:
  std::set<FindingKind> kinds_;
};

}  // namespace plumb
