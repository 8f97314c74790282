// plumb report-study: the source's study (Kildashti, Dong & Samali 2018) made again, at a scale it never had: which systems find a
// contact, what is wrong with the others' answers, and how far apart right answers to different questions are.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <thread>

#include "corpus/case/case.hpp"
#include "corpus/command/command.hpp"
#include "corpus/command/interrupt.hpp"
#include "reports/report_lines.hpp"
#include "reports/study/tables.hpp"

namespace plumb::reports {
namespace {

struct Part {
  const char* name;
  const char* title;
  ReportTable (*make)(const StudyOptions& options);
};

constexpr std::array parts{
    Part{"groups",
         "Four groups of spheroid pairs, chosen by us in the source's terms. Points: the method's own, no truth; "
         "residues\n"
         "and angles of them in all their digits, in long double, * marks what is not 0; off: degrees between the "
         "normal and the certified common normal, ? where that is not proved",
         spheroid_groups},
    Part{"superquadrics", "The same of superquadrics", superquadric_groups},
    Part{"roots",
         "All real solutions of the original six equations, each proved; all: proved to be all; in brackets the share "
         "of "
         "random starts\n"
         "of original_cn that end at one of the kind",
         six_equations_roots},
    Part{"shares",
         "Random orientations of two equal spheroids: answers more than 0.01 degrees from the certified common normal",
         misalignment_shares},
    Part{"maps", "Misalignment over theta_L and theta", misalignment_maps},
    Part{"limits",
         "Certified answers to other questions against the certified common normal, medians: angle between the "
         "normals, distance of\n"
         "the points' middles over the size, relative difference of the overlaps",
         limits_and_sweeps},
    Part{"cost", "Evaluations to an accuracy of the normal, degrees, each by its own problem's certified answer",
         costs_at_equal_accuracy},
};

struct Options {
  StudyOptions study;
  std::vector<std::string> parts;
  ReportLines lines;
};

std::vector<std::string> part_names() {
  std::vector<std::string> out;
  for (const Part& part : parts) out.emplace_back(part.name);
  return out;
}

void declare(CommandLine& app, Options& options) {
  StudyOptions& study = options.study;
  study.threads = std::max(1u, std::thread::hardware_concurrency());
  app.add_option("--part", options.parts, fmt::format("NAME,..; default: all of {}", fmt::join(part_names(), ", ")))
      ->delimiter(',')
      ->is_one_of("part", part_names());
  declare_seed(app, study.seed, "of all that is drawn");
  const auto count = [&](const char* flag, int& value, const char* help) {
    app.add_option(flag, value, help)->capture_default_str()->in_range(1, 1'000'000);
  };
  count("--starts", study.starts, "random starts of original_cn for each pair");
  count("--orientations", study.orientations, "random orientations for each share");
  count("--pairs", study.pairs, "for each point of a limit");
  count("--cost-pairs", study.cost_pairs, "of each set whose cost is measured");
  app.add_option("--threads", study.threads, "changes nothing but the time")->in_range(1, 1024);
  options.lines.declare(app);
}

bool is_asked(const Options& options, const Part& part) {
  const auto& names = options.parts;
  return names.empty() || std::find(names.begin(), names.end(), part.name) != names.end();
}

std::string command_of(const Options& options) {
  const StudyOptions& s = options.study;
  const std::string named = options.parts.empty() ? "" : fmt::format(" --part {}", fmt::join(options.parts, ","));
  return fmt::format("plumb report-study{} --seed {} --starts {} --orientations {} --pairs {} --cost-pairs {}", named,
                     s.seed, s.starts, s.orientations, s.pairs, s.cost_pairs);
}

int report(Options& options) {
  options.lines.add_run(command_of(options));
  for (const Part& part : parts) {
    if (!is_asked(options, part) || interrupted()) continue;
    const ReportTable table = part.make(options.study);
    if (interrupted()) break;  // a part that was cut short says nothing
    options.lines.add(part.title, table);
  }
  options.lines.add_end();
  options.lines.write();
  return exit_done;
}

}  // namespace
}  // namespace plumb::reports

int main(int argc, char** argv) {
  plumb::reports::Options options;
  plumb::CommandLine app("The source's study made again: every system side by side, certified.", "plumb report-study");
  plumb::reports::declare(app, options);
  return plumb::run_command(app, argc, argv, [&] { return plumb::reports::report(options); });
}
