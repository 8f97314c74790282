#include "reports/precision/precision_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "corpus/command/command.hpp"
#include "corpus/command/text_table.hpp"
#include "corpus/json/json_text.hpp"

namespace plumb::reports {
namespace {

std::string command(const SetResults& r, std::string_view method) {
  return fmt::format("plumb report-precision --set {} --method {} {}", r.set.name, method, r.arguments);
}

Json to_json(const Spread& s) {
  return {{"median", s.median}, {"p99", s.p99}, {"max", s.most}};
}

Json set_json(const SetResults& r) {
  Json allowed = Json::array();
  for (const Envelope& e : r.envelopes)
    allowed.push_back({{"scalar", e.scalar},
                       {"normal", to_json(e.normal)},
                       {"overlap", to_json(e.overlap)},
                       {"points", to_json(e.points)}});
  return {{"kind", "set"},
          {"set", r.set.name},
          {"of", r.set.of},
          {"pairs", r.pairs},
          {"envelopes", allowed},
          {"auto_on_front", r.front.is_auto},
          {"front_note", r.front.note}};
}

Json point_json(const SetResults& r, const Point& p) {
  return {{"kind", "point"},
          {"set", r.set.name},
          {"method", p.variant.method},
          {"scalar", p.variant.scalar},
          {"tolerance", p.variant.tolerance},
          {"certificate", p.variant.certificate},
          {"problem", name(p.variant.problem)},
          {"command", command(r, p.variant.method)},
          {"median_ns", p.time.median_ns},
          {"p99_ns", p.time.p99_ns},
          {"iterations", {{"median", p.time.median_iterations}, {"max", p.time.most_iterations}}},
          {"judged", p.judged},
          {"not_converged", p.failed},
          {"off_by_0.01_deg", std::isnan(p.off) ? Json() : Json(p.off)},
          {"overlap_error", to_json(p.overlap)},
          {"normal_error_rad", to_json(p.normal)},
          {"point_error", to_json(p.points)},
          {"pareto", p.is_on_front}};
}

Json path_json(const SetResults& r, const Path& path) {
  Json steps = Json::array();
  for (const Step& step : path.steps)
    steps.push_back({{"iterations", step.iterations},
                     {"normal_error_rad", to_json(step.normal)},
                     {"overlap_error", to_json(step.overlap)}});
  return {{"kind", "path"},
          {"set", r.set.name},
          {"method", path.method},
          {"scalar", path.scalar},
          {"command", command(r, path.method)},
          {"steps", steps}};
}

/// "1e-15 (3e-15)"
std::string error_text(const Spread& s) {
  return fmt::format("{:.0e} ({:.0e})", s.median, s.p99);
}

std::string iterations_text(const Measurement& time) {
  return time.most_iterations > 0 ? fmt::format("{:.0f}", time.median_iterations) : "-";
}

std::string time_text(double ns) {
  const double us = ns * 1e-3;
  return fmt::format("{:.{}f}", us, us < 1e4 ? 3 : 0);
}

const TextTable point_columns({{"", "<2"},
                               {"method", "<42"},
                               {"tol.", ">6"},
                               {"median", ">9", " us"},
                               {"p99", ">9", " us"},
                               {"iter", ">7"},
                               {"no answer", ">8.1f", " %"},
                               {"off", ">6.1f", " %"},
                               {"overlap", ">19"},
                               {"normal, rad", ">19"},
                               {"points", ">19"}});

void print_point(const Point& p) {
  print_line(point_columns.row(p.is_on_front ? "*" : "", name_of(p.variant), tolerance_text(p.variant.tolerance),
                               time_text(p.time.median_ns), time_text(p.time.p99_ns), iterations_text(p.time),
                               100 * p.failed, 100 * p.off, error_text(p.overlap), error_text(p.normal),
                               error_text(p.points)));
}

void print_envelopes(const SetResults& r) {
  const TextTable columns({{"condition x epsilon: what the pairs allow", "<94"},
                           {"overlap", ">19"},
                           {"normal, rad", ">19"},
                           {"points", ">19"}},
                          "  ");
  print_line(columns.head());
  for (const Envelope& e : r.envelopes)
    print_line(
        columns.row(fmt::format("  {}", e.scalar), error_text(e.overlap), error_text(e.normal), error_text(e.points)));
}

void print_paths(const SetResults& r) {
  std::size_t most = 0;
  for (const Path& path : r.paths) most = std::max(most, path.steps.size());
  std::vector<Column> columns{{"normal, rad (median), after so many iterations", "<46"}};
  for (std::size_t k = 0; k < most; ++k) columns.push_back({std::to_string(k), ">7"});
  const TextTable table(columns, "  ");
  print_line(table.head());
  for (const Path& path : r.paths) {
    std::vector<std::string> cells{fmt::format("  {}, {}", path.method, path.scalar)};
    for (const Step& step : path.steps) cells.push_back(fmt::format("{:.0e}", step.normal.median));
    print_line(table.row_of(cells));
  }
}

}  // namespace

std::vector<Json> json_lines(const SetResults& r) {
  std::vector<Json> lines{set_json(r)};
  for (const Point& point : r.points) lines.push_back(point_json(r, point));
  for (const Path& path : r.paths) lines.push_back(path_json(r, path));
  return lines;
}

void print_table(const SetResults& r) {
  const auto in_double =
      std::find_if(r.envelopes.begin(), r.envelopes.end(), [](const Envelope& e) { return e.scalar == "double"; });
  print_line(fmt::format("{}: {} pairs, {}, {}; {} of known truth; condition x epsilon of the normal {}", r.set.name,
                         r.pairs, r.set.of, r.set.takes_all ? "overlapping or apart" : "overlap ratio 1e-3..5e-2",
                         r.known, error_text(in_double->normal)));
  print_line(point_columns.head());
  for (const Point& p : r.points) print_point(p);
  print_line("  front: " + r.front.note);
  print_envelopes(r);
  print_paths(r);
}

}  // namespace plumb::reports
