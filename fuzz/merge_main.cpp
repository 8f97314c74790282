// plumb merge: the results of several campaigns as one.
#include "fuzz/merge.hpp"

#include "corpus/command.hpp"
#include "fuzz/table.hpp"

namespace plumb {
namespace {

struct Arguments {
  std::vector<std::string> folders;
  std::string out;
  bool partial = false;
};

int merge(const Arguments& args) {
  const Results all = merge_folders(args.folders, args.partial ? Gaps::counted : Gaps::refused);
  // After the reading: --out may be one of the folders that were read.
  prepare_folder(args.out);
  return report(all, args.out);
}

}  // namespace
}  // namespace plumb

int main(int argc, char** argv) {
  plumb::Arguments args;
  CLI::App app("What one campaign would have found, from its shards", "plumb merge");
  app.add_option("folders", args.folders, "folders that plumb campaign --out wrote, or files of their chunks/")
      ->required();
  app.add_option("--out", args.out, "folder for the result")->required();
  app.add_flag("--partial", args.partial, "also where shards are missing or were interrupted; then exit 130");
  return plumb::run_command(app, argc, argv, [&] { return plumb::merge(args); });
}
