// plumb merge: the results of several campaigns as one.
#include "fuzz/campaign/merge.hpp"

#include <filesystem>

#include "corpus/command/command.hpp"
#include "fuzz/campaign/out_folder.hpp"
#include "fuzz/results/table.hpp"

namespace plumb {
namespace {

struct Arguments {
  std::vector<std::string> folders;
  std::string out;
  bool partial = false, force = false;
};

/// `source`: a folder, or a file of it or of its chunks/.
bool lies_in(const std::filesystem::path& source, const std::filesystem::path& folder) {
  std::error_code error;
  const std::filesystem::path parent = std::filesystem::absolute(source).parent_path();
  const auto is_folder = [&](const std::filesystem::path& path) {
    return std::filesystem::equivalent(path, folder, error);
  };
  if (!std::filesystem::is_regular_file(source, error)) return is_folder(source);
  return is_folder(parent) || (parent.filename() == "chunks" && is_folder(parent.parent_path()));
}

void require_another_folder(const Arguments& args) {
  for (const std::string& source : args.folders)
    if (lies_in(source, args.out))
      throw InputFailure(args.out, 0, "--out", "is a folder to merge, whose shards would be lost");
}

int merge(const Arguments& args) {
  require_another_folder(args);
  const Results all = merge_folders(args.folders, args.partial ? Gaps::counted : Gaps::refused);
  // After the reading: what cannot be merged leaves an earlier result as it was.
  const FolderLock lock = lock_out(args.out);
  if (!args.force) require_replaceable(args.out, all.asked, false);
  prepare_folder(args.out);
  return report(all, args.out);
}

}  // namespace
}  // namespace plumb

int main(int argc, char** argv) {
  plumb::Arguments args;
  plumb::CommandLine app("What one campaign would have found, from its shards", "plumb merge");
  app.add_option("folders", args.folders, "folders that plumb campaign --out wrote, or files of their chunks/")
      ->required();
  app.add_option("--out", args.out, "folder for the result")->required();
  app.add_flag("--partial", args.partial, "also where shards are missing or were interrupted; then exit 130");
  app.add_flag("--force", args.force, plumb::kForceHelp);
  return plumb::run_command(app, argc, argv, [&] { return plumb::merge(args); });
}
