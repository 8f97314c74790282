// plumb report --issue CASE: what somebody else's maintainer needs, as Markdown. Nothing in it asks for plumb.
#pragma once

#include <string>

#include "corpus/case/case.hpp"
#include "corpus/solvers/solver.hpp"
#include "properties/laws/accuracy.hpp"

namespace plumb::reports {

/// The pair in numbers, expected and got, and how to check it by hand; and whether there is a finding at all. A solver that gives no
/// answer has what it did instead.
struct Issue {
  std::string markdown;
  bool has_finding = false;
};
/// `command`: what makes it again.
[[nodiscard]] Issue issue(const Case& c, const Solver& solver, const Accuracy& accuracy, const std::string& command);

}  // namespace plumb::reports
