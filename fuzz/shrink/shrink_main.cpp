// plumb shrink: the simplest case with the same defect and at least half its severity, and what of it matters.
#include <optional>

#include "corpus/command/command.hpp"
#include "fuzz/shrink/explain.hpp"
#include "properties/laws/accuracy_option.hpp"

namespace plumb {
namespace {

struct Arguments {
  std::string file, method, out, accuracy;
  ForeignOption foreign;
  bool json = false;
};

void declare(CommandLine& app, Arguments& args) {
  app.add_option("CASE", args.file, "case file; of a .jsonl each line is shrunk by itself")->required();
  auto* method = app.add_option("--method", args.method, "instead of the method that the case names");
  declare_solver(app, args.foreign, "the same, a shared library (solver/plumb_solver.h)", method);
  declare_accuracy_of_cases(app, args.accuracy);
  app.add_option("--out", args.out, "write the simplest case to this file");
  app.add_flag("--json", args.json, "one object a case");
}

int shrink_files(const Arguments& args) {
  const std::optional<Solver> asked = solver_instead(args.foreign, args.method, "shrink");
  const std::optional<Accuracy> asked_accuracy = accuracy_instead(args.accuracy);
  bool found = false;
  std::string kept;
  each_case(args.file, [&](const Case& c, int line) {
    if (!asked && c.extra.contains("x_answer"))
      throw InputFailure(args.file, line, "x_answer",
                         "is a recorded answer: --method or --solver names who answers simpler cases");
    const Solver solver = asked ? *asked : solver_of_case(c, args.file, line);
    const Accuracy accuracy = asked_accuracy ? *asked_accuracy : accuracy_of_case(c, args.file, line);
    const Explained explained = shrink_and_explain(c.pair, solver, accuracy);
    const bool failed = explained.shrunk.from.judgement.finding.kind != FindingKind::none;
    found = found || failed;
    if (failed) kept += format_case(kept_shrunk(c, explained, solver.name)) + "\n";
    print_line(args.json ? write_json(explained_json(c, explained, solver.name))
                         : explained_text(c, explained, solver.name));
    flush_output();
  });
  if (!args.out.empty() && found) write_file(args.out, kept);
  return found ? exit_finding : exit_done;
}

}  // namespace
}  // namespace plumb

int main(int argc, char** argv) {
  plumb::Arguments args;
  plumb::CommandLine app(
      "The simplest case with the same defect and at least half its severity, explained; 1 for a finding.",
      "plumb shrink");
  plumb::declare(app, args);
  return plumb::run_command(app, argc, argv, [&] { return plumb::shrink_files(args); });
}
