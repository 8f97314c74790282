// plumb check: judges anybody's answer to a case by the reference.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "corpus/case/answer.hpp"
#include "corpus/case/case.hpp"
#include "corpus/certificate/reference_store.hpp"
#include "corpus/command/command.hpp"
#include "corpus/command/interrupt.hpp"
#include "corpus/solvers/solver.hpp"
#include "properties/laws/accuracy_option.hpp"
#include "properties/laws/judged_answer.hpp"
#include "properties/laws/laws_convex.hpp"
#include "solver/reference/search/stationary.hpp"

namespace plumb {
namespace {

struct Options {
  std::string cases;
  std::string answers;
  std::string cache;
  std::string accuracy = "rounding";
};

void declare(CommandLine& app, Options& options) {
  app.add_option("CASE", options.cases, "case file, or .jsonl whose cases the answers name")->required();
  app.add_option("--answer", options.answers,
                 "the fields of plumb solve: one object, or one a line; - for standard input")
      ->required();
  declare_accuracy(app, options.accuracy);
  app.add_option("--cache", options.cache, cache_help);
}

/// The cases that the answers are about. After a bad line the answers to those before it are still judged.
struct Cases {
  std::vector<Case> read;
  std::optional<InputFailure> failure;
};

Cases read_cases(const std::string& path) {
  Cases cases;
  CaseReader reader(path, CaseShapes::every);
  try {
    for (auto c = reader.next(); c; c = reader.next()) cases.read.push_back(std::move(*c));
  } catch (const InputFailure& failure) {
    if (cases.read.empty()) throw;
    cases.failure = failure;
  }
  if (cases.read.empty()) throw InputFailure(reader.file(), 0, "", "holds no case");
  return cases;
}

/// What an answer's error names.
struct Place {
  const std::string& answers;
  int line;
  const std::string& cases;

  [[noreturn]] void refuse_name(const std::string& name, const std::string& what) const {
    throw InputFailure(answers, line, "name", "'" + name + "' " + what + " of " + cases);
  }
};

/// A file with one case needs no name; among several the name must say which.
const Case& case_of(const std::string& name, const Cases& cases, const Place& place) {
  if (cases.read.size() == 1 && !cases.failure) return cases.read.front();
  const auto named = [&](const Case& c) { return c.name == name; };
  const auto found = std::find_if(cases.read.begin(), cases.read.end(), named);
  if (found == cases.read.end()) {
    // It may be one of those behind the bad line.
    if (cases.failure) throw *cases.failure;
    place.refuse_name(name, "names no case");
  }
  if (std::any_of(found + 1, cases.read.end(), named)) place.refuse_name(name, "names several cases");
  return *found;
}

void put(Json& out, const char* key, double value) {
  if (std::isfinite(value)) out[key] = value;
}

/// Of the certified overlap; 0 where the reference has none.
int certified_sign(const Reference& reference) {
  const Solution& truth = reference.common_normal;
  return truth.solved ? (truth.overlap > 0) - (truth.overlap < 0) : 0;
}

Json judgement_json(const Case& c, const GivenAnswer& answer, const Judgement& judgement, const Json& angles) {
  Json out;
  out["name"] = c.name;
  out["method"] = answer.method;
  out["finding"] = name(judgement.finding.kind);
  // JSON has no infinity; kept failures use the same word.
  if (std::isinf(judgement.finding.severity)) out["severity"] = "infinite";
  put(out, "severity", judgement.finding.severity);
  put(out, "angle_error_deg", judgement.angle_error_deg);
  if (!angles.is_null()) out["angles_deg"] = angles;
  put(out, "overlap_error", judgement.overlap_error);
  put(out, "point_error", judgement.point_error);
  if (judgement.right_from < right_at_no_level) out["x_right_from"] = accuracy_levels[judgement.right_from].name;
  if (!judgement.judged) out["detail"] = "not judged: the reference has no proved answer to this method's problem";
  if (!judgement.finding.detail.empty()) out["detail"] = judgement.finding.detail;
  return out;
}

/// Which of the case's common normals a wrong one is; null where none is near.
Json hit_json(const Pair& pair, const Contact<double>& answer) {
  const double angle = 1e-6, length = 1e-9 * size_of(pair);  // rounding, and the answers of solvers that stop early
  const StationarySet all = find_stationary(pair);
  const auto hit = find_hit(all, answer.normal, answer.overlap, angle, length);
  if (!hit) return nullptr;
  const StationaryPair& found = all.pairs[*hit];
  return {{"kind", name(found.kind)},
          {"overlap", static_cast<double>(found.overlap_lower)},
          {"rank", *hit + 1},
          {"of", all.pairs.size()},
          {"complete", all.complete}};
}

FindingKind print(const Json& judgement, FindingKind finding) {
  print_line(write_json(judgement));
  flush_output();
  return finding;
}

FindingKind check_convex(const Case& c, const ConvexPair& pair, const GivenAnswer& answer, const Accuracy& accuracy) {
  const Judgement judgement = judge_convex(pair, answer.contact, accuracy, false);
  Json out = judgement_json(c, answer, judgement, nullptr);
  out["reference"] = name(Effort::bounds);
  return print(out, judgement.finding.kind);
}

FindingKind check_answer(const Case& c, const GivenAnswer& answer, const ReferenceSource& source,
                         const Accuracy& accuracy) {
  Judge judge(c.pair, source);
  const Judgement judgement = judge.judge({.problem = answer.problem, .accuracy = accuracy}, answer.contact);
  const Json angles = angles_json(c.pair, answer.contact, certified_sign(judge.reference()));
  Json out = judgement_json(c, answer, judgement, angles);
  out["reference"] = name(judge.reference().effort);
  if (judgement.finding.kind == FindingKind::wrong_branch) {
    if (Json hit = hit_json(c.pair, answer.contact); !hit.is_null()) out["hit"] = std::move(hit);
  }
  return print(out, judgement.finding.kind);
}

int check(const Options& options) {
  const Cases cases = read_cases(options.cases);
  const ReferenceSource source = references_of(open_store(options.cache));
  const Accuracy accuracy = parse_accuracy(options.accuracy);
  AnswerReader answers(options.answers);
  int code = exit_done;
  bool any = false;
  while (!interrupted()) {
    const std::optional<GivenAnswer> answer = answers.next();
    if (!answer) break;
    any = true;
    const Case& c = case_of(answer->name, cases, {answers.file(), answers.line(), options.cases});
    if (c.convex && answer->problem != Problem::common_normal)
      throw InputFailure(answers.file(), answers.line(), "method", answer->method + " is for superellipsoids");
    const FindingKind found =
        c.convex ? check_convex(c, *c.convex, *answer, accuracy) : check_answer(c, *answer, source, accuracy);
    if (found != FindingKind::none) code = exit_finding;
  }
  if (cases.failure) throw *cases.failure;
  if (!any && !interrupted()) throw InputFailure(answers.file(), 0, "", "holds no answer");
  return code;
}

}  // namespace
}  // namespace plumb

int main(int argc, char** argv) {
  plumb::Options options;
  plumb::CommandLine app("Judge anybody's answer to a case by the reference; 1 for a finding.", "plumb check");
  plumb::declare(app, options);
  return plumb::run_command(app, argc, argv, [&] { return plumb::check(options); });
}
