// What the targets that ask a solver about a pair have in common: the certified judgement, and what is kept of a finding.
#pragma once

#include "corpus/case/case.hpp"
#include "fuzz/targets/target.hpp"
#include "properties/laws/laws.hpp"

namespace plumb {

/// Asks the solver of target_settings.hpp, judges by all laws, lights the thermometers; the case of a finding that stops is kept
/// ready for plumb replay.
[[nodiscard]] Outcome examine_pair(const Case& c, const char* target);

/// The case of a finding, where the settings name a folder.
void keep_finding(const Case& c, const char* target, const std::string& method, const Finding& finding,
                  const Reference& reference);

}  // namespace plumb
