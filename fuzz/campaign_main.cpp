// plumb campaign: random cases of the families, judged.
#include <fmt/format.h>

#include <filesystem>

#include "corpus/command.hpp"
#include "corpus/reference_store.hpp"
#include "fuzz/arguments.hpp"
#include "fuzz/shell_word.hpp"
#include "fuzz/shrink_kept.hpp"
#include "fuzz/table.hpp"

namespace plumb {
namespace {

struct Arguments {
  std::string family, method, shard = "1/1", out, cache;
  ForeignOption solver;
  std::int64_t cases = 0;
  std::uint64_t seed = 1;
  unsigned threads = default_threads();
  bool shrink = false;
};

void declare(CLI::App& app, Arguments& args) {
  app.add_option("--family", args.family, "spheroid, ellipsoid, superquadric, hard, several with commas, or all")
      ->required();
  app.add_option("--cases", args.cases, "cases of each family")->required()->check(refuse_count);
  app.add_option("--seed", args.seed, "same seed, same cases and results")->capture_default_str();
  app.add_option("--method", args.method, "methods with commas, or all (the default without --solver)");
  declare_solver(app, args.solver, "a shared library behind solver/plumb_solver.h, in processes of its own");
  app.add_option("--shard", args.shard, "i/n: the i-th of n parts, 1 <= i <= n; plumb merge puts them together");
  app.add_option("--threads", args.threads, "default: one for each processor")->check(CLI::Range(1, 1024));
  app.add_option("--out", args.out, "folder for summary.json, campaign.bins and failures/");
  app.add_option("--cache", args.cache, cache_help);
  app.add_flag("--shrink", args.shrink, "then shrink each bucket's simplest case, into failures/ as well")
      ->needs("--out");
}

/// Without either option: all. A foreign solver is asked alone unless methods are named beside it.
std::string methods_of(const Arguments& args) {
  return args.method.empty() && args.solver.library.empty() ? "all" : args.method;
}

CampaignOptions options_of(const Arguments& args) {
  const std::string methods = methods_of(args);
  CampaignOptions options{{}, args.seed, args.threads, parse_shard(args.shard)};
  if (!methods.empty()) options.solvers = find_solvers(methods);
  if (args.solver.library.empty()) return options;
  options.solvers.push_back(load_solver(args.solver.library, args.solver.limits));
  options.libraries[options.solvers.back().name] =
      std::filesystem::absolute(args.solver.library).lexically_normal().string();
  return options;
}

std::string command_options(const Arguments& args) {
  const std::string methods = methods_of(args);
  const std::string by_name = methods.empty() ? "" : " --method " + methods;
  return by_name + (args.solver.library.empty() ? "" : " --solver " + shell_word(args.solver.library));
}

int campaign(const Arguments& args) {
  CampaignOptions options = options_of(args);
  const auto store = open_store(args.cache);
  options.references = references_of(store);
  std::vector<Source> sources;
  for (const std::string& family : find_families(args.family))
    sources.push_back(family_source(family, static_cast<std::uint64_t>(args.cases), args.seed, command_options(args)));
  if (!args.out.empty()) prepare_folder(args.out);
  const Results results = run_campaign(sources, options);
  if (store) fmt::print(stderr, "{}\n", in_words(store->counts()));
  const int code = report(results, args.out);
  if (args.shrink) shrink_kept(results.kept, options, args.out);
  return code;
}

}  // namespace
}  // namespace plumb

int main(int argc, char** argv) {
  plumb::Arguments args;
  CLI::App app("Random cases of the families: every method's answer judged by every law", "plumb campaign");
  plumb::declare(app, args);
  return plumb::run_command(app, argc, argv, [&] { return plumb::campaign(args); });
}
