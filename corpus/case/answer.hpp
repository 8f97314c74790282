// Answers as files hold them: the object of `plumb solve --json`, written and read back.
#pragma once

#include <optional>
#include <string>

#include "corpus/case/case.hpp"
#include "solver/contact.hpp"

namespace plumb {

/// What was asked, what came, and how long it took.
struct Answer {
  std::string name;          ///< of the case
  std::optional<Pair> pair;  ///< nothing where a shape is no superellipsoid's: no angles and no residuals
  Want want;
  Contact<double> contact;
  std::optional<double> nanoseconds;
  struct None {
    std::string finding, detail;  ///< crash or slow, and what happened
  };
  std::optional<None> none = {};  ///< of a foreign solver that gave no answer: there is nothing but the method's name
  Problem problem = Problem::common_normal;  ///< of a foreign solver, which its name does not tell
};

/// The contract's object; a field that was not asked for, or is not valid, is absent. A radius of curvature that is
/// infinite (a flat) is the string "infinite". Without an answer "x_finding" and "x_detail" say why.
[[nodiscard]] Json answer_json(const Answer& answer);

/// Those of them that are the answer itself: status, verdict, overlap, normal, points, contact_point, iterations, evaluations.
[[nodiscard]] Json contact_json(const Contact<double>& contact, const Want& want);

/// Reads those; null is absent, absent is NaN; converged, and with the overlap's verdict, unless it says otherwise. Throws FieldError,
/// also when there is nothing that could be judged.
[[nodiscard]] Contact<double> read_contact(const Field& answer);

/// The three angles of "angles_deg"; null when none is valid. Without a sign (0) d_n1 and d_n2 say nothing.
[[nodiscard]] Json angles_json(const Pair& pair, const Contact<double>& contact, int overlap_sign);

/// +1, -1, or 0 when the overlap has no sign.
[[nodiscard]] int sign_of(double overlap);

/// Anybody's answer to a case.
struct GivenAnswer {
  std::string name;                          ///< empty when it does not say
  std::string method;                        ///< "answer" when it does not say
  Problem problem = Problem::common_normal;  ///< the one that `method` is, or solves
  Contact<double>
      contact;  ///< NaN where it is silent; converged, and with the overlap's verdict, unless it says otherwise
};

/// Reads the fields of `plumb solve`; null is absent. Throws InputFailure: for other fields (but "x_.."), for a "method" that is
/// no method's, problem's or foreign solver's name, and when there is nothing that could be judged.
[[nodiscard]] GivenAnswer parse_answer(const std::string& text, const std::string& file, int line = 0);

/// The answer that a case holds itself, under "x_answer": the flight recorder's (solver/plumb_recorder.h).
struct RecordedAnswer {
  GivenAnswer given;                   ///< of method "recorded" unless it says otherwise
  std::optional<Answer::None> none{};  ///< "x_finding" in its place: there was no answer
};

/// nullopt when the case holds none; throws InputFailure.
[[nodiscard]] std::optional<RecordedAnswer> recorded_answer(const Case& c, const std::string& file, int line = 0);

/// The answers in a file, one after the other: one object, or one a line, whatever the file's name; "-" is standard input.
class AnswerReader {
 public:
  explicit AnswerReader(const std::string& path);
  /// nullopt at the end; throws InputFailure.
  [[nodiscard]] std::optional<GivenAnswer> next();
  [[nodiscard]] const std::string& file() const { return objects_.file(); }
  /// Line of the last answer; 0 for what comes first in a file that is not named .jsonl: it may be all that there is.
  [[nodiscard]] int line() const { return numbered_ ? objects_.line() : 0; }

 private:
  ObjectReader objects_;
  bool numbered_;
  bool any_ = false;
};

}  // namespace plumb
