#include "fuzz/campaign/judging_shapes.hpp"

#include "corpus/case/answer.hpp"
#include "properties/laws/judged_answer.hpp"

namespace plumb {
namespace {

Json shapes_line(const Case& c, const Solver& solver, const JudgedAnswer& judged) {
  Answer answer{c.name, {}, Want{}, judged.answer, {}};
  if (!solver.is_own) answer.problem = solver.abilities.problem;
  Json out = answer_json(answer);
  const Finding& finding = judged.judgement.finding;
  out["finding"] = name(finding.kind);
  out["severity"] = severity_json(finding.severity);
  if (!finding.law.empty()) out["law"] = finding.law;
  if (!finding.detail.empty()) out["detail"] = finding.detail;
  out["judged"] = is_judged(judged.judgement);
  return out;
}

void keep_shapes(Results& results, const Source& source, const Case& c, const std::string& method,
                 const Finding& finding, const Accuracy& accuracy) {
  const std::string words = bucket(name(finding.kind), method, c.convex.value_or(ConvexPair{}));
  ++results.buckets[words];
  results.kept.add(words, failure_of(failing_case(c, method, finding, accuracy, source.command)));
}

}  // namespace

void judge_shapes(Results& results, const Source& source, const Case& c, std::uint64_t index,
                  const CampaignOptions& options) {
  if (!c.convex) return;
  const ConvexPair& pair = *c.convex;
  FamilyResults& family = results.families[source.family];
  Json answers = Json::array();
  for (const Solver& solver : options.solvers) {
    const JudgedAnswer judged = solve_and_judge(pair, solver, options.accuracy);
    Tally& tally = family.methods[solver.name];
    tally.published = solver.published;
    tally.not_asked += judged.asked ? 0 : 1;
    if (!judged.asked) continue;
    add_answer(tally, std::nullopt, judged.answer, judged.judgement, judged.nanoseconds);
    if (options.keeps_answers) answers.push_back(shapes_line(c, solver, judged));
    const Finding& finding = judged.judgement.finding;
    if (finding.kind != FindingKind::none) keep_shapes(results, source, c, solver.name, finding, options.accuracy);
  }
  if (options.keeps_answers)
    results.answers[{source.family, index}] =
        write_json(Json{{"case", Json::parse(format_case(c))}, {"answers", std::move(answers)}}) + "\n";
  ++family.cases;
  family.digest += digest(pair);
  ++family.needed[static_cast<std::size_t>(Effort::bounds)];
}

}  // namespace plumb
