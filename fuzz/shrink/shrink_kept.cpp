#include "fuzz/shrink/shrink_kept.hpp"

#include <algorithm>
#include <vector>

#include "corpus/command/in_parallel.hpp"
#include "corpus/command/interrupt.hpp"
#include "fuzz/shrink/explain.hpp"

namespace plumb {

void shrink_kept(const KeptFailures& kept, const CampaignOptions& options, const std::filesystem::path& folder) {
  std::vector<const std::pair<const std::string, KeptBucket>*> buckets;
  for (const auto& bucket : kept.buckets()) buckets.push_back(&bucket);
  std::vector<std::string> shrunk_cases(buckets.size());  // written by one thread, which may throw
  in_parallel(buckets.size(), options.threads, [&](std::size_t i) {
    const auto& [bucket, of] = *buckets[i];
    const Case& simplest = of.simplest.kept;
    const auto by = std::find_if(options.solvers.begin(), options.solvers.end(),
                                 [&](const Solver& solver) { return simplest.expect.method == solver.name; });
    if (by == options.solvers.end() || simplest.convex || interrupted()) return;  // of the reference; other shapes
    try {
      Case shrunk = kept_shrunk(simplest, shrink_and_explain(simplest.pair, *by, options.accuracy), by->name);
      shrunk.provenance["file"] = bucket + std::string(kSimplest);
      shrunk_cases[i] = format_case(shrunk) + "\n";
    } catch (const NoAnswer&) {  // it hung too often to be asked any more: the case stays as it is
    }
  });
  for (std::size_t i = 0; i < buckets.size(); ++i)
    if (!shrunk_cases[i].empty())
      write_file(folder / "failures" / (buckets[i]->first + std::string(kShrunk)), shrunk_cases[i]);
}

}  // namespace plumb
