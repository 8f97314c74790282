// Files of corpus/case.hpp: reading one case after the other, finding case files, writing without loss.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>

#include "corpus/case.hpp"

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

[[noreturn]] void fail(const std::string& file, int error) {
  throw InputFailure(file, 0, "", std::strerror(error));
}

bool is_blank(const std::string& text) {
  return text.find_first_not_of(" \t\r\n") == std::string::npos;
}

std::string rest_of(std::istream& in) {
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

InputFailure::InputFailure(const std::string& file, int line, const std::string& field, const std::string& reason)
    : std::runtime_error(located(file, line, field, reason)) {}

struct CaseReader::State {
  std::string file;
  std::ifstream opened;
  std::istream* in = nullptr;
  bool one_a_line = true;
  int line = 0;
};

CaseReader::CaseReader(const std::string& path) : state_(std::make_unique<State>()) {
  state_->file = path == "-" ? "standard input" : path;
  state_->in = &std::cin;
  if (path == "-") return;
  if (fs::is_directory(path)) fail(path, EISDIR);
  state_->one_a_line = fs::path(path).extension() == ".jsonl";
  state_->opened.open(path, std::ios::binary);
  if (!state_->opened) fail(path, errno);
  state_->in = &state_->opened;
}

CaseReader::~CaseReader() = default;

int CaseReader::line() const {
  return state_->one_a_line ? state_->line : 0;
}

std::optional<Case> CaseReader::next() {
  State& state = *state_;
  std::string text;
  while (state.one_a_line && std::getline(*state.in, text)) {
    ++state.line;
    if (is_blank(text)) continue;
    // A single case that was written over several lines comes through a pipe as well.
    if (state.in != &std::cin || state.line > 1 || Json::accept(text)) return parse_case(text, state.file, state.line);
    const std::string whole = text + "\n" + rest_of(std::cin);
    if (!Json::accept(whole)) return parse_case(text, state.file, state.line);
    return parse_case(whole, state.file);
  }
  if (state.in->bad()) fail(state.file, EIO);
  if (state.one_a_line || state.in->eof()) return std::nullopt;
  text = rest_of(*state.in);
  state.in->setstate(std::ios::eofbit);
  return parse_case(text, state.file);
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
    if (!fs::exists(path)) fail(path, ENOENT);
    files.emplace_back(path);
  } catch (const fs::filesystem_error& error) {
    throw InputFailure(error.path1().empty() ? path : error.path1().string(), 0, "", error.code().message());
  }
}

/// A file that is closed at the end, and forgotten if it was not put in its place.
class Output {
 public:
  Output(const fs::path& path, int flags) : path_(path), file_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
  ~Output() {
    if (file_ >= 0) ::close(file_);
  }
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  [[nodiscard]] bool write(std::string_view text) const {
    while (file_ >= 0 && !text.empty()) {
      const ssize_t written = ::write(file_, text.data(), text.size());
      if (written < 0 && errno != EINTR) return false;
      if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
    }
    return file_ >= 0;
  }
  [[nodiscard]] bool sync() const { return ::fsync(file_) == 0; }
  [[nodiscard]] bool move_to(const fs::path& target) const { return ::rename(path_.c_str(), target.c_str()) == 0; }
  void remove() const { (void)::unlink(path_.c_str()); }

 private:
  fs::path path_;
  int file_;
};

// Symbolic links are followed, so that the file they point to is replaced and not the link.
fs::path target_of(const fs::path& path) {
  std::error_code error;
  const fs::path target = fs::weakly_canonical(path, error);
  return error ? path : target;
}

bool is_special(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  return fs::exists(status) && !fs::is_regular_file(status);
}

}  // namespace

std::vector<fs::path> find_case_files(const std::vector<std::string>& paths) {
  std::vector<fs::path> files;
  for (const std::string& path : paths) add_path(files, path);
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

void write_file(const fs::path& path, const std::string& text) {
  if (is_special(path)) {
    if (!Output(path, O_WRONLY).write(text)) fail(path.string(), errno);
    return;
  }
  const fs::path target = target_of(path);
  const Output temporary(target.string() + "." + std::to_string(::getpid()) + ".tmp", O_WRONLY | O_CREAT | O_TRUNC);
  if (temporary.write(text) && temporary.sync() && temporary.move_to(target)) return;
  const int error = errno;
  temporary.remove();
  fail(path.string(), error);
}

}  // namespace plumb
