// plumb check: judges anybody's answer to a case by the reference.
#include <cmath>
#include <string>
#include <vector>

#include "corpus/answer.hpp"
#include "corpus/case.hpp"
#include "corpus/command.hpp"
#include "corpus/interrupt.hpp"
#include "corpus/solver.hpp"
#include "properties/laws.hpp"

namespace plumb {
namespace {

struct Options {
  std::string cases;
  std::string answers;
};

void declare(CLI::App& app, Options& options) {
  app.add_option("CASE", options.cases, "case file, or .jsonl whose cases the answers name")->required();
  app.add_option("--answer", options.answers, "the fields of plumb solve: one object, or one a line")->required();
}

std::vector<Case> read_cases(const std::string& path) {
  std::vector<Case> cases;
  CaseReader reader(path);
  for (auto c = reader.next(); c; c = reader.next()) cases.push_back(std::move(*c));
  if (cases.empty()) throw InputFailure(path, 0, "", "holds no case");
  return cases;
}

/// A file with one case needs no name; among several the name must say which.
const Case& case_of(const GivenAnswer& answer, const std::vector<Case>& cases, const Options& options) {
  if (cases.size() == 1) return cases.front();
  const Case* found = nullptr;
  for (const Case& c : cases) {
    if (c.name != answer.name) continue;
    if (found != nullptr)
      throw InputFailure(options.answers, 0, "name", "'" + answer.name + "' names several cases of " + options.cases);
    found = &c;
  }
  if (found == nullptr)
    throw InputFailure(options.answers, 0, "name", "'" + answer.name + "' names no case of " + options.cases);
  return *found;
}

Problem problem_of(const std::string& method) {
  for (const Solver& solver : all_solvers())
    if (solver.name == method) return solver.problem;
  return Problem::common_normal;
}

void put(Json& out, const char* key, double value) {
  if (std::isfinite(value)) out[key] = value;
}

Json judgement_json(const Case& c, const GivenAnswer& answer, const Judgement& judgement) {
  Json out;
  out["name"] = c.name;
  out["method"] = answer.method;
  out["finding"] = name(judgement.finding.kind);
  // JSON has no infinity; kept failures use the same word.
  if (std::isinf(judgement.finding.severity)) out["severity"] = "infinite";
  put(out, "severity", judgement.finding.severity);
  put(out, "angle_error_deg", judgement.angle_error_deg);
  put(out, "overlap_error", judgement.overlap_error);
  put(out, "point_error", judgement.point_error);
  if (!judgement.judged) out["detail"] = "not judged: the reference has no answer to this method's problem";
  if (!judgement.finding.detail.empty()) out["detail"] = judgement.finding.detail;
  return out;
}

int check(const Options& options) {
  const std::vector<Case> cases = read_cases(options.cases);
  int code = exit_done;
  for (const GivenAnswer& answer : read_answers(options.answers)) {
    if (interrupted()) break;
    const Case& c = case_of(answer, cases, options);
    const Judgement judgement = Judge(c.pair).judge(problem_of(answer.method), answer.contact);
    print_line(write_json(judgement_json(c, answer, judgement)));
    if (judgement.finding.kind != FindingKind::none) code = exit_finding;
  }
  return code;
}

}  // namespace
}  // namespace plumb

int main(int argc, char** argv) {
  plumb::Options options;
  CLI::App app("Judge anybody's answer to a case by the reference; 1 for a finding.", "plumb check");
  plumb::declare(app, options);
  return plumb::run_command(app, argc, argv, [&] { return plumb::check(options); });
}
