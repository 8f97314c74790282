// plumb promote: a kept case goes on in its life, where today's answer holds what its new folder asks.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "corpus/command/build_info.hpp"
#include "corpus/command/command.hpp"
#include "properties/command/life.hpp"
#include "properties/command/replay_reports.hpp"

namespace plumb {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string file, to, why;
  std::string corpus = "corpus/cases";
};

std::string refuse_empty(const std::string& text) {
  return text.find_first_not_of(" \t\n") == std::string::npos ? "says nothing" : "";
}

void declare(CommandLine& app, Options& options) {
  app.add_option("FILE", options.file, "a case of the corpus is moved, one from elsewhere is copied")->required();
  app.add_option("--to", options.to)
      ->required()
      ->is_one_of("folder", std::vector<std::string>(std::begin(life_folders), std::end(life_folders)));
  app.add_option("--why", options.why, "what was found, mended or seen, for the case's provenance")
      ->required()
      ->check(refuse_empty);
  app.add_option("--corpus", options.corpus, "where the three folders are")->capture_default_str();
}

fs::path place_asked(const Options& options) {
  const fs::path folder = fs::path(options.corpus) / options.to, to = folder / fs::path(options.file).filename();
  if (!fs::is_directory(folder)) throw InputFailure(folder.string(), 0, "--to", "is no folder");
  if (fs::exists(to)) throw InputFailure(to.string(), 0, "--to", "is there already");
  return to;
}

/// In one of the corpus's own three folders, from where it goes on.
bool is_in_life(const Options& options) {
  const fs::path corpus = fs::absolute(options.file).parent_path().parent_path();
  std::error_code error;
  return life_of(options.file) && fs::equivalent(corpus, options.corpus, error);
}

std::string from(const Options& options) {
  return is_in_life(options) ? fs::absolute(options.file).parent_path().filename().string() : options.file;
}

Expect expected(const Expect& before, const Replayed& today, const std::string& to) {
  Expect out = before;
  out.method = today.method;
  out.finding = std::string(name(today.finding.kind));
  out.status.reset();
  if (to == life_folders[static_cast<int>(Life::open)]) out.status = today.status;
  return out;
}

Json record(const Case& c, const Replayed& today, const Options& options) {
  return {{"from", from(options)},
          {"to", options.to},
          {"why", options.why},
          {"commit", build_info().commit},
          {"finding", {{"before", c.expect.finding.value_or("none")}, {"after", name(today.finding.kind)}}}};
}

Case promoted(const Case& c, const Replayed& today, const Options& options) {
  if (!c.provenance.is_null() && !c.provenance.is_object())
    throw InputFailure(today.file, today.line, "provenance", "must be an object, to take the record");
  Case out = c;
  out.expect = expected(c.expect, today, options.to);
  out.provenance["promotions"].push_back(record(c, today, options));
  return out;
}

/// The cases as they will stand, one a line; empty where one of them does not hold there.
std::string judge_all(const Options& options, const fs::path& to) {
  CaseReader reader(options.file);
  std::string text;
  bool holds = true;
  for (std::optional<Case> c = reader.next(); c; c = reader.next()) {
    const Replayed today = replay_case(*c, options.file, reader.line(), std::nullopt);
    const Case then = promoted(*c, today, options);
    const Replayed there = replay_case(then, to.string(), reader.line(), std::nullopt);
    print_line(replay_line(there));
    holds = holds && outcome(there) != Outcome::differs;
    text += format_case(then) + "\n";
  }
  if (text.empty()) throw InputFailure(options.file, 0, "", "holds no case");
  return holds ? text : "";
}

int promote(const Options& options) {
  const fs::path to = place_asked(options);
  const std::string text = judge_all(options, to);
  if (text.empty()) {
    print_line(fmt::format("{} stays: it does not hold in {}/", options.file, options.to));
    return exit_finding;
  }
  write_file(to, text);
  if (is_in_life(options)) fs::remove(options.file);
  print_line(fmt::format("{} is {}", to.string(), is_in_life(options) ? "its place now" : "a copy"));
  return exit_done;
}

}  // namespace
}  // namespace plumb

int main(int argc, char** argv) {
  plumb::Options options;
  plumb::CommandLine app("Move a kept case on in its life; 1 where it does not hold what its new folder asks.",
                         "plumb promote");
  plumb::declare(app, options);
  return plumb::run_command(app, argc, argv, [&] { return plumb::promote(options); });
}
