// plumb report-precision: what accuracy costs. Every method in each of its scalars at each tolerance: time against error, and
// how often there is no answer, or none near the truth.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "corpus/command.hpp"
#include "corpus/interrupt.hpp"
#include "corpus/solver.hpp"
#include "reports/bench_measure.hpp"
#include "reports/bench_sets.hpp"
#include "reports/precision_error.hpp"
#include "solver/method/methods.hpp"

namespace plumb::reports {
namespace {

struct Options {
  std::int64_t count = 200;
  std::uint64_t seed = 1;
  int repeat = 5;
  bool json = false;
  std::string out;
};

void declare(CLI::App& app, Options& options) {
  app.add_option("--cases", options.count, "pairs of each set")->capture_default_str()->check(refuse_count);
  app.add_option("--seed", options.seed, "same seed, same pairs")->capture_default_str();
  app.add_option("--repeat", options.repeat, "time each pair so often; the least counts")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  app.add_flag("--json", options.json, "one JSON object a point in the place of the tables");
  app.add_option("--out", options.out, "file for the JSON objects, one a line");
}

/// One point of the diagram: a way to an answer.
struct Variant {
  std::string method, scalar, certificate;  ///< certificate: what is asked for beside the answer, or empty
  double tolerance = 0;                     ///< 0: all that rounding allows
  Problem problem = Problem::common_normal;
  std::function<Contact<double>(const Pair&)> timed;
  std::function<Contact<long double>(const Pair&)> judged;
};

Want at_tolerance(double tolerance) {
  Want want;
  want.tolerance = tolerance;
  return want;
}

/// The fields that are judged.
Contact<long double> lengthened(const Contact<double>& from) {
  Contact<long double> out;
  out.status = from.status;
  out.iterations = from.iterations;
  out.overlap = static_cast<long double>(from.overlap);
  out.normal = from.normal.cast<long double>();
  out.point1 = from.point1.cast<long double>();
  out.point2 = from.point2.cast<long double>();
  return out;
}

Contact<double> status_of(const Contact<long double>& from) {
  Contact<double> out;
  out.status = from.status;
  out.iterations = from.iterations;
  return out;
}

Variant in_double(const Solver& solver, double tolerance) {
  const Want want = at_tolerance(tolerance);
  const auto answer = [solver, want](const Pair& pair) { return solver.solve(pair, want, nullptr); };
  return {solver.name, "double", "", tolerance, solver.problem, answer, [answer](const Pair& pair) {
            return lengthened(answer(pair));
          }};
}

Variant in_long_double(const Method& method, double tolerance) {
  const Want want = at_tolerance(tolerance);
  const auto answer = [solve = method.solve_long, want](const Pair& pair) { return solve(pair, want, nullptr); };
  return {std::string(method.name),
          "long double",
          "",
          tolerance,
          method.problem,
          [answer](const Pair& pair) { return status_of(answer(pair)); },
          answer};
}

/// `auto`, and the reference at an effort: an answer, and how far it can be from the truth.
Variant with_certificate(const Solver& solver, Effort effort) {
  Variant out = in_double(solver, 0);
  out.certificate = name(effort);
  out.timed = [answer = out.timed, effort](const Pair& pair) {
    Contact<double> contact = answer(pair);
    if (find_reference(pair, effort).global != Claim::proved) contact.status = Status::stalled;
    return contact;
  };
  return out;
}

std::vector<Variant> variants() {
  constexpr std::array tolerances{1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 0.0};
  std::vector<Variant> out;
  for (const Solver& solver : all_solvers()) {
    const Method* method = find_method(solver.name);
    if (method == nullptr) {  // the C door asks for no tolerance
      out.push_back(in_double(solver, 0));
      continue;
    }
    for (const double tolerance : tolerances) out.push_back(in_double(solver, tolerance));
    for (const double tolerance : tolerances) out.push_back(in_long_double(*method, tolerance));
    if (solver.name == "auto")
      for (const Effort effort : efforts) out.push_back(with_certificate(solver, effort));
  }
  return out;
}

struct Point {
  Variant variant;
  Measurement time;
  Spread overlap, normal, points;
  double failed = 0;  ///< share without an answer
  double off = 0;     ///< share of the judged answers whose normal is more than 0.01 degrees from the truth
  std::size_t judged = 0;
  bool is_on_front = false;
};

using Truths = std::map<Problem, std::vector<Truth>>;

Truths truths_of(const std::vector<Case>& cases) {
  Truths out;
  for (const Problem problem : {Problem::common_normal, Problem::deepest_points, Problem::midway})
    for (const Case& c : cases)
      if (!interrupted()) out[problem].push_back(truth_of(c.pair, problem));
  return out;
}

void judge(Point& point, const std::vector<Case>& cases, const Truths& truths) {
  constexpr double off = 0.01 * std::numbers::pi / 180;
  std::vector<double> overlap, normal, points;
  std::size_t failed = 0, far = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Contact<long double> answer = point.variant.judged(cases[i].pair);
    const Truth& truth = truths.at(point.variant.problem)[i];
    if (answer.status != Status::converged) {
      ++failed;
      continue;
    }
    const AnswerError error = error_of(answer, truth);
    overlap.push_back(error.overlap);
    normal.push_back(error.normal);
    points.push_back(error.points);
    point.judged += truth.known ? 1 : 0;
    far += error.normal > off ? 1 : 0;
  }
  point.overlap = spread(overlap);
  point.normal = spread(normal);
  point.points = spread(points);
  point.failed = static_cast<double>(failed) / static_cast<double>(cases.size());
  point.off = point.judged > 0 ? static_cast<double>(far) / static_cast<double>(point.judged) : 0;
}

/// What a user can count on: the normal's p99, and nothing at all where more than one answer in a hundred is not there.
double counted_error(const Point& point) {
  const bool is_there = point.failed <= 0.01 && !std::isnan(point.normal.p99);
  return is_there ? point.normal.p99 : std::numeric_limits<double>::infinity();
}

/// Answers of one problem; certificates are an axis of their own.
void mark_front(std::vector<Point>& points) {
  const auto is_candidate = [](const Point& p) {
    return p.variant.problem == Problem::common_normal && p.variant.certificate.empty() &&
           std::isfinite(counted_error(p));
  };
  for (Point& p : points) {
    const auto beats = [&](const Point& q) {
      const bool no_worse = q.time.median_ns <= p.time.median_ns && counted_error(q) <= counted_error(p);
      const bool better = q.time.median_ns < p.time.median_ns || counted_error(q) < counted_error(p);
      return is_candidate(q) && no_worse && better;
    };
    p.is_on_front = is_candidate(p) && std::none_of(points.begin(), points.end(), beats);
  }
}

std::vector<Job> jobs_of(const std::vector<Variant>& all, const std::vector<Case>& cases) {
  std::vector<Job> jobs;
  for (const Variant& variant : all) {
    Job job;
    job.solver.name = variant.method;
    job.solver.solve = [timed = variant.timed](const Pair& pair, const Want&, const Contact<double>*) {
      return timed(pair);
    };
    for (const Case& c : cases) job.tasks.push_back({c.pair, {}});
    jobs.push_back(std::move(job));
  }
  return jobs;
}

std::vector<Point> points_of(const std::vector<Case>& cases, const Truths& truths, int repeats) {
  const std::vector<Variant> all = variants();
  const std::vector<Measurement> times = measure(jobs_of(all, cases), repeats);
  std::vector<Point> points;
  for (std::size_t i = 0; i < times.size() && !interrupted(); ++i) {
    points.push_back({all[i], times[i], {}, {}, {}});
    judge(points.back(), cases, truths);
  }
  mark_front(points);
  return points;
}

/// The least error that the pairs' condition numbers allow in double, rad: the envelope.
Spread envelope(const std::vector<Truth>& truths) {
  std::vector<double> out;
  for (const Truth& truth : truths)
    out.push_back(truth.known ? truth.condition.normal * std::numeric_limits<double>::epsilon()
                              : std::numeric_limits<double>::quiet_NaN());
  return spread(out);
}

Json to_json(const Spread& s) {
  return {{"median", s.median}, {"p99", s.p99}, {"max", s.most}};
}

Json to_json(const PairSet& set, const Point& p, const Spread& allowed) {
  Json out{{"set", set.name},
           {"pairs", p.time.pairs},
           {"method", p.variant.method},
           {"scalar", p.variant.scalar},
           {"tolerance", p.variant.tolerance},
           {"problem", name(p.variant.problem)},
           {"median_ns", p.time.median_ns},
           {"p99_ns", p.time.p99_ns},
           {"iterations", {{"median", p.time.median_iterations}, {"max", p.time.most_iterations}}},
           {"judged", p.judged},
           {"not_converged", p.failed},
           {"off_by_0.01_deg", p.off},
           {"overlap_error", to_json(p.overlap)},
           {"normal_error_rad", to_json(p.normal)},
           {"point_error", to_json(p.points)},
           {"condition_times_epsilon", to_json(allowed)},
           {"pareto", p.is_on_front}};
  if (!p.variant.certificate.empty()) out["certificate"] = p.variant.certificate;
  return out;
}

std::string name_of(const Variant& v) {
  const std::string precision = v.scalar == "double" ? "" : ", " + v.scalar;
  const std::string certificate = v.certificate.empty() ? "" : " + " + v.certificate;
  return v.method + precision + certificate;
}

void print_table(const PairSet& set, const std::vector<Point>& points, const Spread& allowed) {
  print_line(
      fmt::format("{}: {} pairs, {}, overlap ratio 1e-3..5e-2; condition x epsilon of the normal {:.0e} ({:.0e})",
                  set.name, points[0].time.pairs, set.of, allowed.median, allowed.p99));
  print_line(fmt::format("  {:<42}{:>6}{:>12}{:>12}{:>7}{:>10}{:>8}{:>19}{:>19}{:>19}", "method", "tol.", "median",
                         "p99", "iter", "no answer", "off", "overlap", "normal, rad", "points"));
  for (const Point& p : points) {
    const auto error = [](const Spread& s) { return fmt::format("{:.0e} ({:.0e})", s.median, s.p99); };
    print_line(fmt::format("{} {:<42}{:>6}{:>9.3f} us{:>9.3f} us{:>7}{:>8.1f} %{:>6.1f} %{:>19}{:>19}{:>19}",
                           p.is_on_front ? '*' : ' ', name_of(p.variant),
                           p.variant.tolerance > 0 ? fmt::format("{:.0e}", p.variant.tolerance) : "0",
                           p.time.median_ns * 1e-3, p.time.p99_ns * 1e-3,
                           p.time.most_iterations > 0 ? fmt::format("{:.0f}", p.time.median_iterations) : "-",
                           100 * p.failed, 100 * p.off, error(p.overlap), error(p.normal), error(p.points)));
  }
}

int report(const Options& options) {
  std::string lines;
  for (const PairSet& set : pair_sets()) {
    const std::vector<Case> cases = draw(set, static_cast<std::size_t>(options.count), options.seed);
    const Truths truths = truths_of(cases);
    if (interrupted()) break;
    const std::vector<Point> points = points_of(cases, truths, options.repeat);
    if (interrupted()) break;
    const Spread allowed = envelope(truths.at(Problem::common_normal));
    for (const Point& point : points) {
      const std::string line = write_json(to_json(set, point, allowed));
      lines += line + "\n";
      if (options.json) print_line(line);
    }
    if (!options.json) print_table(set, points, allowed);
    flush_output();
  }
  if (!options.out.empty()) write_file(options.out, lines);
  return interrupted() ? exit_interrupted : exit_done;
}

}  // namespace
}  // namespace plumb::reports

int main(int argc, char** argv) {
  plumb::reports::Options options;
  CLI::App app("What accuracy costs in time: every method, scalar and tolerance, against the certified reference.",
               "plumb report-precision");
  plumb::reports::declare(app, options);
  return plumb::run_command(app, argc, argv, [&] { return plumb::reports::report(options); });
}
