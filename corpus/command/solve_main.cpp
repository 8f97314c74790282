// plumb solve: the contact of each case by one method or several.
#include <algorithm>
#include <array>
#include <ranges>
#include <sstream>
#include <string_view>
#include <utility>

#include "corpus/case/answer.hpp"
#include "corpus/case/answer_table.hpp"
#include "corpus/command/command.hpp"
#include "corpus/command/interrupt.hpp"
#include "corpus/json/nearest_word.hpp"
#include "corpus/solvers/solver.hpp"

namespace plumb {
namespace {

struct Options {
  std::string cases;
  std::string methods;
  ForeignOption foreign;
  std::string want = "overlap,normal,points";
  int repeat = 1;
  bool warm = false;
  bool json = false;
};

void declare(CommandLine& app, Options& options) {
  app.add_option("CASE", options.cases, "case file, .jsonl with one case a line, or - for standard input")->required();
  app.add_option(
      "--method", options.methods,
      "NAME,.. or all; default auto (plumb methods lists them), which alone knows other shapes than superellipsoids");
  declare_solver(app, options.foreign, "a shared library that implements solver/plumb_solver.h");
  app.add_option("--want", options.want,
                 "what to compute: overlap,normal,points,curvature,derivatives,patch; or verdict alone")
      ->capture_default_str();
  app.add_option("--repeat", options.repeat, "time the smallest of this many calls")->in_range(1, 1'000'000'000);
  app.add_flag("--warm", options.warm, "start the timed calls from the case's own answer");
  app.add_flag("--json", options.json, "one JSON object a line for each case and method");
}

/// The verdict is answered in any case; with nothing beside it a method may stop at the first proof of it.
Want parse_want(const std::string& names) {
  Want want{false, false, false, false, false};
  bool verdict = true;
  const std::array<std::pair<std::string_view, bool*>, 7> words{{{"verdict", &verdict},
                                                                 {"overlap", &want.overlap},
                                                                 {"normal", &want.normal},
                                                                 {"points", &want.points},
                                                                 {"curvature", &want.curvature},
                                                                 {"derivatives", &want.derivatives},
                                                                 {"patch", &want.patch}}};
  const auto known = std::views::keys(words);
  std::istringstream list(names);
  for (std::string name; std::getline(list, name, ',');) {
    const auto word = std::find_if(words.begin(), words.end(), [&](const auto& w) { return w.first == name; });
    if (word == words.end())
      throw InputFailure("--want", 0, name, no_such("field", name, {known.begin(), known.end()}));
    *word->second = true;
  }
  return want;
}

std::vector<Solver> chosen_solvers(const Options& options) {
  std::vector<Solver> solvers;
  if (!options.methods.empty() || options.foreign.empty())
    solvers = find_solvers(options.methods.empty() ? "auto" : options.methods);
  std::ranges::move(load_solvers(options.foreign), std::back_inserter(solvers));
  return solvers;
}

/// The last call's answer, which is that of every call, and the smallest time.
template <class AnyPair>
void ask(Answer& answer, const AnyPair& pair, const Solver& solver, const Options& options) {
  Contact<double> start;
  if (options.warm) start = solve_timed(solver, pair, answer.want, nullptr).contact;
  for (int i = 0; i < options.repeat && (i == 0 || !interrupted()); ++i) {
    const TimedContact timed = solve_timed(solver, pair, answer.want, options.warm ? &start : nullptr);
    answer.contact = timed.contact;
    answer.nanoseconds = std::min(answer.nanoseconds.value_or(timed.nanoseconds), timed.nanoseconds);
  }
}

/// The answer, or why there is none.
Answer solve_case(const Case& c, const Solver& solver, const Want& want, const Options& options) {
  Answer answer{c.name, c.convex ? std::nullopt : std::optional(c.pair), want, {}, {}};
  if (!solver.is_own) answer.problem = solver.abilities.problem;
  try {
    if (c.convex)
      ask(answer, *c.convex, solver, options);
    else
      ask(answer, c.pair, solver, options);
  } catch (const NoAnswer& none) {
    answer.contact = {};
    answer.contact.method = solver.name;
    answer.none = {none.how == NoAnswer::How::hung ? "slow" : "crash", none.what()};
  }
  return answer;
}

void print_answers(const std::vector<Answer>& answers, bool json) {
  if (json)
    for (const Answer& answer : answers) print_line(write_json(answer_json(answer)));
  else
    print_line(answer_table(answers));
}

int solve(const Options& options) {
  const Want want = parse_want(options.want);
  const std::vector<Solver> solvers = chosen_solvers(options);
  int code = exit_done;
  const auto work = [&](const Case& c, int) {
    std::vector<Answer> answers;
    for (const Solver& solver : solvers) {
      if (c.convex && !solver.solve_convex) continue;
      answers.push_back(solve_case(c, solver, want, options));
      if (answers.back().none && !solver.published) code = exit_finding;
    }
    if (answers.empty()) throw FieldError("bodies", solvers.front().name + " takes superellipsoids alone");
    print_answers(answers, options.json);
    flush_output();
  };
  each_case(options.cases, work, CaseShapes::every);
  return code;
}

}  // namespace
}  // namespace plumb

int main(int argc, char** argv) {
  plumb::Options options;
  plumb::CommandLine app("Solve the contact of each case, by one method or all of them.", "plumb solve");
  plumb::declare(app, options);
  return plumb::run_command(app, argc, argv, [&] { return plumb::solve(options); });
}
