// Answers as files hold them: the object of `plumb solve --json`, written and read back.
#pragma once

#include <optional>
#include <string>

#include "corpus/case.hpp"
#include "solver/contact.hpp"

namespace plumb {

/// What was asked, what came, and how long it took.
struct Answer {
  std::string name;  ///< of the case
  Pair pair;
  Want want;
  Contact<double> contact;
  std::optional<double> nanoseconds;
};

/// The contract's object; a field that was not asked for, or is not valid, is absent. A radius of curvature that is
/// infinite (a flat) is the string "infinite".
[[nodiscard]] Json answer_json(const Answer& answer);

/// +1, -1, or 0 when the overlap has no sign.
[[nodiscard]] int sign_of(double overlap);

/// Anybody's answer to a case.
struct GivenAnswer {
  std::string name;    ///< empty when it does not say
  std::string method;  ///< "answer" when it does not say
  Contact<double>
      contact;  ///< NaN where it is silent; converged, and with the overlap's verdict, unless it says otherwise
};

/// Reads the fields of `plumb solve`; null is absent, and fields of other names are ignored. Throws InputFailure.
[[nodiscard]] GivenAnswer parse_answer(const std::string& text, const std::string& file, int line = 0);

/// Every answer in a file: one object, or one a line. Throws InputFailure.
[[nodiscard]] std::vector<GivenAnswer> read_answers(const std::string& path);

}  // namespace plumb
