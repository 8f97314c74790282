// plumb campaign: random cases of the families, judged.
#include <fmt/format.h>

#include "corpus/command.hpp"
#include "fuzz/arguments.hpp"
#include "fuzz/table.hpp"

namespace plumb {
namespace {

struct Arguments {
  std::string family, method, solver, shard = "1/1", out;
  std::int64_t cases = 0;
  std::uint64_t seed = 1;
  unsigned threads = default_threads();
};

void declare(CLI::App& app, Arguments& args) {
  app.add_option("--family", args.family, "spheroid, ellipsoid, superquadric, hard, several with commas, or all")
      ->required();
  app.add_option("--cases", args.cases, "cases of each family")->required()->check(CLI::PositiveNumber);
  app.add_option("--seed", args.seed, "same seed, same cases and results")->capture_default_str();
  app.add_option("--method", args.method, "methods with commas, or all (the default without --solver)");
  app.add_option("--solver", args.solver, "a shared library behind solver/plumb_solver.h");
  app.add_option("--shard", args.shard, "i/n: the i-th of n parts, 1 <= i <= n; plumb merge puts them together");
  app.add_option("--threads", args.threads, "default: one for each processor")->check(CLI::Range(1, 1024));
  app.add_option("--out", args.out, "folder for summary.json, campaign.bins and failures/");
}

std::vector<Solver> solvers_of(const Arguments& args) {
  std::vector<Solver> solvers;
  if (!args.method.empty() || args.solver.empty()) solvers = find_solvers(args.method.empty() ? "all" : args.method);
  if (!args.solver.empty()) solvers.push_back(load_solver(args.solver));
  return solvers;
}

std::string methods_in_words(const Arguments& args) {
  if (args.solver.empty()) return args.method.empty() ? "all" : args.method;
  return (args.method.empty() ? "" : args.method + " ") + "--solver " + args.solver;
}

int campaign(const Arguments& args) {
  CampaignOptions options{solvers_of(args), args.seed, args.threads, parse_shard(args.shard)};
  std::vector<Source> sources;
  for (const std::string& family : find_families(args.family))
    sources.push_back(family_source(family, static_cast<std::uint64_t>(args.cases), args.seed, methods_in_words(args)));
  if (!args.out.empty()) prepare_folder(args.out);
  const Results results = run_campaign(sources, options);
  if (!args.out.empty()) write_results(results, args.out);
  fmt::print("{}", table_text(results));
  if (!args.out.empty()) fmt::print("{}", kept_text(results, args.out));
  return exit_code(results);
}

}  // namespace
}  // namespace plumb

int main(int argc, char** argv) {
  plumb::Arguments args;
  CLI::App app("Random cases of the families: every method's answer judged by every law", "plumb campaign");
  plumb::declare(app, args);
  return plumb::run_command(app, argc, argv, [&] { return plumb::campaign(args); });
}
