// Files of corpus/case/case.hpp: reading one case after the other, finding case files.
#include <algorithm>
#include <cerrno>
#include <cstring>

#include "corpus/case/case.hpp"

namespace plumb {
namespace {

namespace fs = std::filesystem;

// One line whatever stands in file and field names.
std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }, ' ');
  return text;
}

std::string located(const std::string& file, int line, const std::string& field, const std::string& reason) {
  std::string out = file;
  if (line > 0) out.append(":").append(std::to_string(line));
  if (!field.empty()) out.append(": ").append(field);
  return one_line(out + ": " + reason);
}

}  // namespace

InputFailure::InputFailure(const std::string& file, int line, const std::string& field, const std::string& reason)
    : std::runtime_error(located(file, line, field, reason)) {}

void fail_with(const std::string& file, int error) {
  throw InputFailure(file, 0, "", std::strerror(error));
}

CaseReader::CaseReader(const std::string& path, CaseShapes shapes)
    : objects_(path, ObjectReader::layout_of(path)), shapes_(shapes) {}

std::optional<Case> CaseReader::next() {
  const std::optional<std::string> text = objects_.next();
  if (!text) return std::nullopt;
  return parse_case(*text, objects_.file(), objects_.line(), shapes_);
}

namespace {

bool is_case_file(const fs::directory_entry& entry) {
  if (!entry.is_regular_file()) return false;
  const fs::path& path = entry.path();
  return (path.extension() == ".json" || path.extension() == ".jsonl") && path.filename() != "summary.json";
}

void add_folder(std::vector<fs::path>& files, const std::string& folder) {
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (is_case_file(entry)) files.push_back(entry.path());
}

void add_path(std::vector<fs::path>& files, const std::string& path) {
  try {
    if (fs::is_directory(path)) return add_folder(files, path);
    if (!fs::exists(path)) fail_with(path, ENOENT);
    files.emplace_back(path);
  } catch (const fs::filesystem_error& error) {
    throw InputFailure(error.path1().empty() ? path : error.path1().string(), 0, "", error.code().message());
  }
}

}  // namespace

std::vector<fs::path> find_case_files(const std::vector<std::string>& paths) {
  std::vector<fs::path> files;
  for (const std::string& path : paths) add_path(files, path);
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

}  // namespace plumb
