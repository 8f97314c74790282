// replay-TARGET FILE..: what the target says of stored inputs, with any compiler. Folders stand for their files.
// Exit 1 when an input stops the engine, 2 when a file cannot be read, a folder holds none or a setting is of no use.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <vector>

#include "corpus/case/case.hpp"
#include "corpus/file/text_input.hpp"
#include "fuzz/targets/target.hpp"

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_at(const fs::path& path) {
  if (!fs::is_directory(path)) return {path};
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(path))
    if (entry.is_regular_file()) files.push_back(entry.path());
  if (files.empty()) throw plumb::InputFailure(path.string(), 0, "", "holds no file");
  std::sort(files.begin(), files.end());
  return files;
}

int replay(const fs::path& path) {
  const std::string text = plumb::read_text(path);
  const std::vector<std::uint8_t> bytes(text.begin(), text.end());
  const plumb::Outcome outcome = plumb::examine(bytes);
  std::printf("%s: %s\n", path.c_str(), outcome.line.c_str());
  return outcome.stop ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: %s FILE..\n", argv[0]);
    return 2;
  }
  try {
    int worst = 0;
    for (int i = 1; i < argc; ++i)
      for (const fs::path& file : files_at(argv[i])) worst = std::max(worst, replay(file));
    return worst;
  } catch (const std::exception& e) {
    (void)std::fflush(stdout);
    std::fprintf(stderr, "%s\n", e.what());
    return 2;
  }
}
