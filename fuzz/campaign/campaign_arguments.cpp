#include "fuzz/campaign/campaign_arguments.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "fuzz/campaign/arguments.hpp"
#include "fuzz/campaign/merge.hpp"
#include "fuzz/campaign/out_folder.hpp"
#include "fuzz/results/table.hpp"
#include "fuzz/shrink/shrink_kept.hpp"
#include "properties/laws/accuracy_option.hpp"

namespace plumb {
namespace {

/// Without either option: all. A foreign solver is asked alone unless methods are named beside it.
std::string methods_of(const CampaignArguments& args) {
  return args.method.empty() && args.foreign.empty() ? "all" : args.method;
}

CampaignOptions options_of(const CampaignArguments& args) {
  const std::string methods = methods_of(args);
  CampaignOptions options{
      {}, args.seed,  args.threads, parse_shard(args.shard), parse_accuracy(args.accuracy), !args.answers.empty(),
      {}, args.chunks};
  if (!methods.empty()) options.solvers = find_solvers(methods);
  std::ranges::move(load_solvers(args.foreign), std::back_inserter(options.solvers));
  return options;
}

std::string command_options(const CampaignArguments& args, const CampaignOptions& options) {
  const std::string methods = methods_of(args);
  std::string out = methods.empty() ? "" : " --method " + methods;
  for (const Solver& solver : options.solvers) out += solver.option;
  return out + accuracy_option(accuracy_text(options.accuracy));
}

void require_replaceable(const CampaignArguments& args, const PreparedCampaign& campaign, const ChunkFolder& chunks) {
  chunks.require_own(args.resume ? "" : kForceReplaces);
  require_replaceable(args.out, asked_of(campaign.sources, campaign.options), !chunks.empty());
}

}  // namespace

CommandOption* declare_campaign(CommandLine& app, CampaignArguments& args, const std::string& threads) {
  app.add_option("--family", args.family,
                 fmt::format("{}, several with commas, or all; of shapes: plumb families",
                             fmt::join(find_families("all"), ", ")))
      ->required();
  app.add_option("--cases", args.cases, "cases of each family")->required()->check(refuse_count);
  declare_seed(app, args.seed, "same seed, same cases and results");
  app.add_option("--method", args.method, "methods with commas, or all (the default without --solver)");
  declare_solver(app, args.foreign,
                 "a shared library behind solver/plumb_solver.h, in processes of its own; any number");
  declare_accuracy(app, args.accuracy);
  app.add_option("--shard", args.shard, "i/n: the i-th of n parts, 1 <= i <= n; plumb merge puts them together");
  app.add_option("--threads", args.threads, threads)->in_range(1, 1024);
  auto* out = app.add_option("--out", args.out, "folder for summary.json, campaign.bins and failures/");
  app.add_option("--chunks", args.chunks, "parts of the work, each kept in DIR/chunks once it is done")
      ->check(refuse_count)
      ->in_range(1, static_cast<std::int64_t>(kMostParts))
      ->capture_default_str();
  app.add_flag("--resume", args.resume, "do what is missing in DIR, after a run with the same arguments")->needs(out);
  app.add_flag("--force", args.force, kForceHelp)->needs(out);
  app.add_option("--cache", args.cache, cache_help);
  app.add_flag("--shrink", args.shrink, "then shrink each bucket's simplest case, into failures/ as well")->needs(out);
  return out;
}

PreparedCampaign prepare_campaign(const CampaignArguments& args) {
  if (!args.answers.empty() && args.resume)
    throw InputFailure("plumb campaign", 0, "--answers", "is of a whole run: not with --resume");
  PreparedCampaign campaign{open_store(args.cache), options_of(args), {}};
  campaign.options.references = references_of(campaign.store);
  for (const std::string& family : find_families(args.family))
    campaign.sources.push_back(family_source(family, static_cast<std::uint64_t>(args.cases), args.seed,
                                             command_options(args, campaign.options)));
  return campaign;
}

ChunkFolder chunks_in(const CampaignArguments& args, const PreparedCampaign& campaign) {
  return {args.out, asked_of(campaign.sources, campaign.options), chunks_of(campaign.sources, campaign.options)};
}

ChunkFolder open_chunks(const CampaignArguments& args, const PreparedCampaign& campaign) {
  const ChunkFolder chunks = chunks_in(args, campaign);
  if (!args.force) require_replaceable(args, campaign, chunks);
  chunks.open(args.resume);
  prepare_folder(args.out);
  return chunks;
}

std::optional<Results> finished_before(const CampaignArguments& args, const PreparedCampaign& campaign) {
  if (!args.resume) return std::nullopt;
  return read_finished(args.out, asked_of(campaign.sources, campaign.options));
}

int report_campaign(const CampaignArguments& args, const PreparedCampaign& campaign, const Results& results) {
  if (campaign.store) fmt::print(stderr, "{}\n", in_words(campaign.store->counts()));
  const int code = report(results, args.out);
  if (!args.answers.empty()) {
    std::string lines;
    for (const auto& [place, line] : results.answers) lines += line;
    write_file(args.answers, lines);
  }
  if (args.shrink) shrink_kept(results.kept, campaign.options, args.out);
  return code;
}

}  // namespace plumb
