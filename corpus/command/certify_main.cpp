// plumb certify: the proof of a case, as decimals that are rounded outwards; proofs that are stored, and their verifier.
#include <chrono>

#include "corpus/certificate/certificate.hpp"
#include "corpus/certificate/proof_file.hpp"
#include "corpus/command/command.hpp"
#include "corpus/command/interrupt.hpp"
#include "solver/reference/search/make_proof.hpp"
#include "solver/reference/touch/touch.hpp"

namespace plumb {
namespace {

struct Options {
  std::string cases, effort, proof, verify;
  std::string problem = "common_normal";
  int digits = 50;
  bool all = false;
  bool json = false;
};

std::vector<std::string> problem_words() {
  std::vector<std::string> out;
  for (const Problem problem : problems) out.emplace_back(name(problem));
  return out;
}

void declare(CommandLine& app, Options& options) {
  app.add_option("CASE", options.cases, "case file, .jsonl with one case a line, or - for standard input")->required();
  app.add_option("--digits", options.digits, "significant digits that are printed, and computed without --effort")
      ->in_range(1, 50)
      ->capture_default_str();
  CommandOption* all = app.add_flag("--all", options.all, "also every other common normal, and whether these are all");
  app.add_flag("--json", options.json, "one JSON object a line for each case");
  CommandOption* effort =
      app.add_option("--effort", options.effort, "bounds (trusts the machine's pow), proof (19 digits), digits (50)")
          ->is_one_of("effort", {"bounds", "proof", "digits"});
  CommandOption* proof = app.add_option("--proof", options.proof, "write the proofs to this file, one a line");
  CommandOption* verify = app.add_option("--verify", options.verify,
                                         "confirm the proofs in this file, one for each case, without searching")
                              ->excludes(all)
                              ->excludes(effort)
                              ->excludes(proof);
  app.add_option("--problem", options.problem,
                 "another problem than the common normal's: a geometric potential's (deepest_points, midway) or that "
                 "of the relative motion undone, with the centre distance at first touch along the line of centres "
                 "(first_touch)")
      ->is_one_of("problem", problem_words())
      ->excludes(all)
      ->excludes(effort)
      ->excludes(proof)
      ->excludes(verify);
}

class Stopwatch {
 public:
  [[nodiscard]] double milliseconds() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// As far as --effort says; without it as far as the digits ask for, and on to the end where that leaves something open.
Reference reference_of(const Pair& pair, const Options& options) {
  constexpr int digits_of_a_proof = 15;
  for (const Effort effort : efforts)
    if (name(effort) == options.effort) return find_reference(pair, effort);
  if (options.digits <= digits_of_a_proof) {
    Reference found = find_reference(pair, Effort::proof);
    if (found.verdict != Verdict::undecided && found.global == Claim::proved) return found;
  }
  return find_reference(pair, Effort::digits);
}

/// The stored form of a reference, verified; why there is none.
struct Storing {
  std::string text, failure;
};

Storing store(const Case& c, const Reference& found) {
  auto proof = reference::make_proof(c.pair, found);
  if (!proof) return {"", found.reason.empty() ? "the reference has none" : found.reason};
  reference::ProofCheck check = reference::verify_proof(c.pair, *proof);
  if (!check.failure.empty()) return {"", std::move(check.failure)};
  return {format_proof({c.name, c.pair, check.overlap, std::move(*proof)}) + "\n", ""};
}

void print(const Json& certificate, bool json) {
  print_line(json ? write_json(certificate) : certificate_table(certificate));
  flush_output();
}

/// The certificates of all cases; their proofs, too, when they are to be kept.
class CertifyRun {
 public:
  explicit CertifyRun(const Options& options) : options_(options) {}

  void certify(const Case& c) {
    if (c.convex) return certify_convex(c.name, *c.convex);
    const Stopwatch watch;
    const Reference found = reference_of(c.pair, options_);
    Json out{{"name", c.name}};
    put_reference(out, found, options_.digits);
    if (found.effort == Effort::digits && found.common_normal.solved)
      put_condition_claims(out, c.pair, found.common_normal);
    if (options_.all) put_stationary(out, find_stationary(c.pair), options_.digits);
    if (!options_.proof.empty()) put_proof(out, store(c, found));
    out["timing"]["ms"] = watch.milliseconds();
    print(out, options_.json);
  }

  [[nodiscard]] int finish() const {
    if (!proofs_.empty()) write_file(options_.proof, proofs_);
    return code_;
  }

 private:
  void certify_convex(const std::string& name, const ConvexPair& pair) const {
    if (options_.all || !options_.effort.empty() || !options_.proof.empty())
      throw FieldError("bodies", "--all, --effort and --proof are for superellipsoids");
    const Stopwatch watch;
    Json out{{"name", name}};
    put_convex(out, pair, options_.digits);
    out["timing"]["ms"] = watch.milliseconds();
    print(out, options_.json);
  }

  void put_proof(Json& out, const Storing& storing) {
    proofs_ += storing.text;
    out["proof"] = storing.failure.empty() ? "stored" : "not stored: " + storing.failure;
    if (!storing.failure.empty()) code_ = exit_finding;
  }

  const Options& options_;
  std::string proofs_;
  int code_ = exit_done;
};

Problem problem_of(const Options& options) {
  return *std::find_if(problems.begin(), problems.end(), [&](Problem p) { return options.problem == name(p); });
}

/// The answer to another problem than the common normal's, with its proof.
void certify_problem(const Case& c, const Options& options) {
  const Stopwatch watch;
  Json out{{"name", c.name}, {"problem", options.problem}};
  const Problem problem = problem_of(options);
  put_problem(out, find_problem_reference(c.pair, problem), options.digits);
  if (problem == Problem::first_touch) put_first_touch(out, prove_first_touch(c.pair), options.digits);
  out["digits"] = options.digits;
  out["timing"]["ms"] = watch.milliseconds();
  print(out, options.json);
}

/// Each case with its proof, in the order of the two files.
class VerifyRun {
 public:
  explicit VerifyRun(const Options& options)
      : options_(options), proofs_(options.verify, ObjectReader::Layout::by_content) {
    if (options.verify == "-" && options.cases == "-")
      throw InputFailure("--verify", 0, "", "standard input holds the cases");
  }

  void certify(const Case& c) {
    const std::optional<std::string> text = proofs_.next();
    if (!text) throw InputFailure(proofs_.file(), 0, "", "holds no proof for case '" + c.name + "'");
    const StoredProof stored = parse_proof(*text, proofs_.file(), proofs_.line());
    const Stopwatch watch;
    const Verification found = verify_stored(c.pair, stored);
    report(c, found, watch);
    if (!found.failure.empty()) code_ = exit_finding;
  }

  [[nodiscard]] int finish() {
    if (!interrupted() && proofs_.next()) throw InputFailure(proofs_.file(), proofs_.line(), "", "is for no case");
    return code_;
  }

 private:
  void report(const Case& c, const Verification& found, const Stopwatch& watch) const {
    if (!found.failure.empty() && !options_.json)
      return print_line(c.name + ": the proof does not hold: " + found.failure);
    Json out{{"name", c.name}};
    if (found.failure.empty()) put_overlap(out, found.proved, options_.digits);
    out["proof"] = found.failure.empty() ? "holds" : "does not hold: " + found.failure;
    out["digits"] = options_.digits;
    out["timing"]["ms"] = watch.milliseconds();
    print(out, options_.json);
  }

  const Options& options_;
  ObjectReader proofs_;
  int code_ = exit_done;
};

int certify(const Options& options) {
  if (options.problem != name(Problem::common_normal)) {
    each_case(options.cases, [&](const Case& c, int) { certify_problem(c, options); });
    return exit_done;
  }
  if (!options.verify.empty()) {
    VerifyRun run(options);
    each_case(options.cases, [&](const Case& c, int) { run.certify(c); });
    return run.finish();
  }
  CertifyRun run(options);
  try {
    each_case(options.cases, [&](const Case& c, int) { run.certify(c); }, CaseShapes::every);
  } catch (const InputFailure&) {
    (void)run.finish();  // the proofs of the cases before it
    throw;
  }
  return run.finish();
}

}  // namespace
}  // namespace plumb

int main(int argc, char** argv) {
  plumb::Options options;
  plumb::CommandLine app("Prove the overlap, the verdict, the normal and the points of a case.", "plumb certify");
  plumb::declare(app, options);
  return plumb::run_command(app, argc, argv, [&] { return plumb::certify(options); });
}
