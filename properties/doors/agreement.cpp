#include "properties/doors/agreement.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "properties/doors/columns.hpp"
#include "properties/laws/allowance.hpp"
#include "solver/batch/batch.hpp"
#include "solver/method/methods.hpp"

namespace plumb {
namespace {

const Method& automatic_method() {
  static const Method& method = *find_method("auto");
  return method;
}

/// What rounding leaves open of an overlap, for any pair: no condition number of an overlap is larger. `epsilons` of double's.
double allowed_overlap(const Pair& pair, double overlap, double epsilons = 1) {
  return epsilons * law::few_of(reference::largest_overlap_condition * (size_of(pair) + std::abs(overlap)));
}

Finding overlaps_agree(const Pair& pair, double overlap, double whole, double allowed, std::string_view asked) {
  return {FindingKind::overlap_error,
          law::severity_of(std::abs(overlap - whole), allowed),
          {},
          fmt::format("{}: overlap {:.17g}, else {:.17g}, size {:.3g}", asked, overlap, whole, size_of(pair))};
}

/// Another verdict, as far as the overlap is from zero.
Finding verdicts_agree(Verdict said, const Contact<double>& whole, double allowed, std::string_view asked) {
  if (said == whole.verdict || whole.verdict == Verdict::undecided) return {};
  return {said == Verdict::overlapping ? FindingKind::false_contact : FindingKind::missed_contact,
          law::severity_of(std::abs(whole.overlap), allowed),
          {},
          fmt::format("{}: {}, with an overlap of {:.17g}", asked, name(said), whole.overlap)};
}

Finding verdict_alone_agrees(const Pair& pair, const Contact<double>& whole) {
  const Want yes_or_no{false, false, false, false, false};
  const Contact<double> asked = automatic_method().solve(pair, yes_or_no, nullptr);
  return verdicts_agree(asked.verdict, whole, law::few_of(size_of(pair)), "verdict alone");
}

Finding warm_agrees(const Pair& pair, const Contact<double>& whole) {
  const Contact<double> warm = automatic_method().solve(pair, {}, &whole);
  if (warm.status != Status::converged)
    return {FindingKind::nonconverged, law::wrong_altogether, {}, "warm from its own answer: no answer"};
  return overlaps_agree(pair, warm.overlap, whole.overlap, allowed_overlap(pair, whole.overlap),
                        "warm from its own answer");
}

Finding batch_agrees(const Pair& pair, const Contact<double>& whole) {
  const PairColumns columns({&pair, 1});
  ContactColumns out(1);
  (void)solve_batch(columns.arrays(), {}, out.arrays());
  if (out.status[0] != Status::converged)
    return {FindingKind::nonconverged, law::wrong_altogether, {}, "in a batch: no answer"};
  return overlaps_agree(pair, out.overlap[0], whole.overlap, allowed_overlap(pair, whole.overlap), "in a batch");
}

template <class S>
Finding scalar_agrees(const Pair& pair, const Contact<double>& whole, const Contact<S>& other, std::string_view asked) {
  if (other.status != Status::converged) return {};
  constexpr double epsilons =
      std::max(1.0, static_cast<double>(std::numeric_limits<S>::epsilon() / law::machine_epsilon));
  const double allowed = allowed_overlap(pair, whole.overlap, epsilons);
  return law::worse(overlaps_agree(pair, static_cast<double>(other.overlap), whole.overlap, allowed, asked),
                    verdicts_agree(other.verdict, whole, allowed, asked));
}

Finding float_agrees(const Pair& pair, const Contact<double>& whole) {
  return scalar_agrees<float>(pair, whole, find_method_in<float>("auto")->solve(pair, {}, nullptr), "float");
}

Finding long_double_agrees(const Pair& pair, const Contact<double>& whole) {
  return scalar_agrees<long double>(pair, whole, find_method_in<long double>("auto")->solve(pair, {}, nullptr),
                                    "long double");
}

constexpr std::array all_question_laws{
    AgreementLaw{"verdict_alone", "a yes or no says what the whole answer says", verdict_alone_agrees},
    AgreementLaw{"warm_from_itself", "a start from the answer ends at the answer", warm_agrees},
    AgreementLaw{"batch", "a batch has the answers of single calls", batch_agrees},
};

constexpr std::array all_scalar_laws{
    AgreementLaw{"float", "float has double's overlap and verdict, to float's rounding", float_agrees},
    AgreementLaw{"long_double", "long double has double's overlap and verdict, to double's rounding",
                 long_double_agrees},
};

}  // namespace

std::span<const AgreementLaw> question_laws() {
  return all_question_laws;
}

std::span<const AgreementLaw> scalar_laws() {
  return all_scalar_laws;
}

Finding worst_disagreement(std::span<const AgreementLaw> laws, const Pair& pair, const Contact<double>& whole) {
  Finding worst;
  for (const AgreementLaw& asked : laws) {
    Finding finding = asked.check(pair, whole);
    finding.law = asked.name;
    worst = law::worse(worst, finding);
  }
  return worst.severity > 1 ? worst : Finding{FindingKind::none, worst.severity, {}, {}};
}

}  // namespace plumb
