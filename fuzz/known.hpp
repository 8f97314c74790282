// When the fuzz target stops: every finding is an error but those of the table in known.cpp.
#pragma once

#include <set>
#include <span>
#include <string_view>

#include "properties/laws.hpp"

namespace plumb {

/// A fault that is known, written down and expected; the fuzzer would find nothing else.
struct KnownFault {
  std::string_view method;
  FindingKind kind;
  double severity;  ///< up to which it is expected
  std::string_view reason;
  std::string_view pinned;  ///< the issue or case that holds it
};
[[nodiscard]] std::span<const KnownFault> known_faults();

/// Which findings stop the engine. "default": all but `nonconverged` with a status of its own (a flag is a legal answer) and
/// the known faults; "all"; "none"; or the words of the kinds, comma-separated.
class AbortRule {
 public:
  explicit AbortRule(std::string_view words);
  [[nodiscard]] bool stops(std::string_view method, const Finding& finding) const;

 private:
  bool use_table_ = false;
  std::set<FindingKind> kinds_;
};

}  // namespace plumb
