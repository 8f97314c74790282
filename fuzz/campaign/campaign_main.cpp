// plumb campaign: random cases of the families, judged.
#include "corpus/command/command.hpp"
#include "fuzz/campaign/arguments.hpp"
#include "fuzz/campaign/campaign_arguments.hpp"
#include "fuzz/campaign/out_folder.hpp"

namespace plumb {
namespace {

int campaign(const CampaignArguments& args) {
  const PreparedCampaign campaign = prepare_campaign(args);
  if (args.out.empty()) return report_campaign(args, campaign, run_campaign(campaign.sources, campaign.options));
  const FolderLock lock = lock_out(args.out);
  if (const auto finished = finished_before(args, campaign)) return report_campaign(args, campaign, *finished);
  const ChunkFolder chunks = open_chunks(args, campaign);
  const Results results = run_campaign(campaign.sources, campaign.options, &chunks);
  const int code = report_campaign(args, campaign, results);
  if (!results.incomplete()) chunks.remove();
  return code;
}

}  // namespace
}  // namespace plumb

int main(int argc, char** argv) {
  plumb::CampaignArguments args;
  args.threads = plumb::default_threads();
  plumb::CommandLine app("Random cases of the families: every method's answer judged by every law", "plumb campaign");
  plumb::declare_campaign(app, args, "default: one for each processor");
  app.add_option("--answers", args.answers, "file for the cases and every answer to each, a line a case");
  return plumb::run_command(app, argc, argv, [&] { return plumb::campaign(args); });
}
