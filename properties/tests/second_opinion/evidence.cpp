#include "properties/tests/second_opinion/evidence.hpp"

namespace plumb {
namespace {

Json line_of(const Case& c, const Solver& solver, const JudgedAnswer& judged) {
  Json out;
  out["name"] = c.name;
  out["bodies"] = bodies_json(c.pair);
  out["answer"] = answer_json({c.name, c.pair, {}, judged.answer, std::nullopt});
  out["problem"] = name(solver.abilities.problem);
  out["abilities"] = abilities_json(solver.abilities);
  out["finding"] = name(judged.judgement.finding.kind);
  out["x_solver"] = solver.name;
  out["x_law"] = judged.judgement.finding.law;
  out["x_severity"] = judged.judgement.finding.severity;
  out["x_detail"] = judged.judgement.finding.detail;
  return out;
}

}  // namespace

std::vector<Evidenced> evidence(const Case& c, const std::vector<Solver>& solvers, const ReferenceSource& source) {
  std::vector<Evidenced> out;
  Judge judge(c.pair, source);
  for (const Solver& solver : solvers) {
    if (!solver.abilities.takes(c.pair)) continue;
    const JudgedAnswer judged = solve_and_judge(judge, c.pair, solver);
    const FindingKind finding = judged.judgement.finding.kind;
    if (!judged.judgement.judged && finding == FindingKind::none) continue;
    out.push_back({solver.name, finding, line_of(c, solver, judged)});
  }
  return out;
}

}  // namespace plumb
