// What checks a proof shares nothing with what searches for it: the include closure of the verifier, read from the files.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace plumb::reference::independence_tests {
namespace {

namespace fs = std::filesystem;

const fs::path root(PLUMB_SOURCE_DIR);

/// What a file includes of the repository, by paths from its root.
std::set<std::string> included_by(const std::string& file) {
  std::ifstream in(root / file);
  EXPECT_TRUE(in) << file;
  std::set<std::string> out;
  const std::string opening = "#include \"";
  for (std::string line; std::getline(in, line);)
    if (line.rfind(opening, 0) == 0) out.insert(line.substr(opening.size(), line.rfind('"') - opening.size()));
  return out;
}

/// All that files include, with the .cpp of every header: its code is run as well. To each file the one that brought it.
std::map<std::string, std::string> closure_of(const std::string& folder) {
  std::map<std::string, std::string> out;
  std::vector<std::string> open;
  const auto take = [&](const std::string& file, const std::string& from) {
    if (out.emplace(file, from).second) open.push_back(file);
  };
  for (const auto& entry : fs::directory_iterator(root / folder))
    take(fs::relative(entry.path(), root).generic_string(), folder);
  while (!open.empty()) {
    const std::string file = open.back();
    open.pop_back();
    for (const std::string& header : included_by(file)) take(header, file);
    const fs::path source = fs::path(file).replace_extension(".cpp");
    // reference.hpp is included for the words of an answer; its .cpp is the search that makes them.
    if (file != "solver/reference/reference.hpp" && fs::exists(root / source)) take(source.generic_string(), file);
  }
  return out;
}

bool is_under(const std::string& file, const std::string& folder) {
  return file.rfind(folder + "/", 0) == 0;
}

TEST(Independence, TheVerifierReachesNoSearchAndNoMethod) {
  const auto closure = closure_of("solver/reference/proof");
  for (const auto& [file, from] : closure) {
    for (const char* folder : {"solver/reference/search", "solver/reference/touch", "solver/reference/condition",
                               "solver/method", "solver/batch", "solver/scene", "fuzz", "reports", "corpus"})
      EXPECT_FALSE(is_under(file, folder)) << file << ", from " << from;
    EXPECT_TRUE(is_under(file, "solver")) << file << ", from " << from;
  }
  // It did read what a proof stands on.
  for (const char* file : {"solver/reference/proof/verify.cpp", "solver/reference/proof/proof.cpp",
                           "solver/reference/interval/enclosure.cpp", "solver/reference/interval/double_power.cpp",
                           "solver/reference/interval/interval.hpp", "solver/reference/cover.hpp"})
    EXPECT_TRUE(closure.contains(file)) << file;
}

/// What has to be believed is a short list, and a file that joins it is to be seen here.
TEST(Independence, TheTrustedFilesAreTheseAndNoOthers) {
  const std::set<std::string> trusted{
      "solver/contact.cpp",
      "solver/contact.hpp",
      "solver/reference/cover.hpp",
      "solver/reference/interval/double_power.cpp",
      "solver/reference/interval/double_power.hpp",
      "solver/reference/interval/double_power_tables.hpp",
      "solver/reference/interval/enclosure.cpp",
      "solver/reference/interval/enclosure.hpp",
      "solver/reference/interval/enclosure_impl.hpp",
      "solver/reference/interval/digits.hpp",
      "solver/reference/interval/interval.hpp",
      "solver/reference/interval/interval_double.hpp",
      "solver/reference/interval/interval_mpfi.cpp",
      "solver/reference/interval/interval_mpfi.hpp",
      "solver/reference/interval/vector_interval.hpp",
      "solver/reference/meter.hpp",
      "solver/reference/proof/meridian.cpp",
      "solver/reference/proof/meridian.hpp",
      "solver/reference/proof/proof.cpp",
      "solver/reference/proof/proof.hpp",
      "solver/reference/proof/verify.cpp",
      "solver/reference/proof/verify.hpp",
      "solver/reference/proof/verify_double.cpp",
      "solver/reference/proof/verify_impl.hpp",
      "solver/reference/real.hpp",
      "solver/reference/reference.hpp",
      "solver/standard_arithmetic.hpp",
  };
  std::set<std::string> found;
  for (const auto& [file, from] : closure_of("solver/reference/proof")) found.insert(file);
  for (const std::string& file : found) EXPECT_TRUE(trusted.contains(file)) << file << " has to be believed as well";
  for (const std::string& file : trusted) EXPECT_TRUE(found.contains(file)) << file << " is no longer needed";
}

/// Nor does the reference as a whole, search and all, include a method: a mistake of one is not to hide in the other.
TEST(Independence, NoFileOfTheReferenceIncludesAMethod) {
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(root / "solver/reference")) {
    if (!entry.is_regular_file()) continue;
    ++files;
    for (const std::string& header : included_by(fs::relative(entry.path(), root).generic_string()))
      EXPECT_FALSE(is_under(header, "solver/method")) << entry.path() << " includes " << header;
  }
  EXPECT_GT(files, 50);
}

}  // namespace
}  // namespace plumb::reference::independence_tests
