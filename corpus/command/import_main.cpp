// plumb import: the touching pairs of a dump, as cases.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "corpus/case/case.hpp"
#include "corpus/command/command.hpp"
#include "corpus/command/interrupt.hpp"
#include "corpus/command/line_sink.hpp"
#include "corpus/dump/dump_pairs.hpp"
#include "corpus/dump/dump_reader.hpp"
#include "corpus/json/nearest_word.hpp"
#include "corpus/json/number_text.hpp"

namespace plumb {
namespace {

struct Arguments {
  std::vector<std::string> files, columns;
  std::string format = "auto", step = "all", out;
  double gap = 0;
};

std::string refuse_step(const std::string& text) {
  const bool is_step = text == "all" || text == "last" || number_from<std::int64_t>(text).has_value();
  return is_step ? "" : "'" + text + "' is no step: a whole number, last or all";
}

std::string refuse_gap(const std::string& text) {
  const auto gap = number_from<double>(text);
  return gap && *gap >= 0 && *gap <= 1e6 ? "" : "'" + text + "' is not a number from 0 to 1e6";
}

void declare(CommandLine& app, Arguments& arguments) {
  app.add_option("FILE", arguments.files, "dumps, or - for standard input")->required();
  app.add_option("--format", arguments.format, "shapex is a diameter (lammps) or a semi-axis (liggghts)")
      ->is_one_of("format", {"lammps", "liggghts", "auto"})
      ->capture_default_str();
  app.add_option("--step", arguments.step, "the frame of this step, the last one of all files, or all")
      ->check(refuse_step)
      ->capture_default_str();
  app.add_option("--gap", arguments.gap, "also pairs apart by less than this ratio of the larger body's size")
      ->check(refuse_gap)
      ->capture_default_str();
  app.add_option("--column", arguments.columns, "ROLE=NAME: quatw=c_1[4]; roles are LAMMPS's own names");
  app.add_option("-o", arguments.out, "file for the cases; else standard output");
}

DumpOptions options_of(const Arguments& arguments) {
  DumpOptions out;
  if (arguments.format != "auto") out.format = arguments.format == "lammps" ? DumpFormat::lammps : DumpFormat::liggghts;
  const std::vector<std::string> roles = dump_roles();
  for (const std::string& text : arguments.columns) {
    const std::size_t equals = text.find('=');
    const std::string role = text.substr(0, equals);
    if (equals == std::string::npos || equals + 1 == text.size())
      throw InputFailure("--column", 0, text, "is not ROLE=NAME");
    if (std::ranges::find(roles, role) == roles.end())
      throw InputFailure("--column", 0, role, no_such("role", role, roles));
    out.columns[role] = text.substr(equals + 1);
  }
  return out;
}

struct Counts {
  std::size_t frames = 0, particles = 0, points = 0, pairs = 0;
};

/// Two images of a particle that touch the same other one are two cases: the second is called ..-image2.
std::string name_of(const std::string& of_file, const DumpFrame& frame, const DumpPair& pair, std::size_t times) {
  const std::string name = fmt::format("{}step{}-{}-{}", of_file, frame.step, frame.particles[pair.first].id,
                                       frame.particles[pair.second].id);
  return times > 1 ? fmt::format("{}-image{}", name, times) : name;
}

Json provenance_of(const std::string& file, const DumpFrame& frame, const DumpPair& pair) {
  Json out = Json::object();
  out["source"] = "plumb import";
  out["file"] = file;
  out["format"] = frame.format == DumpFormat::lammps ? "lammps" : "liggghts";
  out["step"] = frame.step;
  if (frame.time) out["time"] = *frame.time;
  if (!frame.units.empty()) out["units"] = frame.units;
  out["ids"] = {frame.particles[pair.first].id, frame.particles[pair.second].id};
  if (frame.box.repeats()) out["image"] = pair.image;
  return out;
}

/// A file, and what the names of its cases begin with: file2- for the second of several, whose steps may be the first's.
struct Source {
  std::string file, prefix;
};

void import_frame(const Source& source, const DumpFrame& frame, double gap, LineSink& sink, Counts& counts) {
  std::array<std::size_t, 2> last{frame.particles.size(), 0};
  std::size_t times = 0;
  try {
    each_touching_pair(frame, gap, [&](const DumpPair& pair) {
      times = last == std::array{pair.first, pair.second} ? times + 1 : 1;
      last = {pair.first, pair.second};
      sink.add(format_case(
          {name_of(source.prefix, frame, pair, times), pair.pair, {}, provenance_of(source.file, frame, pair), {}}));
      ++counts.pairs;
    });
  } catch (const std::invalid_argument& error) {
    throw InputFailure(source.file, 0, fmt::format("step {}", frame.step), error.what());
  }
  ++counts.frames;
  counts.particles += frame.particles.size();
  counts.points += frame.points;
  sink.flush();
}

/// The last frame of all files is the one of the highest step.
struct LastFrame {
  Source source;
  std::optional<DumpFrame> frame;
};

void read_file(DumpReader& reader, const Source& source, const Arguments& arguments, LastFrame& last, LineSink& sink,
               Counts& counts) {
  const auto step = number_from<std::int64_t>(arguments.step);
  const bool keeps_last = arguments.step == "last";
  const auto is_wanted = [&](std::int64_t at) {
    if (keeps_last) return !last.frame || at >= last.frame->step;
    return !step || at == *step;
  };
  while (auto frame = reader.next(is_wanted)) {
    if (keeps_last)
      last = {source, std::move(frame)};
    else
      import_frame(source, *frame, arguments.gap, sink, counts);
  }
}

/// Once all is read: beside a refusal nothing else is said.
void report(const std::vector<std::string>& notes, const Counts& counts) {
  for (const std::string& note : notes) fmt::print(stderr, "{}\n", note);
  fmt::print(stderr, "{} frames, {} particles, {} pairs", counts.frames, counts.particles, counts.pairs);
  if (counts.points > 0) fmt::print(stderr, "; left out: {} points (shape and radius 0)", counts.points);
  fmt::print(stderr, "{}\n", interrupted() ? "; interrupted: incomplete" : "");
}

int import_files(const Arguments& arguments) {
  const DumpOptions options = options_of(arguments);
  LineSink sink(arguments.out);
  Counts counts;
  LastFrame last;
  std::vector<std::string> notes;
  std::string first;
  for (std::size_t i = 0; i < arguments.files.size() && !interrupted(); ++i) {
    DumpReader reader(arguments.files[i], options);
    const Source source{reader.file(), arguments.files.size() > 1 ? fmt::format("file{}-", i + 1) : ""};
    read_file(reader, source, arguments, last, sink, counts);
    if (i == 0) first = reader.file();
    for (const std::string& note : reader.notes()) notes.push_back(fmt::format("{}: {}", reader.file(), note));
  }
  if (last.frame) import_frame(last.source, *last.frame, arguments.gap, sink, counts);
  if (counts.frames == 0 && !interrupted())
    throw InputFailure(first, 0, arguments.step == "all" ? "" : "step " + arguments.step, "holds no such frame");
  if (counts.frames > 0) sink.finish();
  report(notes, counts);
  return exit_done;
}

}  // namespace
}  // namespace plumb

int main(int argc, char** argv) {
  plumb::Arguments arguments;
  plumb::CommandLine app("The pairs of a LAMMPS or LIGGGHTS dump that touch, as cases.", "plumb import");
  plumb::declare(app, arguments);
  return plumb::run_command(app, argc, argv, [&] { return plumb::import_files(arguments); });
}
