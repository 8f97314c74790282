// plumb merge: the results of several campaigns as one.
#include <fmt/format.h>

#include "corpus/command.hpp"
#include "fuzz/table.hpp"

namespace plumb {
namespace {

struct Arguments {
  std::vector<std::string> folders;
  std::string out;
};

int merge(const Arguments& args) {
  Results all = read_results(args.folders.front());
  for (std::size_t i = 1; i < args.folders.size(); ++i) {
    Results next = read_results(args.folders[i]);
    if (next.seed != all.seed)
      throw InputFailure(args.folders[i], 0, "seed",
                         fmt::format("is {}, that of {} is {}", next.seed, args.folders.front(), all.seed));
    all.merge(std::move(next));
  }
  // After the reading: --out may be one of the folders that were read.
  prepare_folder(args.out);
  return report(all, args.out);
}

}  // namespace
}  // namespace plumb

int main(int argc, char** argv) {
  plumb::Arguments args;
  CLI::App app("What one campaign would have found, from its shards", "plumb merge");
  app.add_option("folders", args.folders, "folders that plumb campaign --out wrote")->required();
  app.add_option("--out", args.out, "folder for the result")->required();
  return plumb::run_command(app, argc, argv, [&] { return plumb::merge(args); });
}
