// One case of a replay: solved, judged by the laws, held against what it expects.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "corpus/case/case.hpp"
#include "corpus/solvers/solver.hpp"
#include "properties/laws/laws.hpp"

namespace plumb {

struct Replayed {
  std::string file;
  int line = 0;  ///< 0 in a file that is one case
  std::string name;
  std::string method;
  Finding finding;
  std::string unjudged;                  ///< why the reference has no answer to this method's problem; empty: it has
  std::vector<std::string> differences;  ///< in words; empty: the case gave what it expects
  double seconds = 0;
  std::string status = {};  ///< of the answer
  bool is_own = true;       ///< the method is plumb's own and no published baseline
  double angle_error_deg =
      std::numeric_limits<double>::quiet_NaN();  ///< to the certified common normal, whatever the problem; NaN: unknown
};

enum class Outcome { as_expected, differs, not_judged };

/// Without a reference no finding is no news; a finding of the laws that need none, and what differs, count all the same.
[[nodiscard]] Outcome outcome(const Replayed& replayed);

/// By the answer that the case holds under "x_answer", which is judged as it stands; else by the method that it names (auto when it
/// names none); or by the one that is asked for instead. A recorded finding is met by one that comes before it as well. A case without
/// an expected finding expects none; what the folder asks of it (life.hpp) counts as expected, and in open/, where the answer
/// is known to fail, the case's numbers do not. Another method than the case's own is not held to the case's status and finding, and
/// to its numbers only when it answers the same problem. What it does not claim to answer is not judged. Findings
/// are those at `accuracy`; the references come from `source`. Throws InputFailure when there is
/// no such method.
[[nodiscard]] Replayed replay_case(const Case& c, const std::string& file, int line,
                                   const std::optional<Solver>& instead, const ReferenceSource& source = {},
                                   const Accuracy& accuracy = {});

/// "FILE" or "FILE:LINE".
[[nodiscard]] std::string place_of(const Replayed& replayed);

}  // namespace plumb
