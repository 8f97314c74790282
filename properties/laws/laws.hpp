// What must be true of an answer. Each law is one function from the evidence to a finding, written here once and used by
// the test suite, the fuzzers, the campaign and replay alike.
#pragma once

#include <array>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "corpus/solvers/abilities.hpp"
#include "properties/laws/accuracy.hpp"
#include "properties/laws/finding_kinds.hpp"
#include "properties/laws/seen_point.hpp"
#include "solver/contact.hpp"
#include "solver/reference/condition/nearby.hpp"
#include "solver/reference/condition/solution_set.hpp"
#include "solver/reference/reference.hpp"

namespace plumb {

struct Finding {
  FindingKind kind = FindingKind::none;
  double severity = 0;  ///< error over what the condition number allows; above 1 it is a finding
  std::string law;      ///< the law that was broken
  std::string detail;   ///< in words, with figures
  double doubt = 0;     ///< by how much the reference's own bounds leave the severity open
};

/// Everything a law may look at.
struct Evidence {
  const Pair& pair;
  Problem problem;
  const Contact<double>& answer;
  const Reference& reference;
  const Solution& own;  ///< the 50-digit answer to the method's own problem (reference.common_normal for CN methods)
  /// Solves a related pair with the same method; empty when only an answer is there (plumb check).
  std::function<Contact<double>(const Pair&)> solve;
  /// One of plumb's: it answers every legal pair, and with the same bits in any unit that is a power of two. Others may refuse, and round.
  bool is_own = false;
  /// All answers to all inputs within rounding of the pair, for where a condition number is infinite; may be empty.
  std::function<const reference::SolutionSet&()> all_solutions = {};
  /// How far the answers to inputs within rounding are, for where a condition number bounds too little; may be empty.
  std::function<const reference::NearbyAnswers&()> nearby = {};
  /// What is allowed beside rounding.
  Accuracy accuracy = {};
  /// What the method claims to answer; null: everything.
  const Abilities* claims = nullptr;
  /// The answer's points as the laws see them, kept from law to law; may be empty.
  std::function<const law::SeenPair&()> seen = {};
};

/// What a law needs to be asked.
enum class Needs {
  nothing,   ///< but bounds and verdict
  solution,  ///< a certified answer to the method's own problem
  rounding   ///< that, and an answer that is held to rounding: a coarser one is held to the certified answer, and alone
};

struct Law {
  std::string_view name;
  std::string_view statement;
  Finding (*check)(const Evidence&);
  Needs needs = Needs::solution;
  int line = __builtin_LINE();  ///< in its row of law_file; std::source_location is not in AFL++'s clang 14
};
inline constexpr std::string_view law_file = "properties/laws/laws.cpp";

/// Every law, in the order of precedence.
[[nodiscard]] std::span<const Law> laws();

/// The first law that an answer breaks.
struct Decision {
  Finding finding;
  bool decided = true;  ///< the reference's digits are enough to say so
};
[[nodiscard]] Decision decide(const Evidence& evidence);

/// The verdict of all laws on one answer, and its figures.
struct Judgement : Decision {
  bool judged = false;  ///< the reference has an answer to the method's own problem (a proved one to a potential's)
  double angle_error_deg = std::numeric_limits<
      double>::quiet_NaN();  ///< to the certified common normal, whatever the method's problem; NaN when unknown
  double overlap = std::numeric_limits<double>::quiet_NaN();  ///< of its own problem, certified; NaN when unknown
  double overlap_error =
      std::numeric_limits<double>::quiet_NaN();  ///< |overlap - own problem's| / size; NaN when unknown
  double point_error = std::numeric_limits<
      double>::quiet_NaN();  ///< the larger point's distance from its own problem's / size; NaN when unknown
  std::size_t right_from = right_at_no_level;  ///< the finest of accuracy_levels at which no law is broken
  bool wrong_aside = false;  ///< it did not converge, and the verdict that it gives all the same is wrong
};
[[nodiscard]] Judgement judge(const Evidence& evidence);

/// Who is judged, and how: the rest of what Judge::judge is asked.
struct JudgedBy {
  Problem problem = Problem::common_normal;
  /// Solves a related pair; may be empty.
  std::function<Contact<double>(const Pair&)> solve_again = {};
  bool is_own = false;
  Accuracy accuracy = {};
  const Abilities* claims = nullptr;
};

/// The evidence gathered and judged: what campaign, fuzzers, replay and check call. Bounds first, then a proof, then digits:
/// each is computed when the one before leaves an answer's severity open, once for a case, and shared by all methods.
class Judge {
 public:
  explicit Judge(const Pair& pair, ReferenceSource source = {});
  /// The dearest that was needed so far.
  [[nodiscard]] const Reference& reference() const { return references_.back(); }
  /// By the cheapest effort that tells; undecided where none does.
  [[nodiscard]] Verdict certified_verdict();
  [[nodiscard]] const Solution& solution(Problem problem) { return solution(problem, reference()); }
  [[nodiscard]] Judgement judge(const JudgedBy& by, const Contact<double>& answer);
  [[nodiscard]] Judgement judge(Problem problem, const Contact<double>& answer,
                                const std::function<Contact<double>(const Pair&)>& solve_again = {},
                                bool is_own = false) {
    return judge({problem, solve_again, is_own}, answer);
  }

 private:
  using Nearby = const reference::NearbyAnswers& (Judge::*)(const Reference&);
  /// What `look` sees in the evidence, by the cheapest effort with which it is decided.
  template <class Look>
  [[nodiscard]] auto decided_by(const JudgedBy& by, const Contact<double>& answer, const Accuracy& accuracy,
                                const Look& look, Nearby nearby_by = &Judge::nearby);
  [[nodiscard]] std::size_t right_from(const JudgedBy& by, const Contact<double>& answer, const Finding& as_asked);
  [[nodiscard]] bool is_right(const JudgedBy& by, const Contact<double>& answer, const Accuracy& accuracy);
  [[nodiscard]] const Reference& reference(Effort effort);
  [[nodiscard]] const Solution& solution(Problem problem, const Reference& reference);
  [[nodiscard]] const reference::SolutionSet& all_solutions(const Reference& found);
  [[nodiscard]] const reference::NearbyAnswers& nearby(const Reference& found);
  [[nodiscard]] const reference::NearbyAnswers& more_than_nearby(const Reference& found);
  [[nodiscard]] const law::SeenPair& seen(const Contact<double>& answer);

  Pair pair_;
  ReferenceSource source_;
  std::deque<Reference> references_;                             ///< by effort
  std::array<std::optional<Solution>, problems.size()> others_;  ///< by problem
  std::optional<reference::SolutionSet> all_solutions_;
  std::optional<reference::NearbyAnswers> nearby_, more_than_nearby_;
  std::optional<law::SeenPair> seen_;  ///< of the answer that is judged
};

}  // namespace plumb
