// plumb report: campaigns and scenes as one page, and as data beside it.
#include <fmt/format.h>

#include <filesystem>
#include <map>

#include "corpus/command/build_info.hpp"
#include "corpus/command/command.hpp"
#include "corpus/command/interrupt.hpp"
#include "corpus/command/program_folder.hpp"
#include "corpus/file/text_input.hpp"
#include "corpus/solvers/host/shell_words.hpp"
#include "properties/laws/accuracy_option.hpp"
#include "reports/document/compare.hpp"
#include "reports/document/formats.hpp"
#include "reports/document/issue.hpp"
#include "reports/document/sections.hpp"

namespace plumb::reports {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::vector<std::string> folders;
  std::string out, issue, accuracy;
  std::map<std::string, std::string> sections;  ///< the files that options name, by section
  ForeignOption foreign;
  std::size_t failures = 500;
};

void declare(CommandLine& app, Arguments& args) {
  app.add_option(
      "DIR", args.folders,
      "folders of campaigns, the first of which the others are compared with, and of plumb scene --out; none "
      "are needed beside --study or --fem");
  app.add_option("-o,--out", args.out, "the page, FILE.html");
  app.add_option("--issue", args.issue,
                 "instead: this case as a report for its solver's maintainer, in Markdown, to --out or standard "
                 "output; 1 when there is a finding");
  declare_accuracy_of_cases(app, args.accuracy);
  for (const Section& section : all_sections()) {
    const std::string name = section.name;
    const std::string source = source_of(section) + (source_of(section).starts_with("plumb ") ? " --out" : "");
    app.add_option("--" + name, args.sections[name],
                   "what " + source + " left; else the last DIR's " + name + ".jsonl, where there is one");
  }
  declare_solver(app, args.foreign, "the shared library of a foreign solver whose failures are to be solved again");
  app.add_option("--failures", args.failures,
                 "kept cases in the gallery of each run: plumb's own, then each method's most frequent")
      ->capture_default_str()
      ->in_range(0, 100000);
}

/// In a <script>, no text can end it or open a comment.
std::string inert(std::string json) {
  for (std::size_t at = 0; (at = json.find('<', at)) != std::string::npos; at += 6) json.replace(at, 1, "\\u003c");
  return json;
}

std::string page_of(const std::string& json) {
  constexpr std::string_view place = "<!-- plumb:data -->";
  const fs::path path = data_file("report.html");
  std::string page = read_text(path);
  const std::size_t at = page.find(place);
  if (at == std::string::npos) throw InputFailure(path.string(), 0, "", fmt::format("holds no {}", place));
  return page.replace(at, place.size(),
                      "<script type=\"application/json\" id=\"plumb-data\">" + inert(json) + "</script>");
}

/// What its option named, else the last folder's file of its name, where there is one.
fs::path file_of(const Section& section, const Arguments& args) {
  const std::string& given = args.sections.at(section.name);
  if (!given.empty() || args.folders.empty()) return given;
  const fs::path beside = fs::path(args.folders.back()) / (std::string(section.name) + ".jsonl");
  return fs::exists(beside) ? beside : fs::path();
}

std::string command_of(const Arguments& args, const std::vector<Solver>& foreign) {
  std::string out = "plumb report";
  for (const std::string& folder : args.folders) out += " " + shell_word(folder);
  for (const Section& section : all_sections())
    if (const std::string& file = args.sections.at(section.name); !file.empty())
      out += fmt::format(" --{} {}", section.name, shell_word(file));
  for (const Solver& solver : foreign) out += solver.option;
  if (args.failures != Arguments().failures) out += fmt::format(" --failures {}", args.failures);
  return out + " -o " + shell_word(args.out);
}

/// The data lie beside the page by its name: a campaign's summary.json must not be among them.
void refuse_bad_page(const Arguments& args) {
  const fs::path page = args.out;
  if (page.extension() != ".html")
    throw InputFailure(args.out, 0, "--out", "must end in .html: the data lie beside it");
  for (const std::string& folder : args.folders)
    if (fs::weakly_canonical(fs::path(page).replace_extension(".json")) ==
        fs::weakly_canonical(fs::path(folder) / "summary.json"))
      throw InputFailure(args.out, 0, "--out", "its data would take the place of " + folder + "/summary.json");
}

/// What stands beside the page is replaced only where it is an earlier report's: its .json says so.
void refuse_to_replace(const fs::path& page, const std::vector<const char*>& extensions) {
  const fs::path json = fs::path(page).replace_extension(".json");
  constexpr std::string_view mark = "{\"format\":\"plumb/report-1\"";
  if (fs::exists(json) && read_text(json).starts_with(mark)) return;
  for (const char* extension : extensions)
    if (const fs::path beside = fs::path(page).replace_extension(extension); fs::exists(beside))
      throw InputFailure(beside.string(), 0, "",
                         "stands where the report's data would, and is of no report: choose another -o");
}

/// Folders of one name are called by their paths.
void name_apart(Json& runs) {
  std::map<std::string, int> seen;
  for (const Json& run : runs) ++seen[run["name"].get<std::string>()];
  for (Json& run : runs)
    if (seen.at(run["name"].get<std::string>()) > 1) run["name"] = run["folder"];
}

Json document(const Arguments& args, const std::vector<Run>& runs) {
  const BuildInfo build = build_info();
  const Shown shown{args.failures, load_solvers(args.foreign)};
  Json out{{"format", "plumb/report-1"},
           {"made",
            {{"commit", build.commit},
             {"compiler", build.compiler},
             {"flags", build.flags},
             {"command", command_of(args, shown.foreign)}}},
           {"runs", Json::array()},
           {"comparisons", Json::array()},
           {"playbacks", Json::array()},
           {"findings", findings_json()},
           {"laws", laws_json()},
           {"methods", methods_json()}};
  for (const Run& run : runs) out["runs"].push_back(run_json(run, shown));
  for (const std::string& folder : args.folders)
    if (holds_playback(folder)) out["playbacks"].push_back(playback_json(folder));
  name_apart(out["runs"]);
  name_apart(out["playbacks"]);
  for (std::size_t i = 1; i < runs.size(); ++i) out["comparisons"].push_back(comparison_json(runs[0], runs[i]));
  for (const Section& section : all_sections()) {
    const fs::path file = file_of(section, args);
    out[section.name] = file.empty() ? Json() : read_section(section, file);
  }
  return out;
}

void refuse_no_run(const std::string& folder) {
  if (!fs::is_directory(folder)) throw InputFailure(folder, 0, "", "there is no such folder");
  if (!holds_playback(folder) && fs::exists(fs::path(folder) / "run.json"))
    throw InputFailure(folder, 0, "",
                       "holds a scene's run without a playback: add it to the scene's run.outputs.write");
}

/// A folder with a playback alone is no campaign's.
std::vector<Run> read_runs(const Arguments& args) {
  std::vector<Run> runs;
  for (const std::string& folder : args.folders) refuse_no_run(folder);
  for (const std::string& folder : args.folders)
    if (!holds_playback(folder) || fs::exists(fs::path(folder) / "campaign.bins"))
      runs.push_back({folder, read_results(folder)});
  return runs;
}

void refuse_nothing_to_show(const Arguments& args) {
  if (!args.folders.empty()) return;
  std::string options;
  for (const Section& section : all_sections()) {
    if (!section.stands_alone) continue;
    if (!args.sections.at(section.name).empty()) return;
    options += (options.empty() ? "--" : " nor --") + std::string(section.name);
  }
  throw InputFailure("DIR", 0, "", "is required where there is neither " + options);
}

/// By the foreign solver that was named, or the method that the case names.
int write_issue(const Arguments& args) {
  const std::optional<Case> c = CaseReader(args.issue).next();
  if (!c) throw InputFailure(args.issue, 0, "", "holds no case");
  const auto solver =
      solver_instead(args.foreign, args.foreign.empty() ? c->expect.method.value_or("auto") : "", "--issue");
  if (!solver) throw InputFailure(args.issue, 0, "expect.method", "names no method");
  const std::optional<Accuracy> asked = accuracy_instead(args.accuracy);
  const Accuracy accuracy = asked ? *asked : accuracy_of_case(*c, args.issue, 0);
  const std::string options = solver->option + accuracy_option(accuracy_text(accuracy));
  const Issue found = issue(*c, *solver, accuracy, "plumb report --issue " + shell_word(args.issue) + options);
  if (!found.has_finding) {
    print_line(solver->name + " has no finding on this case: there is nothing to report");
    return exit_done;
  }
  if (args.out.empty())
    print_line(found.markdown);
  else
    write_file(args.out, found.markdown);
  return exit_finding;
}

int report(const Arguments& args) {
  if (!args.issue.empty()) return write_issue(args);
  if (args.out.empty()) throw InputFailure("--out", 0, "", "is required: the page, FILE.html");
  refuse_nothing_to_show(args);
  refuse_bad_page(args);
  const fs::path page = args.out;
  const std::vector<Run> runs = read_runs(args);
  const Json whole = document(args, runs);
  if (interrupted()) return exit_interrupted;  // before anything is written: what an earlier report left stays whole
  std::vector<const char*> extensions{".json", ".md"};
  if (!runs.empty()) extensions.insert(extensions.end(), {".csv", ".ladders.csv", ".junit.xml", ".sarif"});
  refuse_to_replace(page, extensions);
  // A file name need not be UTF-8; what is not is replaced.
  const std::string json = whole.dump(-1, ' ', false, Json::error_handler_t::replace);
  const auto beside = [&](const char* extension) { return fs::path(page).replace_extension(extension); };
  write_file(beside(".json"), json + "\n");
  write_file(beside(".md"), markdown(runs, whole));
  if (!runs.empty()) {
    write_file(beside(".csv"), csv(runs));
    write_file(beside(".ladders.csv"), ladders_csv(runs));
    write_file(beside(".junit.xml"), junit(runs.back()));
    write_file(beside(".sarif"), sarif(runs.back()));
  }
  write_file(page, page_of(json));
  print_line(page.string());
  return exit_done;
}

}  // namespace
}  // namespace plumb::reports

int main(int argc, char** argv) {
  plumb::reports::Arguments args;
  plumb::CommandLine app(
      "Campaigns, scenes, the source's study and the finite elements as one self-contained page, with .json, .csv, "
      ".ladders.csv, .md, .junit.xml and .sarif beside it.",
      "plumb report");
  plumb::reports::declare(app, args);
  return plumb::run_command(app, argc, argv, [&] { return plumb::reports::report(args); });
}
