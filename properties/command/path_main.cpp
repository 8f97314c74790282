// plumb path: two bodies along a motion, every step solved cold and from the step before, and how the answers change.
#include <fmt/format.h>

#include <algorithm>

#include "corpus/certificate/reference_store.hpp"
#include "corpus/command/command.hpp"
#include "corpus/command/interrupt.hpp"
#include "corpus/solvers/solver.hpp"
#include "properties/generators/paths.hpp"
#include "properties/laws/motion/path.hpp"

namespace plumb {
namespace {

struct Options {
  std::vector<std::string> files;
  std::string methods = "auto";
  ForeignOption foreign;
  std::string cache;
  std::string folder;
  bool list = false;
  bool json = false;
};

void declare(CommandLine& app, Options& options) {
  app.add_option("FILE", options.files, "case files whose lines are the steps of a motion, and folders of them");
  auto* methods = app.add_option("--method", options.methods, "NAME,.. or all; default auto");
  declare_solver(app, options.foreign, "instead, a shared library (solver/plumb_solver.h)", methods);
  app.add_option("--cache", options.cache, cache_help);
  app.add_option("--write", options.folder, "write plumb's own motions to this folder, NAME.jsonl each");
  app.add_flag("--list", options.list, "list plumb's own motions");
  app.add_flag("--json", options.json, "one JSON object a line");
}

/// The steps of one motion, in a file that may hold several.
struct Track {
  std::string file, name;
  std::vector<Case> steps;
};

std::string path_name(const Case& c) {
  if (!c.provenance.is_object() || !c.provenance.contains("path")) return "";
  const Json& name = c.provenance.at("path");
  return name.is_string() ? name.get<std::string>() : write_json(name);
}

bool same_shape(const Body& a, const Body& b) {
  return a.shape.semi_axes == b.shape.semi_axes && a.shape.n1 == b.shape.n1 && a.shape.n2 == b.shape.n2;
}

void require_same_bodies(const Track& track, const Case& next, int line) {
  const Pair &was = track.steps.back().pair, &is = next.pair;
  const bool same1 = same_shape(was.body1, is.body1);
  if (same1 && same_shape(was.body2, is.body2)) return;
  throw InputFailure(track.file, line, same1 ? "bodies[1].shape" : "bodies[0].shape", "not that of the step before");
}

void append_step(std::vector<Track>& tracks, const std::string& file, Case step, int line) {
  const std::string name = path_name(step);
  if (tracks.empty() || tracks.back().file != file || tracks.back().name != name)
    tracks.push_back({file, name, {}});
  else
    require_same_bodies(tracks.back(), step, line);
  tracks.back().steps.push_back(std::move(step));
}

/// After a bad line the steps before it are still followed.
struct Tracks {
  std::vector<Track> read;
  std::optional<InputFailure> failure;
};

void read_file(std::vector<Track>& tracks, const std::string& file) {
  CaseReader reader(file);
  while (std::optional<Case> c = reader.next()) append_step(tracks, file, std::move(*c), reader.line());
}

Tracks read_tracks(const std::vector<std::string>& files) {
  if (files.empty()) throw InputFailure("FILE", 0, "", "is missing");
  Tracks out;
  try {
    for (const auto& file : find_case_files(files)) read_file(out.read, file);
  } catch (const InputFailure& failure) {
    out.failure = failure;
  }
  if (out.read.empty()) throw out.failure.value_or(InputFailure(files.front(), 0, "", "holds no case"));
  return out;
}

/// What a track's answers by one solver came to.
struct Judged {
  const Track& track;
  const Solver& solver;
  std::vector<PathFinding> findings;
  int cold_evaluations = 0, warm_evaluations = 0;

  [[nodiscard]] const std::string& name() const { return track.name.empty() ? track.file : track.name; }
  [[nodiscard]] double largest_severity() const {
    double largest = 0;
    for (const PathFinding& found : findings) largest = std::max(largest, found.finding.severity);
    return largest;
  }
};

Judged judge_track(const Track& track, const Solver& solver, PathJudge& judge) {
  const PathEvidence evidence =
      judge.follow(solver.abilities.problem, [&](const Pair& pair, const Contact<double>* last) {
        return solver.abilities.claimed(solver.solve(pair, Want{}, last));
      });
  Judged out{track, solver, judge_path(evidence)};
  for (const PathStep& step : evidence.steps) {
    out.cold_evaluations += step.cold.evaluations;
    out.warm_evaluations += step.warm.evaluations;
  }
  return out;
}

Json finding_json(const Judged& judged, const PathFinding& found) {
  const Finding& f = found.finding;
  return {{"path", judged.name()},        {"step", found.step},      {"name", judged.track.steps[found.step].name},
          {"method", judged.solver.name}, {"finding", name(f.kind)}, {"law", f.law},
          {"severity", f.severity},       {"detail", f.detail}};
}

Json summary_json(const Judged& judged) {
  return {{"path", judged.name()},
          {"method", judged.solver.name},
          {"steps", judged.track.steps.size()},
          {"findings", judged.findings.size()},
          {"largest_severity", judged.largest_severity()},
          {"evaluations", {{"cold", judged.cold_evaluations}, {"warm", judged.warm_evaluations}}}};
}

std::string finding_line(const Judged& judged, const PathFinding& found) {
  const Finding& f = found.finding;
  return fmt::format("{} {} {} {} {:.3g} {}: {}", judged.name(), found.step, judged.solver.name, name(f.kind),
                     f.severity, f.law, f.detail);
}

std::string summary_line(const Judged& judged) {
  return fmt::format("{} {}: {} steps, {} findings, largest severity {:.3g}, evaluations {} cold, {} warm",
                     judged.name(), judged.solver.name, judged.track.steps.size(), judged.findings.size(),
                     judged.largest_severity(), judged.cold_evaluations, judged.warm_evaluations);
}

void print_judged(const Judged& judged, bool json) {
  for (const PathFinding& found : judged.findings)
    print_line(json ? write_json(finding_json(judged, found)) : finding_line(judged, found));
  print_line(json ? write_json(summary_json(judged)) : summary_line(judged));
  flush_output();
}

/// Whether the solver claims every step: a motion has steps apart, and their verdict at least is to be known.
bool claims(const Solver& solver, const Track& track) {
  return solver.abilities.apart != Apart::none &&
         std::ranges::all_of(track.steps, [&](const Case& step) { return solver.abilities.takes(step.pair); });
}

/// Whether a solver that is no published baseline has a finding.
bool follow_track(const Track& track, const std::vector<Solver>& solvers, const ReferenceSource& source, bool json) {
  std::vector<Pair> pairs;
  for (const Case& step : track.steps) pairs.push_back(step.pair);
  PathJudge judge(pairs, source);
  bool any = false;
  for (const Solver& solver : solvers) {
    if (!claims(solver, track)) continue;
    const Judged judged = judge_track(track, solver, judge);
    if (interrupted()) return any;  // what is done of it is no track
    print_judged(judged, json);
    any = any || (!solver.published && !judged.findings.empty());
  }
  return any;
}

int follow(const Options& options) {
  const std::vector<Solver> solvers =
      options.foreign.empty() ? find_solvers(options.methods) : load_solvers(options.foreign);
  const ReferenceSource source = references_of(open_store(options.cache));
  const Tracks tracks = read_tracks(options.files);
  bool any = false;
  for (const Track& track : tracks.read)
    if (!interrupted()) any = follow_track(track, solvers, source, options.json) || any;
  if (tracks.failure && !interrupted()) throw InputFailure(*tracks.failure);
  return any ? exit_finding : exit_done;
}

int list_paths() {
  for (const Path& path : paths()) print_line(fmt::format("{:<20} {}", path.name, path.summary));
  return exit_done;
}

int write_paths(const std::filesystem::path& folder) {
  for (const Path& path : paths())
    write_file(folder / (std::string(path.name) + ".jsonl"), format_steps(steps_of(path)));
  return exit_done;
}

int run(const Options& options) {
  if (options.list) return list_paths();
  return options.folder.empty() ? follow(options) : write_paths(options.folder);
}

}  // namespace
}  // namespace plumb

int main(int argc, char** argv) {
  plumb::Options options;
  plumb::CommandLine app("Follow a motion step by step, cold and warm; 1 for a finding.", "plumb path");
  plumb::declare(app, options);
  return plumb::run_command(app, argc, argv, [&] { return plumb::run(options); });
}
