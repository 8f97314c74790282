// One case of a replay: solved, judged by the laws, held against what it expects.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "corpus/case.hpp"
#include "corpus/solver.hpp"
#include "properties/laws.hpp"

namespace plumb {

struct Replayed {
  std::string file;
  int line = 0;  ///< 0 in a file that is one case
  std::string name;
  std::string method;
  Finding finding;
  bool judged = false;                   ///< false: no finding, but also no reference to hold the answer against
  std::vector<std::string> differences;  ///< in words; empty: the case gave what it expects
  double seconds = 0;
};

/// By the method that the case names (auto when it names none), or by the one that is asked for instead. A case without
/// an expected finding expects none. Another method than the case's own is not held to the case's status and finding, and
/// to its numbers only when it answers the same problem. Throws InputFailure when there is no such method.
[[nodiscard]] Replayed replay_case(const Case& c, const std::string& file, int line,
                                   const std::optional<Solver>& instead);

/// "FILE" or "FILE:LINE".
[[nodiscard]] std::string place_of(const Replayed& replayed);

}  // namespace plumb
