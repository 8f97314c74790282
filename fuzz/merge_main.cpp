// plumb merge: the results of several campaigns as one.
#include "fuzz/merge.hpp"

#include "corpus/command.hpp"
#include "fuzz/table.hpp"

namespace plumb {
namespace {

struct Arguments {
  std::vector<std::string> folders;
  std::string out;
};

int merge(const Arguments& args) {
  const Results all = merge_folders(args.folders);
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
